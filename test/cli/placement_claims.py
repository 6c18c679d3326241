# SPDX-License-Identifier: BSD-3-Clause
"""What is said of where a path fits, against the oracle at points of it, moved by what the margin allows."""

import itertools
import re

import rate_claims
from claims import QUALITY, numbers, on, row, segments
from oracle import BAD, GOOD, plus
from reasons import N, hold, reason

GOOD = (rf"every point of the path is {QUALITY}(?P<rates>, and at (?:\S+ m/s|its feeds) the joints keep within their "
        r"limits of (?:speed|acceleration|speed and acceleration))?")
PLACED = (rf"Proved: with this translation, and moved from there by up to {N} m along each axis, {GOOD}; "
          rf"no translation that may be chosen has a margin above {N} m\.")
NOWHERE = rf"Proved: there is no translation that may be chosen with which {GOOD}\."
OPEN = rf"Proved: no translation that may be chosen has a margin above {N} m\. Whether one has any is not decided\."
TUPLE = r"\((?P<x>\S+), (?P<y>\S+), (?P<z>\S+)\) m"
SCALED = (rf" Proved: scaled about \((?P<about>\S+, \S+, \S+)\) m and then moved by {TUPLE}, every point of the path "
          rf"is {QUALITY} at all scales from (?P<least>[01]) to (?P<scale>[\d.e+-]+); no translation that may be "
          r"chosen allows one above (?P<above>[\d.e+-]+?)\.(?: Speeds do not count for the scale\.)?")
UNSCALED = (rf" Proved: no translation is such that every point of the path is {QUALITY} at all scales from [01] to "
            r"one above (?P<none_above>[\d.e+-]+?)\.")
STOPPED = r"(?: [A-Z][^:]* ended the search: [^.]*\.| The accuracy is below what [^.]*\.)?"
WHY = (r"(?: All of the set is within (?P<extent>(?:[xyz] \S+ to \S+ m(?:, )?)+)\.)?"
       r"(?: For instance, moved by \(\S+, \S+, \S+\) m, a point of it is at \((?P<bad>\S+, \S+, \S+)\) m: "
       r"(?P<why>.*?)\.)?")
PLACEMENT = (rf"(?:(?P<placed>{PLACED})|(?P<nowhere>{NOWHERE.replace('?P<rates>', '?P<no_rates>')})|(?P<open>{OPEN}))"
             rf"{STOPPED}(?:(?:{SCALED}|{UNSCALED}){STOPPED})?{WHY}"
             rf"{rate_claims.NOT_HELD}(?: (?P<remark>Joint limits are off: .*))?")
SAMPLES = 12  # of a segment, corners of the margin at each


def middle_of(case):
    ends = [end for segment in segments(case) for end in segment[1:]]
    return [(min(x) + max(x)) / 2 for x in zip(*ends)]


def moved(case, place, scale=1):
    """The segments there, scaled about the middle of their bounds."""
    middle = middle_of(case)

    def put(point):
        return plus(plus(middle, plus(point, middle, -1), scale), place)

    return [(segment[0], put(segment[1]), put(segment[2])) for segment in segments(case)]


def points(case, place, margin, scale=1):
    for segment in moved(case, place, scale):
        for k in range(SAMPLES + 1):
            for corner in itertools.product((-margin, margin), repeat=3) if margin > 0 else ((0, 0, 0), ):
                yield plus(on(segment, k / SAMPLES), corner)


def is_bad(case, place, margin, scale=1):
    return any(case.machine.verdict(point, case.criterion) == BAD for point in points(case, place, margin, scale))


def is_slow(case, place):
    """Whether the joints keep their speeds, at the speed of the tool that was asked for."""
    limits = rate_claims.Limits(case)
    speed = case.tool_speed or float(case.words[case.words.index("--tool-speed") + 1])
    return all(rate_claims.least_feed(case, segment, limits) >= speed * (1 - 1e-5) for segment in moved(case, place))


def elsewhere(case):
    """Places of the path: all that have its first end near to where the machine has its tool."""
    leg = case.machine.legs[float][0]
    zero, span = plus(leg.c, leg.zero), case.machine.span
    start = segments(case)[0][1]
    for _ in range(25):
        yield plus(plus(zero, start, -1), [case.rng.uniform(-0.7, 0.7) * span for _ in range(3)])


def placement(case, match):
    span = case.machine.span
    margin, bound = 0, None
    if match["placed"]:
        place = case.place or numbers(row(case.text, "translation"))
        margin, bound = (float(x) for x in (match["placed"].split("up to ")[1].split()[0],
                                            match["placed"].split("margin above ")[1].split()[0]))
        hold(0 < margin <= bound, margin, "is above", bound)
        hold(not is_bad(case, place, margin), "a point is bad at", place, "within", margin)
        hold(not match["rates"] or is_slow(case, place), "too fast at", place)
        hold(is_bad(case, place, bound + 0.02 * span), "all is good beyond the margin", bound)
    elif match["open"]:
        bound = float(match["open"].split("margin above ")[1].split()[0])
    for place in elsewhere(case):
        if match["nowhere"]:
            hold(is_bad(case, place, 0) or match["no_rates"] and not is_slow(case, place), "all is good at", place)
        elif not match["rates"]:
            hold(is_bad(case, place, bound + 0.02 * span), "the margin is above", bound, "at", place)
    if match["remark"]:
        hold("not proved" in match["remark"], match["remark"])
    if match["why"]:  # the point is told to six digits
        reason(case, match["why"], [float(x) for x in match["bad"].split(", ")], 1e-5 * span)
    if match["extent"]:
        within(case, match["extent"])
    scales(case, match)


def within(case, extent):
    """No good point of a grid is beyond the bounds."""
    bounds = re.findall(r"([xyz]) (\S+) to (\S+) m", extent)
    steps = [case.machine.span * k / 3 for k in range(-5, 6)]
    for point in itertools.product(steps, repeat=3):
        if any(not float(lower) <= point["xyz".index(axis)] <= float(upper) for axis, lower, upper in bounds):
            hold(case.machine.verdict(point, case.criterion) != GOOD, point, "is good, beyond", extent)


def scales(case, match):
    if match["scale"]:
        place, least, scale, above = ([float(match[k]) for k in "xyz"], *(float(match[k]) for k in
                                                                          ("least", "scale", "above")))
        hold(least <= scale <= above, "scales", least, scale, above)
        about = [float(x) for x in match["about"].split(", ")]
        hold(max(abs(a - b) for a, b in zip(about, middle_of(case))) < 1e-9 * case.machine.span, "scaled about", about)
        for share in (0.01, 0.5, 1):
            hold(not is_bad(case, place, 0, least + share * (scale - least)), "a point is bad at", place)
        hold(is_bad(case, place, 0, above + 0.03), "all is good at", place, "and a scale above", above)
        for place in elsewhere(case):
            hold(is_bad(case, place, 0, above + 0.03), "all is good at", place, "and a scale above", above)
    elif match["none_above"]:
        for place in elsewhere(case):
            hold(is_bad(case, place, 0, float(match["none_above"]) + 0.03), "all is good at", place)
