#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How the largest cube of the Orthoglide shrinks with what is asked of it."""

import pkm_workspace as pkm

machine = pkm.Machine.from_numbers(machine="orthoglide")
for said, conditions in {
    "the paper's": {},
    "condition number at most 2.5": {"kappa_max": 2.5},
    "as built, struts to 0.1 mm": {"tolerance_length": 1e-4},
    "out of a sphere about (0.3, 0.3, 0.3) m": {"keep_out": "sphere 0.3 0.3 0.3 0.1"},
    "100 N in every direction, drives of 250 N": {"tool_force_min": 100, "joint_effort_max": 250},
}.items():
    region = pkm.largest(machine, shape="cube", accuracy=1e-3, **conditions)
    print(f"{said:45} {region.size:.4f} to {region.size_upper_bound:.4f} m")
