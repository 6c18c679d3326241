# SPDX-License-Identifier: BSD-3-Clause
"""The sentences of pkm that say 'proved': for each its pattern, and what the oracle holds against it."""

import math
import re
from types import SimpleNamespace

from oracle import BAD, GOOD, Region, plus
from larger import MORE, beyond, no_region, placements
from reasons import N, Wrong, hold, reason

QUALITY = r"(?:dextrous|reachable) in (?:the machine's own|the other|either|the machine's other) aspect"
BRACKET = rf"{N}(?: to {N})?"


class Case(SimpleNamespace):
    """What is told, and what it is about: machine, rng, text, words of the command; for the node in place of words what
    was asked for, and in place of rows of the text the fields of the answer."""

    words = ()
    definition = None  # a text with the criterion
    region = size = bad_point = point = None
    segments = None  # of a path: name, start, end
    place = None  # of a path that is moved
    tool_speed = None  # along it, and the accelerations that are allowed there
    joint_acceleration_max = math.inf
    findings = None  # on singularities: serial or parallel, joint or "", status, point or None, bounds of the least
    figures = center = lowest = None  # of a comparison: label to bounds; of its region, and its least joint values


def criterion_of(text):
    """As the text defines it, in the words of the command or in those of the node."""
    text = " ".join(text.split())
    match = re.search(rf"(?:dextrous with psi in \[{N}, {N}\]|reachable), (own|other|both) aspects?, "
                      "joint limits (on|off)", text)
    if match:
        return SimpleNamespace(aspect=match[3], limits=match[4] == "on",
                               psi=match[1] and (float(match[1]), float(match[2])))
    match = re.search(r"(Dextrous|Reachable): .*?, in (its own|its other|either) aspect(.*)", text)
    hold(match, "no definition in", text)
    factors = re.search(rf"velocity transmission factors in \[{N}, {N}\]", match[3])
    hold((match[1] == "Dextrous") == bool(factors), match[3])
    hold(not re.search("force transmission|condition number", match[3]), "the oracle does not know", match[3])
    return SimpleNamespace(aspect=match[2].split()[-1].replace("either", "both"), limits="within the joint" in match[3],
                           psi=factors and (float(factors[1]), float(factors[2])))


def row(text, label):
    match = re.search(rf"^  {re.escape(label)}  +(.*)$", text, re.M)
    hold(match, "no row", label, "in", text)
    return match[1].strip()


def numbers(text):
    return [float(x) for x in re.findall(N, text)]


def bracket(text):
    found = re.match(BRACKET, text)
    return float(found[1]), float(found[2] or found[1])


def all_good(case, region, count=300):
    for u in region.samples(case.rng, count):
        point = region.point(u)
        hold(case.machine.verdict(point, case.criterion) != BAD, "the point", point, "is bad")


def found_region(case, shape):
    if case.region:
        return case.size, case.region
    size = float(re.search(rf"^  (?:edge|radius|height|factor) .*?  {N}$", case.text, re.M)[1])
    angle = re.search(rf"^  turned by +{N} rad", case.text, re.M)
    return size, Region(shape, numbers(row(case.text, "dimensions")), numbers(row(case.text, "center")),
                        angle and float(angle[1]))


def without_region(case, shape):
    """Where nothing is found: a region of size 1 at the tool point of the zero configuration."""
    sides = {"square": [1, 1, 0], "sphere": [1], "disc": [0, 1]}.get(shape, [1, 1, 1])
    legs = case.machine.legs[float]
    return 1, Region(shape, sides, plus(legs[0].c, legs[0].zero))


