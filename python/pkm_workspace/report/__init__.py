# SPDX-License-Identifier: BSD-3-Clause
"""Reports to read and to print: one file of HTML, without a network (docs/report.md).

    import pkm_workspace as pkm
    from pkm_workspace import report
    report.machine(pkm.Machine("machine.urdf"), "machine.html", psi_min=0.4)
    report.comparison([pkm.Machine("a.urdf"), pkm.Machine("b.urdf")], "comparison.html")
    report.study("designs.sqlite", "designs.html")

Keywords are conditions, tolerances and so on by the names that pkm_workspace.largest() has for them. Brackets in
tables are certified and rounded outward; pictures are drawn from floating point.
"""

from pkm_workspace.report.comparison import comparison
from pkm_workspace.report.machine import machine
from pkm_workspace.report.studies import study

__all__ = ["comparison", "machine", "study"]
