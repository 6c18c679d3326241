#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Orthoglide and UraneSX beside each other, as the paper does, by the largest square."""

import pkm_workspace as pkm

names = ("orthoglide", "uranesx")
found = pkm.compare(*(pkm.Machine.from_numbers(machine=name) for name in names), shape="square", accuracy=1e-3)
for name, one in zip(names, found.machines):
    print(f"{name:12} edge {one.size:.4f} to {one.size_upper_bound:.4f} m")
for figure in sorted(found.machines[0].figures):
    print(f"{figure:28}", *(one.figures.get(figure) for one in found.machines))
