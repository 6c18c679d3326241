# SPDX-License-Identifier: BSD-3-Clause
"""What check_certificate.py needs beyond boxes and rails that are not parallel; read by it, as `core`."""
import math
from fractions import Fraction

Form, P, ONE, need, only = core.Form, core.P, core.ONE, core.need, core.only  # noqa: F821
form, exact, dot, side = core.form, core.exact, core.dot, core.side  # noqa: F821


def norm(v):
    """No smaller than |v|."""
    return Form(math.isqrt(max(0, dot(v, v).upper()) << P) + 1)


def inverse(x):
    """Encloses 1 / x for x > 0: 1 / x + a x is convex, so largest at one of the ends, and at least 2 sqrt(a)."""
    low, high = x.lower(), x.upper()
    need(low > 0, "a division by what may be 0")
    a = ONE * ONE * ONE // (low * high)
    most = max(ONE * ONE // low + (a * low >> P), ONE * ONE // high + (a * high >> P)) + 2
    least = 2 * math.isqrt(a << P)  # of 1 / x + a x
    return Form(-a) * x + Form((most + least) >> 1, r=((most - least) >> 1) + 2)


def cosine_and_sine(angle):
    need(abs(angle) <= 8, "an angle of more than 8 rad")
    q = P + 40
    top, bottom = angle.as_integer_ratio()
    x, term, sums = (top << q) // bottom, 1 << q, [0, 0]
    for n in range(120):
        sums[n % 2] += -term if n % 4 > 1 else term
        term = term * x // ((n + 1) << q)
    return [Form(y >> 40, r=4) for y in sums]


class RoundBody(core.Body):  # noqa: F821
    """A ball, or an upright cylinder."""

    def __init__(self, data):
        kind, = data
        need(kind in ("ball", "cylinder"), "a body of kind %s" % kind)
        measures, self.round = data[kind], 3 if kind == "ball" else 2
        only(measures, "the body", "radius", *(("lower", "upper") if self.round == 2 else ()))
        self.radius = core.several(measures["radius"], 2)  # noqa: F821
        self.low, self.high = [[-x for x in self.radius]] * self.round, [self.radius] * self.round
        if self.round == 2:
            self.low = self.low + [core.several(measures["lower"], 2)]  # noqa: F821
            self.high = self.high + [core.several(measures["upper"], 2)]  # noqa: F821
        need(all(a[k] <= 0 <= b[k] for a, b in zip(self.low, self.high) for k in (0, 1)), "a body without its center")

    def has(self, point):
        return super().has(point) and all(
            sum(Fraction(x) ** 2 for x in point[part][:self.round]) <= Fraction(self.radius[k]) ** 2
            for k, part in enumerate(("fixed", "per_size")))

    def avoidance(self, point, low, high, h):
        if list(self.sides(point, low, high, h, self.round)):
            return None
        off = [form(point[j]) - side(low[j], high[j], j) for j in range(self.round)] + [Form(0)] * (3 - self.round)
        radius = exact(self.measure(self.radius, h))
        return dot(off, off) - radius * radius

    def misses(self, low, high, center, h):
        gap = [max(0, Fraction(low[j]) - center[j], center[j] - Fraction(high[j])) for j in range(self.round)]
        return super().misses(low, high, center, h) or sum(x ** 2 for x in gap) > self.measure(self.radius, h) ** 2

    def corners(self, low, high, center, h):
        """Those of the box where u . (x - c) <= radius |u|, for the u that leads from the center to its middle."""
        box = [side(a, b, j) for j, (a, b) in enumerate(zip(low, high))]
        u = [box[j].c - exact(center[j]).c if j < self.round else 0 for j in range(3)]
        if not any(u):
            return core.SIGNS  # noqa: F821
        radius = exact(self.measure(self.radius, h)).upper()
        most = radius * (math.isqrt(dot(u, u)) + 1) - dot(u, u) + 8 * core.swing(u)  # noqa: F821
        slope = [x * box[j].g[j] for j, x in enumerate(u)]

        def excess(d):
            return dot(slope, d) - (most << P)

        points = [d for d in core.SIGNS if excess(d) <= 0]  # noqa: F821
        for d in points[:]:
            for j in range(3):
                end = d[:j] + (-d[j],) + d[j + 1:]
                if excess(end) <= 0:
                    continue
                way = (-excess(d) << (P + 1)) // (excess(end) - excess(d)) + 2  # rounded up: beyond the plane
                points.append(d[:j] + (d[j] + way if d[j] < 0 else d[j] - way,) + d[j + 1:])
        return points


class Travel(core.Bound):  # noqa: F821
    """The same for boxes of places along parallel rails: every center is a place + t e, and t changes joint values
    only."""

    def __init__(self, claims, data):
        super().__init__(claims, data)
        self.axis = data["travel_axis"]
        need(self.axis in (0, 1, 2) and data["centers"][0][self.axis] == data["centers"][1][self.axis],
             "places that are not flat")
        need(all(isinstance(leg, core.Leg) and leg.direction is claims.legs[0].direction  # noqa: F821
                 for leg in claims.legs), "travel along rails that are not parallel")
        need(not any(map(self.push, data["bad"])), "a bad point that others along the rails are not")

    def push(self, term):
        """How much of the travel a condition has in it."""
        sign = {"joint_lower": 1, "joint_upper": -1}.get(term.get("of"), 0)
        return sign * self.claims.legs[term["leg"]].sense if sign else 0

    def covers(self, j, sign, face):
        search_box = self.data["search_box"]
        if j == self.axis:
            return self.claims.legs[0].axis[j].lower() > 0 or self.claims.legs[0].axis[j].upper() < 0
        if search_box and self.is_along_axis() and sign * search_box[sign > 0][j] <= sign * face:
            return True
        u = [Form(sign * ONE * (k == j)) for k in range(3)]
        return any(self.covers_place(leg, u, form(sign * face)) for leg in self.claims.legs)

    def is_along_axis(self):
        e = self.claims.legs[0].direction
        return all(e[k].c == e[k].r == 0 for k in range(3) if k != self.axis)

    def rest_of_search_box(self, travel):
        """How far the travel, times this, may make a sum grow while centers are in the search box; None if unknown."""
        if self.data["search_box"] is None or not self.is_along_axis():
            return None
        (low, high), level = ([Fraction(corner[self.axis]) for corner in self.data["search_box"]],
                              Fraction(self.data["centers"][0][self.axis]))
        is_up = (self.claims.legs[0].direction[self.axis].c > 0) == (travel > 0)
        return high - level if is_up else level - low

    def covers_place(self, leg, u, most):
        """By one rail and the plane that places lie in, where q_k + t e_k is known along its axis k."""
        k, e, c = self.axis, leg.axis, leg.center
        e = e if e[k].lower() > 0 else [-x for x in e]
        level, along = form(self.data["centers"][0][k]), dot(e, u)
        w = [e[k] * x for x in u]
        w[k] = w[k] - along
        reach = e[k] * dot(u, c) + (level - c[k]) * along + leg.offset(w)
        return e[k].lower() > 0 and (reach - e[k] * most).upper() <= 0

    def excludes(self, low, high, leaf):
        total = self.sum(low, high, leaf)
        if total is None or self.out_of_reach(low, high, leaf):
            return total is not None
        travel = sum(Fraction(term["weight"]) * self.push(term) for term in leaf["terms"] if "at" in term)
        if travel == 0:
            return total.upper() < 0
        rest = self.rest_of_search_box(travel)
        if rest is not None and (total + exact(abs(travel) * rest)).upper() < 0:
            return True
        legs = self.claims.at(core.box(low, high))  # noqa: F821
        for i in range(3):  # what is left of the travel is bounded by a limit at the center
            for name, limit in zip(("joint_lower", "joint_upper"), self.claims.limits(i)):
                term = {"of": name, "leg": i}
                if limit is None or self.push(term) * travel >= 0:
                    continue
                if (total + exact(abs(travel)) * self.claims.scalar(term, legs)).upper() < 0:
                    return True
        return False


class Boxes:
    """The points of a box, as far as they are proved to satisfy the criterion or not to: leaves are 1, a reason, or 0
    where nothing is claimed."""

    def __init__(self, claims, data):
        only(data, "the boxes", "box", "tree")
        self.claims, self.data = claims, data

    def verify(self):
        good, bad = 0, 0
        for low, high, leaf in core.boxes(self.data["tree"], *core.several(self.data["box"], 2)):  # noqa: F821
            if leaf == 1:
                core.proved(self.inside, low, high, core.SPLITS, "the criterion")  # noqa: F821
                middle = [exact((Fraction(a) + Fraction(b)) / 2) for a, b in zip(low, high)]
                need(core.in_aspect(self.claims, middle), "a box is in another aspect")  # noqa: F821
                good += 1
            elif isinstance(leaf, dict):
                core.proved(lambda a, b: self.outside(a, b, leaf), low, high,  # noqa: F821
                            core.SPLITS, "the reason")  # noqa: F821
                bad += 1
            else:
                need(leaf == 0, "a leaf that is none")
        return ("every point of the boxes inside satisfies the criterion (%d), no point of those outside (%d)" %
                (good, bad))

    def inside(self, low, high):
        return core.good(self.claims, core.box(low, high), core.SIGNS)  # noqa: F821

    def outside(self, low, high, leaf):
        only(leaf, "a leaf", "of", "leg", "v")
        legs = self.claims.at(core.box(low, high))  # noqa: F821
        out_of_reach = any(at["b2"].upper() < leg.least for leg, at in zip(self.claims.legs, legs))
        return out_of_reach or self.claims.scalar(leaf, legs).upper() < 0


class Path:
    """Every point of straight segments satisfies the criterion: [start, end, t from 0 to 1 that part its pieces]."""

    def __init__(self, claims, data):
        self.claims, self.data = claims, data

    def verify(self):
        count = 0
        need(isinstance(self.data, list) and self.data, "a path without segments")
        for start, end, cuts in (core.several(segment, 3) for segment in self.data):  # noqa: F821
            need(len(cuts) > 1 and cuts[0] == 0 and cuts[-1] == 1 and sorted(cuts) == cuts,
                 "pieces that are not the whole segment")
            ends = [[form(x) for x in core.several(point, 3)] for point in (start, end)]  # noqa: F821
            need(core.in_aspect(self.claims, ends[0]), "a segment is in another aspect")  # noqa: F821
            for first, last in zip(cuts, cuts[1:]):
                core.proved(lambda a, b: self.inside(ends, a, b), [first, 0, 0], [last, 0, 0],  # noqa: F821
                            core.SPLITS, "the criterion")  # noqa: F821
                count += 1
        return "every point of the path satisfies the criterion (segments: %d, pieces: %d)" % (len(self.data), count)

    def inside(self, ends, low, high):
        t = side(low[0], high[0], 0)
        return core.good(self.claims, [a + t * (b - a) for a, b in zip(*ends)], core.SIGNS)  # noqa: F821


class Telescope:
    """A strut of variable length: x = p - center, n = x, b = |x|, q = |x| - length."""
    least = 0

    def __init__(self, data, _directions, _steepest):
        only(data, "a leg", "joint", "kind", "center", "length", "limits")
        self.center = [form(x) for x in core.several(data["center"], 3)]  # noqa: F821
        self.length, self.limits = form(data["length"]), core.several(data["limits"], 2)  # noqa: F821
        need(self.length.lower() > 0, "a strut without length")

    def at(self, p):
        x = [a - b for a, b in zip(p, self.center)]
        return {"b2": dot(x, x), "n": x}

    def diagonal(self, at, square):
        return (Form(ONE) - square) * at["b2"]

    def from_limit(self, is_upper, at):
        q = core.root(at["b2"], 0) - self.length  # noqa: F821
        return form(self.limits[1]) - q if is_upper else q - form(self.limits[0])

    def across(self, _v):
        return [Form(0)] * 3

    def offset(self, _v):
        return Form(0)

    def farthest(self, u, is_limited):
        if not is_limited or self.limits[1] is None:
            return None
        return dot(u, self.center) + norm(u) * (self.length + form(self.limits[1]))


class Crank:
    """A crank with its tip at r (u cos th + v sin th) and a forearm n of length L from there to x = p - center:
    m = x_u^2 + x_v^2, k = (x^2 + r^2 - L^2) / 2 r, beta = mode sqrt(m - k^2), cos th = (k x_u + beta x_v) / m,
    sin th = (k x_v - beta x_u) / m, b = gear beta."""

    def __init__(self, data, _directions, steepest):
        only(data, "a leg", "joint", "kind", "center", "along", "across", "radius", "length", "working_mode",
             "drive_scale", "limits")
        self.center, self.u, self.v = ([form(x) for x in core.several(data[name], 3)]  # noqa: F821
                                       for name in ("center", "along", "across"))
        for a, b, product in ((self.u, self.u, ONE), (self.v, self.v, ONE), (self.u, self.v, 0)):
            need(dot(a, b).lower() <= product <= dot(a, b).upper(), "a crank's directions are no unit vectors across")
        self.radius, self.length, self.mode = form(data["radius"]), form(data["length"]), data["working_mode"]
        need(self.mode in (1, -1) and min(self.radius.lower(), self.length.lower()) > 0, "a crank that is none")
        scale, self.limits = data["drive_scale"], core.several(data["limits"], 2)  # noqa: F821
        self.gear = Form(ONE) if scale is None else self.radius * inverse(form(scale))
        self.square = self.length * self.length
        self.least, self.least_beta = 0, 0
        if steepest:
            self.least = self.square.lower() * (ONE * ONE // (steepest * steepest).upper()) // ONE
            self.least_beta = self.least * (ONE * ONE // (self.gear * self.gear).upper()) // ONE
        need(self.limits == [None, None] or 0 < self.limits[1] - self.limits[0] <= 3.14,
             "limits of a crank that are a half turn apart")
        self.ends = [cosine_and_sine(x) for x in self.limits if x is not None]

    def at(self, p):
        x = [a - b for a, b in zip(p, self.center)]
        u, v = dot(self.u, x), dot(self.v, x)
        m = u * u + v * v
        k = (dot(x, x) + self.radius * self.radius - self.square) * inverse(self.radius + self.radius)
        beta2 = m - k * k
        beta = core.root(beta2, self.least_beta)  # noqa: F821
        beta = beta if self.mode > 0 else -beta
        tip = [Form(0, r=self.radius.upper())] * 2
        if m.lower() > 0:
            per_m = self.radius * inverse(m)
            tip = [(k * u + beta * v) * per_m, (k * v - beta * u) * per_m]
        return {"b2": self.gear * self.gear * beta2, "tip": tip,
                "n": [a - tip[0] * b - tip[1] * c for a, b, c in zip(x, self.u, self.v)]}

    def diagonal(self, at, square):
        return self.square - square * at["b2"]

    def from_limit(self, is_upper, at):
        """r sin of the angle from the limit, or to it: with less than half a turn between them, both say all."""
        cosine, sine = self.ends[is_upper]
        beyond = cosine * at["tip"][1] - sine * at["tip"][0]
        return -beyond if is_upper else beyond

    def across(self, v):
        return v

    def offset(self, v):
        return norm(v) * (self.radius + self.length)

    def farthest(self, u, _is_limited):
        return dot(u, self.center) + self.offset(u)


LEGS = {"telescopic_strut": Telescope, "crank": Crank}
