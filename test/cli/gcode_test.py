#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm path --gcode: jobs against an interpretation of their own, at points of every move."""

import math
import random
import unittest
from types import SimpleNamespace

import oracle
from pkm import ORTHOGLIDE, CommandTest, run
from rs274 import Interpreter

SEED = 20261127
SAMPLES = 4


def slicer_job(rng, count):
    """Layers of outlines and infill as slicers write them for a delta printer, some wider or faster than it can."""
    lines = ["; generated", "M140 S60", "M104 S200", "G21", "G90", "M82", "G28 ;home", "M109 S200", "G92 E0",
             "G1 Z15.0 F9000", "G1 X0 Y0 F3000", "M117 Printing..."]
    z, e = 0.3, 0.0
    while len(lines) < count - 4:
        lines += [f";LAYER:{z:.2f}", f"G0 F6000 X{rng.uniform(-20, 20):.3f} Y{rng.uniform(-20, 20):.3f} Z{z:.2f}"]
        radius, feed = rng.choice((20, 45, 70, 130)), rng.choice((1200, 2400, 9000, 14000))
        for k in range(rng.randrange(60, 120)):
            e += 0.04
            way = rng.choice((f"G1 X{radius * math.cos(k / 9):.3f} Y{radius * math.sin(k / 9):.3f}",
                              f"G1 X{rng.uniform(-radius, radius):.3f} Y{rng.uniform(-radius, radius):.3f}"))
            lines.append(way + (f" F{feed}" if k == 0 else "") + f" E{e:.5f}")
        lines += ["G1 F1800 E%.5f" % (e - 5), "G92 E0", "M106 S255"]
        e, z = 0.0, z + 0.2
    return lines + ["M107", "G28", "M84", "M104 S0"]


def cam_job(rng):
    """Inches, work offsets, a tool, arcs in all planes by center and by radius, helices, relative moves, G93, G92."""
    lines = ["%", "(pocket)", "N10 G17 G20 G40 G49 G54 G80 G90 G94", "G10 L2 P2 X1.5 Y-2 Z0.25", "T1 M6",
             "G43 H1 S8000 M3", "G55", "G0 X0 Y0", "Z1", "F30"]
    for _ in range(60):
        radius = rng.choice((0.5, 1.25, 2.0, 3.0))
        x, y, z = (rng.choice((-9, -4, -1.5, 0, 2.25, 6, 14)) for _ in range(3))
        lines += ["G90 G94 F%d" % rng.choice((60, 300, 2400)), f"G1 X{x} Y{y} Z{z}", "G91.1",
                  f"G17 G2 X{x + 2 * radius} I{radius} J0", f"G3 X{x} Y{y} R{radius}",
                  f"G18 G3 X{x + radius} Z{z + radius} I0 K{radius}", f"G2 X{x} Z{z} R-{radius}",
                  f"G19 G2 Y{y + radius} Z{z + radius} J{radius} K0", f"G91 G3 Y-{radius} Z-{radius} R{radius}",
                  f"G17 G2 Z0.5 I{radius} P2", f"G90 G90.1 G3 X{x} Y{y} Z{z} I{x - radius} J{y}",
                  f"G93 G1 X{x + 1} Z{z + 0.5} F{rng.choice((10, 90))}", "G94 F100", "G53 G0 Z1.5",
                  "G92 X0.25 Y0.125", "G1 X0 Y0 (about where it was)", "G92.1"]
    return lines + ["G0 Z1", "G54", "G21", "G1 X10 Y-10.5 F500", "M30", "%"]


