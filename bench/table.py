#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what pkm_workspace_bench measured as one table: table.py FILE.json... [--markdown] [--compiler TEXT]

Times are medians of the repetitions. Fails when two rows of one case contradict each other about the largest region.
"""

import argparse
import collections
import json
import pathlib
import re
import statistics
import sys

HEADINGS = ("case", "accuracy", "way", "boxes of centers", "boxes of points", "time [ms]", "times ours", "notes")
RIGHT = {3, 4, 5, 6}
KNOWN = {"name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions", "repetition_index",
         "threads", "iterations", "real_time", "cpu_time", "time_unit", "error_occurred", "error_message", "label",
         "aggregate_name", "aggregate_unit", "size", "upper", "centers", "points"}
EXPLANATION = """Times ours: how many times the time of the first row of the same case and accuracy, in the same run.
The paper's algorithm and "list, eigenvalues" come to their accuracy in steps of one digit from 0.1, counted together.
"list, minors" does so at once and decides the same Weyl/Rohn test without computing eigenvalues.
Left out for the Orthoglide's cube, as taking minutes: the polynomial as written at all of these accuracies,
the polynomial with derivatives at 1e-7."""


def rows_of(runs):
    """Yields case, accuracy, way and the repetitions of each row, in order."""
    rows = collections.OrderedDict()
    for run in runs:
        if run["run_type"] == "iteration":
            rows.setdefault(tuple(re.sub(r"(/[a-z_]+(:[0-9.]+)?)+$", "", run["name"]).split("|")), []).append(run)
    return rows.items()


def number(value, digits=3):
    """Text with that many significant digits, and no fewer than those before the point."""
    return f"{value:.0f}" if value >= 10 ** digits else f"{value:.{digits}g}"


def cells(key, runs, baseline):
    first = runs[0]
    if first.get("error_occurred"):
        return [*key, "", "", "", "", first["error_message"]]
    time = statistics.median(run["real_time"] for run in runs)
    notes = {name: statistics.median(run[name] for run in runs) for name in first if name not in KNOWN}
    counts = [f"{first[name]:.0f}" if name in first else "" for name in ("centers", "points")]
    ratio = number(time / baseline.setdefault(key[:2], time))
    return [*key, *counts, number(time), ratio, ", ".join(f"{name} {number(notes[name], 4)}" for name in notes)]


def contradictions(rows):
    """Yields the cases of which two rows have no size of the largest region in common."""
    brackets = {}
    for (case, *_), (run, *_) in rows:
        if "size" in run and not run.get("error_occurred"):
            lower, upper = brackets.get(case, (0.0, float("inf")))
            brackets[case] = max(lower, run["size"]), min(upper, run["upper"])
    return [case for case, (lower, upper) in brackets.items() if lower > upper]


def processor():
    found = re.search(r"^model name\s*:\s*(.*)$", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    return found.group(1) if found else "unknown processor"


def show(table, markdown):
    widths = [max(len(line[column]) for line in table) for column in range(len(HEADINGS))]
    for place, line in enumerate(table):
        padded = [text.rjust(width) if column in RIGHT else text.ljust(width)
                  for column, (text, width) in enumerate(zip(line, widths))]
        print("| " + " | ".join(padded) + " |" if markdown else "  ".join(padded).rstrip())
        if markdown and place == 0:
            print("|" + "|".join("-" * (w + 1) + (":" if c in RIGHT else "-") for c, w in enumerate(widths)) + "|")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", type=pathlib.Path, nargs="+")
    parser.add_argument("--markdown", action="store_true")
    parser.add_argument("--compiler", default="unknown compiler")
    options = parser.parse_args()
    texts = [file.read_text(encoding="utf-8") for file in options.files]
    measured = [json.loads(text) for text in texts if text]  # empty where a filter leaves nothing
    if not measured:
        sys.exit("nothing was measured")
    rows, baseline = list(rows_of(run for file in measured for run in file["benchmarks"])), {}
    print(f"{processor()}, {measured[0]['context']['num_cpus']} processors; {options.compiler}; Release; one thread "
          "but where a row says otherwise.\n")
    show([HEADINGS, *(cells(key, runs, baseline) for key, runs in rows)], options.markdown)
    print("\n" + EXPLANATION)
    wrong = contradictions(rows)
    sys.exit("rows contradict each other: " + ", ".join(wrong) if wrong else 0)


if __name__ == "__main__":
    main()
