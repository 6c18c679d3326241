#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm largest against the reference values: closed forms, and dense searches that are good to 1e-5."""

import math
import re
import unittest
from fractions import Fraction

from pkm import DATA, MACHINES, ORTHOGLIDE, URANESX, CommandTest, run

CUBE = 1 / math.sqrt(6) + 1 / (3 * math.sqrt(2))  # largest cube of the unit Orthoglide, edge [m]
CUBE_STROKE = 1 + 1 / (3 * math.sqrt(2)) - 1 / math.sqrt(6)  # its joint range [m]
CUBE_ACROSS = 1 - math.sqrt(2 / 3)  # and the part of it across the face [m]
SEARCH = 1e-5  # error of the values that a search gave [m]
SOLIDS = {"cube": [], "box": ["--proportions", 2, 1, 1]}
SHAPES = dict(SOLIDS, square=[])


class Largest(CommandTest):
    def largest(self, urdf, *words):
        return self.answer("largest", "--urdf", urdf, *words)

    def assertProven(self, answer, size, slack=0.0):
        self.assertEqual(answer["status"], "proven")
        self.assertLessEqual(answer["size_upper_bound"] - answer["size"], answer["accuracy"])
        self.assertBrackets(answer["size"], size, answer["size_upper_bound"], slack)

    def test_cube_of_the_orthoglide(self):
        for accuracy in (1e-2, 1e-3, 1e-5, 1e-7):
            answer = self.largest(ORTHOGLIDE, "--accuracy", accuracy)
            self.assertProven(answer, CUBE, 1e-12)
            self.assertEqual(answer["accuracy"], accuracy)

    def test_joint_ranges_of_the_orthoglide(self):
        answer = self.largest(ORTHOGLIDE, "--accuracy", 1e-7)
        self.assertEqual([entry["joint"] for entry in answer["joint_ranges"]], ["rail_x", "rail_y", "rail_z"])
        for entry in answer["joint_ranges"]:
            self.assertAlmostEqual(entry["stroke"], CUBE_STROKE, delta=1e-5)
            self.assertAlmostEqual(entry["across"], CUBE_ACROSS, delta=1e-5)
            self.assertGreaterEqual(entry["upper"] - entry["lower"], entry["stroke"] - 1e-6)

    def test_joint_ranges_are_enclosed_up_to_the_border_of_reach(self):
        answer = self.largest(URANESX, "--set", "reachable", "--force-max", 2, "--shape", "square")
        x, y, z = answer["center"]
        for entry, turn in zip(answer["joint_ranges"], (0, 2 * math.pi / 3, 4 * math.pi / 3)):
            offset = [abs(x - 11 / 26 * math.cos(turn)), abs(y - 11 / 26 * math.sin(turn))]
            far = sum((d + answer["size"] / 2)**2 for d in offset)
            near = sum(max(0, d - answer["size"] / 2)**2 for d in offset)
            ends = {"lower": z + math.sqrt(max(0, 1 - far)), "upper": z + math.sqrt(1 - near)}
            for end, value in ends.items():
                lower, upper = entry["enclosures"][end]
                self.assertBrackets(lower, value, upper, 1e-7)
                self.assertLess(upper - lower, 1e-6)
            self.assertEqual(entry["lower"], entry["enclosures"]["lower"][0])
            self.assertEqual(entry["upper"], entry["enclosures"]["upper"][1])
            for width in ("stroke", "across"):
                self.assertEqual(entry[width], entry["enclosures"][width][1])

    def test_cubes_for_other_bounds(self):
        for factor, edge in ((1.5, 0.397924), (2.5, 0.733668), (3, 0.786583), (4, 0.845790)):
            answer = self.largest(ORTHOGLIDE, "--psi-min", 1 / factor, "--psi-max", factor, "--accuracy", 1e-4)
            self.assertProven(answer, edge, SEARCH)
            self.assertEqual(answer["psi_max"], factor)

    def test_squares_of_the_uranesx(self):
        for shift, paper, edge in ((0, 0.51, 0.51949), (0.05, 0.47, 0.47585), (0.1, 0.42, 0.42859),
                                   (0.15, 0.37, 0.377935), (0.2, 0.32, 0.324062), (-0.035, 0, 0.54774)):
            urdf = self.machine("--machine", "uranesx", "--lambda", shift)
            answer = self.largest(urdf, "--shape", "square", "--accuracy", 1e-4)
            self.assertProven(answer, edge, SEARCH)
            self.assertGreater(answer["size"], paper)
            self.assertNotIn("volume", answer)

    def test_other_lengths(self):
        for length in (0.31058, 1000):
            urdf = self.machine("--machine", "orthoglide", "--length", length)
            answer = self.largest(urdf, "--accuracy", 1e-4 * length)
            self.assertProven(answer, CUBE * length, 1e-12 * length)

    def test_region_is_inside_and_one_of_the_upper_bound_is_not(self):
        for name, words in SHAPES.items():
            answer = self.largest(ORTHOGLIDE, "--shape", name, *words)
            check = lambda sides: self.answer("check", "--urdf", ORTHOGLIDE, "--center", *answer["center"],
                                              "--sides", *sides)["verdict"]
            self.assertEqual(check(answer["dimensions"]), "inside")
            growth = answer["size_upper_bound"] / answer["size"] * (1 + 1e-12)
            self.assertEqual(check([growth * side for side in answer["dimensions"]]), "outside")

    def test_volume_brackets(self):
        for name, words in SOLIDS.items():
            answer = self.largest(ORTHOGLIDE, "--shape", name, *words)
            product = Fraction(2 if name == "box" else 1)
            self.assertLessEqual(Fraction(answer["volume"]), product * Fraction(answer["size"])**3)
            self.assertGreaterEqual(Fraction(answer["volume_upper_bound"]),
                                    product * Fraction(answer["size_upper_bound"])**3)

    def test_round_shapes(self):
        sphere = self.largest(ORTHOGLIDE, "--shape", "sphere")
        self.assertBrackets(sphere["size"], 0.53037, sphere["size_upper_bound"], 1e-6)
        self.assertEqual(sphere["dimensions"], [sphere["size"]])
        self.assertLessEqual(sphere["volume"], 4 / 3 * 3.1415926535 * sphere["size"]**3 * (1 + 1e-9))
        disc = self.largest(URANESX, "--shape", "disc", "--joint-limits", "off")
        self.assertBrackets(disc["size"], 0.355406, disc["size_upper_bound"], 1e-5)
        self.assertEqual(disc["dimensions"], [0, disc["size"]])
        cylinder = self.largest(ORTHOGLIDE, "--shape", "cylinder", "--ratio", 0.5, 0.5)
        self.assertEqual(cylinder["status"], "proven")
        self.assertEqual(cylinder["dimensions"], [cylinder["size"], cylinder["size"] / 2])
        text = self.text("largest", "--urdf", ORTHOGLIDE, "--shape", "cylinder", "--ratio", 1, 1, "--accuracy", 0.01)
        self.assertRegex(text, r"dimensions +0\.\d+ x 0\.\d+ m, height x radius\n")

    def test_a_free_ratio_is_bracketed_by_its_volume(self):
        words = ("--shape", "cylinder", "--accuracy", 1e-2, "--ratio")
        free = self.largest(ORTHOGLIDE, *words, 0.5, 0.8)
        self.assertEqual(free["status"], "proven")
        self.assertEqual(free["ratio"], [0.5, 0.8])
        for ratio in (0.5, 0.65, 0.8):
            fixed = self.largest(ORTHOGLIDE, *words, ratio, ratio)
            self.assertIsNone(fixed["ratio"])
            self.assertLessEqual(fixed["volume"], free["volume_upper_bound"])
            self.assertLessEqual(fixed["size"], free["size_upper_bound"])
            if ratio == 0.5:
                self.assertGreater(fixed["size"], free["size"] + 0.05)
        text = self.text("largest", "--urdf", ORTHOGLIDE, *words, 0.5, 0.8)
        self.assertNotRegex(text, r"size\s+above")
        claimed = re.search(r"0\.5\s+to\s+0\.8\s+times\s+its\s+height\s+and\s+a\s+volume\s+above\s+(\S+)\s+m\^3", text)
        self.assertGreaterEqual(Fraction(claimed.group(1)), Fraction(free["volume_upper_bound"]))

    def test_a_machine_whose_limits_leave_nothing(self):
        urdf = self.file("empty.urdf", self.with_limits(ORTHOGLIDE, 5, 6))
        for words in (["cube"], ["sphere"], ["cylinder", "--ratio", 0.5, 0.5], ["cylinder", "--ratio", 0.5, 1]):
            answer = self.largest(urdf, "--joint-limits", "on", "--time-limit", 1, "--shape", *words)
            self.assertEqual((answer["status"], answer["size"], answer["size_upper_bound"]), ("none", 0, 0))

    def test_search_box_and_center(self):
        everywhere = self.largest(ORTHOGLIDE, "--search-box", -1, 1, -1, 1, -1, 1)
        self.assertProven(everywhere, CUBE, 1e-12)
        origin = self.largest(ORTHOGLIDE, "--center", 0, 0, 0)
        self.assertEqual(origin["center"], [0, 0, 0])
        same = self.largest(ORTHOGLIDE, "--search-box", 0, 0, 0, 0, 0, 0)
        self.assertEqual(origin["size"], same["size"])
        self.assertLess(origin["size_upper_bound"], CUBE)
        aside = self.largest(ORTHOGLIDE, "--search-box", 0.2, 0.3, -0.1, 0, -0.3, 0.1)
        for value, lower, upper in zip(aside["center"], (0.2, -0.1, -0.3), (0.3, 0, 0.1)):
            self.assertBrackets(lower, value, upper)

    def test_joint_limits(self):
        urdf = self.file("near.urdf", self.with_limits(ORTHOGLIDE, -0.1, 0.2))
        self.assertProven(self.largest(urdf, "--joint-limits", "off"), CUBE, 1e-12)
        answer = self.largest(urdf, "--max-boxes", 20000)
        self.assertIs(answer["joint_limits"], True)
        self.assertEqual(answer["status"], "proven")
        self.assertLess(answer["size_upper_bound"], 0.3)
        for entry in answer["joint_ranges"]:
            self.assertGreaterEqual(entry["lower"], -0.1 - 1e-6)
            self.assertLessEqual(entry["upper"], 0.2 + 1e-6)

    def test_budget_ends_with_an_honest_bracket(self):
        answer = self.largest(ORTHOGLIDE, "--max-boxes", 2, "--accuracy", 1e-9)
        self.assertEqual(answer["status"], "stopped")
        self.assertBrackets(answer["size"], CUBE, answer["size_upper_bound"], 1e-12)
        self.assertTrue(answer["message"])

    def test_it_is_said_what_ended_a_search(self):
        for words, ended_by in ((("--time-limit", 1e-9), "the time limit of 1e-09 s"),
                                (("--max-boxes", 2), "the limit of 2 boxes")):
            answer = self.largest(ORTHOGLIDE, "--accuracy", 1e-9, *words)
            self.assertEqual(answer["message"], f"T{ended_by[1:]} ended the search: the bracket holds, but is wide.")

    def test_no_limit_of_time_can_be_asked_for(self):
        self.assertProven(self.largest(ORTHOGLIDE, "--time-limit", 0), CUBE, 1e-12)

    def test_none_is_an_answer(self):
        answer = self.largest(ORTHOGLIDE, "--psi-min", 0.99, "--psi-max", 0.995)
        self.assertEqual(answer["status"], "none")
        self.assertEqual(answer["size"], 0)
        self.assertLessEqual(answer["size_upper_bound"], answer["accuracy"])
        self.assertIsNone(answer["center"])
        self.assertEqual(answer["joint_ranges"], [])
        text = self.text("largest", "--urdf", ORTHOGLIDE, "--psi-min", 0.99, "--psi-max", 0.995)
        self.assertRegex(text, r"status +none")

    def test_the_aspect_is_said_and_may_be_chosen(self):
        other = self.largest(ORTHOGLIDE, "--aspect", "other", "--accuracy", 1e-5)
        self.assertBrackets(other["size"], 0.062854514, other["size_upper_bound"])  # docs/values.md
        self.assertEqual(other["aspect"], "other")
        both = self.largest(ORTHOGLIDE, "--set", "reachable", "--aspect", "both")
        self.assertBrackets(both["size"], math.sqrt(2), both["size_upper_bound"])
        for words, said in (((), "dextrous in the machine's own aspect"),
                            (("--aspect", "other"), "dextrous in the machine's other aspect"),
                            (("--set", "reachable", "--aspect", "both"), "reachable in either aspect"),
                            (("--set", "reachable", "--max-boxes", 10), "reachable in the machine's own aspect")):
            text = re.sub(r"\s+", " ", self.text("largest", "--urdf", ORTHOGLIDE, *words))
            self.assertRegex(text, f"Proved: .*, has all its points {said}\\.")

    def test_threads_prove_the_same(self):
        self.assertProven(self.largest(ORTHOGLIDE, "--threads", 2), CUBE, 1e-12)

    def test_every_answer_describes_itself(self):
        keys = {"status", "center", "dimensions", "size", "size_upper_bound", "joint_ranges", "boxes", "seconds",
                "shape", "accuracy", "psi_min", "psi_max", "joint_limits", "machine", "geometry_hash", "version",
                "message"}
        hashes = set()
        for name, urdf in MACHINES.items():
            answer = self.largest(urdf, "--shape", "square")
            self.assertLessEqual(keys, answer.keys())
            self.assertEqual(answer["machine"], name)
            self.assertEqual(answer["dimensions"][2], 0)
            hashes.add(answer["geometry_hash"])
        self.assertEqual(len(hashes), len(MACHINES))

    def test_text_never_claims_more_than_the_numbers(self):
        for urdf, shape in ((ORTHOGLIDE, "cube"), (URANESX, "square")):
            for accuracy in (1e-2, 1e-4, 3e-6):
                words = ("--urdf", urdf, "--shape", shape, "--accuracy", accuracy, "--joint-limits", "off")
                answer, text = self.answer("largest", *words), self.text("largest", *words)
                number = lambda pattern: Fraction(re.search(pattern, text).group(1))
                self.assertLessEqual(number(r"edge \[m\] +(\S+)"), Fraction(answer["size"]))
                self.assertGreaterEqual(number(r"upper bound +(\S+)"), Fraction(answer["size_upper_bound"]))
                self.assertGreaterEqual(number(r"a\s+size\s+above\s+(\S+),"), Fraction(answer["size_upper_bound"]))
                for entry in answer["joint_ranges"]:
                    row = re.search(entry["joint"] + r" +(\S+) +(\S+) +(\S+) +(\S+)", text).groups()
                    lower, upper, stroke, across = map(Fraction, row)
                    self.assertLessEqual(lower, Fraction(entry["lower"]))
                    self.assertGreaterEqual(upper, Fraction(entry["upper"]))
                    self.assertGreaterEqual(stroke, Fraction(entry["stroke"]))
                    self.assertGreaterEqual(across, Fraction(entry["across"]))

    def test_rails_that_cannot_move_are_named(self):
        fixed = self.file("fixed.urdf", self.with_limits(ORTHOGLIDE, 0, 0))
        answer = self.answer("largest", "--urdf", fixed, "--set", "reachable")
        self.assertEqual(answer["status"], "none")
        self.assertRegex(answer["message"], "proved: the joint limits hold 'rail_x', 'rail_y', 'rail_z' fixed")

    def test_bounds_that_fit_the_machine(self):
        delta = str(DATA / "equal_homes.urdf")
        words = ("--shape", "disc", "--accuracy", 0.01)
        fitting = self.largest(delta, *words, "--psi", "auto")
        self.assertEqual((fitting["psi_min"], fitting["psi_max"]), (0.25, 3.9))
        self.assertEqual(fitting["size"], self.largest(delta, *words, "--psi-min", 0.25, "--psi-max", 3.9)["size"])
        said = run("largest", "--urdf", delta, *words, "--psi", "auto").stderr
        self.assertIn("pkm: note: psi in [0.25, 3.9]: about twice as wide as at the best point, (", said)
        said = run("largest", "--urdf", delta, *words).stderr
        self.assertIn("pkm: warning: the default bounds of psi, [0.5, 2], suit the paper's machines", said)
        self.assertIn("the legs are drawn up to 0.000324 m apart at joint values 0 (allowed: 0.00269 m)", said)
        self.assertEqual(run("largest", "--urdf", ORTHOGLIDE, "--accuracy", 0.1).stderr, "")


if __name__ == "__main__":
    unittest.main()
