# SPDX-License-Identifier: BSD-3-Clause
"""What a machine does at a point, from the definitions alone: |p + b_i - a_i - rho_i e_i| = L_i, and J^-1 by its rows.

Numbers are those of the URDF's text, as decimals. A point is looked at in doubles first, and in 50 digits where these
do not tell; what is left then is undecided (0), and counted.
"""

import copy
import decimal
import itertools
import math
from decimal import Decimal
from types import SimpleNamespace
from xml.etree import ElementTree

decimal.getcontext().prec = 50
ZERO, GOOD, BAD = 0, 1, -1
MARGIN = {float: 1e-11, Decimal: Decimal("1e-40")}


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def plus(u, v, factor=1):
    return [x + factor * y for x, y in zip(u, v)]


def det(m):
    return sum(m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3])
               for i in range(3))


def root(x):
    return x.sqrt() if isinstance(x, Decimal) else math.sqrt(x)


def coefficients(m):
    """Of the characteristic polynomial of a symmetric matrix: all are >= 0 if and only if no eigenvalue is below 0."""
    minors = sum(m[i][i] * m[j][j] - m[i][j] * m[j][i] for i, j in ((0, 1), (0, 2), (1, 2)))
    return m[0][0] + m[1][1] + m[2][2], minors, det(m)


def shifted(m, factor, shift):
    return [[factor * m[i][j] + (shift if i == j else 0) for j in range(3)] for i in range(3)]


class Leg:
    """c = a - b: the tool's place where the strut's length and the joint value are both 0."""

    def __init__(self, rail, strut, tool, number=Decimal):
        vector = lambda tag, joint: [number(x) for x in joint.find(tag).get("xyz").split()]
        self.name = rail.get("name")
        self.zero = vector("origin", strut)
        axis = vector("axis", rail)
        self.e = [x / root(dot(axis, axis)) for x in axis]
        self.c = plus(vector("origin", rail), vector("origin", tool))
        self.length = root(dot(self.zero, self.zero))
        self.side = 1 if dot(self.zero, self.e) > 0 else -1
        limit = rail.find("limit")
        has_limits = limit is not None and limit.get("lower") is not None
        self.limits = [number(limit.get(end)) for end in ("lower", "upper")] if has_limits else None
        self.speed = float(limit.get("velocity", 0)) if limit is not None else 0
        self.speed = self.speed if self.speed > 0 else math.inf

    def rounded(self):
        leg = Leg.__new__(Leg)
        leg.name, leg.side, leg.length, leg.speed = self.name, self.side, float(self.length), self.speed
        leg.e, leg.c, leg.zero = ([float(x) for x in v] for v in (self.e, self.c, self.zero))
        leg.limits = self.limits and [float(x) for x in self.limits]
        return leg


class State:
    """At a point in reach: etas, rhos, rows of A, det A, and G = J^-1 J^-T."""

    def __init__(self, legs, p):
        self.radicands, self.etas, self.rhos, self.a = [], [], [], []
        for leg in legs:
            w = plus(p, leg.c, -1)
            along = dot(w, leg.e)
            across = plus(w, leg.e, -along)
            radicand = leg.length * leg.length - dot(across, across)
            self.radicands.append(radicand)
            if radicand > 0:
                self.etas.append(leg.side * root(radicand))
                self.rhos.append(along - self.etas[-1])
                self.a.append(plus(across, leg.e, self.etas[-1]))
        self.in_reach = len(self.etas) == 3
        if self.in_reach:
            self.det = det(self.a)
            rows = [[x / eta for x in row] for row, eta in zip(self.a, self.etas)]
            self.g = [[dot(u, v) for v in rows] for u in rows]

    def psi(self):
        """Singular values of J^-1, from the least, to 1e-8."""
        mean = sum(self.g[i][i] for i in range(3)) / 3
        m = shifted(self.g, 1, -mean)
        p = math.sqrt(sum(x * x for row in m for x in row) / 6)
        angle = math.acos(max(-1.0, min(1.0, det(m) / (2 * p**3)))) / 3 if p > 1e-100 else 0.0
        return sorted(math.sqrt(max(0.0, mean + 2 * p * math.cos(angle + 2 * math.pi * k / 3))) for k in range(3))


