#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The largest cube in which the paper's Orthoglide is certain to behave well."""

import pkm_workspace as pkm

machine = pkm.Machine.from_numbers(machine="orthoglide")  # struts of 1 m
region = pkm.largest(machine, shape="cube", accuracy=1e-4)

print(f"edge: proved {region.size:.5f} m, none is above {region.size_upper_bound:.5f} m; center {region.center} m")
for joint in region.joint_ranges:
    print(f"{joint.joint}: {joint.lower:.4f} to {joint.upper:.4f} {joint.unit}")
