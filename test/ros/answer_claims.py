# SPDX-License-Identifier: BSD-3-Clause
"""What the oracle holds against answers of the node: their sentences, and the fields beside them."""

import math
import re

import claims
import rate_claims
import table_claims
from claims import (MORE, all_good, beyond, bracket, large_cylinder, no_region, on, placements, remark_on, spans,
                    verdicts, without_region)
from oracle import BAD, GOOD, Region
from reasons import hold, reason

NEAR = 1e-9  # what doubles leave of a value


def xyz(message):
    return [message.x, message.y, message.z]


def holds_value(bounds, value, *what):
    slack = NEAR * (1 + abs(value))
    hold(bounds.lower - slack <= value <= bounds.upper + slack, *what, bounds.lower, bounds.upper, "but it is", value)


def region_in(answer):
    turn = answer.orientation
    quaternion = 2 * math.atan2(turn.z, turn.w)
    hold(turn.x == turn.y == 0 and abs(turn.z**2 + turn.w**2 - 1) < NEAR, turn)
    hold(abs(math.remainder(quaternion - answer.angle, 2 * math.pi)) < NEAR, turn, answer.angle)
    hold(answer.turned or answer.angle == 0, answer.angle)
    angle = answer.angle if answer.turned else None
    return Region(answer.shape, list(answer.solid.dimensions), xyz(answer.center), angle)


def ranges(case, rails):
    """Joint values of samples lie within; and what is told is not much wider than they go."""
    for leg, rail, (low, high) in zip(case.machine.legs[float], rails, case.spans):
        few = 0.02 * (high - low) + NEAR
        hold(rail.joint == leg.name, rail.joint, "is not", leg.name)
        hold(low - few <= rail.lower <= low + NEAR and high - NEAR <= rail.upper <= high + few, rail, low, high)
        hold(low - few <= rail.inner_lower and rail.inner_upper <= high + few, rail, low, high)
        hold(rail.lower <= rail.inner_lower and rail.inner_upper <= rail.upper, rail)
        hold(rail.stroke_lower_bound - few <= high - low <= rail.stroke_upper_bound + NEAR, rail, high - low)


def volumes(answer, region):
    shape, d = answer.shape, region.dimensions
    volume = {"sphere": lambda: 4 / 3 * math.pi * d[0]**3, "disc": lambda: 0, "square": lambda: 0,
              "cylinder": lambda: math.pi * d[1]**2 * d[0]}.get(shape, lambda: math.prod(d))()
    hold(answer.volume <= volume * (1 + NEAR) and answer.volume >= volume * (1 - NEAR), answer.volume, volume)
    hold(answer.volume <= answer.volume_upper_bound or volume == 0, answer.volume_upper_bound)


def centers_of(case, answer, region):
    if not answer.use_search_box:
        return list(placements(case, region))
    ends = list(zip(xyz(answer.min_corner), xyz(answer.max_corner)))
    hold(answer.size == 0 or all(low <= x <= high for x, (low, high) in zip(region.center, ends)), answer)
    return [[case.rng.uniform(*end) for end in ends] for _ in range(20)]


def region(case, match):
    answer, found = case.answer, case.answer.size > 0
    told = match.groupdict()
    status = 0 if told.get("proven") else 2 if told.get("none") else 1
    hold(answer.status == status, "status", answer.status, case.text)
    unit = without_region(case, answer.shape)[1]
    own = region_in(answer) if found else unit
    if found:
        all_good(case, own)
        case.spans = spans(case, own)
        ranges(case, answer.joint_ranges)
        volumes(answer, own)
    centers = centers_of(case, answer, own)
    if answer.ratio_max > 0:
        hold(not found or answer.volume < answer.volume_upper_bound, answer)
        return large_cylinder(case, {"from": answer.ratio_min, "to": answer.ratio_max,
                                     "volume": answer.volume_upper_bound, "given": "", "where": ""}, centers)
    narrow = answer.size_upper_bound - answer.size <= answer.hypotheses.accuracy * (1 + NEAR)
    hold(status == 1 or narrow, "wider than asked:", answer.size, answer.size_upper_bound)
    hold(answer.size <= answer.size_upper_bound, answer.size, answer.size_upper_bound)
    no_region(case, own, beyond(answer.size_upper_bound, answer.size) if found else answer.size_upper_bound, centers)
    if told.get("remark"):
        remark_on(case, told["remark"], case.spans)
    return None


