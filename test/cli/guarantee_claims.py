# SPDX-License-Identifier: BSD-3-Clause
"""What the oracle holds against the sentences of a guarantee: values at points, by the Jacobian."""

import itertools
import math
import re

from oracle import dot
from reasons import N, hold

SPEED, FORCE, STIFFNESS, ERROR = 1.0, 1000.0, 1e6, 1e-5  # of the joints: the URDF's, and those that are given
GUARANTEE = (r"Proved for every point: (?P<subject>.*?)(?: by (?:joints|drives) .*?)? is at (?P<end>least|most) "
             rf"(?P<value>{N})(?: [a-zN/]+)?; near "
             rf"(?P<place>\(.*?\)) m it is no (?:more|less) than (?P<other>{N})(?: [a-zN/]+)?(?:, by '(?P<joint>.*?)')?"
             r"(?P<early>\. The accuracy was not met: .*)?\.")
NO_GUARANTEE = r"Nothing is proved of (?!the global)(?P<subject>.*?)(?: by (?:joints|drives) .*?)?: (?P<why>.*)\."


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def jacobian(state):
    """Columns: the tool's velocity for one unit of each joint."""
    return [[state.etas[i] * x / state.det for x in cross(state.a[(i + 1) % 3], state.a[(i + 2) % 3])]
            for i in range(3)]


def norm(v):
    return math.sqrt(dot(v, v))


def off_axis(u, v):
    return math.acos(max(-1.0, min(1.0, dot(u, v) / (norm(u) * norm(v)))))


VALUES = {
    "the least force transmission factor": lambda s, zero: 1 / s.psi()[2],
    "the largest force transmission factor": lambda s, zero: 1 / s.psi()[0],
    "the condition number of J": lambda s, zero: s.psi()[2] / s.psi()[0],
    "the speed of the tool in every direction": lambda s, zero: min(SPEED * abs(e) / norm(a)
                                                                    for e, a in zip(s.etas, s.a)),
    "the force of the tool in every direction": lambda s, zero: min(FORCE / norm(c) for c in jacobian(s)),
    "the stiffness at the tool in the softest direction": lambda s, zero: STIFFNESS * s.psi()[0]**2,
    "the largest error of the tool's position": lambda s, zero: max(
        norm([sum(ERROR * sign * c[k] for sign, c in zip(signs, jacobian(s))) for k in range(3)])
        for signs in itertools.product((1, -1), repeat=3)),
    "the angle between the strut and its rail least": lambda s, zero: min(math.acos(min(1.0, abs(e) / norm(a)))
                                                                          for e, a in zip(s.etas, s.a)),
    "the angle between the strut and its rail most": lambda s, zero: max(math.acos(min(1.0, abs(e) / norm(a)))
                                                                         for e, a in zip(s.etas, s.a)),
    "the tilt of the strut's ball joints": lambda s, zero: max(off_axis(a, b) for a, b in zip(s.a, zero)),
}


def guarantee(case, match):
    value_at = VALUES.get(match["subject"]) or VALUES[match["subject"] + " " + match["end"]]
    zero = [leg.zero for leg in case.machine.legs[float]]
    sign, region = (1 if match["end"] == "least" else -1), case.region
    proved, other = float(match["value"]), float(match["other"])
    for k in range(200):
        share = [case.rng.random() if k % 2 else case.rng.choice((0.0, 1.0)) for _ in range(3)]
        state = case.machine.state(region.point(share))
        hold(state.in_reach, "not reached")
        value = value_at(state, zero)
        hold(sign * (value - proved) >= -1e-6 * abs(proved), match["subject"], "is", value, "somewhere, not", proved)
    place = [float(x) for x in re.findall(N, match["place"])]
    value = value_at(case.machine.state(place), zero)
    hold(sign * (value - other) <= 1e-3 * abs(other), match["subject"], "is", value, "at the place, not", other)
    hold(match["early"] or abs(proved - other) <= 2e-4 * abs(other), "wider than asked", match[0])


def nothing(case, match):
    """Some point of the region is not reached, or has next to nothing of it."""
    zero = [leg.zero for leg in case.machine.legs[float]]
    if "for none of the values" in match["why"]:
        least = min(VALUES[match["subject"] + " least"](case.machine.state(case.region.point(
            [case.rng.random() for _ in range(3)])), zero) for _ in range(2000))
        return hold(least < 0.1, match[0], "but", least)
    states = [case.machine.state(case.region.point([case.rng.choice((0.0, 0.5, 1.0)) for _ in range(3)]))
              for _ in range(100)]
    hold(not all(s.in_reach and s.det * case.machine.sign > 0 for s in states), match[0], "but all seems to be reached")
