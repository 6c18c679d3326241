#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A family of machines is a function of Python: the largest square of a linear delta over its radius."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pkm_workspace as pkm


def linear_delta(difference):
    return pkm.Machine.from_numbers(machine="uranesx", rail_radius=difference + 0.1, platform_radius=0.1)  # L = 1 m


def square(difference):
    return pkm.largest(linear_delta(difference), shape="square", accuracy=1e-4, threads=1)


differences = np.linspace(0.3, 0.5, 9)
with ThreadPoolExecutor() as pool:  # the interpreter is free while the core computes
    found = list(pool.map(square, differences))
for difference, region in zip(differences, found):
    print(f"R - r = {difference:.3f} m: edge {region.size:.4f} to {region.size_upper_bound:.4f} m")

# What this suggests is proved for all machines of the range at once by
best = pkm.best_of_family(machine="uranesx", parameter="R-r", range=(0.3, 0.5), shape="square", accuracy=1e-4)
print(f"best: R - r = {best.parameter:.5f} m, edge {best.size:.5f} m; none has more than {best.size_upper_bound:.5f}")
