#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm path --gcode --interpreter rs274. A program of that name stands in for LinuxCNC's: it prints what that one, 2.9.0
of Debian 12, printed for test/data/rs274/part.numbered. Where rs274 itself is installed, it is asked too."""

import math
import os
import pathlib
import shutil
import stat
import sys
import unittest

from gcode_test import GcodeTest
from pkm import DATA, ORTHOGLIDE, run
from rs274 import Interpreter

RS274 = shutil.which("rs274")
JOB = DATA / "rs274" / "part.ngc"
PRINTED = (DATA / "rs274" / "part.printed").read_text(encoding="utf-8")
NUMBERED = (DATA / "rs274" / "part.numbered").read_text(encoding="utf-8")
PRINTED_NEAR = 2e-7  # [m]: four digits behind the point of millimetres
OPTIONS = ("--interpreter", "rs274", "--tool-length", 1, 0.0125)

# What part.ngc is, by hand, in the controller's coordinates: 12.5 mm of tool; G55 is turned by 30 degrees about
# (50, -20); G10 L20 puts the zero of G54 at (-10, 0, 100). Where cutter compensation begins is taken from what was
# printed, and its moves are printed a line later.
BY_HAND = """N7 G21 G90 G17 G0 X0 Y0
N8 Z112.5
N13 G1 X0 Y10 F3000
N13 X40 F3300
N13 X80 F3600
N18 G0 X50 Y-20 Z62.5
N19 G1 X136.602540378444 Y30 F6000
N20 G2 X236.602540378444 Y-143.205080756888 I24.019237886467 J-101.602540378444
N21 G0 X0 Y0 Z112.5
N23 G1 X10 F1200
N24 G0 Z122.5
N24 X30 Y40
N24 G1 Z92.5
N24 G0 Z122.5
N25 X-610
N25 G1 Z92.5
N25 G0 Z122.5
N28 G1 X-10 Y0 Z112.5 F5080
N29 G18 G3 X15.4 Z137.9 I12.7 K12.7
N30 G19 G2 Y76.2 Z163.3 J38.1 K12.7 P2
N33 G17 G1 X80 Y72.4047 F4000
N34 Y140
N35 X-110
N35 G0 X-140 Y150
N37 G1 X-40 F90000
N39 G28
N40 G0 Z0
N41 X0 Y0""".split("\n")

STAND_IN = """#!{python}
import os, pathlib, signal, sys
folder = pathlib.Path({folder!r})
(folder / "words").write_text("\\n".join(sys.argv[1:]))
(folder / "id").write_text(str(os.getpid()))
job = pathlib.Path(sys.argv[-1]).read_text()
(folder / "job").write_text(job)
(folder / "tools").write_text(pathlib.Path(sys.argv[sys.argv.index("-t") + 1]).read_text())
sys.stdout.write({printed!r})
sys.stdout.flush()
sys.stderr.write("executing\\n" + {errors!r}.replace("JOB", sys.argv[-1]))
sys.stderr.flush()
if {closes}:
    os.close(1)
if {hangs}:
    signal.pause()