def largest(case, match):
    shape, found = match["shape"], bool(match["first"])
    size, region = (found_region if found else without_region)(case, shape)
    if found:
        hold((region.angle is not None) == bool(match["turned"]), match[0], "is turned by", region.angle)
        all_good(case, region)
    elif match["turned"]:
        region.angle = 0.0
    centers = list(placements(case, region))
    if match["where"] == "with this center":
        centers = [numbers(" ".join(case.words[case.words.index("--center") + 1:][:3]))]
    elif match["where"].endswith("in the search box"):
        at = case.words.index("--search-box") + 1
        ends = [float(x) for x in case.words[at:at + 6]]
        centers = [[case.rng.uniform(ends[k], ends[k + 1]) for k in (0, 2, 4)] for _ in range(20)]
    if "--ratio" in case.words:
        ends = case.words[case.words.index("--ratio") + 1:][:2]
        hold(match["volume"] or ends[0] == ends[1], "of free ratios a higher cylinder may be the smaller one")
    if match["any"]:
        measures = numbers(match["given"])
        hold(not found and measures, "a size of 0 is no region")
        region.dimensions = [1e-6, *measures] if "radius" in match["given"] else [*measures, 1e-6]
        return no_region(case, region, 1, centers, match)
    if match["size"]:
        hold(not found or float(match["size"]) >= size, "the bound is below the size")
        if size == 0:  # less than the digits that are printed
            size, region = 1, Region(shape, without_region(case, shape)[1].dimensions, region.center, region.angle)
        return no_region(case, region, beyond(float(match["size"]), size), centers, match)
    return large_cylinder(case, match, centers)


def large_cylinder(case, match, centers):
    volume = float(match["volume"])
    for k, center in enumerate(centers):
        ratio = float(match["from"]) + (float(match["to"]) - float(match["from"])) * (k % 5) / 4
        height = (volume / math.pi / ratio**2)**(1 / 3)
        no_region(case, Region("cylinder", [height, ratio * height], center), 1, [center], match)


def body_of(case):
    match = re.search(rf", (\w+) with center \({N}, {N}, {N}\) m, (sides|radius|height) (.*? m)$", case.text, re.M)
    return Region(match[1], numbers(match[6]), [float(x) for x in match.groups()[1:4]])


def region_of(case):
    """What a sentence on a region is about: what was asked for, or the body that the text names."""
    return case.region or body_of(case)


def inside(case, match):
    all_good(case, region_of(case), 600)


def bad_point_of(case):
    point = case.bad_point or numbers(row(case.text, "bad point"))
    hold(region_of(case).contains(point), point, "is not in the region")
    return point


def bad_point(case, match):
    point = bad_point_of(case)
    hold(case.machine.verdict(point, case.criterion) == BAD, point, "is not bad")
    for text in match["reasons"].split("; "):
        reason(case, text, point)


def point_of(case):
    """What was asked for, or the tool point that the text names."""
    return case.point or numbers(re.search(r"at the tool point (\(.*?\)) m", case.text)[1])


def good_point(case, match):
    point = point_of(case)
    hold(case.machine.verdict(point, case.criterion) == GOOD, point, "is not good")
    reason(case, match["limit"], point)
    if match["remark"]:
        remark_on(case, match["remark"], [(rho, rho) for rho in case.machine.state(point).rhos])


def no_good_point(case, match):
    point = point_of(case)
    hold(case.machine.verdict(point, case.criterion) == BAD, point, "is not bad")
    for text in match["reasons"].split("; "):
        reason(case, text, point)


def singular_point(case, match):
    """Between the bad point and another one so near, det A vanishes: it is next to nothing all around."""
    point, within = bad_point_of(case), float(match["within"])
    state = case.machine.state(point)
    scale = math.prod(leg.length for leg in case.machine.legs[float])
    hold(within < 1e-9 and abs(state.det) <= (1e-9 + 10 * within) * scale, "det A is", state.det, "at", point)


def shares(case, match):
    ends = numbers(match["lower"]) + numbers(match["upper"])
    sides, carry = numbers(match["sides"]), set()
    for k in range(24):
        u = [k & 1, k >> 1 & 1, k >> 2 & 1] if k < 8 else [case.rng.random() for _ in range(3)]
        center = [low + x * (high - low) for x, low, high in zip(u, ends[:3], ends[3:])]
        carry.add(Region("box", sides, center).bad(case.machine, case.criterion, case.rng, 60) is None)
    told = {"all": {True}, "none": {False}, "some": {True, False}}[match["share"]]
    hold(carry == told, match["share"], "is told, samples say", carry)


def segments(case):
    """Each with its name: name, start, end."""
    if case.segments:
        return case.segments
    lines = [case.words[k + 1] for k, word in enumerate(case.words) if word == "--segment"]
    points = [numbers(line) for line in lines]
    return [(lines[k + 1], points[k], points[k + 1]) for k in range(len(points) - 1)]


