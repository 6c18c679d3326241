# SPDX-License-Identifier: BSD-3-Clause
"""One row for one design."""

import difflib
import time
import warnings

from pkm_workspace import core
from pkm_workspace.errors import PkmError, PkmWarning

FIGURES = ["status", "reason", "size", "size_upper_bound", "center_x", "center_y", "center_z", "stroke_1", "stroke_2",
           "stroke_3"]
VOLUMES = ["measure_lower", "measure_upper"]
DEATHS = 3  # of workers on the same design, before it is given up
OF_BODY = ("shape", "proportions", "ratio", "vertices", "seen_from")


def refuse_unknown(command, keywords):
    """At once, and not in every row."""
    known = core.keywords_of(command)
    for name in keywords:
        if name not in known:
            like = difflib.get_close_matches(name, known, 1)
            raise PkmError(f"{name}: {command} has no such keyword" + (f"; did you mean {like[0]}?" if like else ""))


class Question:
    """What is asked of every machine: the keywords of largest(); volumes: of pave(), too; guarantees: of guarantee(),
    with the quantities that are wanted, about the largest region."""

    def __init__(self, volumes=None, guarantees=None, **region):
        self.region = {"threads": 1, **region}
        self.volumes = None if volumes is None else {"threads": 1, "list_boxes": None, **volumes}
        self.guarantees = None if guarantees is None else {"threads": 1, **guarantees}
        if isinstance(self.guarantees and self.guarantees.get("quantity"), str):
            self.guarantees["quantity"] = [self.guarantees["quantity"]]
        for command, keywords in (("largest", region), ("pave", volumes or {}), ("guarantee", guarantees or {})):
            refuse_unknown(command, keywords)
        if guarantees is not None and not guarantees.get("quantity"):
            raise PkmError("guarantees: say of what, such as {'quantity': ['tool_force_min', 'stiffness_min']}")
        if guarantees is not None and region.get("turned"):
            raise PkmError("guarantees are not known of turned regions: leave out turned or guarantees")

    def describe(self):
        return {"largest": self.region, "pave": self.volumes, "guarantee": self.guarantees}

    def columns(self):
        guaranteed = [] if self.guarantees is None else self.guarantees["quantity"]
        return (FIGURES + (VOLUMES if self.volumes is not None else [])
                + [f"{name}_{end}" for name in guaranteed for end in ("lower", "upper")] + ["seconds"])

    def row(self, family, design):
        """The values of the columns. A design that there is no machine of has a status and a reason."""
        begin = time.perf_counter()
        row = dict.fromkeys(self.columns())
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", PkmWarning)
            try:
                self.fill(row, family(**design))
            except Exception as reason:  # a family is anybody's code, and a row is not the study
                text = str(reason) if isinstance(reason, PkmError) else f"{type(reason).__name__}: {reason}"
                if row["status"] is None:
                    row.update(status="refused", reason=text)
                else:
                    row["reason"] += f" Not computed: volumes or guarantees: {text}"
        row["seconds"] = time.perf_counter() - begin
        return list(row.values())

    def lost(self):
        """The row of a design that workers die of."""
        row = dict.fromkeys(self.columns())
        row.update(status="lost", reason=f"{DEATHS} workers died of it")
        return list(row.values())

    def fill(self, row, machine):
        region = core.largest(machine, **self.region)
        row.update(status=region.status, reason=region.message, size=region.size,
                   size_upper_bound=region.size_upper_bound)
        if region.center is not None:
            row.update(zip(("center_x", "center_y", "center_z"), region.center))
        for number, joint in enumerate(region.joint_ranges, 1):
            row[f"stroke_{number}"] = joint.stroke
        if self.volumes is not None:
            paving = core.pave(machine, **self.volumes)
            measure = "area" if paving.dimension == 2 else "volume"
            row.update(measure_lower=paving[measure + "_lower"], measure_upper=paving[measure + "_upper"])
        if self.guarantees is not None and region.size > 0:
            self.guarantee(row, machine, region)

    def guarantee(self, row, machine, region):
        body = {name: self.region[name] for name in OF_BODY if name in self.region}
        known = core.guarantee(machine, center=region.center, size=region.size, **{"shape": "cube", **body},
                               **self.guarantees)
        for one in known.guarantees:
            row[one.quantity + "_lower"], row[one.quantity + "_upper"] = one.value


def rows_of(family, question, designs):
    """A row for each of the designs, as (number, values)."""
    return [(number, question.row(family, design)) for number, design in designs]