class GcodeTest(CommandTest):
    def job(self, lines, urdf, *options):
        return self.answer("path", "--urdf", urdf, "--gcode", self.file("job.ngc", "\n".join(lines) + "\n"),
                           "--most-listed", 1000000, *options)

    def refused(self, *lines, options=()):
        process = run("path", "--urdf", ORTHOGLIDE, "--gcode", self.file("job.ngc", "\n".join(lines) + "\n"), *options)
        self.assertEqual(process.returncode, 2, process.stdout)
        return " ".join(process.stderr.split())

    def violation(self, point, ahead, speed):
        """How far the point is from good: > 0 where the place or a joint's speed there is bad for certain."""
        if self.machine_there.verdict(point, self.criterion) == oracle.BAD:
            return math.inf
        step = math.dist(point, ahead)
        if not speed or step == 0:
            return 0
        legs = self.machine_there.legs[float]
        here, there = self.machine_there.state(point).rhos, self.machine_there.state(ahead).rhos
        return max(abs(b - a) / step * speed / leg.speed for a, b, leg in zip(here, there, legs)) - 1

    def violation_at(self, move, t):
        """Ahead is a millionth of the way."""
        t = min(t, 1 - 1e-6)
        return self.violation(move.point(t), move.point(t + 1e-6), move.speed)

    def set_oracle(self, answer, urdf):
        with open(urdf, encoding="utf-8") as file:
            self.machine_there = oracle.Machine(file.read())
        self.criterion = SimpleNamespace(psi=(answer["psi_min"], answer["psi_max"]), limits=True, aspect="own")

    def expect_good(self, move, place):
        worst = max(self.violation_at(move, k / SAMPLES) for k in range(SAMPLES + 1))
        self.assertLessEqual(worst, 1e-4, place)

    def expect_bad(self, move, offence, place, near=1e-12):
        """@param near how exactly the move is known [m]"""
        self.assertEqual(offence["verdict"], "outside", place)
        there = move.point(offence["bad_at"])
        self.assertLess(math.dist(there, offence["point"]), near, place)
        self.assertAlmostEqual(offence["tool_speed"], move.speed or 0, delta=near, msg=place)
        at = [min(1, max(0, offence["bad_at"] + step)) for step in (0, 1e-7)]
        self.assertGreater(max(self.violation_at(move, t) for t in at), -1e-4, place)

    def expect_right(self, lines, urdf, interpreter, *options):
        """What is listed is bad where it says so; what is not is good at samples. @return lines, offending lines"""
        answer = self.job(lines, urdf, *options)
        self.set_oracle(answer, urdf)
        listed = {offence["line"]: offence for offence in answer["offences"]}
        moves = list(interpreter.run(lines))
        for move in moves:
            offence = listed.pop(move.line, None)
            place = f"seed {SEED}, line {move.line}: {lines[move.line - 1]}"
            if offence is None:
                self.expect_good(move, place)
            else:
                self.expect_bad(move, offence, place)
        self.assertEqual(listed, {}, "lines that are no moves")
        count = sum(not move.is_point for move in moves)
        self.assertEqual((answer["moves"], answer["unknown_moves"]), (count, interpreter.unknown))
        self.assertEqual(answer["outside"], len(answer["offences"]))
        return count, answer


