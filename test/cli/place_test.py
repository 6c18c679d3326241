#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm place: what it finds, held against pkm path at the translation and all around; what it refuses."""

import itertools
import math
import random
import re
import unittest

from pkm import ORTHOGLIDE, CommandTest, run

SEED = 20261128


def layers(rng, count, radius, feed):
    """Outlines and infill, as a slicer writes them, about a point beside the zero of the job; with arcs."""
    lines, z = ["G21", "G90", "G92 E0", f"G1 X30 Y10 Z0.2 F{feed}"], 0.2
    while len(lines) < count:
        for k in range(40):
            lines.append(f"G1 X{30 + radius * math.cos(k / 6):.3f} Y{10 + 0.7 * radius * math.sin(k / 6):.3f} E1")
        lines += [f"G2 X{30 + rng.uniform(-5, 5):.3f} Y10 R{radius + 9:.3f} E1", f"G1 X{30 + radius:.3f} Y10 E1"]
        z += 0.3
        lines.append(f"G0 Z{z:.2f}")
    return "\n".join(lines) + "\n"


class Place(CommandTest):
    def place(self, *words):
        return self.answer("place", "--urdf", ORTHOGLIDE, *words)

    def checked(self, job, at, *words):
        return self.answer("path", "--urdf", ORTHOGLIDE, "--gcode", job, "--origin", *at, *words)["verdict"]

    def test_a_job_fits_with_its_margin_and_not_with_more(self):
        rng = random.Random(SEED)
        for feed, words in ((3000, ()), (60000, ()), (3000, ("--base-z", "-0.1"))):
            job = self.file("job.gcode", layers(rng, 120, 40, feed))
            found = self.place("--gcode", job, *words)
            self.assertEqual(found["status"], "proven")
            self.assertTrue(found["holds_limits"])
            at, margin = found["translation"], found["margin"] * (1 - 1e-9)
            end = found["margin"] + found["accuracy"]
            self.assertBrackets(found["margin"], found["margin_upper_bound"], end, 1e-12)
            verdicts = set()
            for corner in [(0, 0, 0), *itertools.product((-1, 1), repeat=3)]:
                moved = [x + sign * margin for x, sign in zip(at, corner)]
                self.assertEqual(self.checked(job, moved), "inside")
                moved = [x + sign * (found["margin_upper_bound"] + 0.002) for x, sign in zip(at, corner)]
                verdicts.add(self.checked(job, moved))
            self.assertIn("outside", verdicts)
            if words:
                self.assertAlmostEqual(at[2] + 0.0002, -0.1, places=12)

    def test_speeds_count(self):
        job = self.file("job.gcode", "G21\nG90\nG1 X0 Y0 Z0 F66000\nG1 X300\nG1 Y200 Z100\n")
        with_speeds = self.place("--gcode", job)
        without = self.place("--gcode", job, "--joint-speeds-off")
        self.assertLess(with_speeds["margin_upper_bound"], without["margin"])
        self.assertFalse(without["holds_limits"])
        fast = self.file("fast.gcode", layers(random.Random(SEED), 100, 40, 200000))
        self.assertEqual(self.place("--gcode", fast)["status"], "none")

    def test_a_part_and_its_bracket_of_scales(self):
        # a box of 0.2 x 0.1 x 0.1 m, kept in one of 0.5 x 0.3 x 0.4: 0.1 m are left on both sides along y, 0.15 along x
        corners = itertools.product((0, 0.2), (0, 0.1), (0, 0.1))
        part = self.file("part.txt", "".join(f"{x} {y} {z}\n" for x, y, z in corners))
        words = ("--vertices", part, "--keep-in", "box", 0, 0, 0, 0.5, 0.3, 0.4, "--largest-scale")
        found = self.place(*words)
        self.assertBrackets(found["margin"], 0.1, found["margin_upper_bound"])
        scale = found["largest_scale"]
        self.assertBrackets(scale["scale"], 2.5, scale["upper_bound"])
        self.assertLess(scale["upper_bound"] - scale["scale"], 0.0011)
        low = self.place(*words, "--base-z", -0.2, "--within", -1, 1, 0, 0, -1, 1)
        self.assertEqual(low["status"], "proven" if low["margin"] > 0 else
                         "stopped" if low["margin_upper_bound"] > 0 else "none")
        self.assertLess(low["margin_upper_bound"], 1e-3)  # it stands on the border of the box

    def test_what_stopped_it_is_said(self):
        line = ("--segment", "start 0 0 0", "--segment", "line 0.5 0 0")
        stopped = self.place(*line, "--max-boxes", 1)
        self.assertEqual(stopped["status"], "stopped")
        self.assertIn("The limit of 1 box ended the search", stopped["message"].replace("boxes", "box"))
        tall = self.file("tall.txt", "0 0 0\n0.1 0 0\n0 0.1 0\n0 0 0.2\n")  # as high as the box that it is kept in
        border = self.place("--vertices", tall, "--keep-in", "box", 0, 0, 0, 0.3, 0.3, 0.2)
        if border["margin"] == 0:
            self.assertEqual(border["status"] == "none", border["margin_upper_bound"] == 0, border)
            told = "Whether one has any is not decided. The accuracy ended the search: a finer one may find a place."
            self.assertEqual(border["status"] == "stopped", told in border["message"], border)

    def test_what_is_left_out_is_told(self):
        job = self.file("job.gcode", "G21 G90\nG1 X10 F3000\nG0 X0 Y0 Z0\nG1 X100 F6000\nG0 Y50\nG1 X0\nM104 S200\n")
        found = self.place("--gcode", job)
        self.assertIn("and at its feeds the joints keep within their limits of speed;", found["message"])
        self.assertIn("2 moves begin or end where the job does not say", found["message"])
        self.assertIn("The speeds of 1 rapid move (G0) are not held against a limit", found["message"])
        self.assertEqual((found["moves"], found["unknown_moves"], found["ignored"]), (3, 2, {"M104": 1}))
        self.assertIn("M104 (1)", self.text("place", "--urdf", ORTHOGLIDE, "--gcode", job))
        line = ("--segment", "start 0 0 0", "--segment", "line 0.1 0 0", "--tool-speed", 0.3)
        aside = self.place(*line, "--joint-speeds-off", "--joint-acceleration-max", 5)
        self.assertIn("and at 0.3 m/s the joints keep within their limits of acceleration;", aside["message"])
        self.assertIn("Joint speeds are not held against a limit: they are left aside.", aside["message"])
        self.assertEqual((aside["joint_speed_limits"], aside["joint_acceleration_limits"]), ([None] * 3, [5] * 3))
        both = self.place(*line, "--joint-acceleration-max", 5, "--largest-scale")
        self.assertIn("limits of speed and acceleration;", both["message"])
        self.assertRegex(both["message"], r"scaled about \(0\.05\S*, \S+, \S+\) m and then moved by")
        self.assertTrue(both["message"].endswith("Speeds do not count for the scale."))

    def test_there_is_none(self):
        text = self.text("place", "--urdf", ORTHOGLIDE, "--segment", "start 0 0 0", "--segment", "line 0.8 0.8 0.8")
        self.assertIn("there is no translation", " ".join(text.split()))
        far = self.place("--segment", "start 0 0 0", "--segment", "line 0.1 0 0", "--within", 3, 4, 0, 1, 0, 1)
        self.assertEqual((far["status"], far["translations"]), ("none", None))

    def refused(self, *words):
        process = run("place", "--urdf", ORTHOGLIDE, *words)
        self.assertEqual((process.returncode, process.stdout), (2, ""))
        return " ".join(process.stderr.split())

    def test_refusals(self):
        line = ("--segment", "start 0 0 0", "--segment", "line 0.1 0 0")
        part = self.file("part.txt", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        self.assertIn("--vertices FILE", self.refused())
        self.assertIn("given twice", self.refused(*line, "--vertices", part))
        self.assertIn("--reference is without effect", self.refused(*line, "--reference", 0, 0, 0))
        self.assertIn("about --largest-scale", self.refused(*line, "--scale-accuracy", 0.1))
        point = ("--segment", "start 0 0 0", "--segment", "line 0 0 0")
        self.assertIn("the path is one point, the same at every scale", self.refused(*point, "--largest-scale"))
        flat = self.file("flat.txt", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n")
        self.assertRegex(self.refused("--vertices", flat), r"--vertices \S*flat.txt: the part, .*lie in one plane")
        self.assertIn("--tool-speed is without effect", self.refused("--vertices", part, "--tool-speed", 1))
        self.assertIn("joint_acceleration_max is without effect", self.refused(*line, "--joint-acceleration-max", 1))
        self.assertIn("--origin is without effect", self.refused(*line, "--origin", 0, 0, 0))
        self.assertIn("translation by 2 m along z", self.refused(*line, "--base-z", 2, "--within", 0, 1, 0, 1, 0, 1))
        self.assertIn("seen from its reference (5, 5, 5) m",
                      self.refused("--vertices", part, "--largest-scale", "--reference", 5, 5, 5))
        self.assertIn("line 0.1 0", self.refused("--segment", "start 0 0 0", "--segment", "line 0.1 0"))

    def test_no_place_is_told_with_what_is_in_the_way(self):
        answer = self.answer("place", "--urdf", ORTHOGLIDE, "--segment", "start 0 0 0", "--segment", "line 0.1 0 0",
                             "--base-z", 5)
        self.assertEqual((answer["status"], answer["margin_upper_bound"]), ("none", 0))
        self.assertRegex(answer["message"],
                         r"Proved: there is no translation .* All of the set is within x \S+ to \S+ m,"
                         r" y \S+ to \S+ m, z \S+ to \S+ m\. For instance, moved by \(.*, 5\) m, a point of it is at "
                         r"\(.*, 5\) m: the strut of 'rail_\w' is 1 m long and would have to reach")
        extent = [float(x) for x in re.findall(r"[xyz] (\S+) to (\S+) m", answer["message"])[2]]
        self.assertTrue(-2 < extent[0] < -0.5 and 0.5 < extent[1] < 2, extent)


if __name__ == "__main__":
    print("seed", SEED)
    unittest.main()
