#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm study: the best machine of a family, against closed forms and dense searches."""

import math
import re
import unittest

from pkm import ORTHOGLIDE, CommandTest, run

JUMP = 2 / (3 * math.sqrt(3))  # the R - r of the UraneSX with the largest square [m]
EDGE = 0.55021  # and its edge, by a search [m]
BY_RADIUS = ("study", "--machine", "uranesx", "--parameter", "R-r", "--shape", "square", "--range")


class Study(CommandTest):
    def test_best_uranesx(self):
        answer = self.answer(*BY_RADIUS, 0.3, 0.5, "--accuracy", 1e-4)
        self.assertEqual(answer["status"], "proven")
        self.assertBrackets(answer["size"], EDGE, answer["size_upper_bound"], 1e-5)
        self.assertLessEqual(answer["size_upper_bound"] - answer["size"], 1e-4)
        self.assertBrackets(JUMP, answer["parameter"], JUMP + 1e-4)
        self.assertEqual(len(answer["candidates"]), 1)
        candidates = answer["candidates"][0]
        self.assertBrackets(candidates["lower"], JUMP, candidates["upper"])
        self.assertLess(candidates["upper"] - candidates["lower"], 2e-4)
        self.assertEqual(answer["family"], {"parameter": "R-r", "unit": "m"})
        self.assertEqual(answer["dimensions"], [answer["size"], answer["size"], 0])

    def test_parts_of_the_paper_s_table(self):
        """docs/values.md: the edges by a search for lambda = 0, 0.05, ...; they fall with lambda."""
        edges = [0.51949, 0.47585, 0.42859, 0.377935]
        answer = self.answer("study", "--machine", "uranesx", "--parameter", "lambda", "--range", 0, 0.2, "--shape",
                             "square", "--parts", 4)
        self.assertEqual(len(answer["parts"]), 4)
        for k, (part, edge) in enumerate(zip(answer["parts"], edges)):
            self.assertAlmostEqual(part["lower"], 0.05 * k, delta=1e-12)
            self.assertBrackets(part["size"], edge, part["size_upper_bound"], 1e-5)
        self.assertEqual(answer["parameter"], 0)
        self.assertIs(answer["joint_limits"], False)
        self.assertEqual([joint["joint"] for joint in answer["joint_ranges"]], ["rail_1", "rail_2", "rail_3"])

    def test_between_two_machines(self):
        """Scaled from L = 1 m to 1.25 m, the largest cube grows with it."""
        larger = self.machine("--machine", "orthoglide", "--length", 1.25)
        answer = self.answer("study", "--urdf", ORTHOGLIDE, "--urdf", larger, "--range", 0, 1, "--accuracy", 0.02,
                             "--joint-limits", "off")
        self.assertEqual(answer["status"], "proven")
        self.assertGreater(answer["parameter"], 0.9)
        edge = 1.25 * (1 / math.sqrt(6) + 1 / (3 * math.sqrt(2)))
        self.assertBrackets(answer["size"], edge, answer["size_upper_bound"])

    def test_families_with_other_legs(self):
        """No machine that pkm largest looks at by itself has more than the family's upper bound."""
        for machine, parameter, lower, upper, accuracy in (("tripod", "base-radius", 0.4, 0.6, 0.04),
                                                           ("delta", "crank", 0.5, 0.54, 0.1)):
            answer = self.answer("study", "--machine", machine, "--parameter", parameter, "--range", lower, upper,
                                 "--accuracy", accuracy, "--time-limit", 3600)
            self.assertEqual((answer["status"], answer["family"]), ("proven", {"parameter": parameter, "unit": "m"}))
            self.assertLessEqual(answer["size_upper_bound"] - answer["size"], accuracy)
            for value in (lower, 0.3 * lower + 0.7 * upper, upper, answer["parameter"]):
                urdf = self.machine("--machine", machine, f"--{parameter}", repr(value))
                found = self.answer("largest", "--urdf", urdf, "--accuracy", 0.01)
                self.assertLessEqual(found["size"], answer["size_upper_bound"])
            self.assertGreaterEqual(found["size_upper_bound"], answer["size"])  # of the best one

    def test_a_parameter_that_a_machine_has_not_is_refused(self):
        process = run("study", "--machine", "tripod", "--parameter", "crank", "--range", 0.1, 0.2)
        self.assertEqual(process.returncode, 2)
        self.assertIn("--parameter crank is none of the tripod; allowed: base-radius, length, platform-radius",
                      process.stderr)
        process = run("study", "--machine", "delta", "--parameter", "length", "--range", 0.5, 1.2)
        self.assertEqual(process.returncode, 2)
        self.assertRegex(process.stderr,
                         r"at zero the legs span 0.644\d* m across, which must be less than their len")

    def test_none_and_budgets_are_answers(self):
        none = self.answer(*BY_RADIUS, 0.45, 0.5, "--psi-min", 1.2, "--psi-max", 1.3)
        self.assertEqual((none["status"], none["size"], none["parameter"]), ("none", 0, None))
        for budget in (("--time-limit", 1e-6), ("--max-boxes", 2000)):
            answer = self.answer(*BY_RADIUS, 0.3, 0.5, "--accuracy", 1e-6, *budget)
            self.assertEqual(answer["status"], "stopped")
            upper = answer["size_upper_bound"]
            self.assertBrackets(answer["size"], EDGE, math.inf if upper is None else upper, 1e-5)

    def test_text_tells_where_a_larger_one_may_be(self):
        process = run(*BY_RADIUS, 0.3, 0.5, "--accuracy", 1e-4, "--parts", 2)
        self.assertEqual(process.returncode, 0)
        self.assertRegex(process.stdout, r"(?m)^  R-r +0\.38490\d+ m$")
        self.assertRegex(process.stdout, r"(?m)^  larger at most at +0\.3848\d* to 0\.3849\d* m, below 0\.55")
        self.assertEqual(len(re.findall(r"(?m)^  0\.[34] .* 0\.[45] ", process.stdout)), 2)


if __name__ == "__main__":
    unittest.main()