sys.exit({code})
"""


class WithRs274(GcodeTest):
    def setUp(self):
        super().setUp()
        self.path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", self.path)

    def stand_in(self, printed, errors="", code=0, hangs=False, closes=False):
        program = self.folder / "bin" / "rs274"
        program.parent.mkdir(exist_ok=True)
        program.write_text(STAND_IN.format(python=sys.executable, folder=str(self.folder), printed=printed,
                                           errors=errors, code=code, hangs=hangs, closes=closes))
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        os.environ["PATH"] = f"{program.parent}:{self.path}"

    def told(self, name):
        return (self.folder / name).read_text()

    def refusal(self, *lines, options=()):
        return self.refused(*(lines or ("G0 X1",)), options=("--interpreter", "rs274", *options))

    def expect_the_part(self):
        """The lines of part.ngc that offend are those of its moves by hand, at the same places."""
        answer = self.answer("path", "--urdf", ORTHOGLIDE, "--gcode", JOB, "--psi-min", 0.6, "--psi-max", 1.5, *OPTIONS)
        self.set_oracle(answer, ORTHOGLIDE)
        by_hand = Numbered()
        moves = list(by_hand.run(BY_HAND))
        offences = list(answer["offences"])
        for move in moves:
            place = f"line {move.line} to {move.point(1)}"
            if offences and offences[0]["line"] == move.line and math.dist(
                    move.point(offences[0]["bad_at"]), offences[0]["point"]) < PRINTED_NEAR:
                self.expect_bad(move, offences.pop(0), place, PRINTED_NEAR)
            else:
                self.expect_good(move, place)
        self.assertEqual(offences, [])
        count = sum(not move.is_point for move in moves)
        self.assertEqual((answer["lines"], answer["moves"], answer["unknown_moves"]), (43, count, by_hand.unknown))
        self.assertGreater(answer["outside"], 4)
        self.assertLess(answer["outside"], count / 2)
        self.assertEqual(answer["interpreter"], "rs274")
        self.assertIn("The moves are those that rs274 prints, whose numbers it rounds", answer["message"])
        return answer

    def test_the_whole_language(self):
        self.stand_in(PRINTED)
        answer = self.expect_the_part()
        self.assertEqual(self.told("job"), NUMBERED)
        self.assertEqual(self.told("tools"), "T1 P1\n")
        words = self.told("words").split()
        self.assertEqual([words[k] for k in (0, 1, 2, 3, 5)], ["-g", "-n", "2", "-t", "-v"])
        for k in (4, 6, 7):
            self.assertFalse(pathlib.Path(words[k]).parent.exists(), "temporary files are removed")
        self.assertEqual(answer["ignored"]["SELECT_TOOL"], 1)

    @unittest.skipUnless(RS274, "rs274 is not installed")
    def test_the_whole_language_by_the_program_itself(self):
        self.expect_the_part()
        self.assertIn("job.ngc:2: Bad character 'u' used", self.refusal("G0 X1", "U3", "M2"))
        self.assertIn("job.ngc:1: Requested tool 5 not found in the tool table; give the length", self.refusal("T5 M6"))
        self.assertIn("job.ngc:1: File ended with no percent sign or program end", self.refusal("G0 X1"))
        self.assertIn("job.ngc:2: RIGID_TAP", self.refusal("S100 M3", "G33.1 Z0 K1", "M2"))
        endless = self.refusal("o1 while [1]", "#1 = 2", "o1 endwhile", "M2", options=("--time-limit", 0.5))
        self.assertIn("rs274 was not at the end when the time limit of 0.5 s (--time-limit) ended it", endless)

    def test_what_stands_before_the_job(self):
        self.stand_in("")
        self.refusal("%", "N12 G0 X1", "", " n 7 (a) g1", "n g", "%", options=(
            "--tool-at", 0.25, 0, -0.125, "--origin", 0.1, 0, 0, "--work-offset", "G59.3", 1e-12, -0.5, 999,
            "--tool-length", 7, -0.001, "--tool-diameter", 9, 0.003, "--tool-diameter", 7, 0.012))
        lines = self.told("job").split("\n")
        self.assertEqual(lines[0], "%")
        self.assertEqual(lines[1], "N0 G21 G53 G0 X2000000.{0} Y2000000.{0} Z2000000.{0}".format(12 * "0"))
        self.assertEqual(lines[2:4], ["N0 G28.1", "N0 G30.1"])
        self.assertEqual(lines[12], "N0 G10 L2 P9 X0.000000001000 Y-500.000000000000 Z999000.000000000000")
        self.assertEqual(lines[13:18], ["N0 G10 L1 P7 Z-1.000000000000", "N0 G10 L1 P7 R6.000000000000",
                                        "N0 G10 L1 P9 R1.500000000000",
                                        "N0 G53 G0 X150.000000000000 Y0.000000000000 Z-125.000000000000", "N0 G80"])
        self.assertEqual(lines[18:], ["N2  G0 X1", "", "N4  (a) g1", "N5 n g", "%", ""])
        self.assertEqual(self.told("tools"), "T7 P1\nT9 P2\n")

    def test_the_program_is_missing(self):
        os.environ["PATH"] = str(self.folder)
        text = self.refusal()
        self.assertIn("rs274 cannot be started: there is no such program in PATH; install LinuxCNC", text)

    def test_its_errors_are_passed_on(self):
        self.stand_in(PRINTED[:2000], "Unknown word starting with e\nN7 G0 X1 (MSG, )hello\n", 1)
        self.assertIn("job.ngc:7: Unknown word starting with e", self.refusal())
        self.stand_in("", "EOF in file:JOB seeking o-word: o<5> from line: 17\nM2\n", 1)
        self.assertIn("job.ngc: EOF seeking o-word: o<5> ", self.refusal() + " ")
        self.stand_in("", "Requested tool 5 not found in the tool table\nN3 T5 M6\n", 1)
        self.assertIn("job.ngc:3: Requested tool 5 not found in the tool table; give the length", self.refusal())
        self.stand_in("", "", 3)
        self.assertIn("job.ngc: rs274 ends without the end of the job, and gives no reason", self.refusal())
        self.stand_in(PRINTED.replace("PROGRAM_END()", "FINISH()"))
        self.assertIn("rs274 did not come to the end of the job; end it with M2", self.refusal())

    def test_what_it_prints_and_is_not_read_is_refused(self):
        call = "STRAIGHT_FEED(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)"
        self.stand_in(f"1 N5     RIGID_TAP(1.0, 2.0, 3.0)\n2 N6     {call}\nnonsense\n3 N7     PROGRAM_END()\n")
        text = self.refusal()
        self.assertIn("job.ngc:5: RIGID_TAP(1.0, 2.0, 3.0) is not among the calls", text)
        self.assertIn("job.ngc:6: no feed is in effect", text)
        self.assertIn("job.ngc:6: rs274 prints 'nonsense', which is not a call", text)
        self.assertIn("whether a line behind / counts", self.refusal("G0 X1", "/G0 X2"))

    def test_it_is_killed_when_the_time_is_up(self):
        for command, closes in (("path", False), ("place", False), ("path", True)):
            self.stand_in(PRINTED, hangs=True, closes=closes)
            process = run(command, "--urdf", ORTHOGLIDE, "--gcode", JOB, *OPTIONS, "--time-limit", 0.2)
            self.assertEqual(process.returncode, 2, process.stdout)
            self.assertIn("rs274 was not at the end when the time limit of 0.2 s", " ".join(process.stderr.split()))
            self.assertRaises(ProcessLookupError, os.kill, int(self.told("id")), 0)

    def test_a_part_is_placed(self):
        self.stand_in("1 N1     SET_FEED_RATE(600.0000)\n"
                      "2 N1     STRAIGHT_TRAVERSE(0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
                      "3 N2     STRAIGHT_FEED(200.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
                      "4 N3     PROGRAM_END()\n")
        job = self.file("line.ngc", "F600 G0 X0 Y0 Z0\nG1 X[100*2]\nM2\n")
        words = ("place", "--urdf", ORTHOGLIDE, "--accuracy", 0.01, "--gcode")
        read = self.answer(*words, job, "--interpreter", "rs274")
        plain = self.answer(*words, self.file("plain.ngc", "F600 G0 X0 Y0 Z0\nG1 X200\n"))
        self.assertEqual(read["margin"], plain["margin"])
        self.assertIn("The moves are those that rs274 prints", read["message"])

    def test_options_of_the_interpreter(self):
        self.assertIn("G41 and G42 are read with --interpreter rs274 only",
                      self.refused("G0 X1", options=("--tool-diameter", 1, 0.01)))
        self.assertIn("rs275", self.refused("G0 X1", options=("--interpreter", "rs275")))


class Numbered(Interpreter):
    """Whose lines have their numbers in words N."""

    def run(self, lines):
        for line in lines:
            number, rest = line[1:].split(" ", 1)
            move = self.step(int(number), rest)
            if move:
                yield move


if __name__ == "__main__":
    unittest.main()