def on(segment, t):
    return plus(segment[1], plus(segment[2], segment[1], -1), t)


def verdicts(case, segment, first, last, count=300, open_at=()):
    return {case.machine.verdict(on(segment, first + (last - first) * k / count), case.criterion)
            for k in range(count + 1) if all(abs(first + (last - first) * k / count - t) > 1e-4 for t in open_at)}


def path_inside(case, match):
    for segment in segments(case):
        hold(BAD not in verdicts(case, segment, 0, 1), "a point of", segment, "is bad")
    if match["remark"]:
        rhos = [case.machine.state(on(segment, k / 100)).rhos for segment in segments(case) for k in range(101)]
        remark_on(case, match["remark"], [(min(rho), max(rho)) for rho in zip(*rhos)])


def path_leaves(case, match):
    """Good before, but for what is said to be open; bad within the digits of the place, where the reason holds."""
    t, upper = float(match["t"]), float(match["upper"] or match["t"])
    width = 2 * 10.0**-len(match["t"].partition(".")[2]) if not match["upper"] else 0.0
    open_at = numbers((match["open"] or "").replace("t = ", ""))
    for segment in segments(case):
        last = segment[0] == (match["place"] or match["segment"])
        end = max(0, t - width) if last else 1
        if match["leaves"] == "leaves the set" and (end > 0 or not last):
            hold(BAD not in verdicts(case, segment, 0, end, open_at=open_at), "bad before t =", t, "on", segment[0])
        if last:
            break
    else:
        raise Wrong("no such segment: " + match[0])
    points = [on(segment, min(1, max(0, x))) for x in (t - width, t, upper, upper + width)]
    hold(any(case.machine.verdict(point, case.criterion) == BAD for point in points), "no bad point near t =", t)
    reason(case, match["reason"], on(segment, upper), slack=1e-4 if not match["upper"] else 1e-2)


def volume(case, match):
    ends = numbers(row(case.text, "box"))
    flat = sum(a < b for a, b in zip(ends[:3], ends[3:]))
    hold(match["measure"] == {3: "volume", 2: "area"}[flat], match["measure"])
    measured(case, *bracket(match["bracket"]), ends)


def measured(case, lower, upper, ends):
    """The measure of the good points between two corners is within these bounds."""
    sides = [b - a for a, b in zip(ends[:3], ends[3:])]
    size, count = math.prod(side for side in sides if side > 0), 4000
    good = sum(case.machine.verdict([a + case.rng.random() * side for a, side in zip(ends, sides)],
                                    case.criterion) == GOOD for _ in range(count))
    share = good / count
    error = 4 * size * math.sqrt(max(share * (1 - share), 1 / count) / count)
    hold(lower - error <= share * size <= upper + error, lower, "to", upper, "but samples say", share * size)


def region_of_words(case):
    """The box-like region that --shape, --center and --size give, or None."""
    if "--size" not in case.words:
        return None
    words = [str(word) for word in case.words]
    value = lambda name, k=1: float(words[words.index(name) + k])
    shape, size = words[words.index("--shape") + 1], value("--size")
    sides = {"square": [size, size, 0], "sphere": [size], "disc": [0, size]}.get(shape, [size] * 3)
    return Region(shape, sides, [value("--center", k) for k in (1, 2, 3)])


def remark(case, match):
    """On limits that are not asked for, with the region that is proved to be good."""
    inside(case, match)
    remark_on(case, match["remark"], spans(case, region_of(case)))


def spans(case, region):
    """Least and largest joint value of each leg over a region."""
    return [region.span(lambda p, k=k: case.machine.state(p).rhos[k], case.rng) for k in range(3)]


def remark_on(case, text, reaches):
    """@param reaches least and largest joint value of each leg"""
    for leg, (low, high) in zip(case.machine.legs[float], reaches):
        beyond = {"lower": leg.limits[0] - low, "upper": high - leg.limits[1]}
        for end, by in beyond.items():
            told = re.search(rf"'{leg.name}' would leave its {end} limit, {N} m, by at least {N} m", text)
            slack = 0.02 * (high - low) + 1e-12
            hold(told or by <= slack, leg.name, "leaves its", end, "limit by", by, "and nothing is told")
            hold(not told or float(told[2]) <= by + slack, text, "but it is", by)
