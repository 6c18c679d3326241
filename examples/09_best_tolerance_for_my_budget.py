#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Exact struts, or exact sliders? What to pay for, when a tolerance t costs 1 mm / t and 10 are to be spent."""

import pkm_workspace as pkm

BUDGET = 10.0
machine = pkm.Machine.from_numbers(machine="orthoglide")
best = None
for share in (0.1, 0.3, 0.5, 0.7, 0.9):  # of the budget, for the struts
    tolerances = {"tolerance_length": 1e-3 / (share * BUDGET), "tolerance_slider": 1e-3 / ((1 - share) * BUDGET)}
    region = pkm.largest(machine, shape="cube", accuracy=3e-4, **tolerances)
    print(f"struts to {1e3 * tolerances['tolerance_length']:.2f} mm, sliders to "
          f"{1e3 * tolerances['tolerance_slider']:.2f} mm: every such machine has a cube of {region.size:.4f} m")
    if best is None or region.size > best[0]:
        best = region.size, share, region
size, share, region = best
print(f"best: {share:.0%} of the budget for the struts, {size:.4f} m, at {region.center} m")

limit = pkm.tolerate(machine, center=region.center, sides=[size - 0.02] * 3, tolerance_length=1e-3,
                     tolerance_slider=1e-3, accuracy=0.2)
print(f"a cube 20 mm smaller holds with {limit.holds:.3f} mm of both, and fails with {limit.fails:.3f} mm")
