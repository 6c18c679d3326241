#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a box, a path and many points are good, and why not."""

import numpy as np
import pkm_workspace as pkm

machine = pkm.Machine.from_numbers(machine="orthoglide")
for side in (0.3, 0.6, 0.9):
    answer = pkm.check(machine, center=(0.08, 0.08, 0.08), sides=(side, side, side))
    print(f"box of {side} m: {answer.verdict}. {answer.message}")

path = pkm.path(machine, segment=["start 0 0 0", "line 0.3 0 0", "line 0.6 0 0"])
print(f"path: {path.verdict}. {path.message}")

points = np.random.default_rng(1).uniform(-0.5, 0.5, (200, 3))
states = pkm.evaluate(machine, points=points).points
good = np.array([state.satisfies is True for state in states])
print(f"{good.sum()} of {len(points)} points are proved to be good")
