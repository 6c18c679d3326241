# SPDX-License-Identifier: BSD-3-Clause
"""What the oracle holds against sentences on components and paths: good points, and a flood of them on a grid."""

import re

from claims import QUALITY, numbers, row
from oracle import BAD, GOOD, plus
from reasons import hold

COMPONENTS = (r"Proved: the boxes inside form (?P<count>\d+) connected components?(?:, and no path in the (?:set|part "
              r"of the set in the box) joins any two of the (?P<clusters>\d+) clusters that these form)?\."
              r"(?: Undecided boxes may join components of one cluster: a finer resolution may settle that\.)?"
              r" The zero configuration is (?:in component (?P<zero>\d+)|not in the set|in no box .*)\.")
CONNECTED = (r"Proved: the points are connected, and every point of the path of (?P<lines>\d+) lines? that joins them "
             rf"is {QUALITY}\.")
APART = rf"Proved: the points are apart\. Both are {QUALITY}, and no path in the set joins them\."
STEPS = 20  # of the flood, in a length of the machine


def flood(case, start):
    """Steps from a good point to all others that good points lead to, along the axes."""
    size = case.machine.span / STEPS
    good = lambda point: case.machine.verdict(point, case.criterion) == GOOD
    at = lambda step: [x + size * k for x, k in zip(start, step)]
    seen, queue = {(0, 0, 0)}, [(0, 0, 0)]
    while queue:
        step = queue.pop()
        for axis in range(3):
            for way in (1, -1):
                there = tuple(k + way * (axis == i) for i, k in enumerate(step))
                middle = [x + 0.5 * size * way * (axis == i) for i, x in enumerate(at(step))]
                if there not in seen and max(map(abs, there)) <= 3 * STEPS and good(at(there)) and good(middle):
                    seen.add(there)
                    queue.append(there)
    return seen, size


def joined(case, start, end):
    """Whether the flood from one good point comes next to the other, and a good line leads there."""
    seen, size = flood(case, start)
    near = tuple(round((y - x) / size) for x, y in zip(start, end))
    if near not in seen:
        return False
    corner = [x + size * k for x, k in zip(start, near)]
    return all(case.machine.verdict(plus(corner, plus(end, corner, -1), t / 20), case.criterion) == GOOD
               for t in range(21))


def components(case, match):
    pattern = r"(?m)^  (\d+ +\d+ +\S+ m\^[23] +\d+ +\(.*)"
    rows = [line.split(None, 2) for line in re.findall(pattern, case.text)]
    hold(len(rows) == min(10, int(match["count"])), match[0], "but the table has", len(rows))
    pieces(case, match, [(line[1], numbers(line[2][line[2].index("("):])[:3]) for line in rows], len(rows) == 10)


def pieces(case, match, rows, are_some):
    """rows: the cluster of each component, and a point in it; are_some: there may be more of them"""
    told = {cluster for cluster, _ in rows}
    hold(are_some or len(told) == int(match["clusters"] or 1), match[0], "but there are", told)
    for _, point in rows:
        hold(case.machine.verdict(point, case.criterion) == GOOD, point, "is not good")
    for cluster, point in rows[1:3]:
        if rows[0][0] != cluster:
            hold(not joined(case, rows[0][1], point), "a flood joins", rows[0][1], point)


def connected(case, match):
    path = [numbers(line) for line in re.findall(r"(?m)^  path +(\(.*\)) m$", case.text)]
    way(case, match, path, numbers(row(case.text, "from")), numbers(row(case.text, "to")))


def way(case, match, path, first, last):
    hold(len(path) == int(match["lines"]) + 1, match[0], "but there are", len(path), "points")
    hold(path[0] == first and path[-1] == last, "another path")
    for start, end in zip(path, path[1:]):
        for t in range(101):
            point = plus(start, plus(end, start, -1), t / 100)
            hold(case.machine.verdict(point, case.criterion) != BAD, point, "is bad")


def apart(case, match):
    part(case, *(numbers(row(case.text, label)) for label in ("from", "to")))


def part(case, start, end):
    for point in (start, end):
        hold(case.machine.verdict(point, case.criterion) == GOOD, point, "is not good")
    hold(not joined(case, start, end), "a flood joins the points")
