# SPDX-License-Identifier: BSD-3-Clause
"""Studies of many machines: one row for each design, in a file that can be gone on with (docs/study.md).

    from pkm_workspace import study
    designs = study.grid(rail_radius=(0.4, 0.6, 100), platform_radius=[0.05, 0.1])
    study.run(study.Catalogue(machine="uranesx"), designs, "uranesx.sqlite", shape="square", accuracy=1e-4)
    study.export("uranesx.sqlite", "uranesx.csv")
"""

import os
import time

from pkm_workspace.errors import PkmError
from pkm_workspace.study.designs import checked, grid, sample
from pkm_workspace.study.evaluate import Question
from pkm_workspace.study.export import export
from pkm_workspace.study.families import Catalogue, Files, Function, Mixture, family_of
from pkm_workspace.study.table import Table, read
from pkm_workspace.study.workers import Dask, Local

__all__ = ["Catalogue", "Files", "Function", "Mixture", "export", "grid", "read", "run", "sample"]


def run(family, designs, table, *, workers=None, scheduler=None, progress=None, volumes=None, guarantees=None,
        **question):
    """Evaluates every design that has no row in the table yet. Returns how many rows were written.

    family: a function that returns a Machine, by the names of the parameters; or Catalogue, Mixture, Files
    designs: a list of dictionaries: a list of yours, grid(...), sample(...)
    table: a file of SQLite; one that is there is gone on with
    workers: processes of this machine; without it, one for each processor
    scheduler: the address of Dask's scheduler, whose workers compute in place of these
    progress: called with the numbers of rows done and of all, and the seconds since the start
    volumes, guarantees: keywords of pave() and guarantee() (with quantity), for more columns
    question: the keywords of largest()
    """
    if workers is not None and not (isinstance(workers, int) and workers >= 1):
        raise PkmError(f"workers = {workers!r}: must be a whole number from 1")
    family, question = family_of(family), Question(volumes, guarantees, **question)
    rows_by = Table(table, family, question, checked(designs))
    try:
        missing = rows_by.missing()
        return finish(family, question, rows_by, missing, workers, scheduler, progress) if missing else 0
    finally:
        rows_by.close()


def finish(family, question, rows_by, missing, workers, scheduler, progress):
    begin = time.monotonic()
    crew = Dask(family, question, scheduler) if scheduler else Local(family, question,
                                                                     workers or len(os.sched_getaffinity(0)))
    written, all_of_them = 0, len(rows_by.designs)
    for rows in crew.rows(missing):
        written += rows_by.add(rows)
        if progress:
            progress(all_of_them - len(missing) + written, all_of_them, time.monotonic() - begin)
    return written