class Gcode(GcodeTest):
    def test_a_slicer_s_job(self):
        urdf = self.machine("--uranesx", "--length", 0.24, "--joint-speed-max", 0.2)
        lines = slicer_job(random.Random(SEED), 20000)
        self.assertGreater(len(lines), 19900)
        interpreter = Interpreter(origin=(0, 0, -0.2), programmed_rapids=True)
        moves, answer = self.expect_right(lines, urdf, interpreter, "--origin", 0, 0, -0.2, "--psi", "auto",
                                          "--rapid-feed", "programmed")
        self.assertGreater(moves, 15000)
        self.assertGreater(answer["outside"], 100)
        self.assertLess(answer["outside"], moves / 2)
        limits = {offence["binding"]["limit"] for offence in answer["offences"]}
        self.assertIn("joint_speed_max", limits)
        self.assertGreater(len(limits), 1)
        self.assertEqual(answer["ignored"]["M106"], sum(line.startswith("M106") for line in lines))
        self.assertEqual(answer["ignored"]["E"], sum(" E" in line for line in lines))

    def test_a_cam_system_s_job(self):
        lines = cam_job(random.Random(SEED))
        place = {"origin": (0.05, -0.1, 0.2), "offsets": {540: (0, 0.1, 0)}, "lengths": {1: 0.0321}}
        moves, answer = self.expect_right(lines, ORTHOGLIDE, Interpreter(**place), "--origin", 0.05, -0.1, 0.2,
                                          "--work-offset", "G54", 0, 0.1, 0, "--tool-length", 1, 0.0321)
        self.assertGreater(moves, 700)
        self.assertGreater(answer["outside"], 10)
        self.assertLess(answer["outside"], moves / 2)
        rapids = sum(move.speed is None and not move.is_point for move in Interpreter(**place).run(lines))
        self.assertEqual(answer["moves_without_feed"], rapids)
        self.assertIn("are not held against a limit: --rapid-feed", answer["message"])

    def test_every_refused_line_is_named(self):
        text = self.refused("G1 F100 X1 Y1 Z1", "G81 Z1", "G1 X2", "G2 X9 I1", "G43 H5", "G1 A3")
        for phrase in ("job.ngc:2: G81 is not among the codes", "job.ngc:5: G43 H5: the length", "job.ngc:6: A: this"):
            self.assertIn(phrase, text)
        self.assertIn("job.ngc:2: arc: end (0.009, 0, 0) m is 0.007",
                      self.refused("G1 F100 X0 Y0 Z0", "G2 X9 I1"))
        self.assertIn("nothing can be checked", self.refused("G91", "G1 F100 X1 Y1 Z1"))
        self.assertIn("and 81 more", self.refused(*["G81"] * 200))
        self.assertIn("--tool-speed 0.5: tool_speed is without effect",
                      self.refused("G1", options=("--tool-speed", 0.5)))
        self.assertIn("the path is given twice", self.refused("G1", options=("--segment", "start 0 0 0")))
        self.assertIn("the path is given twice", self.refused("G1", options=("--file", "path.txt")))
        self.assertIn("G60", self.refused("G1", options=("--work-offset", "G60", 0, 0, 0)))

    def test_options_of_jobs_are_about_jobs(self):
        process = run("path", "--urdf", ORTHOGLIDE, "--segment", "start 0 0 0", "--segment", "line 0 0 0",
                      "--origin", 0, 0, 0, "--most-listed", 3)
        self.assertEqual(process.returncode, 2)
        self.assertIn("--origin is without effect", process.stderr)
        self.assertIn("--most-listed is without effect", process.stderr)

    def test_relative_moves_from_a_given_place(self):
        answer = self.job(["G91", "G1 F600 X100", "X100", "X-200"], ORTHOGLIDE, "--tool-at", 0, 0, 0, "--largest-feed")
        self.assertEqual((answer["verdict"], answer["moves"], answer["unknown_moves"]), ("inside", 3, 0))
        self.assertBrackets(answer["motion"]["rho"][0][0], 0, 0, 0.01)
        self.assertGreaterEqual(answer["motion"]["rho"][0][1], 0.2)
        self.assertBrackets(0.01, answer["motion"]["joint_speed"][0], 0.0101)
        self.assertIn("At its feeds the joints are proved to keep within their limits.", answer["message"])
        self.assertIn("reaches its limit of speed on", answer["message"])

    def test_what_is_listed_is_bounded(self):
        job = self.file("job.ngc", "G1 F100 X0 Y0 Z0\n" + "X2000\nX0\n" * 30)
        words = ("path", "--urdf", ORTHOGLIDE, "--gcode", job, "--most-listed", 7)
        answer = self.answer(*words)
        self.assertEqual((len(answer["offences"]), answer["outside"]), (7, 60))
        text = self.text(*words)
        self.assertEqual(text.count(": outside near t = "), 7)
        self.assertIn("53 more lines offend (--most-listed)", text)
        self.assertIn("60 lines offend: 60 outside, 0 undecided.", " ".join(text.split()))


if __name__ == "__main__":
    unittest.main()