def brackets(case, told, last):
    """Those that the feedback told, one after the other, and the answer: each lies within the one before."""
    pairs = [(f.volume, f.volume_upper_bound) if case.answer.ratio_max > 0 else (f.size, f.size_upper_bound)
             for f in told + [last]]
    for before, after in zip(pairs, pairs[1:]):
        hold(before[0] <= after[0] <= after[1] <= before[1], "a bracket grew:", before, after)
    own = region_in(last)
    for feedback in told[-3:] if case.answer.ratio_max == 0 else ():
        no_region(case, own, beyond(feedback.size_upper_bound, last.size), list(placements(case, own)))


def value_of(case, limit, state):
    """What is bounded, from the definition."""
    legs = case.machine.legs[float]
    k = [leg.name for leg in legs].index(limit.joint) if limit.joint else None
    if limit.kind == limit.REACH:
        return math.sqrt(max(0, legs[k].length**2 - state.radicands[k]))
    if limit.kind in (limit.JOINT_LOWER, limit.JOINT_UPPER):
        return state.rhos[k]
    if limit.kind == limit.ASPECT:
        sign = case.machine.sign * (-1 if case.criterion.aspect == "other" else 1)
        return sign * state.det / math.prod(leg.length for leg in legs)
    return state.psi()[{limit.PSI_MIN: 0, limit.PSI_MAX: 2}[limit.kind]]


def binding(case, limit, point):
    state = case.machine.state(point)
    value = value_of(case, limit, state)
    at_least = limit.kind in (limit.JOINT_LOWER, limit.ASPECT, limit.PSI_MIN)
    slack = 1e-7 * (1 + abs(value))  # of psi in doubles
    hold(limit.value.lower - slack <= value <= limit.value.upper + slack, limit, "but it is", value)
    margin = (value - limit.bound) * (1 if at_least else -1)
    hold(limit.margin.lower - slack <= margin <= limit.margin.upper + slack, limit, "but it is", margin)


def point(case):
    """The numbers beside the sentence."""
    answer = case.answer
    state = case.machine.state(case.point)
    binding(case, answer.limit, case.point)
    hold(answer.within_reach == (answer.INSIDE if state.in_reach else answer.OUTSIDE), "within reach", answer)
    verdict = {answer.INSIDE: GOOD, answer.OUTSIDE: BAD}[answer.verdict]
    hold(case.machine.verdict(case.point, case.criterion) == verdict, "verdict", answer)
    hold(answer.has_values == state.in_reach, answer)
    if state.in_reach:
        psi = state.psi()
        for bounds, value in zip([*answer.psi, *answer.joints, answer.det_a, answer.condition],
                                 [*psi, *state.rhos, state.det, psi[2] / psi[0]]):
            slack = 1e-6 * (1 + abs(value))
            hold(bounds.lower - slack <= value <= bounds.upper + slack, bounds, "but it is", value)


def rates(case):
    """The fields on how fast the joints go."""
    told, limits = case.answer.rates, rate_claims.Limits(case)
    hold([*told.speed_max] == limits.of["speed"] and [*told.acceleration_max] == limits.of["acceleration"], told)
    hold(len(told.segment_feeds) == len(case.segments), told)
    for segment, feed in zip(case.segments, told.segment_feeds):
        least = rate_claims.least_feed(case, segment, limits)
        hold(feed.lower == 0 or least >= feed.lower * (1 - 1e-5), "too fast", feed)
        hold(least <= feed.upper * 1.1, "not so fast", feed)
        for k in range(51) if feed.lower > 0 else ():
            found = rate_claims.rates_at(case, segment, k / 50)["acceleration"]
            hold(all(x * case.tool_speed**2 <= most * (1 + 1e-4) + 1e-5 for x, most in zip(found, told.accelerations)),
                 "faster than", told.accelerations, found)
    lower, upper = (min(getattr(feed, end) for feed in told.segment_feeds) for end in ("lower", "upper"))
    hold((told.feed.lower, told.feed.upper) == (lower, upper), told)
    hold(told.segment_feeds[told.slowest_segment].lower == lower, told.slowest_segment)


