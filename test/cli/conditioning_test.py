#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm conditioning and pkm singularities: brackets around known values, and what they refuse."""

import unittest

from pkm import ORTHOGLIDE, URANESX, CommandTest, run

CUBE = ("--shape", "cube", "--center", "0.0863", "0.0863", "0.0863", "--size", "0.6439")


class AnalysisTest(CommandTest):
    def assertRefused(self, reason, *words):
        process = run(*words)
        self.assertEqual(process.returncode, 2, process.stdout)
        self.assertRegex(process.stderr, reason)


class Conditioning(AnalysisTest):
    def test_index_of_the_largest_cube_closes_in(self):
        last = [0.0, 1.0]
        for accuracy in (0.1, 0.02):
            answer = self.answer("conditioning", "--urdf", ORTHOGLIDE, *CUBE, "--accuracy", accuracy)
            lower, upper = answer["index"]
            self.assertTrue(answer["complete"])
            self.assertLessEqual(upper - lower, accuracy)
            self.assertLessEqual(max(lower, last[0]), min(upper, last[1]))
            self.assertBrackets(*[answer["measure"][0], 0.6439 ** 3, answer["measure"][1], 1e-12])
            last = [lower, upper]

    def test_a_point_like_region_has_the_index_of_its_point(self):
        # docs/values.md: at (t, t, t) with k = t / sqrt(1 - 2 t^2) = 1/4 the factors are 3/4 and 3/2
        t = 0.25 / (1.0 + 2.0 / 16.0) ** 0.5
        answer = self.answer("conditioning", "--urdf", ORTHOGLIDE, "--shape", "cube", "--center", t, t, t,
                             "--size", 1e-9)
        self.assertBrackets(answer["index"][0], 0.5, answer["index"][1], 1e-8)

    def test_a_body_is_given_by_its_size_or_by_what_it_measures(self):
        at = ("conditioning", "--urdf", ORTHOGLIDE, "--center", 0, 0, 0, "--accuracy", 0.1)
        for named, measured in ((("--shape", "sphere", "--size", 0.25), ("--radius", 0.25)),
                                (("--shape", "cylinder", "--ratio", 0.5, 0.5, "--size", 0.25),
                                 ("--radius", 0.125, "--height", 0.25)),
                                (("--shape", "cube", "--size", 0.25), ("--sides", 0.25, 0.25, 0.25))):
            one, other = self.answer(*at, *named), self.answer(*at, *measured)
            self.assertEqual((one["index"], one["measure"]), (other["index"], other["measure"]))

    def test_no_criterion_is_told_of_a_region(self):
        answer = self.answer("conditioning", "--urdf", ORTHOGLIDE, *CUBE, "--accuracy", 0.1)
        self.assertFalse({"set", "aspect", "joint_limits", "psi_min", "psi_max"} & set(answer))

    def test_the_whole_set_and_its_budget(self):
        answer = self.answer("conditioning", "--urdf", URANESX, "--joint-limits", "off", "--accuracy", 0.1)
        self.assertTrue(answer["complete"])
        self.assertEqual(answer["over"], "set")
        self.assertBrackets(0.25, answer["index"][0], answer["index"][1])
        for words, ended_by in ((("--max-boxes", 100), "the limit of 100 boxes"),
                                (("--time-limit", 1e-9), "the time limit of 1e-09 s")):
            stopped = self.answer("conditioning", "--urdf", ORTHOGLIDE, *words)
            self.assertFalse(stopped["complete"])
            self.assertEqual(f"Nothing is proved of the global conditioning index: {ended_by} ended the computation.",
                             stopped["message"])

    def test_a_set_without_a_volume_has_no_index(self):
        answer = self.answer("conditioning", "--urdf", ORTHOGLIDE, "--psi-min", 0.99, "--psi-max", 0.995)
        self.assertEqual(answer["index"], [0, 1])
        self.assertEqual(answer["message"], "Nothing is proved of the global conditioning index: the set has no proved "
                         "volume.")

    def test_the_memory_is_a_limit(self):
        words = ("conditioning", "--urdf", ORTHOGLIDE, *CUBE, "--accuracy", "1e-9", "--max-memory", "50000")
        answer = self.answer(*words)
        self.assertFalse(answer["complete"])
        self.assertIn("the limit of 50000 bytes of memory ended it", answer["message"])

    def test_out_of_reach_it_is_0(self):
        words = ("conditioning", "--urdf", ORTHOGLIDE, "--shape", "sphere", "--center", "9", "9", "9", "--size", "0.1",
                 "--max-boxes", "20000")
        answer = self.answer(*words)
        self.assertTrue(answer["complete"])
        self.assertEqual(answer["index"], [0, 0])
        self.assertIn("The struts reach no point of it", answer["message"])

    def test_refusals(self):
        for words, reason in (((*CUBE[:-2],), "--center and --size, --sides or --radius go together"),
                              (("--shape", "sphere"), "--shape needs --size"),
                              (("--radius", "0.1"), "--center and --size, --sides or --radius go together"),
                              ((*CUBE, "--max-memory", "4095"), "max-memory 4095: must be at least 4096 bytes"),
                              ((*CUBE, "--aspect", "other"), "all points of a region count: leave out --aspect"),
                              ((*CUBE, "--psi-min", "0.4"), "all points of a region count: leave out --psi-min"),
                              ((*CUBE, "--accuracy", "0"), "accuracy.*> 0"),
                              ((*CUBE[:-1], "-1"), "size.*> 0 m")):
            self.assertRefused(reason, "conditioning", "--urdf", ORTHOGLIDE, *words)


class Singularities(AnalysisTest):
    def test_none_in_the_largest_cube(self):
        answer = self.answer("singularities", "--urdf", ORTHOGLIDE, *CUBE)
        for found in (*answer["serial"], answer["parallel"]):
            self.assertIs(found["exists"], False)
            self.assertGreater(found["least"][0], 0.0)

    def test_one_among_all_reachable_points(self):
        answer = self.answer("singularities", "--urdf", ORTHOGLIDE)
        self.assertIs(answer["parallel"]["exists"], True)
        for lower, upper in zip(answer["parallel"]["box"]["lower"], answer["parallel"]["box"]["upper"]):
            self.assertLessEqual(lower, upper)
        self.assertEqual(answer["over"], "set")
        self.assertIn("parallel", self.text("singularities", "--urdf", ORTHOGLIDE))

    def test_it_is_said_what_ended_a_search(self):
        for words, ended_by in ((("--max-boxes", 1), "the limit of 1 box"),
                                (("--time-limit", 1e-9), "the time limit of 1e-09 s")):
            answer = self.answer("singularities", "--urdf", ORTHOGLIDE, *CUBE, "--accuracy", 1e-9, *words)
            self.assertIsNone(answer["parallel"]["exists"])
            self.assertIn(f"{ended_by} ended the search", answer["message"])

    def test_refusals(self):
        self.assertRefused("--shape needs --size", "singularities", "--urdf", ORTHOGLIDE, "--shape", "cube")


if __name__ == "__main__":
    unittest.main()
