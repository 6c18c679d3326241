#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The reason for every step of a proof, in a file that others check."""

import pathlib
import tempfile

import pkm_workspace as pkm

machine = pkm.Machine.from_numbers(machine="orthoglide")
with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder) / "cube.json"
    region = pkm.largest(machine, shape="cube", accuracy=0.01, certificate=file)
    print(f"edge {region.size:.4f} m, {file.stat().st_size} bytes of reasons")
    for claim in pkm.verify(file).verified:
        print("verified:", claim)
