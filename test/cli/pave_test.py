#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm pave: volumes against closed forms and dense searches, budgets and signals."""

import json
import math
import re
import signal
import subprocess
import unittest
from fractions import Fraction

from pkm import MACHINES, ORTHOGLIDE, PKM, URANESX, CommandTest, run

REACHABLE = 8 * (2 - math.sqrt(2))  # unit Orthoglide, both aspects [m^3]
REACHABLE_OWN = 4.227  # and the machine's own one, by a search
DEXTROUS = 1.632  # volume with psi in [0.5, 2], by a search that is good to 0.001
DEXTROUS_OTHER = 0.0059  # and in the other aspect
REFUSED = r"(?m)^pkm: \S*it.paving: the paving is refused: "


class Pave(CommandTest):
    def pave(self, urdf, *words):
        return self.answer("pave", "--urdf", urdf, *words)

    def assertVolume(self, volumes, value, slack=0.0):
        self.assertBrackets(volumes["volume_lower"], value, volumes["volume_upper"], slack)

    def test_dextrous_volume_of_the_orthoglide(self):
        widths = []
        for resolution in (0.1, 0.05, 0.025):
            answer = self.pave(ORTHOGLIDE, "--resolution", resolution)
            self.assertVolume(answer, DEXTROUS, 1e-3)
            self.assertVolume(answer["own_aspect"], DEXTROUS, 1e-3)
            self.assertVolume(answer["other_aspect"], DEXTROUS_OTHER, 1e-4)
            self.assertIs(answer["complete"], True)
            self.assertEqual(answer["dimension"], 3)
            self.assertEqual(answer["boxes_pending"], 0)
            self.assertEqual(answer["resolution"], resolution)
            widths.append(answer["volume_upper"] - answer["volume_lower"])
        self.assertEqual(widths, sorted(widths, reverse=True))

    def test_reachable_volume_of_the_orthoglide(self):
        answer = self.pave(ORTHOGLIDE, "--set", "reachable", "--aspect", "both", "--resolution", 0.05)
        self.assertVolume(answer, REACHABLE)
        self.assertVolume(answer["own_aspect"], REACHABLE_OWN, 1e-3)
        self.assertVolume(answer["other_aspect"], REACHABLE - REACHABLE_OWN, 1e-3)
        self.assertNotIn("psi_min", answer)

    def test_the_aspect_is_the_machine_s_own_unless_another_is_asked_for(self):
        for words, volume, other in (((), DEXTROUS, DEXTROUS_OTHER),
                                     (("--set", "reachable"), REACHABLE_OWN, REACHABLE - REACHABLE_OWN)):
            own = self.pave(ORTHOGLIDE, *words, "--resolution", 0.05)
            self.assertVolume(own, volume, 1e-3)
            self.assertEqual(own["aspect"], "own")
            opposite = self.pave(ORTHOGLIDE, *words, "--resolution", 0.05, "--aspect", "other")
            self.assertVolume(opposite, other, 1e-3)
            self.assertEqual(opposite["aspect"], "other")
            self.assertEqual((own["own_aspect"], own["other_aspect"]),
                             (opposite["own_aspect"], opposite["other_aspect"]))

    def test_box_bounds_what_is_looked_at(self):
        answer = self.pave(ORTHOGLIDE, "--box", -0.1, 0.1, 0, 0.1, -0.1, 0)
        self.assertEqual(answer["box"], {"lower": [-0.1, 0, -0.1], "upper": [0.1, 0.1, 0]})
        self.assertVolume(answer, 0.2 * 0.1 * 0.1)
        self.assertEqual(answer["boxes_boundary"], 0)

    def test_uranesx_in_a_box(self):
        answer = self.pave(URANESX, "--joint-limits", "off", "--box", -0.5, 0.5, -0.5, 0.5, 0, 0.5)
        twice = self.pave(URANESX, "--joint-limits", "off", "--box", -0.5, 0.5, -0.5, 0.5, 0, 1)
        self.assertGreater(answer["volume_lower"], 0.1)
        self.assertBrackets(twice["volume_lower"], 2 * answer["volume_upper"], math.inf)
        self.assertBrackets(0, 2 * answer["volume_lower"], twice["volume_upper"])

    def test_joint_limits(self):
        for name, urdf in MACHINES.items():
            with self.subTest(name):
                near = self.file("near.urdf", self.with_limits(urdf, -0.1, 0.2))
                limited = self.pave(near, "--joint-limits", "on", "--set", "reachable")
                self.assertIs(limited["joint_limits"], True)
                self.assertGreater(limited["volume_lower"], 0)
                self.assertLess(limited["volume_upper"], REACHABLE)

    def test_budget_ends_with_an_honest_bracket(self):
        for budget, ended_by in ((("--max-boxes", 1000), "the limit of 1000 boxes"),
                                 (("--max-memory", 100000), "its share of the limit of 100000 bytes of memory"),
                                 (("--time-limit", 1e-6), "5e-07 s, its share of the time limit of 1e-06 s")):
            with self.subTest(budget):
                answer = self.pave(ORTHOGLIDE, *budget)
                self.assertEqual(answer["ended_by"], ended_by)
                self.assertRegex(answer["message"], f"^Proved: .* Ended early by {ended_by}: .*\\.$")
                self.assertIs(answer["complete"], False)
                self.assertGreater(answer["boxes_pending"], 0)
                self.assertVolume(answer, DEXTROUS, 1e-3)

    def test_more_boxes_never_tell_less(self):
        for words in ((), ("--set", "reachable")):
            told = [self.pave(ORTHOGLIDE, "--resolution", 0.02, "--max-boxes", 10**k, *words) for k in range(6)]
            for fewer, more in zip(told, told[1:]):
                self.assertLessEqual(fewer["volume_lower"], more["volume_lower"], words)
                self.assertGreaterEqual(fewer["volume_upper"], more["volume_upper"], words)

    def test_uranesx_without_a_box_is_a_plane(self):
        words = ("--resolution", 0.01, "--joint-limits", "off")
        area, text = self.pave(URANESX, *words), self.text("pave", "--urdf", URANESX, *words)
        self.assertEqual(area["dimension"], 2)
        self.assertEqual(area["box"]["lower"][2], area["box"]["upper"][2])
        self.assertNotIn("volume_lower", area)
        self.assertEqual(area["own_aspect"]["area_lower"], area["area_lower"])
        self.assertEqual(area["other_aspect"]["area_upper"], 0)
        self.assertRegex(text, r"area +\S+ to \S+ m\^2\n")
        self.assertRegex(text, r"points of the box that(.|\n)* have\s+an\s+area\s+of(.|\n)*"
                               r"in\s+every\s+plane\s+parallel")
        x0, y0, z = area["box"]["lower"]
        x1, y1, _ = area["box"]["upper"]
        solid = self.pave(URANESX, *words, "--box", x0, x1, y0, y1, z, z + 0.1)
        self.assertEqual(solid["dimension"], 3)
        self.assertLessEqual(solid["volume_lower"], 0.1 * area["area_upper"])
        self.assertGreaterEqual(solid["volume_upper"], 0.1 * area["area_lower"])

    def test_resumed_run_answers_as_a_new_one(self):
        file = self.folder / "it.paving"
        for urdf, words in ((ORTHOGLIDE, ()), (ORTHOGLIDE, ("--set", "reachable", "--aspect", "both")),
                            (URANESX, ("--joint-limits", "off"))):
            with self.subTest((urdf, words)):
                first = self.pave(urdf, *words, "--resolution", 0.1, "--max-boxes", 3000, "--save", file)
                again = self.pave(urdf, *words, "--resolution", 0.04, "--resume", file, "--save", file)
                fresh = self.pave(urdf, *words, "--resolution", 0.04)
                self.assertEqual(again["boxes_here"], fresh["boxes"] - first["boxes"])
                for answer in (again, fresh):
                    del answer["boxes_here"], answer["seconds"]
                self.assertEqual(again, fresh)
                text = self.text("pave", "--urdf", urdf, *words, "--resolution", 0.04, "--resume", file)
                self.assertRegex(text, r"effort +\d+ boxes \(0 of them in this run\)")
                self.assertEqual([path.name for path in self.folder.iterdir()], ["it.paving"])

    def test_file_about_something_else_is_refused(self):
        file = self.folder / "it.paving"
        self.pave(ORTHOGLIDE, "--resolution", 0.2, "--save", file)
        content = file.read_bytes()

        def refusal(urdf, *words):
            process = run("pave", "--urdf", urdf, "--resolution", 0.1, "--resume", file, *words)
            self.assertEqual(process.returncode, 2)
            self.assertEqual(process.stdout, "")
            return process.stderr

        hashes = [self.answer("evaluate", "--urdf", urdf, "--point", 0, 0, -0.8)["geometry_hash"]
                  for urdf in (ORTHOGLIDE, URANESX)]
        self.assertRegex(refusal(URANESX), REFUSED + f"geometry hash: .*{hashes[0]}.*{hashes[1]}")
        self.assertRegex(refusal(ORTHOGLIDE, "--psi-max", 3), REFUSED + r"criterion: .*\[0.5, 2\].*\[0.5, 3\]")
        self.assertRegex(refusal(ORTHOGLIDE, "--box", 0, 1, 0, 1, 0, 1), REFUSED + "box: ")
        self.assertEqual(refusal(ORTHOGLIDE, "--psi-max", 3).count("the earlier paving is of"), 1)
        file.write_bytes(content[:-100])
        self.assertRegex(refusal(ORTHOGLIDE), REFUSED + "it has .* bytes .*cut")
        file.write_bytes(content[:-100] + b"x" + content[-99:])
        self.assertRegex(refusal(ORTHOGLIDE), REFUSED + "its checksum does not fit: it was altered")

    def test_interrupt_ends_with_what_is_proved(self):
        process = subprocess.Popen([PKM, "pave", "--urdf", ORTHOGLIDE, "--resolution", "1e-4", "--progress", "--json"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertRegex(process.stderr.readline(), r"^\d+ s: volume inside .* boxes, \S+ boxes/s$")  # it is under way
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate()
        self.assertEqual(process.returncode, 0)
        answer = json.loads(output)
        self.assertIs(answer["complete"], False)
        self.assertVolume(answer, DEXTROUS, 1e-3)

    def test_interrupted_run_leaves_a_file_to_go_on_from(self):
        file = self.folder / "it.paving"
        process = subprocess.Popen([PKM, "pave", "--urdf", ORTHOGLIDE, "--resolution", "1e-4", "--progress", "--save",
                                    file], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.assertRegex(process.stderr.readline(), r"^\d+ s: volume inside ")  # it is under way
        process.send_signal(signal.SIGINT)
        process.communicate()
        self.assertEqual(process.returncode, 0)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["it.paving"])
        again = self.pave(ORTHOGLIDE, "--resolution", 0.03, "--resume", file)
        fresh = self.pave(ORTHOGLIDE, "--resolution", 0.03)
        self.assertLess(again["boxes_here"], fresh["boxes_here"])
        for answer in (again, fresh):
            del answer["boxes_here"], answer["seconds"]
        self.assertEqual(again, fresh)

    def test_listed_boxes(self):
        """All of them, or fewer and larger ones, none of which claims more; their volumes are those that are told."""

        def volume(boxes):
            return math.fsum((x1 - x0) * (y1 - y0) * (z1 - z0) for x0, x1, y0, y1, z0, z1 in boxes)

        words = ("--resolution", 0.1, "--list-boxes")
        all_of_them = self.pave(ORTHOGLIDE, *words, 1000000)
        listed = all_of_them["listed"]
        self.assertEqual(len(listed["inside"]), all_of_them["boxes_inside"])
        self.assertEqual(len(listed["undecided"]), all_of_them["boxes_boundary"])
        self.assertAlmostEqual(volume(listed["inside"]), all_of_them["volume_inside"], delta=1e-12)
        self.assertAlmostEqual(volume(listed["undecided"]), all_of_them["volume_boundary"], delta=1e-12)
        few = self.pave(ORTHOGLIDE, *words, 500)["listed"]
        self.assertLessEqual(len(few["inside"]) + len(few["undecided"]), 500)
        self.assertGreater(len(few["inside"]), 0)
        self.assertLess(volume(few["inside"]), volume(listed["inside"]))
        self.assertGreaterEqual(volume(few["inside"]) + volume(few["undecided"]), all_of_them["volume_upper"] - 1e-12)
        self.assertNotIn("listed", self.pave(ORTHOGLIDE, "--resolution", 0.1))

    def test_parts_of_boxes_tell_more_than_whole_ones(self):
        answer = self.pave(ORTHOGLIDE, "--resolution", 0.05)
        self.assertLess(answer["volume_upper"] - answer["volume_lower"], 0.1 * answer["volume_boundary"])
        self.assertLessEqual(answer["volume_inside"], answer["volume_lower"])
        self.assertLessEqual(answer["volume_upper"], answer["volume_inside"] + answer["volume_boundary"] + 1e-12)
        finer = self.pave(ORTHOGLIDE, "--resolution", 0.025)
        self.assertLess(finer["volume_upper"] - finer["volume_lower"],
                        0.3 * (answer["volume_upper"] - answer["volume_lower"]))

    def test_volume_to_a_width(self):
        """The paving stays what it is."""
        coarse = self.pave(ORTHOGLIDE)
        for words, value, slack in (((), DEXTROUS, 1e-3), (("--set", "reachable", "--aspect", "both"), REACHABLE, 0)):
            close = self.pave(ORTHOGLIDE, *words, "--volume-to", 5e-4)
            self.assertVolume(close, value, slack)
            self.assertLessEqual(close["volume_upper"] - close["volume_lower"], 5e-4 * close["volume_upper"])
            for aspect in ("own_aspect", "other_aspect"):
                self.assertLessEqual(close[aspect]["volume_upper"] - close[aspect]["volume_lower"],
                                     5e-4 * close["volume_upper"])
            self.assertIs(close["complete"], True)
            if not words:
                self.assertGreater(close["volume_boxes"], coarse["volume_boxes"])
                for key in ("boxes", "boxes_inside", "boxes_boundary", "volume_inside", "volume_boundary"):
                    self.assertEqual(close[key], coarse[key], key)
        area = self.pave(URANESX, "--joint-limits", "off", "--volume-to", 1e-4)
        self.assertLessEqual(area["area_upper"] - area["area_lower"], 1e-4 * area["area_upper"])
        self.assertGreater(area["area_inside"], 0)

    def test_volume_that_is_not_known_as_closely_as_asked(self):
        for budget, ended_by in ((("--max-boxes", 100000), "the limit of 100000 boxes"),
                                 (("--max-memory", 10000000), "its share of the limit of 10000000 bytes of memory")):
            answer = self.pave(ORTHOGLIDE, "--volume-to", 1e-5, *budget)
            self.assertEqual(answer["ended_by"], ended_by)
            self.assertEqual(answer["boxes_pending"], 0)
            self.assertIs(answer["complete"], False)
            self.assertVolume(answer, DEXTROUS, 1e-3)
        for value in ("0", "1.5", "-1", "nan"):
            process = run("pave", "--urdf", ORTHOGLIDE, "--volume-to", value)
            self.assertEqual(process.returncode, 2)
            self.assertRegex(process.stderr, f"--volume-to {value}: .*from 1e-15 to 1")

    def test_reachable_volume_is_closer_than_its_boxes(self):
        answer = self.pave(ORTHOGLIDE, "--set", "reachable", "--aspect", "both", "--resolution", 0.1)
        self.assertVolume(answer, REACHABLE)
        self.assertLess(answer["volume_upper"] - answer["volume_lower"], 0.02 * REACHABLE)
        flat = ("--set", "reachable", "--joint-limits", "off")
        plane = self.pave(URANESX, *flat, "--resolution", 0.05)
        finer = self.pave(URANESX, *flat, "--resolution", 0.01)
        self.assertLessEqual(plane["area_lower"], finer["area_upper"])
        self.assertGreaterEqual(plane["area_upper"], finer["area_lower"])

    def test_criteria_without_velocity_factors(self):
        """[1/f, f] is the same for velocity and for force factors; it bounds the condition number by f^2."""
        velocity = self.pave(ORTHOGLIDE, "--resolution", 0.05)
        force = self.pave(ORTHOGLIDE, "--resolution", 0.05, "--set", "reachable", "--force-min", 0.5, "--force-max", 2)
        self.assertVolume(force["own_aspect"], DEXTROUS, 1e-3)
        self.assertEqual((force["force_min"], force["force_max"], force["set"]), (0.5, 2, "reachable"))
        condition = self.pave(ORTHOGLIDE, "--resolution", 0.05, "--set", "reachable", "--kappa-max", 4)
        self.assertGreaterEqual(condition["own_aspect"]["volume_upper"], velocity["own_aspect"]["volume_lower"])
        both = self.pave(ORTHOGLIDE, "--resolution", 0.05, "--kappa-max", 1.5)
        self.assertLess(both["volume_upper"], velocity["volume_lower"])

    def test_text_never_claims_more_than_the_numbers(self):
        for resolution in (0.2, 0.1, 0.06):
            words = ("pave", "--urdf", ORTHOGLIDE, "--resolution", resolution)
            answer, text = self.answer(*words), self.text(*words)
            lower, upper = map(Fraction, re.search(r"volume +(\S+) to (\S+) m\^3", text).groups())
            self.assertLessEqual(lower, Fraction(answer["volume_lower"]))
            self.assertGreaterEqual(upper, Fraction(answer["volume_upper"]))


if __name__ == "__main__":
    unittest.main()
