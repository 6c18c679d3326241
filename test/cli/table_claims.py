# SPDX-License-Identifier: BSD-3-Clause
"""What the oracle holds against sentences that are about the rows of a table."""

import math
import re
from types import SimpleNamespace

from claims import bracket, no_region, placements, region_of_words, row, without_region
from oracle import BAD, GOOD, Region
from reasons import N, Wrong, hold

REACHABLE = SimpleNamespace(psi=None, limits=False, aspect="both")


def status(case, match):
    """Where it says so, size and bound are no further apart than asked, but for their last digits."""
    accuracy = float(case.words[case.words.index("--accuracy") + 1])
    shape, machine = re.search(r"^Largest (\w+) (of machine)?", case.text).groups()
    if match[1].startswith("none") and machine and "--base-z" not in case.words:  # else the sentence says it
        size, region = without_region(case, shape)
        accuracy *= 1e-3 if "of any size" in match[1] else 1
        return no_region(case, region, accuracy / size, list(placements(case, region)))
    if match[1].startswith("none"):
        return None
    bound = re.search(rf"^  upper bound +{N}$", case.text, re.M)
    size = re.search(rf"^  (?:edge|radius|height|factor)[^\n]*  {N}$", case.text, re.M)
    if bound:
        digits = 10.0**-len(bound[1].partition(".")[2])
        hold(float(bound[1]) - float(size[1]) <= accuracy + 2 * digits, case.text)


def measures(state, leg):
    """eta of a leg over its strut, or det A over the struts, for the leg None; None out of reach."""
    if not state.in_reach:
        return None
    return state.det if leg is None else state.etas[leg]


def counted(case, points, leg):
    for point in points:
        if case.machine.verdict(point, case.criterion) != BAD:
            value = measures(case.machine.state(point), leg)
            if value is not None:
                yield abs(value)


def everywhere(case, count):
    center = without_region(case, "cube")[1].center
    span = 2 * case.machine.span
    for _ in range(count):
        yield [x + case.rng.uniform(-span, span) / 2 for x in center]


def mean(case, match):
    """Of 1 / kappa, 0 out of reach, over points that are spread evenly."""
    lower, upper = float(match["lower"]), float(match["upper"])
    region = case.region or region_of_words(case)
    points = (region.point([case.rng.random() for _ in range(3)]) for _ in range(3000)) if region else \
        everywhere(case, 4000)
    values = []
    for p in points:
        if region or case.machine.verdict(p, case.criterion) == GOOD:
            state = case.machine.state(p)
            psi = state.psi() if state.in_reach else [0, 0, 1]
            values.append(psi[0] / psi[2])
    average = sum(values) / len(values)
    error = 4 * math.sqrt(sum((x - average)**2 for x in values)) / len(values) + 1e-9
    hold(lower - error <= average <= upper + error, "samples say", average, "within", error)


def is_singular_near(case, point, leg):
    """The measure, or what its root is taken of, has both signs near the point that is told to four digits."""
    width, values = 2e-3 * case.machine.span, []
    for _ in range(300):
        state = case.machine.state([x + case.rng.uniform(-width, width) for x in point])
        if leg is not None:
            values.append(state.radicands[leg] / case.machine.span**2 if len(state.radicands) > leg else 1)
        elif state.in_reach:
            values.append(state.det / case.machine.span**3)
    hold(values and (min(values) < 0 < max(values) or min(map(abs, values)) < 1e-4), "not singular near", point)


def findings(case):
    """Rows of the table: serial or parallel, joint, what is proved, where, and bounds of the least measure."""
    rows = re.findall(r"^  (serial|parallel)(?:, (\S+))? +(.*?)  \|[^|]+\| \[m(?:\^3)?\] (.*)$", case.text, re.M)
    for kind, name, verdict, least in rows:
        place = verdict.startswith("at") and [float(x) for x in re.findall(N, verdict)]
        yield kind, name, "there" if place else verdict.strip(), place, bracket(least)


def singularities(case, match):
    region = case.region or region_of_words(case)
    points = [region.point(u) for u in region.samples(case.rng, 800)] if region else list(everywhere(case, 3000))
    rows = list(case.findings or findings(case))
    hold(len(rows) == 4, "rows of singularities:", rows)
    for kind, name, status, place, (lower, upper) in rows:
        words = f"serial .*'{name}'" if name else "parallel singularities"
        for where, text in (("there", match["there"]), ("undecided", match["open"])):
            hold(bool(re.search(words, text or "")) == (status == where), words, match[0])
        leg = [leg.name for leg in case.machine.legs[float]].index(name) if name else None
        if status == "there":
            is_singular_near(case, place, leg)
        else:
            values = list(counted(case, points, leg))
            hold(status in ("none", "undecided"), status)
            hold(not values or min(values) >= lower * (1 - 1e-9), name, "has", values and min(values), "below", lower)
            hold(status != "none" or not region or min(values) <= upper * 1.02, "nothing below", upper, values)
    if match["remark"]:
        remark_on_points(case, match["remark"], points)


