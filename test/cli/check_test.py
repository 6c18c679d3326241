#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm check: verdicts without tolerance, and bad points that are bad."""

import math
import unittest

from pkm import ORTHOGLIDE, URANESX, CommandTest

CUBE = 1 / math.sqrt(6) + 1 / (3 * math.sqrt(2))  # largest cube of the unit Orthoglide, edge [m]
CENTER = [0.086273015] * 3  # its center [m], printed digits of the reference


class Check(CommandTest):
    def check(self, urdf, center, sides, *words):
        return self.answer("check", "--urdf", urdf, "--center", *center, "--sides", *sides, *words)

    def assertBadPoint(self, urdf, answer):
        """The bad point lies in the box, and pkm evaluate proves that it is bad."""
        point = answer["bad_point"]
        for value, center, side in zip(point, answer["center"], answer["sides"]):
            self.assertLessEqual(abs(value - center), 0.5 * side * (1 + 1e-15))
        self.assertIs(self.answer("evaluate", "--urdf", urdf, "--point", *point)["dextrous"], False)

    def test_cube_of_the_orthoglide_below_the_optimum(self):
        for edge in (0.6, 0.6439, 0.64395):
            answer = self.check(ORTHOGLIDE, CENTER, [edge] * 3)
            self.assertEqual(answer["verdict"], "inside")
            self.assertIsNone(answer["bad_point"])

    def test_cube_of_the_paper_sticks_out(self):
        for edge in (0.644, CUBE + 1e-7):
            answer = self.check(ORTHOGLIDE, CENTER, [edge] * 3)
            self.assertEqual(answer["verdict"], "outside")
            self.assertBadPoint(ORTHOGLIDE, answer)

    def test_square_of_the_uranesx(self):
        for edge, verdict in ((0.5194, "inside"), (0.5196, "outside")):
            answer = self.check(URANESX, (-0.01329, 0, 0), (edge, edge, 0))
            self.assertEqual(answer["verdict"], verdict)
        self.assertBadPoint(URANESX, answer)

    def test_sides_may_be_zero(self):
        self.assertEqual(self.check(ORTHOGLIDE, (0, 0, 0), (0.5, 0, 0))["verdict"], "inside")
        self.assertEqual(self.check(ORTHOGLIDE, (0, 0, 0), (5, 0, 0))["verdict"], "outside")

    def test_round_bodies(self):
        """As test/ros/planner_test.cpp asks the node for them."""
        for body, verdict, shape, dimensions in (
                (("--radius", 0.4), "inside", "sphere", [0.4]), (("--radius", 0.8), "outside", "sphere", [0.8]),
                (("--radius", 0.3, "--height", 0.4), "inside", "cylinder", [0.4, 0.3]),
                (("--radius", 0.9, "--height", 0.4), "outside", "cylinder", [0.4, 0.9]),
                (("--radius", 0.3, "--height", 0), "inside", "disc", [0, 0.3]),
                (("--radius", 0, "--height", 0.3), "inside", "box", [0, 0, 0.3]),
                (("--shape", "cylinder", "--ratio", 0.75, 0.75, "--size", 0.4), "inside", "cylinder", [0.4, 0.3])):
            answer = self.answer("check", "--urdf", ORTHOGLIDE, "--center", 0, 0, 0, *body)
            self.assertEqual((answer["verdict"], answer["shape"]), (verdict, shape))
            for told, asked in zip(answer["dimensions"], dimensions):
                self.assertBrackets(told, asked, told, 1e-15)
            self.assertRegex(answer["message"], rf"(every point|lies in) (of )?the {shape} ")

    def test_what_largest_finds_is_inside_and_its_bound_outside(self):
        for shape in (("sphere", ), ("cylinder", "--ratio", 0.5, 0.5)):
            body = ("--urdf", ORTHOGLIDE, "--shape", *shape)
            found = self.answer("largest", *body, "--accuracy", 0.01)
            for size, verdict in ((found["size"], "inside"), (found["size_upper_bound"] * 1.05, "outside")):
                answer = self.answer("check", *body, "--size", size, "--center", *found["center"])
                self.assertEqual(answer["verdict"], verdict)

    def test_other_aspect_is_outside(self):
        self.assertEqual(self.check(ORTHOGLIDE, [-0.545923012] * 3, [0.06] * 3)["verdict"], "outside")

    def test_budget_leaves_it_undecided(self):
        answer = self.check(ORTHOGLIDE, CENTER, [0.6439] * 3, "--max-boxes", 3)
        self.assertEqual(answer["verdict"], "undecided")
        self.assertIsNone(answer["bad_point"])
        self.assertLessEqual(answer["boxes"], 3)

    def test_joint_limits(self):
        urdf = self.file("near.urdf", self.with_limits(ORTHOGLIDE, -0.1, 0.2))
        box = ((0.05, 0.05, 0.05), (0.28, 0.28, 0.28))
        self.assertEqual(self.check(urdf, *box, "--joint-limits", "off")["verdict"], "inside")
        refused = self.check(urdf, *box)
        self.assertEqual(refused["verdict"], "outside")
        self.assertRegex(refused["message"], r"joint 'rail_.' would be at -?[0-9.]+ m, "
                         r"(below its lower limit of -0.1|above its upper limit of 0.2) m")

    def test_text_tells_the_bad_point_with_all_digits(self):
        words = ("check", "--urdf", ORTHOGLIDE, "--center", *CENTER, "--sides", 0.644, 0.644, 0.644)
        text = self.text(*words)
        self.assertRegex(text, r"verdict +outside")
        self.assertIn("({}, {}, {}) m".format(*self.answer(*words)["bad_point"]), text)
        self.assertRegex(text, "velocity\\s+transmission\\s+factor\\s+is\\s+[0-9.]+,\\s+(above\\s+2|below\\s+0.5)")

    def test_shares_of_the_centers(self):
        for edge, around, share in ((0.64, 1e-4, "all"), (0.5, 0.3, "some")):
            box = [value for center in CENTER for value in (center - around, center + around)]
            answer = self.answer("check", "--urdf", ORTHOGLIDE, "--centers", *box, "--sides", edge, edge, edge)
            self.assertEqual(answer["share"], share)
        far = self.answer("check", "--urdf", ORTHOGLIDE, "--centers", 2, 3, 2, 3, 2, 3, "--sides", 0.1, 0.1, 0.1)
        self.assertEqual(far["share"], "none")
        self.assertIn("none are proved to", self.text("check", "--urdf", ORTHOGLIDE, "--centers", 2, 3, 2, 3, 2, 3,
                                                      "--sides", 0.1, 0.1, 0.1))

    def test_multi_precision_settles_what_doubles_leave_open(self):
        words = ("--multi-precision",)
        self.assertEqual(self.check(ORTHOGLIDE, CENTER, [0.6439] * 3, *words)["verdict"], "inside")
        answer = self.answer("largest", "--urdf", ORTHOGLIDE, "--accuracy", 1e-12, *words)
        self.assertEqual(answer["status"], "proven")
        self.assertBrackets(answer["size"], CUBE, answer["size_upper_bound"], 1e-15)
        self.assertEqual(self.answer("largest", "--urdf", ORTHOGLIDE, "--accuracy", 1e-12)["status"], "stopped")


if __name__ == "__main__":
    unittest.main()
