# SPDX-License-Identifier: BSD-3-Clause
"""The report of machines side by side."""

from pkm_workspace import core
from pkm_workspace.errors import PkmError
from pkm_workspace.report import plots
from pkm_workspace.report.machine import meaning, said
from pkm_workspace.report.numbers import bracket, number, rounded_up
from pkm_workspace.report.page import Page


def comparison(machines, path, *, shape="cube", **criterion):
    """Writes the report of two machines or more, compared by their largest regions of a shape."""
    machines = list(machines)
    if len(machines) < 2:
        raise PkmError("a comparison needs two machines or more")
    answers = core.compare(*machines, shape=shape, **criterion).machines
    first = answers[0]
    page = Page("Machines compared", f"by the largest {shape}; {said(first, criterion)}")
    names = [f"{number_} {answer.machine}" for number_, answer in enumerate(answers, 1)]
    page.section("Size")
    page.table(["machine", meaning(first), "volume", "center [m]", "status"],
               [[name, bracket(answer.size, answer.size_upper_bound, "m"),
                 bracket(answer.volume, answer.volume_upper_bound, "m³") if answer.get("volume") else "",
                 ", ".join(number(x, digits=4) for x in answer.center or []), answer.status]
                for name, answer in zip(names, answers)], sortable=True)
    page.figure(plots.bars(names, [answer.size or 0.0 for answer in answers],
                           [answer.size_upper_bound or 0.0 for answer in answers], f"{meaning(first)} [m]"),
                "Blue: the certified region. Orange: up to where there may be a larger one.")
    page.section("Strokes")
    page.text("Ranges that hold the region, all of the longest stroke of their machine.")
    page.table(["machine", "joint", "range", "stroke"],
               [[name, joint.joint, bracket(joint.lower, joint.upper), rounded_up(joint.upper - joint.lower)]
                for name, answer in zip(names, answers) for joint in answer.joint_ranges or []])
    page.section("What these strokes allow")
    page.text("Brackets for each machine; scaled: as if the region had the size 1.", note=True)
    keys = dict.fromkeys(key for answer in answers for key in answer.get("figures") or {})
    page.table(["figure", *names, *(f"{name}, scaled" for name in names)],
               [[key.replace("_", " "), *(shown(answer.get("figures"), key) for answer in answers),
                 *(shown(answer.get("scaled"), key) for answer in answers)] for key in keys])
    page.save(path)


def shown(figures, key):
    value = (figures or {}).get(key)
    return bracket(*value) if isinstance(value, (list, tuple)) and len(value) == 2 else number(value)