def remark_on_points(case, text, points):
    """What samples prove, which come near the ends of the joint values only."""
    rhos = [state.rhos for state in map(case.machine.state, points) if state.in_reach]
    for k, leg in enumerate(case.machine.legs[float]):
        beyond = {"lower": leg.limits[0] - min(rho[k] for rho in rhos),
                  "upper": max(rho[k] for rho in rhos) - leg.limits[1]}
        for end, by in beyond.items():
            told = re.search(rf"'{leg.name}' would leave its {end} limit, {N} m, by at least {N} m", text)
            hold(told or by <= 0 or "is not proved" in text, leg.name, "leaves its", end, "limit by", by, "and:", text)
            hold(not told or float(told[2]) <= by + 0.5 * case.machine.span, text, "but it is", by)


def study(case, match):
    shape = re.search(r"^Largest (\w+)", case.text)[1]
    low, high = (float(x) for x in re.search(rf"with \S+ from {N} to {N}", case.text).groups())
    lower, upper = float(match["size"] or 0), float(match["above"])
    parameters = [low + (high - low) * k / 12 for k in range(13)]
    where = [[float(x) for x in found] for found in re.findall(rf"from {N} to {N} m", match["where"] or "")]
    center = without_region(case, shape)[1].center
    if not match["none"]:
        center = [float(x) for x in re.findall(N, match["center"])]
        best = Region(shape, [lower, lower, 0], center)
        case.machine = case.family(match["parameter"])
        hold(not best.bad(case.machine, case.criterion, case.rng), "the best machine has no such region")
    for parameter in parameters:
        case.machine = case.family(parameter)
        may = match["none"] or any(a <= parameter <= b for a, b in where)
        no_region(case, Region(shape, [1, 1, 0], center), upper if may else max(lower, 1e-9),
                  list(placements(case, Region(shape, [upper, upper, 0], center))))


def compared(case, what):
    if case.figures:
        return case.figures[what]
    match = re.search(rf"^  {re.escape(what)} +{re.escape(case.name)} +{N}(?: to {N})?  ", case.text, re.M)
    hold(match, "no row", what, case.name, case.text)
    return float(match[1]), float(match[2] or match[1])


def comparison(case, match):
    case.name = match["name"]
    case.machine, largest = case.machines[case.name], case.largest[case.name]
    case.center = [float(x) for x in re.findall(N, row(largest, "center"))]
    case.lowest = [float(re.search(rf"^  {leg.name} +{N}", largest, re.M)[1]) for leg in case.machine.legs[float]]
    compared_machine(case, match["shape"], case.name)


def compared_machine(case, shape, name):
    low, high = compared(case, shape + ": edge [m]")
    center = case.center
    region = Region(shape, [low, low, 0 if shape == "square" else low], center)
    hold(not region.bad(case.machine, case.criterion, case.rng), "the region of", name, "is not good")
    no_region(case, region, high / low, list(placements(case, region)))
    points = [region.point(u) for u in region.samples(case.rng, 300)]
    for what, legs in (("least |eta| [m] in the region", (0, 1, 2)), ("least |det A| [m^3] in the region", (None,))):
        least = min(min(counted(case, points, leg)) for leg in legs)
        lower, upper = compared(case, what)
        hold(lower <= least <= upper * 1.02, what, lower, upper, "but samples say", least)
    volume_for_strokes(case)


def volume_for_strokes(case):
    stroke = compared(case, "largest stroke, Delta rho [m]")[1]
    lower, upper = compared(case, "volume for these strokes [m^3]")
    own = SimpleNamespace(psi=None, limits=False, aspect="own")
    count, good = 6000, 0
    for point in everywhere(case, count):
        if case.machine.verdict(point, own) == GOOD:
            rhos = case.machine.state(point).rhos
            good += all(low <= rho <= low + stroke for low, rho in zip(case.lowest, rhos))
    size, share = (2 * case.machine.span)**3, good / count
    error = 4 * size * math.sqrt(max(share * (1 - share), 1 / count) / count)
    hold(lower - error <= share * size <= upper + error, "volume", lower, upper, "but samples say", share * size, error)


def evaluated(case, match):
    at = case.words.index("--point") + 1
    point = [float(x) for x in case.words[at:at + 3]]
    state, told = case.machine.state(point), match["answer"] == "yes"
    if match["what"] == "within reach":
        return hold(told == state.in_reach, "within reach:", told)
    if match["what"] == "own aspect":
        return hold(told == (state.det * case.machine.sign > 0), "own aspect:", told)
    hold(case.machine.verdict(point, case.criterion) == (GOOD if told else BAD), match["what"], told, "at", point)
    if state.in_reach:
        for value, number in zip(state.psi(), re.findall(N, row(case.text, "psi"))):
            if abs(value - float(number)) > 1e-6 * (1 + value):
                raise Wrong(f"psi is {value}, {number} is told")