class Machine:
    undecided = 0  # points that 50 digits did not settle

    def __init__(self, urdf):
        joints = {joint.get("name"): joint for joint in ElementTree.fromstring(urdf).findall("joint")}
        rails = [joint for joint in joints.values() if joint.get("type") == "prismatic"]
        legs = [Leg(rail, joints[f"parallelogram_back_{i}"], joints[f"tcp_joint_{i}"])
                for i, rail in enumerate(rails, 1)]
        self.legs = {Decimal: legs, float: [leg.rounded() for leg in legs]}
        self.sign = 1 if det([leg.zero for leg in legs]) > 0 else -1
        self.span = max(leg.length for leg in self.legs[float])

    def limited(self, ends):
        """The same with other limits of its joints."""
        machine = copy.deepcopy(self)
        for number, legs in machine.legs.items():
            for leg, pair in zip(legs, ends):
                leg.limits = [number(x) for x in pair]
        return machine

    def state(self, p, number=float):
        return State(self.legs[number], [number(x) for x in p])

    def conditions(self, p, criterion, number=float):
        """Each condition over its scale, >= 0 where it holds."""
        legs = self.legs[number]
        state = self.state(p, number)
        values = [radicand / leg.length**2 for radicand, leg in zip(state.radicands, legs)]
        if not state.in_reach:
            return values
        if criterion.aspect != "both":
            sign = self.sign if criterion.aspect == "own" else -self.sign
            values.append(sign * state.det / (legs[0].length * legs[1].length * legs[2].length))
        if criterion.limits:
            for leg, rho in zip(legs, state.rhos):
                if leg.limits:
                    values += [(rho - leg.limits[0]) / leg.length, (leg.limits[1] - rho) / leg.length]
        if criterion.psi:
            largest = state.g[0][0] + state.g[1][1] + state.g[2][2]
            for factor, bound in zip((1, -1), criterion.psi):
                t = number(bound)**2
                levels = coefficients(shifted(state.g, factor, -factor * t))
                values += [x / (largest + t)**(k + 1) for k, x in enumerate(levels)]
        return values

    def verdict(self, p, criterion):
        for number, margin in MARGIN.items():
            values = self.conditions(p, criterion, number)
            if number is float and any(0 < x < 1e-6 for x in values[:3]):
                continue
            if any(x < -margin for x in values):
                return BAD
            if len(values) >= 3 and all(x > margin for x in values):
                return GOOD
        Machine.undecided += 1
        return ZERO

    def margins(self, p, criterion):
        """How far each condition is from being violated, in floating point, by its name."""
        free = SimpleNamespace(psi=None, limits=criterion.limits, aspect=criterion.aspect)
        values = dict(enumerate(self.conditions(p, free)))
        state = self.state(p)
        if criterion.psi and state.in_reach:
            least, _, largest = state.psi()
            values.update(least=least / criterion.psi[0] - 1, largest=1 - largest / criterion.psi[1])
        return values


def turned(offset, angle):
    """About z, from x to y, if there is an angle."""
    if not angle:
        return offset
    c, s = math.cos(angle), math.sin(angle)
    return [c * offset[0] - s * offset[1], s * offset[0] + c * offset[1], offset[2]]


