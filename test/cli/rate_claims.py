# SPDX-License-Identifier: BSD-3-Clause
"""What is said of the speeds and accelerations of the joints along a path, against differences of the joint values."""

import math
import re

import claims
from claims import on, segments
from reasons import N, Wrong, hold, number_or_near

PLACE = r"(?:line '(?P<{0}place>.*?)' \(line\)|(?P<{0}segment>segment \d+))"
NOT_HELD = r"(?: (?:Joint speeds are|The speeds? of .*? (?:is|are)) not held against a limit: .*?\.)?"
RATES = (r"(?: At (?:its feeds|(?P<kept>\S+) m/s) the joints are proved to keep within their limits\.)?"
         rf"(?: The largest feed is proved to be (?P<feed>{claims.BRACKET}) m/s; at that '(?P<slowest>\w+)' reaches "
         r"its limit of (?P<limit>speed|acceleration) on " + PLACE.format("slowest_") + r"\.|"
         rf" The largest feed is proved to be at most (?P<at_most>{N}) m/s\.| Nothing is known of the largest feed\.)?"
         rf"{NOT_HELD}")
FAST = (r"Proved: at (?P<speed>\S+) m/s the path (?P<leaves>becomes|is) too fast for the joints on " +
        PLACE.format("") + r", (?:near|between) t = (?P<t>[\d.e-]+)(?: and t = (?P<upper>[\d.e-]+))? of its way"
        r"(?:, and is so somewhere between these)?: the (?P<rate>speed|acceleration) of joint '(?P<joint>\w+)' "
        r"(?P<value>.*?)\.(?: Before that it comes within rounding of the border .*?, where nothing is decided\."
        r"| Before that it is not decided .*?\.)?" + RATES)
COUNT = 120  # samples of a segment


class Limits:
    """Of the joints of a case, those of its URDF and those of its words; infinite where there is none."""

    def __init__(self, case):
        words = [str(word) for word in case.words]
        option = "--joint-acceleration-max"
        most = float(words[words.index(option) + 1]) if option in words else case.joint_acceleration_max
        self.of = {"speed": [leg.speed for leg in case.machine.legs[float]], "acceleration": [most] * 3}
        self.names = [leg.name for leg in case.machine.legs[float]]

    def feed(self, rates, kinds=("speed", "acceleration"), legs=range(3)):
        """The largest that keeps them where the rates are these."""
        ends = [(self.of[kind][k] / rates[kind][k])**(1 if kind == "speed" else 0.5)
                for kind in kinds for k in legs if rates[kind][k] > 0]
        return min(ends, default=math.inf)


def rates_at(case, segment, t):
    """|q'| and |q''| by the length of the way."""
    length = math.dist(segment[1], segment[2])
    step = 1e-4 * case.machine.span / length
    before, here, after = (case.machine.state(on(segment, t + k * step)).rhos for k in (-1, 0, 1))
    way = step * length
    return {"speed": [abs(b - a) / (2 * way) for a, b in zip(before, after)],
            "acceleration": [abs(a - 2 * x + b) / way**2 for a, x, b in zip(before, here, after)]}


def least_feed(case, segment, limits, last=1, **of):
    """Over points that are in reach, all around."""
    rates = (rates_at(case, segment, last * k / COUNT) for k in range(COUNT + 1))
    return min((limits.feed(each, **of) for each in rates if len(each["acceleration"]) == 3), default=math.inf)


def named(case, name):
    for segment in segments(case):
        if segment[0] == name:
            return segment
    raise Wrong("no such segment: " + name)


def told(case, match):
    """The sentences beside the verdict."""
    limits = Limits(case)
    if match["kept"]:
        for segment in segments(case):
            hold(least_feed(case, segment, limits) >= float(match["kept"]) * (1 - 1e-5), "too fast on", segment)
    if match["feed"]:
        lower, upper = claims.bracket(match["feed"])
        for segment in segments(case):
            hold(least_feed(case, segment, limits) >= lower * (1 - 1e-5), "too fast on", segment, "at", lower)
        at = {"kinds": (match["limit"], ), "legs": (limits.names.index(match["slowest"]), )}
        slowest = named(case, match["slowest_place"] or match["slowest_segment"])
        hold(least_feed(case, slowest, limits, **at) <= upper * 1.1, "not so fast at", upper, "on", slowest)


    if match["at_most"]:
        least = min(least_feed(case, segment, limits) for segment in segments(case))
        hold(least <= float(match["at_most"]) * 1.1, "not so fast at", match["at_most"])


def inside(case, match):
    claims.path_inside(case, match)
    told(case, match)


def leaves(case, match):
    claims.path_leaves(case, match)
    told(case, match)


def too_fast(case, match):
    """Slow enough before, and at t above the limit."""
    limits, speed, t = Limits(case), float(match["speed"]), float(match["upper"] or match["t"])
    for segment in segments(case):
        if segment[0] == (match["place"] or match["segment"]):
            break
        hold(least_feed(case, segment, limits) >= speed * (1 - 1e-5), "too fast before, on", segment)
    else:
        raise Wrong("no such segment: " + match[0])
    if match["leaves"] == "becomes":
        before = least_feed(case, segment, limits, last=max(0, float(match["t"]) - 1e-6))
        hold(before >= speed * (1 - 1e-4), "too fast before t =", t, "on", segment[0])
    leg, kind = limits.names.index(match["joint"]), match["rate"]
    value = rates_at(case, segment, t)[kind][leg] * speed**(1 if kind == "speed" else 2)
    hold(value >= limits.of[kind][leg] * (1 - 1e-4), "not too fast at t =", t, "on", segment[0])
    bound = rf"its limit of {N} m/s(?:\^2)?"
    number_or_near(match["value"], bound, value, 1e-4 * (1 + value), match["joint"])
    hold(math.isclose(limits.of[kind][leg], float(re.search(bound, match["value"])[1])), match["value"])
    told(case, match)