def binding_rate(case, segment, t):
    limit = case.answer.limit
    kind = {limit.JOINT_SPEED: "speed", limit.JOINT_ACCELERATION: "acceleration"}[limit.kind]
    limits = rate_claims.Limits(case)
    k = limits.names.index(limit.joint)
    value = rate_claims.rates_at(case, segment, t)[kind][k] * case.tool_speed**(1 if kind == "speed" else 2)
    slack = 1e-4 * (1 + value)
    hold(limit.value.lower - slack <= value <= limit.value.upper + slack, limit, "but it is", value)
    hold(limit.bound == limits.of[kind][k] and limit.bound <= value + slack, limit, "but it is", value)
    hold(limit.margin.lower - slack <= limit.bound - value <= limit.margin.upper + slack, limit)


def path(case):
    answer = case.answer
    if case.tool_speed:
        rates(case)
    if answer.verdict == answer.INSIDE:
        hold(answer.offending_segment == -1 and set(answer.segment_verdicts) == {answer.INSIDE}, answer)
        return motion(case)
    told = [case.segments[k] for k in range(len(case.segments)) if answer.segment_verdicts[k] == answer.INSIDE]
    hold(all(BAD not in verdicts(case, segment, 0, 1, 100) for segment in told), "a segment is not inside")
    first = case.segments[answer.offending_segment]
    hold(all(x == answer.INSIDE for x in answer.segment_verdicts[:answer.offending_segment]), answer)
    hold(answer.good_until == 0 or BAD not in verdicts(case, first, 0, answer.good_until * (1 - 1e-12)),
         "bad before", answer.good_until)
    if answer.verdict == answer.OUTSIDE:
        hold(0 <= answer.good_until <= answer.bad_at <= 1, answer)
        hold(math.dist(on(first, answer.bad_at), xyz(answer.offence)) < NEAR, answer.offence)
        hold(answer.open[0].lower <= answer.good_until + NEAR and answer.open[-1].upper == answer.bad_at, answer.open)
        if answer.limit.kind in (answer.limit.JOINT_SPEED, answer.limit.JOINT_ACCELERATION):
            return binding_rate(case, first, answer.bad_at)
        hold(case.machine.verdict(on(first, answer.bad_at), case.criterion) == BAD, "good at", answer.bad_at)
        binding(case, answer.limit, on(first, answer.bad_at))
    return None


def motion(case):
    told, step = case.answer.motion, 1e-4
    for segment in case.segments:
        length = math.dist(segment[1], segment[2])
        for k in range(51):
            here = case.machine.state(on(segment, (1 - step) * k / 50))
            then = case.machine.state(on(segment, (1 - step) * k / 50 + step))
            for bounds, value in zip([*told.psi, *told.joints], [*here.psi(), *here.rhos]):
                slack = 1e-6 * (1 + abs(value))
                hold(bounds.lower - slack <= value <= bounds.upper + slack, bounds, "but it is", value)
            for most, before, after in zip(told.joint_speeds, here.rhos, then.rhos):
                speed = (case.tool_speed or 1) * abs(after - before) / (step * length)
                hold(speed <= most * (1 + 1e-6) + NEAR, "faster than", most, speed)


