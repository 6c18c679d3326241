# SPDX-License-Identifier: BSD-3-Clause
"""What the oracle holds against the texts in rviz."""

import re

from answer_claims import xyz
from claims import all_good, criterion_of
from oracle import BAD, Region
from reasons import N, hold, reason
from table_claims import is_singular_near


def numbers_after(text, start):
    return [float(x) for x in re.findall(N, text[start:])]


def label(case, match):
    """Dimensions, rounded down: with these the region is good, and nearly the one that was answered."""
    answer, told = case.answer, [float(x) for x in match.groups()[1:] if x]
    if match["shape"] in ("disc", "cylinder"):
        told = [told[1] if len(told) > 1 else 0, told[0]]
    if len(told) == 2 and match["shape"] in ("square", "box"):
        told.append(0)
    hold(match["shape"] == answer.shape and len(told) == len(answer.solid.dimensions), match[0])
    hold(all(x <= own <= x * 1.001 for x, own in zip(told, answer.solid.dimensions)), match[0], answer.solid.dimensions)
    all_good(case, Region(answer.shape, told, xyz(answer.center)), 100)


def stroke(case, match):
    answer, most = case.answer, float(match[2])
    region = Region(answer.shape, list(answer.solid.dimensions), xyz(answer.center))
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


def box_inside(case, match):
    all_good(case, box_of(case))


def box_outside(case, match):
    box = box_of(case)
    place = xyz(next(marker for marker in case.markers if marker.ns == "bad_point").pose.position)
    hold(box.contains(place), place, "is not in the box")
    hold(case.machine.verdict(place, case.criterion) == BAD, place, "is not bad")
    told = numbers_after(match["place"], 0)
    hold(all(abs(a - b) <= 1e-3 * abs(b) + 1e-12 for a, b in zip(told, place)), told, "but it is", place)


def singularity(case, match):
    balls = [marker for marker in case.markers if marker.ns == "singularity"]
    at = [marker.text for marker in balls].index(case.text)
    joint = match["joint"]
    leg = [leg.name for leg in case.machine.legs[float]].index(joint) if joint else None
    is_singular_near(case, xyz(balls[at - 1].pose.position), leg)


def tool(case, match):
    """Of a tool that stops at the border, below the text."""
    x, y, z = next(xyz(marker.pose.position) for marker in case.markers if marker.ns == "reason")
    reason(case, match["reason"], [x, y, z - 0.15 * case.machine.span], slack=1e-6)
