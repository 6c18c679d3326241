#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm evaluate against the closed forms of the paper's machines."""

import math
import unittest

from pkm import MACHINES, ORTHOGLIDE, URANESX, CommandTest


class Evaluate(CommandTest):
    def evaluate(self, urdf, point, *words):
        return self.answer("evaluate", "--urdf", urdf, "--point", *point, *words)

    def assertVectorsNear(self, vector, expected):
        self.assertEqual(len(vector), len(expected))
        for value, wanted in zip(vector, expected):
            self.assertAlmostEqual(value, wanted, places=12)

    def test_isotropic_point_of_the_orthoglide(self):
        answer = self.evaluate(ORTHOGLIDE, (0, 0, 0))
        self.assertVectorsNear(answer["psi"], [1, 1, 1])
        self.assertVectorsNear(answer["rho"], [0, 0, 0])
        self.assertAlmostEqual(answer["condition"], 1, places=12)
        self.assertAlmostEqual(answer["serial_singularity"], 1, places=12)
        self.assertAlmostEqual(answer["parallel_singularity"], 1, places=12)
        for key in ("within_reach", "dextrous", "aspect_ok"):
            self.assertIs(answer[key], True, key)

    def test_diagonal_of_the_orthoglide(self):
        for t in (-0.2, 0.1, 0.3):
            k = t / math.sqrt(1 - 2 * t * t)
            psi = sorted([1 + 2 * k, 1 - k, 1 - k])
            answer = self.evaluate(ORTHOGLIDE, (t, t, t))
            self.assertVectorsNear(answer["psi"], psi)
            self.assertAlmostEqual(answer["condition"], psi[2] / psi[0], places=11)
            self.assertVectorsNear(answer["rho"], [t + 1 - math.sqrt(1 - 2 * t * t)] * 3)

    def test_axis_of_the_uranesx(self):
        across = 7 / 13 - 3 / 26  # R - r: the struts' part across the rails, evenly spread around the axis
        along = math.sqrt(1 - across**2)
        answer = self.evaluate(URANESX, (0, 0, 0.25))
        self.assertVectorsNear(answer["psi"], sorted([math.sqrt(1.5) * across / along] * 2 + [math.sqrt(3)]))
        self.assertVectorsNear(answer["rho"], [0.25 + along] * 3)

    def test_unreachable_point_is_an_answer(self):
        for name, urdf in MACHINES.items():
            with self.subTest(name):
                answer = self.evaluate(urdf, (2, 0, 0))
                self.assertIs(answer["within_reach"], False)
                self.assertIs(answer["dextrous"], False)
                for key in ("psi", "rho", "condition", "aspect_ok"):
                    self.assertIsNone(answer[key], key)
                self.assertRegex(answer["message"], "strut of 'rail_.*' is 1 m long and would have to reach [0-9.]+ m")

    def test_other_aspect_is_not_dextrous(self):
        answer = self.evaluate(ORTHOGLIDE, (-0.546, -0.546, -0.546))
        self.assertIs(answer["within_reach"], True)
        self.assertIs(answer["aspect_ok"], False)
        self.assertIs(answer["dextrous"], False)
        self.assertRegex(answer["message"], "not dextrous in the machine's own aspect: det A has the wrong sign")

    def test_within_reach_and_reachable_are_two_things(self):
        point = (-0.546, -0.546, -0.546)
        text = self.text("evaluate", "--urdf", ORTHOGLIDE, "--set", "reachable", "--point", *point)
        self.assertRegex(text, r"within reach +yes \(proved\)\n +reachable +no \(proved\)\n")
        self.assertRegex(text, r"Proved: the point is not reachable in the machine's own aspect: det A")
        for aspect, words in (("other", "in the machine's other aspect"), ("both", "in either aspect")):
            answer = self.evaluate(ORTHOGLIDE, point, "--aspect", aspect)
            self.assertIs(answer["dextrous"], True)
            self.assertIn(f"Proved: the point is dextrous {words}; the nearest limit: ", answer["message"])

    def test_psi_bounds_decide(self):
        point = (0.3, 0.3, 0.3)
        least, _, largest = self.evaluate(ORTHOGLIDE, point)["psi"]
        self.assertIs(self.evaluate(ORTHOGLIDE, point, "--psi-max", largest + 1e-9)["dextrous"], True)
        refused = self.evaluate(ORTHOGLIDE, point, "--psi-max", largest - 1e-9)
        self.assertIs(refused["dextrous"], False)
        self.assertEqual(refused["psi_max"], largest - 1e-9)
        self.assertRegex(refused["message"], "largest velocity transmission factor is above .*, by at most ")
        below = self.evaluate(ORTHOGLIDE, point, "--psi-min", least + 1e-9)
        self.assertRegex(below["message"], "least velocity transmission factor is below .*, by at most ")

    def test_force_factors_and_condition_decide(self):
        """Force factors are the reciprocals of psi; the condition number is the ratio of the outer two."""
        point = (0.3, 0.3, 0.3)
        psi = self.evaluate(ORTHOGLIDE, point)["psi"]
        for option, limit, low, text in (("--force-max", 1 / psi[0], False, "largest force transmission factor"),
                                         ("--force-min", 1 / psi[2], True, "least force transmission factor"),
                                         ("--kappa-max", psi[2] / psi[0], False, "condition number of J")):
            for words in ((), ("--set", "reachable")):
                kept = self.evaluate(ORTHOGLIDE, point, *words, option, limit * (1 - 1e-9 if low else 1 + 1e-9))
                self.assertIs(kept["satisfies"], True, option)
                bound = limit * (1 + 1e-9 if low else 1 - 1e-9)
                refused = self.evaluate(ORTHOGLIDE, point, *words, option, bound)
                self.assertIs(refused["satisfies"], False, option)
                self.assertEqual("dextrous" in refused, not words)
                self.assertEqual(refused[option[2:].replace("-", "_")], bound)
                self.assertRegex(refused["message"], text)

    def test_points_of_a_file_answer_as_each_alone(self):
        points = [(0, 0, 0), (0.3, -0.1, 0.2), (2, 0, 0)]
        text = "# X Y Z\n\n" + "".join(f"{x} {y}\t{z}  # a point\n" for x, y, z in points)
        file = self.file("points.txt", text)
        answer = self.answer("evaluate", "--urdf", ORTHOGLIDE, "--points", file)
        self.assertEqual(len(answer["points"]), len(points))
        for point, state in zip(points, answer["points"]):
            alone = self.evaluate(ORTHOGLIDE, point)
            self.assertEqual(state, {key: alone[key] for key in state})
        table = self.text("evaluate", "--urdf", ORTHOGLIDE, "--points", file)
        self.assertRegex(table, r"(?m)^  2 +0 +0 +- +- +- +no$")

    def test_points_that_are_left_out_are_counted(self):
        file = self.file("points.txt", "0.1 0.2 -0.3\n" * 100000)
        answer = self.answer("evaluate", "--urdf", ORTHOGLIDE, "--points", file, "--time-limit", 1e-6)
        self.assertGreater(answer["points_left"], 0)
        self.assertEqual(len(answer["points"]) + answer["points_left"], 100000)
        text = self.text("evaluate", "--urdf", ORTHOGLIDE, "--points", file, "--time-limit", 1e-6)
        self.assertRegex(text, r"(?m)^\d+ points are left out: the time limit of 1e-06 s \(--time-limit\)")

    def test_a_table_says_which_limits_its_points_pass(self):
        urdf = self.file("near.urdf", self.with_limits(ORTHOGLIDE, -0.1, 0.1))
        file = self.file("points.txt", "0 0 0\n0.25 0 0\n0 0 3\n")
        text = self.text("evaluate", "--urdf", urdf, "--joint-limits", "off", "--points", file)
        self.assertRegex(text, "Joint limits are off: .rail_x. would leave its upper limit, 0.1 m, by at least 0.149")
        file = self.file("point.txt", "0 0 0\n")
        text = self.text("evaluate", "--urdf", urdf, "--joint-limits", "off", "--points", file)
        self.assertIn("Joint limits are off: all rails stay within their limits.", " ".join(text.split()))

    def test_border_is_undecided(self):
        answer = self.evaluate(ORTHOGLIDE, (0, 0, 0), "--psi-min", 1, "--psi-max", 1)
        self.assertIsNone(answer["dextrous"])
        self.assertIn("Neither is proved: the border of the set is within rounding of the point, where the ",
                      answer["message"])

    def test_joint_limits_decide_unless_they_are_left_aside(self):
        urdf = self.file("near.urdf", self.with_limits(ORTHOGLIDE, -0.1, 0.1))
        point = (0.25, 0, 0)
        free = self.evaluate(urdf, point, "--joint-limits", "off")
        self.assertEqual((free["dextrous"], free["joint_limits"]), (True, False))
        refused = self.evaluate(urdf, point)
        self.assertIs(refused["joint_limits"], True)
        self.assertIs(refused["dextrous"], False)
        self.assertIs(refused["within_reach"], True)
        self.assertRegex(refused["message"], "joint 'rail_x' would be at 0.25 m, above its upper limit of 0.1 m")

    def test_text_names_values_with_units(self):
        text = self.text("evaluate", "--urdf", ORTHOGLIDE, "--point", "-0.1", "0", "0.2")
        for line in (r"within reach +yes \(proved\)", r"psi +[0-9.]+  [0-9.]+  [0-9.]+", r"rho( +-?[0-9.]+ m){3}"):
            self.assertRegex(text, line)


if __name__ == "__main__":
    unittest.main()
