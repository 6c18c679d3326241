#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs every example: it ends well, says something, is short, and its number follows the one before."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from pkm_workspace import study

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
LINES = 45


class Examples(unittest.TestCase):
    def test_each(self):
        files = sorted(EXAMPLES.glob("*.py"))
        for number, file in enumerate(files, 1):
            with self.subTest(example=file.name):
                self.assertTrue(file.name.startswith(f"{number:02}_"))
                self.assertLessEqual(len(file.read_text(encoding="utf-8").splitlines()), LINES)
                ended = subprocess.run([sys.executable, file], capture_output=True, text=True, cwd="/")
                self.assertEqual(ended.returncode, 0, ended.stderr)
                self.assertTrue(ended.stdout)

    def test_a_job_of_a_cluster(self):
        """With fewer designs, as Slurm runs it."""
        script = (EXAMPLES / "cluster.sbatch").read_text(encoding="utf-8").replace("1000000", "20")
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(2):  # the second time it goes on
                ended = subprocess.run(["bash"], input=script, capture_output=True, text=True, cwd=folder,
                                       env={**os.environ, "SLURM_ARRAY_TASK_ID": "7"})
                self.assertEqual(ended.returncode, 0, ended.stderr)
            rows = study.read(pathlib.Path(folder) / "part_0007.sqlite")[1]
        ranges = {"rail_radius": (0.4, 0.65), "platform_radius": (0.05, 0.12)}
        self.assertEqual([row[1:3] for row in rows],
                         [tuple(design.values()) for design in study.sample(20, 140, **ranges)])

    def test_the_first_one_says_what_is_known(self):
        ended = subprocess.run([sys.executable, EXAMPLES / "01_largest_cube.py"], capture_output=True, text=True)
        self.assertIn("edge: proved 0.64395 m, none is above 0.64405 m", ended.stdout)


if __name__ == "__main__":
    unittest.main()
