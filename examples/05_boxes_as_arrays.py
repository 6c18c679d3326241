#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The dextrous set as boxes in arrays of numpy: its volume, and its section with a plane."""

import numpy as np
import pkm_workspace as pkm

machine = pkm.Machine.from_numbers(machine="orthoglide")
paving = pkm.pave(machine, resolution=0.1)
inside = paving.listed.inside  # (n, 3, 2): least and largest x, y, z of each box [m]

volume = np.prod(inside[:, :, 1] - inside[:, :, 0], axis=1).sum()
print(f"{len(inside)} boxes inside, {volume:.4f} m^3; the set has {paving.volume_lower:.4f} to "
      f"{paving.volume_upper:.4f} m^3")

height = 0.1
cut = inside[(inside[:, 2, 0] <= height) & (height <= inside[:, 2, 1])]
area = np.prod(cut[:, :2, 1] - cut[:, :2, 0], axis=1).sum()
print(f"at z = {height} m, {len(cut)} of them cover {area:.4f} m^2")