class Region:
    """A box with full sides, or a round shape: sphere [radius], disc [0, radius], cylinder [height, radius]. One that
    may be turned about the vertical has an angle."""

    def __init__(self, shape, dimensions, center, angle=None):
        self.shape, self.dimensions, self.center, self.angle = shape, dimensions, center, angle

    def seen_from_center(self, point):
        """Along its own axes."""
        return turned(plus(point, self.center, -1), -(self.angle or 0))

    def point(self, u):
        """Of parameters in [0, 1]^3."""
        d = self.dimensions
        if self.shape in ("disc", "cylinder"):
            turn, radius = 2 * math.pi * u[0], d[1] * u[1]
            offset = [radius * math.cos(turn), radius * math.sin(turn), d[0] * (u[2] - 0.5)]
        elif self.shape == "sphere":
            turn, height, radius = 2 * math.pi * u[0], 2 * u[2] - 1, d[0] * u[1]
            flat = math.sqrt(max(0.0, 1 - height * height))
            offset = [radius * flat * math.cos(turn), radius * flat * math.sin(turn), radius * height]
        else:
            offset = [side * (x - 0.5) for side, x in zip(d, u)]
        return plus(self.center, turned(offset, self.angle))

    def contains(self, point):
        """But for rounding."""
        x, y, z = self.seen_from_center(point)
        d = [length * (1 + 1e-14) for length in self.dimensions]
        if self.shape in ("disc", "cylinder"):
            return math.hypot(x, y) <= d[1] and abs(z) <= d[0] / 2
        if self.shape == "sphere":
            return math.hypot(x, y, z) <= d[0]
        return all(abs(offset) <= side / 2 for offset, side in zip((x, y, z), d))

    def scaled(self, factor, center):
        return Region(self.shape, [factor * x for x in self.dimensions], center, self.angle)

    def samples(self, rng, count):
        """Corners and middles first, then points of which many lie on the border."""
        yield from itertools.product((0.0, 1.0, 0.5), repeat=3)
        is_round = self.shape in ("sphere", "disc", "cylinder")
        for _ in range(count):
            u = tuple(rng.choice((0.0, 1.0, rng.random(), rng.random())) for _ in range(3))
            height = rng.random() if self.shape == "sphere" else u[2]  # not at its poles again and again
            yield (rng.random(), max(u[1], rng.choice((0, 1))), height) if is_round else u

    def nearest(self, point):
        """The point of it that is next to one, or nearly so."""
        offset, d = self.seen_from_center(point), self.dimensions
        if self.shape == "sphere":
            far = math.hypot(*offset)
            return plus(self.center, offset, min(1.0, d[0] / far if far else 1.0))
        if self.shape in ("disc", "cylinder"):
            far = math.hypot(*offset[:2])
            share = min(1.0, d[1] / far if far else 1.0)
            offset = [share * offset[0], share * offset[1], max(-d[0] / 2, min(d[0] / 2, offset[2]))]
        else:
            offset = [max(-side / 2, min(side / 2, x)) for x, side in zip(offset, d)]
        return plus(self.center, turned(offset, self.angle))

    def climb(self, value, point, rng):
        """From a point of it to one where a value is larger, in ever smaller steps. @return the value, and the point"""
        best = value(point)
        for step in (0.1, 0.03, 0.01, 0.003, 0.001):
            for _ in range(40):
                there = self.nearest([x + rng.gauss(0, step * max(self.dimensions)) for x in point])
                best, point = max((best, point), (value(there), there))
        return best, point

    def span(self, value, rng):
        """The least and the largest value that samples, and a climb from the best of them, find in it."""
        points = [self.point(u) for u in self.samples(rng, 120)]
        ends = []
        for sign in (-1, 1):
            signed = lambda p, sign=sign: sign * value(p)
            ends.append(sign * self.climb(signed, max(points, key=signed), rng)[0])
        return ends

    def bad(self, machine, criterion, rng, count=150):
        """A bad point of it, or None where neither samples, nor climbs from the worst for each condition, find any."""
        worst = {}
        for u in self.samples(rng, count):
            point = self.point(u)
            if machine.verdict(point, criterion) == BAD:
                return point
            for name, margin in machine.margins(point, criterion).items():
                worst[name] = min((margin, point), worst.get(name, (math.inf, point)))
        for name, (_, start) in sorted(worst.items(), key=lambda item: item[1][0])[:4]:
            violation = lambda p, name=name: -machine.margins(p, criterion).get(name, math.inf)
            point = self.climb(violation, start, rng)[1]
            if machine.verdict(point, criterion) == BAD:
                return point
        return None
