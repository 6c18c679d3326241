# SPDX-License-Identifier: BSD-3-Clause
"""What the oracle holds against the texts in rviz."""

import math
import re

from answer_claims import region_in, xyz
from claims import all_good, criterion_of
from oracle import BAD, Region
from reasons import N, hold, reason
from table_claims import is_singular_near


def label(case, match):
    """Dimensions, rounded down: with these the region is good, and nearly the one that was answered."""
    answer, told = case.answer, [float(x) for x in re.findall(N, match[0].partition("\n")[0])]
    hold(bool(match["turn"]) == answer.turned, match[0], answer.angle)
    hold(not answer.turned or abs(float(match["turn"]) - math.degrees(answer.angle)) < 0.1, match[0], answer.angle)
    if match["shape"] == "disc":
        told = [0, *told]
    if match["shape"] in ("cube", "square"):
        told = [*told, *told, told[0] if match["shape"] == "cube" else 0]
    if match["shape"] == "box" and len(told) == 2:
        told.append(0)
    hold(match["shape"] == answer.shape and len(told) == len(answer.solid.dimensions), match[0])
    hold(all(x <= own <= x * 1.002 for x, own in zip(told, answer.solid.dimensions)), match[0], answer.solid.dimensions)
    all_good(case, Region(answer.shape, told, xyz(answer.center), answer.angle if answer.turned else None), 100)


def stroke(case, match):
    answer, most = case.answer, float(match[2])
    region = region_in(answer)
    k = [leg.name for leg in case.machine.legs[float]].index(match["joint"])
    low, high = region.span(lambda p: case.machine.state(p).rhos[k], case.rng)
    hold(high - low <= most <= 1.02 * (high - low), match[0], "but it is", high - low)


def caption(case, match):
    """Whose answer it is, and what holds there."""
    hold(not match["sentence"] or match["sentence"] in case.held_before, match[0])
    hold(criterion_of(case.text) == case.criterion, case.text, "but it holds for", case.criterion)
    hold(f"geometry {case.hypotheses.geometry_hash[:8]}, " in case.text, case.text)


def box_of(case):
    box = next(marker for marker in case.markers if marker.ns == "box")
    return Region("box", xyz(box.scale), xyz(box.pose.position))


def sides(case, match):
    told = [float(match[k]) for k in "xyz"]
    hold(all(abs(a - b) <= 1e-3 * b for a, b in zip(told, xyz(next(
        marker for marker in case.markers if marker.ns == "box").scale))), told, "are not its sides")


def box_inside(case, match):
    sides(case, match)
    all_good(case, box_of(case))


def box_outside(case, match):
    sides(case, match)
    box = box_of(case)
    place = xyz(next(marker for marker in case.markers if marker.ns == "bad_point").pose.position)
    hold(box.contains(place), place, "is not in the box")
    hold(case.machine.verdict(place, case.criterion) == BAD, place, "is not bad")
    breaks(case, match["kind"], match["joint"], case.machine.state(place))


def breaks(case, kind, joint, state):
    """To within what the place is known by."""
    slack = 1e-6
    if kind == "reach":
        return hold(not state.in_reach, "the struts reach it")
    if kind == "aspect":
        sign = case.machine.sign * (-1 if case.criterion.aspect == "other" else 1)
        return hold(state.det * sign < slack, "det A is", state.det)
    if kind in ("psi_min", "psi_max"):
        values, bounds = state.psi(), case.criterion.psi
        excess = bounds[0] - values[0] if kind == "psi_min" else values[2] - bounds[1]
        return hold(excess > -slack, kind, values)
    at = [leg.name for leg in case.machine.legs[float]].index(joint)
    low, high = case.machine.legs[float][at].limits
    excess = low - state.rhos[at] if kind == "joint_lower" else state.rhos[at] - high
    return hold(excess > -slack, kind, joint, state.rhos[at])


def singularity(case, match):
    balls = [marker for marker in case.markers if marker.ns == "singularity"]
    at = [marker.text for marker in balls].index(case.text)
    joint = match["joint"]
    leg = [leg.name for leg in case.machine.legs[float]].index(joint) if joint else None
    is_singular_near(case, xyz(balls[at - 1].pose.position), leg)


def tool_at(case, ns):
    """It is above the text."""
    x, y, z = next(xyz(marker.pose.position) for marker in case.markers if marker.ns == ns)
    return [x, y, z + 0.4 * case.machine.span]


def tool(case, match):
    """Of a tool that stops at the border."""
    reason(case, match["reason"], tool_at(case, "reason"), slack=1e-6)


def tool_within(case, match):
    """Three digits of a factor, on their side of its bound."""
    place = tool_at(case, "nearest")
    hold(case.machine.verdict(place, case.criterion) != BAD, place, "is bad")
    if match["reason"]:
        return reason(case, match["reason"], place, slack=1e-6)
    k = 0 if match["side"] == "least" else -1
    told, bound, value = float(match["psi"]), case.criterion.psi[k], case.machine.state(place).psi()[k]
    hold(float(match.group(match.lastindex)) == bound, match[0], "but it is", bound)
    hold(abs(told - value) <= 0.0051 * value and (told - bound) * (1 if k == 0 else -1) > 0, match[0], "but", value)
