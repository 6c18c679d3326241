#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm path: lines and arcs against the borders that are known in closed form."""

import math
import re
import unittest

from pkm import ORTHOGLIDE, CommandTest, run

CORNER = 1 / math.sqrt(6)  # where psi_1 is 1/2 on the diagonal of the Orthoglide


class Path(CommandTest):
    def path(self, *lines, options=(), urdf=ORTHOGLIDE):
        file = self.file("path.txt", "\n".join(lines) + "\n")
        return self.answer("path", "--urdf", urdf, "--file", file, *options)

    def refused(self, *words):
        process = run("path", "--urdf", ORTHOGLIDE, *words)
        self.assertEqual(process.returncode, 2, process.stdout)
        return process.stderr

    def test_speeds_are_short_texts(self):
        words = ("path", "--urdf", ORTHOGLIDE, "--segment", "start 0 0 0", "--segment", "line 0.1 0 0")
        for speed in (1e-9, 1e9):
            text = self.text(*words, "--tool-speed", speed, "--joint-speeds-off")
            told = re.search(r"(?m)^  speed of 'rail_x' +up to (\S{1,11}) m/s$", text)
            self.assertBrackets(speed, float(told[1]), 1.1 * speed)

    def test_a_path_inside(self):
        answer = self.path("start 0 0 0", "line -0.1 0 0  # and back", "arc 0 0.1 0 0.1 0 0",
                           "turn 0 0 0 0 0 1 0 0.1 0", "", "circle 0 0 0 0 0 1", "helix 0 0 0 0 0 1 6.28 0.1",
                           options=("--tool-speed", 0.5))
        self.assertEqual(answer["verdict"], "inside")
        self.assertEqual([segment["verdict"] for segment in answer["segments"]], ["inside"] * 5)
        self.assertRegex(answer["segments"][1]["place"], r"path.txt:3 \(arc\)$")
        self.assertIsNone(answer["first"])
        motion = answer["motion"]
        self.assertLessEqual(motion["rho"][0][0], -0.1)
        self.assertGreaterEqual(motion["rho"][0][1], 0.1)
        self.assertGreaterEqual(motion["joint_speed"][0], 0.5)
        self.assertLess(motion["joint_speed"][0], 0.6)
        for psi in motion["psi"]:
            self.assertLess(psi[0], 1)
            self.assertGreater(psi[1], 1)

    def test_a_path_that_leaves(self):
        answer = self.path("start 0 0 0", "line 0.1 0.1 0.1", "line 0.6 0.6 0.6", "line 0 0 0")
        self.assertEqual(answer["verdict"], "outside")
        self.assertEqual([segment["verdict"] for segment in answer["segments"]], ["inside", "outside", "outside"])
        first = answer["first"]
        self.assertEqual(first["segment"], 1)
        t = (CORNER - 0.1) / 0.5
        self.assertBrackets(first["good_until"], t, first["bad_at"])
        self.assertLess(first["bad_at"] - first["good_until"], 1e-9)
        self.assertEqual(first["binding"]["limit"], "psi_min")
        self.assertIsNone(answer["motion"])
        self.assertRegex(answer["message"], r"leaves the set on .*path.txt:3 .line., near t = .* of its way: "
                         "the least velocity transmission")

    def test_a_touch_is_not_taken_for_the_offence(self):
        answer = self.path("start -0.079970593403865281 -0.22351999604761633 0.18342168780574239",
                           "line 0.8108995385756147 -0.37194738107784847 -0.8025565924264686",
                           options=("--psi-min", "0.7974806294181559"))
        first = answer["first"]
        touch, leaves = first["open"]
        self.assertAlmostEqual(touch[0], 0.584085, places=5)
        self.assertAlmostEqual(touch[1], 0.584085, places=5)
        self.assertGreater(leaves[0], 0.7, "there the path is dextrous")
        self.assertLess(leaves[1] - leaves[0], 1e-9)
        self.assertEqual([first["good_until"], first["bad_at"]], [touch[0], leaves[1]])
        self.assertEqual(answer["end"], "complete")
        self.assertEqual(first["binding"]["limit"], "psi_max")
        self.assertRegex(answer["message"], r"leaves the set on .* near t = 0\.7.*largest velocity transmission factor "
                         r".*\. Before that it comes within rounding of the border near t = 0\.58")

    def test_joint_limits(self):
        limited = self.file("limited.urdf", self.with_limits(ORTHOGLIDE, -0.05, 0.2))
        lines = ("start 0 0 0", "line -0.1 0 0")
        self.assertEqual(self.path(*lines, urdf=limited, options=("--joint-limits", "off"))["verdict"], "inside")
        answer = self.path(*lines, urdf=limited)
        self.assertEqual(answer["first"]["binding"]["joint"], "rail_x")
        self.assertEqual(answer["first"]["binding"]["limit"], "joint_lower")
        self.assertAlmostEqual(answer["first"]["bad_at"], 0.5, places=9)

    def test_it_is_said_that_the_time_ended_it(self):
        lines = ("start 0 0 0", *["line 0.1 0 0.01", "line 0 0.1 0"] * 20000)
        answer = self.path(*lines, options=("--time-limit", 1e-6))
        self.assertEqual((answer["verdict"], answer["end"]), ("undecided", "stopped"))
        self.assertRegex(answer["message"], r"^Not decided on .*, because the time limit of 1e-06 s \(--time-limit\) "
                         r"ended the proof\. Nothing that was looked at is proved to be outside\.$")

    def test_segments_on_the_command_line_mean_the_same(self):
        lines = ("start 0 0 0", "arc 0.1 0 0 0 0.1 0")
        words = [word for line in lines for word in ("--segment", line)]
        answer = self.answer("path", "--urdf", ORTHOGLIDE, *words)
        self.assertEqual(answer["motion"], self.path(*lines)["motion"])
        self.assertIn("speed of 'rail_x'", self.text("path", "--urdf", ORTHOGLIDE, *words))

    def test_every_problem_is_told_with_its_line(self):
        file = self.file("bad.txt", "line 1 2 3\nstart 0 0 0\nspline 1\nline 1 2\narc 1 0 0 2 0 0\nline x 0 0\n")
        text = self.refused("--file", file)
        for phrase in ("bad.txt:1: a path begins with start", "bad.txt:3: 'spline' is none of start, line, arc",
                       "bad.txt:4: line needs 3 numbers, got 2", "bad.txt:5: arc: .*must be farther off a line",
                       "bad.txt:6: .*x"):
            self.assertRegex(text, phrase)
        self.assertRegex(self.refused(), "a path is missing")
        self.assertRegex(self.refused("--file", str(self.folder / "none.txt")),
                         "none.txt: cannot be read: No such file")
        self.assertRegex(self.refused("--file", self.file("a.txt", "start 0 0 0\nline 0 0 0\n"),
                                      "--segment", "start 0 0 0", "--segment", "line 0 0 0"), "given twice")


if __name__ == "__main__":
    unittest.main()
