#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Joint limits hold unless they are left aside; then the answer tells which rails would leave them, and by how much."""

import re
import unittest

from pkm import DATA, ORTHOGLIDE, URANESX, CommandTest, run

LEAN = str(DATA / "lean_delta.urdf")  # rails that lean by 0.8 degrees; limits -0.34 and 0.35 m
DISC = ("--shape", "disc", "--psi-min", 0.3, "--psi-max", 2.5, "--max-boxes", 2000)
LOWER, UPPER = -0.34, 0.35
TOUCH = 1e-12


class Limits(CommandTest):
    def test_every_command_keeps_to_them_and_says_so_beside_the_aspect(self):
        origin = ("--urdf", ORTHOGLIDE)
        for words in (("evaluate", *origin, "--point", 0, 0, 0), ("largest", *origin), ("compare", *origin),
                      ("check", *origin, "--center", 0, 0, 0, "--sides", 0.1, 0.1, 0.1),
                      ("path", *origin, "--segment", "start 0 0 0", "--segment", "line 0.1 0 0"),
                      ("pave", *origin, "--resolution", 0.2), ("singularities", *origin, "--max-boxes", 100),
                      ("conditioning", *origin, "--accuracy", 0.3),
                      ("study", *origin, *origin, "--range", 0, 0.1, "--accuracy", 0.1)):
            with self.subTest(words):
                answer = self.answer(*words)
                said = answer.get("machines", [answer])[0]
                self.assertIs(said["joint_limits"], True)
                aspect, in_words = ("both", "either") if words[0] == "singularities" else ("own", "its own")
                self.assertEqual(said["aspect"], aspect)
                self.assertRegex(self.text(*words), rf"in\s+{in_words}\s+aspect")
                off = self.answer(*words, "--joint-limits", "off")
                self.assertIs(off.get("machines", [off])[0]["joint_limits"], False)

    def test_the_region_lies_where_the_rails_reach(self):
        answer = self.answer("largest", "--urdf", LEAN, *DISC)
        self.assertGreater(answer["size"], 0.05)
        for joint in answer["joint_ranges"]:
            self.assertGreaterEqual(joint["lower"], LOWER - TOUCH)
            self.assertLessEqual(joint["upper"], UPPER + TOUCH)
        self.assertNotIn("beyond_limits", answer)
        self.assertNotIn("Joint limits", answer["message"])

    def test_without_them_the_answer_tells_what_it_breaks(self):
        words = ("largest", "--urdf", LEAN, *DISC, "--joint-limits", "off")
        answer, text = self.answer(*words), re.sub(r"\s+", " ", self.text(*words))
        self.assertGreater(answer["center"][2], 1)  # above the machine
        beyond = answer["beyond_limits"]
        self.assertEqual([(one["joint"], one["limit"]) for one in beyond],
                         [(f"tower_{leg}", "upper") for leg in (1, 2, 3)])
        for one, joint in zip(beyond, answer["joint_ranges"]):
            self.assertLessEqual(one["by"][0], joint["upper"] - UPPER + TOUCH)
            self.assertGreaterEqual(one["by"][1], joint["upper"] - UPPER - TOUCH)
            told = re.search(f"'{one['joint']}' would leave its upper limit, 0.35 m, by at least ([0-9.]+) m", text)
            self.assertLessEqual(float(told.group(1)), one["by"][0])
            self.assertGreater(float(told.group(1)), 0.9 * one["by"][0])
            self.assertIn(told[0], answer["message"])

    def test_boxes_paths_and_points_tell_it_too(self):
        near = self.file("near.urdf", self.with_limits(ORTHOGLIDE, -0.1, 0.15))
        phrase = r"Joint limits are off: 'rail_x' would leave its upper limit, 0.15 m, by at least 0.(1|09)[0-9]* m"
        for words in (("evaluate", "--point", 0.25, 0, 0),
                      ("check", "--center", 0.2, 0, 0, "--sides", 0.1, 0.01, 0.01),
                      ("path", "--segment", "start 0 0 0", "--segment", "line 0.25 0 0")):
            with self.subTest(words):
                answer = self.answer(words[0], "--urdf", near, *words[1:], "--joint-limits", "off")
                self.assertRegex(answer["message"], phrase)
                self.assertEqual([one["joint"] for one in answer["beyond_limits"]], ["rail_x"])
                kept = self.answer(words[0], "--urdf", near, *words[1:])
                self.assertNotRegex(kept["message"], "Joint limits are off")
        within = self.answer("evaluate", "--urdf", near, "--point", 0, 0, 0, "--joint-limits", "off")
        self.assertRegex(within["message"], "Joint limits are off: all rails stay within their limits.$")

    def test_sets_and_boxes_of_many_centers_tell_it_too(self):
        near = ("--urdf", self.file("near.urdf", self.with_limits(ORTHOGLIDE, -0.1, 0.15)))
        sides = ("--sides", 0.1, 0.1, 0)
        for words, least in ((("check", *near, "--centers", 0.1, 0.2, -0.01, 0.01, 0, 0, *sides), 0.1),
                             (("check", *near, "--centers", 0, 2, -0.01, 0.01, 0, 0, *sides), 0.1),
                             (("pave", *near, "--resolution", 0.1), 0.4),
                             (("pave", *near, "--resolution", 0.1, "--box", 0.1, 0.2, -0.1, 0.1, -0.1, 0.1), 0.04),
                             (("conditioning", *near, "--accuracy", 0.3), 0.4),
                             (("singularities", *near, "--max-boxes", 100), 0.9),
                             (("singularities", *near, "--shape", "cube", "--center", 0.2, 0, 0, "--size", 0.1), 0.1)):
            with self.subTest(words):
                answer, text = (tell(*words, "--joint-limits", "off") for tell in (self.answer, self.text))
                ends = {(one["joint"], one["limit"]): one for one in answer["beyond_limits"]}
                beyond = ends["rail_x", "upper"]
                self.assertBrackets(least, beyond["by"][0], beyond["by"][1])
                told = re.search(r"Joint limits are off: .*'rail_x' would leave its upper limit, 0.15 m, by at least "
                                 r"([0-9.]+) m", re.sub(r"\s+", " ", text))
                self.assertLessEqual(float(told[1]), beyond["by"][0])
                self.assertIn(told[0], answer["message"])
                kept = self.answer(*words)
                self.assertNotIn("beyond_limits", kept)
                self.assertNotIn("Joint limits are off", self.text(*words))
        nowhere = ("check", *near, "--centers", 2, 3, 2, 3, 2, 3, "--sides", 0.1, 0.1, 0.1, "--joint-limits", "off")
        self.assertEqual(self.answer(*nowhere)["beyond_limits"], [])
        self.assertNotIn("Joint limits are off", self.text(*nowhere))

    def test_a_set_along_parallel_rails_passes_limits_by_any_length(self):
        for words in (("pave", "--resolution", 0.1), ("conditioning", "--accuracy", 0.3)):
            text = self.text(words[0], "--urdf", URANESX, *words[1:], "--joint-limits", "off")
            self.assertRegex(re.sub(r"\s+", " ", text), r"'rail_3' would leave its lower limit, \S+ m, by any length;")

    def test_a_set_that_limits_leave_without_an_end_names_the_rails_and_the_remedy(self):
        """Limits of a thousand kilometres: only a box bounds what lies along parallel rails."""
        far = self.file("far.urdf", self.with_limits(URANESX, -0.05, 1e6))
        refused = run("pave", "--urdf", far)
        self.assertEqual(refused.returncode, 2)
        self.assertRegex(refused.stderr, "longer than 1000 struts; the joints go: 'rail_1' from -0.05 to 1.* m, "
                         "'rail_2' .*: ask for closer joint limits at both ends of a rail, or for a --box\n")
        box = ("--box", -0.2, 0.2, -0.2, 0.2, -1, 0)
        self.assertGreater(self.answer("pave", "--urdf", far, *box)["volume_lower"], 0.0)

    def test_rails_that_hardly_lean_are_answered_as_their_neighbours(self):
        answer = self.answer("largest", "--urdf", DATA / "lean_rails.urdf", "--max-boxes", 2000)
        self.assertGreater(answer["size"], 0.01)
        self.assertLess(abs(answer["center"][2]), 0.5)


class Scale(CommandTest):
    def test_defaults_are_shares_of_the_machine(self):
        small = ("--urdf", DATA / "small_stage.urdf")  # struts of 7 cm
        largest = self.answer("largest", *small, "--shape", "disc")
        self.assertEqual(largest["accuracy"], 7e-5)
        self.assertEqual(largest["status"], "proven")
        self.assertEqual(self.answer("largest", "--urdf", ORTHOGLIDE)["accuracy"], 1e-3)
        self.assertEqual(self.answer("compare", *small, "--shape", "disc")["machines"][0]["accuracy"], 7e-5)
        long = (*small, "--shape", "box", "--proportions", *[1e9] * 3, "--max-boxes", 100)  # its unit is a thousand km
        self.assertEqual(self.answer("compare", *long)["machines"][0]["accuracy"],
                         self.answer("largest", *long)["accuracy"])
        self.assertEqual(self.answer("pave", "--urdf", ORTHOGLIDE)["resolution"], 0.05)
        self.assertLess(self.answer("pave", *small)["resolution"], 0.004)


if __name__ == "__main__":
    unittest.main()
