#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""docs/real_machines.md is what scripts/real_machines makes: some of its lines, each made anew."""

import csv
import os
import subprocess
import unittest

from pkm import DATA, PKM, CommandTest

ROOT = DATA.parents[1]
PAGE = (ROOT / "docs" / "real_machines.md").read_text(encoding="utf-8")
ROWS = ("2", "6", "17", "21")


class RealMachines(CommandTest):
    def script(self, *words):
        command = [str(ROOT / "scripts" / "real_machines"), "--pkm", os.path.abspath(PKM), *words]
        process = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(process.returncode, 0, process.stderr)
        return process.stdout

    def test_lines_are_those_of_the_page(self):
        lines = self.script("--rows", *ROWS).splitlines()
        self.assertEqual(len(lines), len(ROWS))
        for line in lines:
            self.assertIn(line, PAGE.splitlines())

    def test_the_page_is_made_whole(self):
        self.script("--docs", self.folder)
        self.assertEqual((self.folder / "real_machines.md").read_text(encoding="utf-8"), PAGE)

    def test_every_machine_has_its_line(self):
        with open(DATA / "linear_delta_machines.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        table = [line.split(" | ") for line in PAGE.splitlines() if line.startswith("| ")][1:]
        self.assertEqual([(row["L_mm"], row["R_mm"]) for row in rows], [(cells[1], cells[2]) for cells in table])
        for row, cells in zip(rows, table):  # the strut is as long as the farthest tower is away
            lower, upper = map(float, cells[3].split(" to "))
            self.assertBrackets(lower, float(row["L_mm"]) - float(row["R_mm"]), upper)


if __name__ == "__main__":
    unittest.main()