def mean(case, match):
    lower, upper, answer = float(match["lower"]), float(match["upper"]), case.answer
    hold(lower <= answer.index.lower <= answer.index.upper <= upper, match[0], answer.index)
    hold(answer.complete == bool(match["complete"]), match[0])
    hold(not answer.complete or upper - lower <= case.accuracy * 1.01, "wider than asked", match[0])
    if case.region:
        hold(math.isclose(math.prod(case.region.dimensions), answer.measure.upper), answer.measure)
    table_claims.mean(case, match)


def no_mean(case, match):
    index = case.answer.index
    hold((index.lower, index.upper, case.answer.complete) == (0, 1, False), match[0], index)


def paving(case, match):
    answer = case.answer
    hold(answer.complete == (not match["early"]) == (answer.boxes_pending == 0), answer.complete, case.text)
    lower, upper = bracket(match["bracket"])
    hold(lower <= answer.volume_lower_bound <= answer.volume_upper_bound <= upper, answer, case.text)
    hold({"volume": 3, "area": 2}[match["measure"]] == answer.dimension, answer.dimension, case.text)
    claims.measured(case, answer.volume_lower_bound, answer.volume_upper_bound, case.ends)
    volume_of = lambda low, high: math.prod(b - a for a, b in zip(xyz(low), xyz(high)) if b > a)
    listed = [(xyz(low), xyz(high), good) for boxes, good in ((answer.inside, True), (answer.boundary, False))
              for low, high in zip(boxes.min_corners, boxes.max_corners)]
    inside = sum(volume_of(low, high) for low, high in zip(answer.inside.min_corners, answer.inside.max_corners))
    hold(inside <= answer.volume_inside * (1 + NEAR) <= answer.volume_upper_bound * (1 + 2 * NEAR), inside, answer)
    for low, high, good in listed:
        if good:
            corner = [case.rng.choice(pair) for pair in zip(low, high)]
            hold(case.machine.verdict(corner, case.criterion) != BAD, "a bad corner of a box inside:", corner)
    for _ in range(100):
        p = [case.rng.uniform(a, b) for a, b in zip(case.ends[:3], case.ends[3:])]
        held = any(all(a <= x <= b for a, x, b in zip(low, p, high)) for low, high, _ in listed)
        hold(held or case.machine.verdict(p, case.criterion) != GOOD, "no box holds the good point", p)


def comparison(case, match):
    hold(int(match["count"]) == len(case.answer.machines) == len(case.machines), match[0])
    for machine, compared in zip(case.machines, case.answer.machines):
        region_there = compared.region
        case.machine, case.center = machine, xyz(region_there.center)
        case.lowest = [rail.lower for rail in region_there.joint_ranges]
        case.figures = {figure.label: (figure.value.lower, figure.value.upper) for figure in compared.figures}
        table_claims.compared_machine(case, region_there.shape, region_there.hypotheses.machine)


def region_told(case, match):
    """In one line: the center, the size, and the sentence of pkm largest."""
    case.region = None
    if match["volume_told"]:
        hold(float(match["volume_told"]) <= float(match["volume"]) * MORE, match[0])
    if match["found"]:
        case.size = float(match["size_told"])
        case.region = Region(match["found"], [float(x) for x in match["dimensions"].split()],
                             [float(x) for x in match["center"].split(", ")],
                             match["angle"] and float(match["angle"]))
    corners = re.search(r"its center from \((.*?)\) to \((.*?)\) m", case.definition)
    if corners:
        ends = [[float(x) for x in corner.split(", ")] for corner in corners.groups()]
        case.words = ["--search-box"] + [str(end[k]) for k in range(3) for end in ends]
    hold(bool(corners) == ("in the search box" in match["where"]), case.definition, match[0])
    claims.largest(case, match)


def set_told(case, match):
    claims.measured(case, *bracket(match["bracket"]), case.ends)


def singularities_told(case, match):
    """Of an answer that was held before."""
    hold(match["sentence"] in case.held_before, "nobody was answered:", match["sentence"])


def mean_told(case, match):
    hold(match["sentence"] in case.held_before, "nobody was answered:", match["sentence"])
