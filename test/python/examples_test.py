#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs every example: it ends well, says something, is short, and its number follows the one before."""

import pathlib
import subprocess
import sys
import unittest

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

    def test_the_first_one_says_what_is_known(self):
        ended = subprocess.run([sys.executable, EXAMPLES / "01_largest_cube.py"], capture_output=True, text=True)
        self.assertIn("edge: proved 0.64395 m, none is above 0.64405 m", ended.stdout)


if __name__ == "__main__":
    unittest.main()
