#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks a certificate of pkm_workspace (docs/certificate.md) in integers, sharing nothing with what wrote it.

Numbers are integers in units of 2^-P. Functions over a box are enclosed by forms: a center, a slope for each side of
the box, whose coordinates delta run from -1 to 1, and a radius for all the rest, roundings included. Whatever is not
understood is refused. Round bodies, travel along parallel rails and legs that do not slide are in
certificate_extensions.py.
"""
import json
import math
import pathlib
import runpy
import sys
import types
from fractions import Fraction

P = 128
ONE = 1 << P
SPLITS = 10  # a leaf whose reason does not hold at once is halved so many times, its reason held against each part


class Refused(Exception):
    """The first thing that does not hold, in words."""


def need(holds, what):
    if not holds:
        raise Refused(what)


def only(data, what, *members):
    """Refuses members that are not known: they may change what is claimed."""
    need(isinstance(data, dict) and set(data) <= set(members), "%s has members that are not known here" % what)


def several(data, count):
    need(isinstance(data, list) and len(data) == count, "%s are no %d values" % (data, count))
    return data


def at_index(data, index):
    need(isinstance(index, int) and 0 <= index < len(data), "the number %s counts nothing" % index)
    return data[index]


def once(pairs):
    need(len(dict(pairs)) == len(pairs), "a member that is there twice")
    return dict(pairs)


def sane(data, may_be_truth=False):
    """Refuses numbers that others may read as something else."""
    if isinstance(data, (list, dict)):
        for name, value in data.items() if isinstance(data, dict) else enumerate(data):
            sane(value, name == "joint_limits")
    elif isinstance(data, bool):
        need(may_be_truth, "a truth value in place of a number")
    elif isinstance(data, (int, float)):
        most = 2 ** 53 - 1 if isinstance(data, int) else 1e100
        need(abs(data) <= most, "the number %s is out of range" % data)


def below(x):
    """The largest integer that is no larger than x."""
    top, bottom = x.as_integer_ratio()
    return (top << P) // bottom


def above(x):
    return -below(-x)


class Form:
    """All functions within r of c + g . delta, |delta_j| <= 1."""
    __slots__ = ("c", "g", "r")

    def __init__(self, c, g=(0, 0, 0), r=0):
        self.c, self.g, self.r = c, g, r

    def __add__(self, o):
        return Form(self.c + o.c, tuple(x + y for x, y in zip(self.g, o.g)), self.r + o.r)

    def __neg__(self):
        return Form(-self.c, tuple(-x for x in self.g), self.r)

    def __sub__(self, o):
        return self + -o

    def __mul__(self, o):
        """Products of slopes of one side are worth 0 to their product, as delta_j^2 runs from 0 to 1."""
        a, b = self.g, o.g
        c, r = 2 * self.c * o.c, 2 * (abs(self.c) * o.r + abs(o.c) * self.r)
        for j in range(3):
            c += a[j] * b[j]
            r += abs(a[j] * b[j])
            r += 2 * abs(a[j] * b[j - 1] + a[j - 1] * b[j])
        r += 2 * (self.r * (swing(b) + o.r) + swing(a) * o.r)
        return Form(c >> (P + 1), tuple((self.c * y + o.c * x) >> P for x, y in zip(a, b)), (r >> (P + 1)) + 6)

    def lower(self):
        return self.c - swing(self.g) - self.r

    def upper(self):
        return self.c + swing(self.g) + self.r


def swing(g):
    return abs(g[0]) + abs(g[1]) + abs(g[2])


def form(x):
    """A number, or an enclosure [lower, upper] of one."""
    lower, upper = (below(x[0]), above(x[1])) if isinstance(x, list) else (below(x), above(x))
    need(lower <= upper, "%s is no interval" % (x,))
    return Form((lower + upper) >> 1, r=(upper - lower + 1) >> 1)


def exact(x):
    """A fraction."""
    return Form((x.numerator << P) // x.denominator, r=1)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def root(x, least):
    """Encloses the square root of x wherever x >= least >= 0: sqrt(x) - a x is concave, so least at one of the ends,
    and at most 1 / 4 a."""
    low, high = max(x.lower(), least), max(x.upper(), least)
    first, last = math.isqrt(low << P), math.isqrt(high << P)
    a = ONE * ONE // (first + last + 1)
    below_chord = min(first - (a * low >> P), last - (a * high >> P)) - 1
    above_chord = ONE * ONE // (4 * a) + 1
    return Form(a) * x + Form((below_chord + above_chord) >> 1, r=((above_chord - below_chord) >> 1) + 1)


def side(lower, upper, j):
    """The coordinate j over a side of a box."""
    low, high = below(lower), above(upper)
    g = [0, 0, 0]
    g[j] = (high - low + 1) >> 1
    return Form((low + high) >> 1, tuple(g), 2)


def box(low, high):
    """The points of a box."""
    return [side(a, b, j) for j, (a, b) in enumerate(zip(low, high))]


def extension(name):
    """What the other file defines."""
    path = pathlib.Path(__file__).with_name("certificate_extensions.py")
    return runpy.run_path(str(path), {"core": types.SimpleNamespace(**globals())})[name]


class Leg:
    """A strut of length L from a foot at center + rho axis to the tool: x = p - center, q = x - (axis . x) axis,
    b = mode sqrt(L^2 - |q|^2), n = q + b axis, rho = axis . x - b; n . pdot = b rhodot, |n| = L."""

    def __init__(self, data, directions, steepest):
        only(data, "a leg", "joint", "kind", "center", "direction", "sense", "length", "working_mode", "limits")
        need(data["working_mode"] in (1, -1) and data["sense"] in (1, -1), "a sign that is none")
        self.direction, self.sense = at_index(directions, data["direction"]), data["sense"]
        self.center = [form(x) for x in several(data["center"], 3)]
        self.axis = [x if self.sense > 0 else -x for x in self.direction]
        self.length, self.mode = form(data["length"]), data["working_mode"]
        need(self.length.lower() > 0, "a strut without length")
        self.square = self.length * self.length
        self.limits = several(data["limits"], 2)
        # where |n| <= steepest |b| is asked for, b^2 is at least this share of L^2 there, and |q|^2 at most the rest
        share = min(ONE, ONE * ONE // (steepest * steepest).upper()) if steepest else 0
        self.least = self.square.lower() * share // ONE
        self.radius = math.isqrt(self.square.upper() * (ONE - share)) + 1

    def across(self, v):
        """E v, the part of v across the rail."""
        along = dot(self.axis, v)
        return [x - along * e for x, e in zip(v, self.axis)]

    def offset(self, v):
        """No v . q is larger."""
        a = self.across(v)
        return Form((math.isqrt(max(0, dot(a, a).upper()) << P) + 1) * self.radius // ONE + 1)

    def at(self, p):
        x = [a - b for a, b in zip(p, self.center)]
        along = dot(self.axis, x)
        q = self.across(x)
        b2 = self.square - dot(q, q)
        b = root(b2, self.least)
        b = b if self.mode > 0 else -b
        return {"b2": b2, "n": [a + b * e for a, e in zip(q, self.axis)], "rho": along - b}

    def diagonal(self, at, square):
        """n^2 - square b^2."""
        return self.square - square * at["b2"]

    def from_limit(self, is_upper, at):
        """How far the joint is on the right side of a limit."""
        return form(self.limits[1]) - at["rho"] if is_upper else at["rho"] - form(self.limits[0])

    def farthest(self, u, is_limited):
        """No u . p is larger, by this leg: p = c + q + (rho + b) e. None where that is without bound."""
        if not is_limited or None in self.limits:
            return None
        b = form([0.0, 1.0]) * self.length
        along = form(self.limits) + (b if self.mode > 0 else -b)
        return dot(u, self.center) + dot(u, self.axis) * along + self.offset(u)


class Claims:
    def __init__(self, data):
        need(data["format"] == "pkm_workspace certificate" and data["version"] == 1, "another format or version")
        self.data, asked = data, data["criterion"]
        only(asked, "the criterion", "psi_min", "psi_max", "joint_limits", "aspect")
        only(data["machine"], "the machine", "name", "directions", "legs")
        self.factor = {name: form(asked[name]) for name in ("psi_min", "psi_max") if name in asked}
        need(all(x.lower() > 0 for x in self.factor.values()), "a factor that is not positive")
        need(asked["joint_limits"] in (True, False), "joint limits that hold neither nor do not")
        self.square = {name: x * x for name, x in self.factor.items()}
        self.aspect = asked["aspect"]
        need(self.aspect in (-1, 0, 1), "an aspect that is none")
        directions = [[form(x) for x in several(e, 3)] for e in data["machine"]["directions"]]
        for e in directions:
            need(dot(e, e).lower() <= ONE <= dot(e, e).upper(), "a direction whose length is not 1")
        self.legs = []
        for leg in several(data["machine"]["legs"], 3):
            kind = Leg if leg["kind"] == "sliding_strut" else extension("LEGS")[leg["kind"]]
            self.legs.append(kind(leg, directions, self.factor.get("psi_max")))
        self.body = data["body"]
        if self.body is not None:
            need(len(self.body) == 1, "one body is wanted")
            self.body = Body(self.body) if "box" in self.body else extension("RoundBody")(self.body)

    def limits(self, i):
        return self.legs[i].limits if self.data["criterion"]["joint_limits"] else [None, None]

    # the conditions: what is not negative wherever they hold

    def matrix(self, name, legs):
        """psi_min: A A^T - psi^2 B^2; psi_max: psi^2 B^2 - A A^T; entries 11, 22, 33, 23, 13, 12."""
        diagonal = [leg.diagonal(at, self.square[name]) for leg, at in zip(self.legs, legs)]
        others = [dot(legs[i]["n"], legs[j]["n"]) for i, j in ((1, 2), (0, 2), (0, 1))]
        return [x if name == "psi_min" else -x for x in diagonal + others]

    def scalar(self, term, legs):
        name, i = term["of"], term.get("leg", 0)
        need(i in (0, 1, 2), "no such leg")
        if name in self.factor:
            v = [form(x) for x in several(term["v"], 3)]
            s = self.matrix(name, legs)
            two = Form(2 * ONE)
            return (dot([x * x for x in v], s[:3]) +
                    two * dot([v[1] * v[2], v[0] * v[2], v[0] * v[1]], s[3:]))
        if name == "reach":
            return legs[i]["b2"] - Form(self.legs[i].least)
        if name in ("joint_lower", "joint_upper") and self.limits(i)[name == "joint_upper"] is not None:
            return self.legs[i].from_limit(name == "joint_upper", legs[i])
        if name == "aspect" and self.aspect:
            volume = dot(legs[0]["n"], cross(legs[1]["n"], legs[2]["n"]))
            return volume if self.aspect > 0 else -volume
        raise Refused("a reason of a condition that is not asked for: %s" % name)

    def at(self, p):
        return [leg.at(p) for leg in self.legs]


SIGNS = [(x, y, z) for x in (-ONE, ONE) for y in (-ONE, ONE) for z in (-ONE, ONE)]


class Body:
    """c + K0 + h K1: a box; its measures are [fixed, per size]."""

    def __init__(self, data):
        only(data["box"], "the body", "lower", "upper")
        self.low, self.high = ([several(pair, 2) for pair in several(data["box"][name], 3)]
                               for name in ("lower", "upper"))
        need(all(a[k] <= 0 <= b[k] for a, b in zip(self.low, self.high) for k in (0, 1)), "a body without its center")

    @staticmethod
    def measure(pair, h):
        return Fraction(pair[0]) + Fraction(h) * Fraction(pair[1])

    def has(self, point):
        """Whether the family has the point, in both of its parts."""
        return all(a[k] <= x <= b[k] for k, part in enumerate((point["fixed"], point["per_size"]))
                   for a, x, b in zip(self.low, part, self.high))

    def sides(self, point, low, high, h, first=0):
        """How far a point is beyond those sides of c + K(h) that it may be beyond, for c in the box."""
        for j in range(first, 3):
            below_side, above_side = self.measure(self.low[j], h), self.measure(self.high[j], h)
            offset = form(point[j]) - side(low[j], high[j], j)
            if Fraction(point[j]) - Fraction(low[j]) > above_side:
                yield offset - exact(above_side)
            if Fraction(point[j]) - Fraction(high[j]) < below_side:
                yield exact(below_side) - offset

    def avoidance(self, point, low, high, h):
        """What is not negative where c + K(h) does not hold the point, for c in the box; None if there is none."""
        beyond = list(self.sides(point, low, high, h))
        return Form(-ONE) if not beyond else beyond[0] if len(beyond) == 1 else None

    def misses(self, low, high, center, h):
        """Whether the box has no point of c + K(h)."""
        return any(Fraction(a) > c + self.measure(y, h) or Fraction(b) < c + self.measure(x, h)
                   for a, b, c, x, y in zip(low, high, center, self.low, self.high))

    def corners(self, _low, _high, _center, _h):
        """Points whose hull has all points of the body in the box, as coordinates delta."""
        return SIGNS


def boxes(tree, lower, upper):
    """The leaves of a tree of cuts, in the order in which they are written, with their boxes."""
    open_boxes, nodes = [(several(lower, 3), several(upper, 3))], iter(tree)
    while open_boxes:
        low, high = open_boxes.pop()
        node = next(nodes, None)
        need(node is not None, "the tree ends early")
        if not isinstance(node, list):
            yield low, high, node
            continue
        axis, plane = several(node, 2)
        need(axis in (0, 1, 2) and low[axis] <= plane <= high[axis], "a cut beside its box")
        open_boxes.append((low[:axis] + [plane] + low[axis + 1:], high))
        open_boxes.append((low, high[:axis] + [plane] + high[axis + 1:]))
    need(next(nodes, None) is None, "the tree goes on behind its end")


def halves(low, high):
    axis = max(range(3), key=lambda j: high[j] - low[j])
    middle = low[axis] + 0.5 * (high[axis] - low[axis])
    return ((low, high[:axis] + [middle] + high[axis + 1:]), (low[:axis] + [middle] + low[axis + 1:], high))


def proved(check, low, high, splits, what):
    """Holds a leaf, or else its halves, against its reason."""
    if not check(low, high):
        need(splits > 0 and low != high, "%s does not hold in the box %s to %s" % (what, low, high))
        for half in halves(low, high):
            proved(check, *half, splits - 1, what)


class Region:
    """Every point of c + K(h) satisfies the criterion."""

    def __init__(self, claims, data):
        only(data, "the region", "center", "size", "box", "tree")
        need(data["size"] >= 0, "a size below 0")
        self.claims, self.data, self.body = claims, data, claims.body
        self.center = [Fraction(x) for x in several(data["center"], 3)]
        self.low = [c + self.body.measure(a, data["size"]) for c, a in zip(self.center, self.body.low)]
        self.high = [c + self.body.measure(b, data["size"]) for c, b in zip(self.center, self.body.high)]

    def verify(self):
        lower, upper = (several(corner, 3) for corner in several(self.data["box"], 2))
        need(all(a <= x and y <= b for a, x, y, b in zip(lower, self.low, self.high, upper)),
             "the region reaches beyond the box of its proof")
        count = 0
        for low, high, leaf in boxes(self.data["tree"], lower, upper):
            need(leaf == 0, "a leaf that says something")
            proved(self.inside, low, high, SPLITS, "the criterion")
            count += 1
        need(in_aspect(self.claims, [exact(x) for x in self.center]), "the center is in another aspect")
        return count

    def inside(self, low, high):
        place = (low, high, self.center, self.data["size"])
        return self.body.misses(*place) or good(self.claims, box(low, high), self.body.corners(*place))


def good(claims, p, corners):
    """Whether the criterion, but for the aspect where one point of a connected set settles that, holds at the points p
    for all delta in the hull of the corners."""
    def least(f, d):
        return f.c + (dot(f.g, d) >> P) - f.r - 4

    def definite(s, d):
        """Whether the matrix is positive definite there: its rows' radii, and the roundings, are taken off its
        diagonal, then its leading minors are positive."""
        m = [f.c + (dot(f.g, d) >> P) for f in s]
        r = [f.r + 4 for f in s]
        a, b, c = m[0] - r[0] - r[4] - r[5], m[1] - r[1] - r[3] - r[5], m[2] - r[2] - r[3] - r[4]
        f, e, g = m[3], m[4], m[5]
        return a > 0 and a * b > g * g and a * b * c + 2 * e * f * g > a * f * f + b * e * e + c * g * g

    legs = claims.at(p)
    terms = [{"of": "reach", "leg": i} for i in range(3)]
    for i in range(3):
        terms += [{"of": name, "leg": i} for name, limit in zip(("joint_lower", "joint_upper"), claims.limits(i))
                  if limit is not None]
    if claims.aspect and "psi_min" not in claims.factor:
        terms.append({"of": "aspect"})
    return (all(least(claims.scalar(term, legs), d) >= 0 for term in terms for d in corners) and
            all(definite(claims.matrix(name, legs), d) for name in claims.factor for d in corners))


def in_aspect(claims, point):
    """Whether a point is in the aspect: S_min keeps det A from 0, so one point of a connected set settles its sign."""
    if not claims.aspect or "psi_min" not in claims.factor:
        return True  # good() has seen to that
    return claims.scalar({"of": "aspect"}, claims.at(point)).lower() > 0


class Bound:
    """No c + K(h) with h > size satisfies the criterion, for any center (in the search box, if there is one)."""

    def __init__(self, claims, data):
        only(data, "the bound", "size", "centers", "search_box", "travel_axis", "points", "bad", "tree")
        self.claims, self.data = claims, data
        for point in data["points"]:
            only(point, "a point", "fixed", "per_size")
            need(several(point["fixed"], 3) and several(point["per_size"], 3) and claims.body.has(point),
                 "a point that the body does not have")
        for corner in several(data["search_box"], 2) if data["search_box"] is not None else ():
            several(corner, 3)

    def verify(self):
        for term in self.data["bad"]:
            only(term, "a bad point", "point", "of", "leg", "v")
            here = self.claims.at([form(x) for x in several(term["point"], 3)])
            need(self.claims.scalar(term, here).upper() < 0, "the point %s is not bad" % term["point"])
        lower, upper = (several(corner, 3) for corner in several(self.data["centers"], 2))
        for j in range(3):
            for sign, face in ((-1, lower[j]), (1, upper[j])):
                need(self.covers(j, sign, face), "centers may lie beyond the box of the search")
        count = 0
        for low, high, leaf in boxes(self.data["tree"], lower, upper):
            only(leaf, "a leaf", "size", "terms")
            need(0 <= leaf["size"] <= self.data["size"], "a reason for larger regions only")
            proved(lambda a, b: self.excludes(a, b, leaf), low, high, SPLITS, "the reason")
            count += 1
        return count

    # where centers are: each lies in the set itself, as the body holds its center

    def covers(self, j, sign, face):
        """Whether no center lies beyond a face of the box, which is at this coordinate along the axis j."""
        search_box = self.data["search_box"]
        if search_box and sign * search_box[sign > 0][j] <= sign * face:
            return True
        u, most = [Form(sign * ONE * (k == j)) for k in range(3)], form(sign * face)
        if self.covers_reach(u, most):
            return True
        by_legs = [leg.farthest(u, self.claims.data["criterion"]["joint_limits"]) for leg in self.claims.legs]
        return any(reach is not None and (reach - most).upper() <= 0 for reach in by_legs)

    def covers_reach(self, u, most):
        """By all three rails: with q_i = E_i (p - c_i) and M = E_1 + E_2 + E_3, M p is the sum of E_i c_i + q_i."""
        legs = self.claims.legs
        unit = [[Form(ONE * (j == k)) for k in range(3)] for j in range(3)]
        m = [[sum((leg.across(unit[j])[k] for leg in legs), Form(0)) for k in range(3)] for j in range(3)]
        adjoint = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])]
        det, a = dot(m[0], adjoint[0]), [dot(row, u) for row in adjoint]
        reach = sum((dot(leg.across(a), leg.center) + leg.offset(a) for leg in legs), Form(0))
        return det.lower() > 0 and (reach - det * most).upper() <= 0

    def term(self, term, low, high, size):
        if "bad" in term:
            only(term, "a term", "bad", "weight")
            return self.claims.body.avoidance(at_index(self.data["bad"], term["bad"])["point"], low, high, size)
        only(term, "a term", "at", "of", "leg", "v", "weight")
        return self.claims.scalar(term, self.legs_at(term, low, high, size))

    def legs_at(self, term, low, high, size):
        point = at_index(self.data["points"], term["at"])
        return self.claims.at([c + form(k) + form(size) * form(l)
                               for c, k, l in zip(box(low, high), point["fixed"], point["per_size"])])

    def out_of_reach(self, low, high, leaf):
        """Whether some leg does not reach one of the points, wherever the center."""
        return any(at["b2"].upper() < leg.least for term in leaf["terms"] if "at" in term
                   for leg, at in zip(self.claims.legs, self.legs_at(term, low, high, leaf["size"])))

    def excludes(self, low, high, leaf):
        """A sum of what is not negative where c + K(size) satisfies the criterion, and negative all over the box."""
        total = self.sum(low, high, leaf)
        return total is not None and total.upper() < 0 or self.out_of_reach(low, high, leaf)

    def sum(self, low, high, leaf):
        total = Form(0)
        for term in leaf["terms"]:
            need(term["weight"] >= 0, "a weight below 0")
            value = self.term(term, low, high, leaf["size"])
            if value is None:
                return None
            total = total + form(term["weight"]) * value
        return total


def check(data):
    """@return a sentence for each claim, all of which hold; otherwise raises"""
    sane(data)
    only(data, "the certificate", "format", "version", "written_by", "geometry_hash", "machine", "criterion", "body",
         "region", "bound", "boxes", "path")
    claims, verified = Claims(data), []
    need(any(data[name] is not None for name in ("region", "bound", "boxes", "path")), "nothing is claimed")
    if data["region"] is not None:
        count = Region(claims, data["region"]).verify()
        verified.append("every point of the region satisfies the criterion (boxes: %d)" % count)
    if data["bound"] is not None:
        bound = Bound if data["bound"]["travel_axis"] is None else extension("Travel")
        count = bound(claims, data["bound"]).verify()
        where = " with its center in the search box" if data["bound"]["search_box"] is not None else ""
        verified.append("no region larger than %r%s satisfies it (boxes: %d)" % (data["bound"]["size"], where, count))
    for name, of_kind in (("boxes", "Boxes"), ("path", "Path")):
        if data[name] is not None:
            verified.append(extension(of_kind)(claims, data[name]).verify())
    return verified


NOT_UNDERSTOOD = (ValueError, KeyError, TypeError, AttributeError, IndexError, OverflowError, ZeroDivisionError,
                  RecursionError)


def main():
    if len(sys.argv) != 2:
        sys.exit("give one file: check_certificate.py FILE")
    try:
        with open(sys.argv[1], encoding="utf-8") as file:
            for sentence in check(json.load(file, object_pairs_hook=once)):
                print("Verified: %s." % sentence)
    except (Refused, OSError) as error:
        sys.exit("refused: %s" % error)
    except NOT_UNDERSTOOD as error:
        sys.exit("refused: not understood: %r" % error)


if __name__ == "__main__":
    main()
