#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Zones to keep in and out of, asked of every command that has a criterion."""

import re
import unittest

from pkm import ORTHOGLIDE, URANESX, CommandTest, run

PILLAR = ("--keep-out", "box", 0.1, 0, 0.1, 0.1, 0.1, 0.1)
ROOM = ("--keep-in", "box", 0.01, 0.02, 0.03, 0.4, 0.3, 0.35)
FILE = """
tool_radius: 0.02
keep_in:
  - {kind: box, name: room, center: [0.01, 0.02, 0.03], sides: [0.4, 0.3, 0.35]}
keep_out:
  - {kind: cylinder, name: column, center: [0.5, 0, 0], radius: 0.05, height: .inf}
"""


class Zones(CommandTest):
    def assertRefused(self, pattern, *words):
        process = run(*words)
        self.assertNotEqual(process.returncode, 0)
        self.assertRegex(process.stderr, pattern)

    def test_largest_cube_of_a_room_is_known(self):
        answer = self.answer("largest", "--urdf", ORTHOGLIDE, *ROOM, "--accuracy", 1e-6)
        self.assertBrackets(answer["size"], 0.3, answer["size_upper_bound"], 1e-12)
        self.assertLess(answer["size_upper_bound"] - answer["size"], 1.1e-6)
        self.assertEqual(answer["keep_in"], [{"kind": "box", "name": "", "center": [0.01, 0.02, 0.03],
                                              "sides": [0.4, 0.3, 0.35]}])
        zones = self.file("zones.yaml", FILE)
        answer = self.answer("largest", "--urdf", ORTHOGLIDE, "--zones", zones, "--accuracy", 1e-6)
        self.assertBrackets(answer["size"], 0.26, answer["size_upper_bound"], 1e-12)
        self.assertEqual(answer["tool_radius"], 0.02)
        self.assertIsNone(answer["keep_out"][0]["height"], "without ends")

    def test_every_command_takes_them(self):
        context = ("--urdf", ORTHOGLIDE, *PILLAR)
        beside, around = ("--center", -0.1, 0, 0.1), ("--center", 0, 0, 0.1)
        sides = ("--sides", 0.25, 0.25, 0.25)
        self.assertEqual(self.answer("check", *context, *beside, *sides)["verdict"], "inside")
        self.assertEqual(self.answer("check", *context, *beside, *sides, "--tool-radius", 0.05)["verdict"], "outside")
        refused = self.answer("check", *context, *around, *sides)
        self.assertEqual(refused["verdict"], "outside")
        self.assertRegex(refused["message"],
                         r"the tool is within the box at \(0\.1, 0, 0\.1\) m that it has to keep out of")
        path = self.answer("path", *context, "--segment", "start 0 0 0", "--segment", "line 0.2 0 0.2")
        self.assertEqual(path["verdict"], "outside")
        there = self.answer("evaluate", *context, "--point", 0.1, 0, 0.1)
        self.assertFalse(there["dextrous"])
        self.assertEqual(there["binding"]["limit"], "keep_out")
        self.assertAlmostEqual(there["binding"]["value"], -0.05)
        room = self.answer("pave", "--urdf", ORTHOGLIDE, *ROOM, "--resolution", 0.05, "--set", "reachable")
        self.assertBrackets(room["volume_lower"], 0.4 * 0.3 * 0.35, room["volume_upper"], 1e-12)
        column = ("--keep-out", "cylinder", 0.05, 0, 0, 0.05, "inf")
        compared = self.answer("compare", "--urdf", URANESX, "--shape", "square", *column, "--accuracy", 0.01)
        self.assertBrackets(compared["machines"][0]["size"], 0.3265, compared["machines"][0]["size_upper_bound"], 1e-3)

    def test_the_set_is_told_with_them(self):
        text = self.text("largest", "--urdf", ORTHOGLIDE, "--zones", self.file("zones.yaml", FILE))
        self.assertIn("tool within the box 'room' with center (0.01, 0.02, 0.03) m and sides (0.4, 0.3, 0.35) m, "
                      "tool out of the cylinder 'column' with center (0.5, 0, 0) m, radius 0.05 m and no ends, "
                      "tool radius 0.02 m",
                      re.sub(r"\s+", " ", text))

    def test_what_is_wrong_is_refused(self):
        def refused(pattern, *words):
            self.assertRefused(pattern, "largest", "--urdf", ORTHOGLIDE, *words)

        refused(r"--keep-out cube 0 0 0 1: 'cube' is not a kind of zone; these are: box, cylinder, sphere, half_space",
                "--keep-out", "cube", 0, 0, 0, 1)
        refused(r"--keep-out box 0 0 0 1 1: needs 6 numbers, got 5; give box X Y Z SX SY SZ",
                "--keep-out", "box", 0, 0, 0, 1, 1)
        refused(r"needs one value \(KIND NUMBER\.\.\), got 0", "--keep-out")
        refused(r"its sides \[m\] must be positive", "--keep-out", "box", 0, 0, 0, 1, -1, 1)
        refused(r"its radius \[m\] must be positive", "--keep-out", "sphere", 0, 0, 0, "nan")
        refused(r"its normal must be finite and not 0", "--keep-in", "half_space", 0, 0, 0, 0, 0, 0)
        refused(r"tool_radius = 0.1 m is without effect", "--tool-radius", 0.1)
        refused(r"a tool of radius 0.2 m leaves nothing of it", *ROOM, "--tool-radius", 0.2)
        refused(r"at most 32 are allowed", *(33 * PILLAR))
        refused(r"zones\.yaml:2: 'cube' is not a kind", "--zones",
                self.file("zones.yaml", "keep_in:\n  - {kind: cube}"))
        refused(r"the file has a tool_radius", "--tool-radius", 0.1, "--zones", self.file("zones.yaml", FILE))

    def test_a_room_bounds_what_goes_on_along_the_rails(self):
        free = ("--urdf", URANESX, "--shape", "box", "--proportions", 0, 0, 1, "--joint-limits", "off")
        self.assertRefused("along the rails", "largest", *free)
        answer = self.answer("largest", *free, "--keep-in", "box", 0, 0, 0, 4, 4, 0.2)
        self.assertBrackets(answer["size"], 0.2, answer["size_upper_bound"], 1e-12)


if __name__ == "__main__":
    unittest.main()
