# SPDX-License-Identifier: BSD-3-Clause
"""The report of a study: its table, size over each parameter, Pareto front, sensitivity."""

import numpy as np

from pkm_workspace.errors import PkmError
from pkm_workspace.report import plots
from pkm_workspace.report.numbers import bracket, in_words, number, rounded_down, rounded_up
from pkm_workspace.report.page import Page
from pkm_workspace.study.table import count_of, read, told_of

MOST_ROWS = 2000  # of the table in the page


def study(table, path):
    """Writes the report of a study from its table (a file of SQLite)."""
    names, rows = read(table)
    told = told_of(table)
    parameters = [name for name in names[1:] if name not in told["columns"]]
    data = {name: [row[k] for row in rows] for k, name in enumerate(names)}
    found = [k for k in range(len(rows)) if data["size"][k]]
    if not found:
        raise PkmError(f"{table}: no design has a region: there is nothing to report")
    page = Page("Study", f"{len(rows)} of {count_of(table)} designs are evaluated. Family: {in_words(told['family'])}. "
                f"Asked: {in_words(told['question'])}.")
    add_best(page, data, parameters, found)
    add_parameters(page, data, parameters, found)
    add_front(page, data, found)
    add_sensitivity(page, data, parameters, found)
    add_table(page, names, rows)
    page.save(path)


def add_best(page, data, parameters, found):
    page.section("The best designs")
    best = sorted(found, key=lambda k: -data["size"][k])[:10]
    bounds = [bound for bound in data["size_upper_bound"] if bound is not None]
    unknown = len(data["size"]) - len(bounds)
    page.text(f"{len(found)} of the designs that are evaluated have a region. None of "
              + (f"the {len(bounds)} that are answered" if unknown else "them")
              + f" has one larger than {rounded_up(max(bounds))} m, proved. Nothing is said of machines between designs"
              + (f", nor of {unknown} designs that were refused." if unknown else "."))
    page.table(["design", *parameters, "size"],
               [[data["design"][k], *(number(data[name][k]) for name in parameters),
                 bracket(data["size"][k], data["size_upper_bound"][k], "m")] for k in best])


def numeric(data, names, found):
    """Those of the names that are numbers and differ."""
    return [name for name in names if all(isinstance(data[name][k], (int, float)) for k in found)
            and len({data[name][k] for k in found}) > 1]


def add_parameters(page, data, parameters, found):
    page.section("Size over each parameter")
    for name in numeric(data, parameters, found):
        page.figure(plots.scatter([data[name][k] for k in found], [data["size"][k] for k in found],
                                  [data["size_upper_bound"][k] for k in found], name, "size [m]"),
                    f"Each point is a design: what is proved of it (blue), and up to where its region may be larger "
                    f"(orange), over {name}.")


def stroke_of(data, k):
    strokes = [data[f"stroke_{leg}"][k] for leg in (1, 2, 3)]
    return sum(strokes) if all(stroke is not None for stroke in strokes) else None


def add_front(page, data, found):
    known = sorted((k for k in found if stroke_of(data, k) is not None),
                   key=lambda k: (stroke_of(data, k), -data["size"][k]))
    if len(known) < 2:
        return
    front, largest = [], -1.0
    for number_, k in enumerate(known):
        if data["size"][k] > largest:
            largest = data["size"][k]
            front.append(number_)
    page.section("Size against stroke")
    page.figure(plots.scatter([stroke_of(data, k) for k in known], [data["size"][k] for k in known],
                              [data["size_upper_bound"][k] for k in known], "sum of the three strokes, each in the unit of its joint", "size [m]",
                              marked=front),
                "Green: the Pareto front. No other design has a larger certified region with shorter strokes.")


def ranks(values):
    order = np.argsort(values, kind="stable")
    result = np.empty(len(values))
    result[order] = np.arange(len(values))
    for value in np.unique(values):
        same = np.asarray(values) == value
        result[same] = result[same].mean()
    return result


def add_sensitivity(page, data, parameters, found):
    names = numeric(data, parameters, found)
    if not names or len(found) < 3 or len({data["size"][k] for k in found}) < 2:
        return
    sizes = ranks([data["size"][k] for k in found])
    values = [float(np.corrcoef(ranks([data[name][k] for k in found]), sizes)[0, 1]) for name in names]
    page.section("Sensitivity")
    page.figure(plots.signed_bars(names, values, "rank correlation with the size [1]"),
                "Spearman's rank correlation of each parameter with the certified size: 1 where the size grows with it, "
                "-1 where it falls, near 0 where it hardly matters or goes up and down.")


def add_table(page, names, rows):
    page.section("All designs")
    if len(rows) > MOST_ROWS:
        page.text(f"The first {MOST_ROWS} of {len(rows)} rows; pkm study --export has all of them.", note=True)
    page.table(names, [[shown(name, value) for name, value in zip(names, row)] for row in rows[:MOST_ROWS]],
               sortable=True)


def shown(name, value):
    """What is certified is rounded outward."""
    if not isinstance(value, (int, float)):
        return "" if value is None else value
    if name == "size" or name.endswith("_lower"):
        return rounded_down(value), value
    return (rounded_up(value) if name.endswith(("_upper", "_upper_bound")) else number(value, digits=6)), value
