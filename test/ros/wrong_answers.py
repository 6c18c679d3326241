# SPDX-License-Identifier: BSD-3-Clause
"""For each claim of the node what would be wrong: the oracle has to object to each of these at least once."""

import copy

from claims import Case
from spoils import instead, times


def changed(case, **what):
    return Case(**{**vars(case), **what})


def said(spoil):
    """Another text."""
    return lambda case: changed(case, text=spoil(case.text))


def answered(change):
    """Other fields beside it."""
    def spoil(case):
        answer = copy.deepcopy(case.answer)
        change(answer)
        return changed(case, answer=answer)
    return spoil


def swap(one, other):
    """Two fields, or the bounds in a field: "limit.value.lower"."""
    def change(answer):
        first, second = read(answer, one), read(answer, other)
        write(answer, one, second)
        write(answer, other, first)
    return answered(change)


def read(message, path):
    for name in path.split("."):
        message = message[int(name)] if name.isdigit() else getattr(message, name)
    return message


def write(message, path, value):
    way, _, last = path.rpartition(".")
    holder = read(message, way) if way else message
    if last.isdigit():
        holder[int(last)] = value
    else:
        setattr(holder, last, value)


def field(name, factor):
    return answered(lambda answer: setattr(answer, name, factor * getattr(answer, name)))


def larger(answer):
    answer.solid.dimensions = [1.5 * x for x in answer.solid.dimensions]


def without_status(answer):
    answer.status = 7


def narrower(answer):
    for bounds in (*answer.motion.psi, *answer.motion.joints):
        bounds.upper = bounds.lower


def slower(answer):
    answer.motion.joint_speeds = [0.5 * x for x in answer.motion.joint_speeds]


def faster(answer):
    for feed in (answer.rates.feed, *answer.rates.segment_feeds):
        feed.lower, feed.upper = 1.1 * feed.lower, 1.1 * feed.upper


def gentler(answer):
    answer.rates.accelerations = [0.5 * x for x in answer.rates.accelerations]


def figures(label):
    def change(answer):
        for figure in answer.machines[0].figures:
            if figure.label.startswith(label):
                figure.value.lower, figure.value.upper = 9 * figure.value.lower, 9 * figure.value.upper
    return answered(change)


def elsewhere(case):
    """Each ball of a marker."""
    markers = copy.deepcopy(case.markers)
    for marker in markers:
        marker.pose.position.x += 0.3 * case.machine.span
    return changed(case, markers=markers)


def many_times(case):
    markers = copy.deepcopy(case.markers)
    for marker in markers:
        marker.scale.x, marker.scale.y = 99 * marker.scale.x, 99 * marker.scale.y
    return changed(case, markers=markers)


def at_a_good_point(case):
    leg = case.machine.legs[float][0]
    return changed(case, bad_point=[x + y for x, y in zip(leg.c, leg.zero)])


def in_a_large_region(case):
    return changed(case, region=case.region.scaled(9, case.region.center))


OTHER_SIDE = said(lambda text: text.replace("above", "ABOVE").replace("below", "above").replace("ABOVE", "below"))
REGION = (answered(larger), field("size_upper_bound", 0.7), swap("center.x", "size"),
          said(instead(r"off: .* leave.*", "off: all rails stay within their limits.")),
          swap("joint_ranges.0.lower", "joint_ranges.0.upper"), field("volume", 1.1), answered(without_status))
MEASURE = said(times("have an? (?:volume|area) of ", 3))
WRONG = {
    "inside": (in_a_large_region, field("verdict", 2)),
    "remark": (said(instead(r"Joint limits are off: .*", "Joint limits are off: 'rail_1' would leave its upper limit, "
                            "0.2 m, by at least 99 m.")), ),
    "bad point": (at_a_good_point, said(instead(r"aspect: [^;]*", "aspect: it is ugly"))),
    "singular point": (at_a_good_point, said(times("no further than ", 1e12))),
    "nothing": (field("verdict", 0), ),
    "path inside": (answered(narrower), answered(slower), field("verdict", 2)),
    "path too fast": (swap("limit.value", "limit.margin"), said(times("t = ", 0.5)), field("verdict", 0),
                      answered(faster), answered(gentler), said(times("feed is proved to be ", 2))),
    "placement": (said(times("up to (?=\\S+ m along)", 1.3)), said(times("has a margin above ", 0.4)),
                  said(times("at all scales from [01] to ", 1.2)), said(times("allows one above ", 0.7)),
                  lambda case: changed(case, place=[9 * x + 1 for x in case.place])),
    "path leaves": (swap("good_until", "bad_at"), swap("limit.value", "limit.margin"), said(times("t = ", 0.9)),
                    said(times("t = ", 1.1)), OTHER_SIDE),
    "region": REGION,
    "no region": (said(instead(".*", "Proved to the accuracy asked for.")), field("status", 0)),
    "wide": REGION[:1],
    "good point": (OTHER_SIDE, swap("psi.0", "psi.2"), swap("limit.value", "limit.margin"), field("verdict", 2)),
    "no good point": (OTHER_SIDE, swap("limit.value", "limit.margin"), field("verdict", 2)),
    "mean": (said(times("from ", 1.5)), swap("index.lower", "index.upper"), field("complete", 0)),
    "no mean": (swap("index.lower", "index.upper"), ),
    "set": (field("volume_lower_bound", 3), swap("inside", "boundary"), field("complete", 0), MEASURE),
    "singularities": (said(instead("there are .*, and no", "there are no")),
                      said(instead("Joint limits are off: .*", "Joint limits are off: 'rail_x' would leave its upper "
                                   "limit, 0.2 m, by at least 99 m.")), lambda case: changed(
        case, findings=[(*row[:2], "there" if row[2] == "none" else "none", *row[3:]) for row in case.findings])),
    "comparison": (figures("cube"), figures("volume for these"), figures("least |eta|")),
    "region told": (said(times("of a size above ", 0.7)), said(times(r"at \(", 9)), said(times("dimensions ", 1.5))),
    "set told": (MEASURE, ),
    "label": (said(times(r"\w+ (?:of radius )?", 1.2)), ),
    "stroke": (said(times(r"^\w+\n", 0.5)), ),
    "caption": (said(instead("own aspect|both aspects", "other aspect")), ),
    "box inside": (many_times, said(times("^", 2))),
    "box outside": (elsewhere, said(times("^", 2))),
    "kind": (elsewhere, ),
    "tool": (said(times(r"(?:of|reaches|is) ", 1.5)), ),
}
