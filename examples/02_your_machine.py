#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A linear delta from measured numbers, its largest cylinder, and its URDF in a file."""

import pathlib
import tempfile

import pkm_workspace as pkm

machine = pkm.Machine.from_numbers(linear_delta=True, rail_radius=0.130, platform_radius=0.030, length=0.269,
                                   travel=(0, 0.35))  # [m]; or Machine("machine.urdf"), Machine.from_firmware(...)
region = pkm.largest(machine, psi="auto", shape="cylinder", ratio=(0.3, 3), accuracy=5e-3)
height, radius = region.dimensions
print(f"{machine}: height {height:.4f} m, radius {radius:.4f} m, factors within {region.psi_min} and {region.psi_max}")

with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder) / "machine.urdf"
    file.write_text(machine.urdf, encoding="utf-8")
    same = pkm.largest(pkm.Machine(file), psi="auto", shape="cylinder", ratio=(0.3, 3), accuracy=5e-3)
print("the same from the file:", same.dimensions == region.dimensions)
