#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Machines with cranks and struts of variable length: what is told of them is in the units of their joints."""

import math
import pathlib
import re
import unittest

from pkm import CommandTest, run

URDF = pathlib.Path(__file__).resolve().parents[2] / "urdf"
DELTA, TRIPOD, MIXED = (("--urdf", str(URDF / f"{name}.urdf")) for name in ("delta", "tripod", "mixed_legs"))
BASE, CRANK, FOREARM, PLATFORM = 0.164, 0.524, 1.244, 0.044


def crank_angles(x, y, z):
    """Of the delta's cranks, downward from level: two circles in the plane of each crank."""
    angles = []
    for k in range(3):
        turn = 2 * math.pi * k / 3
        out = math.cos(turn) * x + math.sin(turn) * y + PLATFORM - BASE
        aside = math.cos(turn) * y - math.sin(turn) * x
        far = math.hypot(out, z)
        inner = (CRANK**2 + far**2 - (FOREARM**2 - aside**2)) / (2 * CRANK * far)
        angles.append(math.atan2(-z, out) - math.acos(inner))
    return angles


class Legs(CommandTest):
    def test_joint_values_are_told_in_their_units(self):
        at = (0.1, -0.05, -1.15)
        answer = self.answer("evaluate", *DELTA, "--point", *at)
        for told, angle in zip(answer["rho"], crank_angles(*at)):
            self.assertAlmostEqual(told, angle, delta=1e-10)
        self.assertRegex(self.text("evaluate", *DELTA, "--point", *at), r"rho +\S+ rad  \S+ rad  \S+ rad\n")
        self.assertRegex(self.text("evaluate", *MIXED, "--point", 0, 0, 0), r"rho +\S+ m  \S+ m  \S+ rad\n")
        self.assertEqual([row["unit"] for row in self.answer("largest", *MIXED)["joint_ranges"]], ["m", "m", "rad"])
        rows = r"joint +lower .*\n +rail_x \[m\].*\n +strut_y \[m\].*\n +crank_z \[rad\]"
        self.assertRegex(self.text("largest", *MIXED), rows)
        self.assertRegex(self.text("largest", *TRIPOD), r"joint +lower \[m\] ")

    def test_ranges_are_reached_at_the_corners(self):
        answer = self.answer("largest", *DELTA, "--accuracy", 0.01)
        half = answer["size"] / 2
        corners = [[c + side * half for c, side in zip(answer["center"], (a, b, d))]
                   for a in (-1, 1) for b in (-1, 1) for d in (-1, 1)]
        angles = [crank_angles(*corner) for corner in corners]
        for k, row in enumerate(answer["joint_ranges"]):
            self.assertAlmostEqual(row["upper"], max(angle[k] for angle in angles), delta=1e-9)
            self.assertLessEqual(row["lower"], min(angle[k] for angle in angles) + 1e-10)  # of twelve decimals

    def test_speeds_along_a_path(self):
        path = ("--segment", "start 0 0 -1.1", "--segment", "line 0.1 0 -1.1", "--tool-speed", 1)
        self.assertRegex(self.text("path", *DELTA, *path), r"speed of 'crank_1' +up to \S+ rad/s\n")
        answer = self.answer("path", *DELTA, *path)
        step = 1e-6
        for k in range(3):
            fastest = max(abs(crank_angles(x + step, 0, -1.1)[k] - crank_angles(x - step, 0, -1.1)[k]) / (2 * step)
                          for x in (i / 100 for i in range(11)))
            self.assertGreaterEqual(answer["motion"]["joint_speed"][k] * (1 + 1e-6), fastest)
            self.assertLessEqual(answer["motion"]["joint_speed"][k], 1.05 * fastest + 0.01)

    def test_numbers_of_joints_are_worded_in_their_units(self):
        told = " ".join(self.text("largest", *DELTA, "--tool-speed-min", 1).split())
        self.assertIn("a tool speed of at least 1 m/s in every direction by joints up to 10 rad/s", told)
        told = " ".join(self.text("largest", *MIXED, "--tool-speed-min", 0.2, "--joint-speed-max", 1, 2, 3).split())
        self.assertIn("by joints up to (1 m/s, 2 m/s, 3 rad/s)", told)
        refused = run("largest", *DELTA, "--position-error-max", 1e-4)
        self.assertIn("needs the largest error [rad] of joint 'crank_1'", " ".join(refused.stderr.split()))

    def test_a_point_that_every_strut_reaches(self):
        """Nothing else is asked for of this one."""
        answer = self.answer("evaluate", *TRIPOD, "--set", "reachable", "--joint-limits", "off", "--aspect", "both",
                             "--point", 0.05, 0.03, 0.74)
        self.assertTrue(answer["satisfies"])
        self.assertRegex(answer["message"], r"the strut of 'strut_\d' is 0\.\d+ m long there")

    def test_what_is_not_known_of_them_is_refused(self):
        for words, reason in (
                (("compare", *TRIPOD, *DELTA), r"strokes of their joints \[m\]; joint 'crank_1' of 'delta' turns"),
                (("largest", *TRIPOD, "--joint-limits", "off"), "no longest length but for joint limits that hold"),
                (("largest", *TRIPOD, "--strut-angle-min", 0.1), "strut_angle_min cannot hold: joint 'strut_1'"),
                (("largest", *DELTA, "--tolerance-length", 1e-4), "leg 'crank_1' is no strut of fixed length")):
            with self.subTest(words):
                process = run(*words)
                self.assertEqual(process.returncode, 2, process.stdout)
                self.assertTrue(re.search(reason, " ".join(process.stderr.split())), process.stderr)


if __name__ == "__main__":
    unittest.main()
