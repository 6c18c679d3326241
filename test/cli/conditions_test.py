#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Speeds, forces, stiffness, errors, angles, hinges and balls, asked of every command that has a criterion."""

import math
import re
import unittest
from xml.etree import ElementTree

from pkm import ORTHOGLIDE, URANESX, CommandTest, run

REACHABLE = ("--set", "reachable")
EACH = {
    "tool_speed_min": ("--tool-speed-min", 1.02),
    "tool_force_min": ("--tool-force-min", 168),
    "stiffness_min": ("--stiffness-min", 3e5, "--joint-stiffness", 1e6, "--strut-stiffness", 1e7),
    "position_error_max": ("--position-error-max", 3e-5, "--joint-error-max", 1e-5),
    "strut_angle_max": ("--strut-angle-max", 0.6),
    "ball_tilt_max": ("--ball-tilt-max", 0.5),
}
EDGES = {  # of the largest cube, where the struts may be off their rails by an angle: sqrt(2) times its sine [m]
    "tool_speed_min": math.sqrt(2 - 2 * (1.02 / 1.2)**2),  # by joints up to 1.2 m/s
    "strut_angle_max": math.sqrt(2) * math.sin(0.6),
    "ball_tilt_max": math.sqrt(2) * math.sin(0.5),
}


class Conditions(CommandTest):
    def hinged(self, joint, lower, upper):
        """The Orthoglide with limits of a passive joint."""
        tree = ElementTree.parse(ORTHOGLIDE)
        element = tree.getroot().find(f"joint[@name='{joint}']")
        element.set("type", "revolute")
        ElementTree.SubElement(element, "limit", lower=str(lower), upper=str(upper), effort="1", velocity="1")
        return self.file("hinged.urdf", ElementTree.tostring(tree.getroot(), encoding="unicode"))

    def test_largest_cubes_where_they_are_known(self):
        for name, edge in EDGES.items():
            answer = self.answer("largest", "--urdf", ORTHOGLIDE, *REACHABLE, *EACH[name], "--accuracy", 1e-5)
            self.assertBrackets(answer["size"], edge, answer["size_upper_bound"], 1e-12)
            self.assertLess(answer["size_upper_bound"] - answer["size"], 1.1e-5)

    def test_every_command_takes_each_and_all(self):
        everything = [word for words in EACH.values() for word in words]
        for words in [*EACH.values(), everything]:
            context = ("--urdf", ORTHOGLIDE, *REACHABLE, *words)
            checked = self.answer("check", *context, "--center", 0.05, 0.05, 0.05, "--sides", 0.2, 0.2, 0.2)
            self.assertEqual(checked["verdict"], "inside", words)
            checked = self.answer("check", *context, "--center", 0.05, 0.05, 0.05, "--sides", 1, 1, 1)
            self.assertEqual(checked["verdict"], "outside", words)
            path = self.answer("path", *context, "--segment", "start 0 0 0", "--segment", "line 0.1 0.1 0")
            self.assertEqual(path["verdict"], "inside", words)
            there = self.answer("evaluate", *context, "--point", 0.7, 0.6, -0.4)
            self.assertRegex(there["message"], "^Proved: the point is not ", words)
            paved = self.answer("pave", *context, "--resolution", 0.2)
            self.assertGreater(paved["volume_lower"], 0.01, words)
            compared = self.answer("compare", "--urdf", URANESX, "--shape", "square", *REACHABLE, "--force-max", 4,
                                   *words, "--accuracy", 0.05)
            self.assertEqual(len(compared["machines"]), 1, words)

    def test_answers_tell_what_counted(self):
        answer = self.answer("largest", "--urdf", ORTHOGLIDE, "--tool-speed-min", 0.5, "--joint-speed-max", 1, 2, 3)
        self.assertEqual(answer["tool_speed_min"], 0.5)
        self.assertEqual(answer["joint_speed_max"], [1, 2, 3])
        answer = self.answer("largest", "--urdf", ORTHOGLIDE, *EACH["tool_force_min"])
        self.assertEqual(answer["joint_effort_max"], [280, 280, 280], "of the URDF")
        self.assertNotIn("joint_stiffness", answer)
        text = self.text("largest", "--urdf", ORTHOGLIDE, *EACH["stiffness_min"])
        self.assertIn("with a stiffness of at least 300000 N/m in every direction by drives of 1000000 N/m and struts "
                      "of 10000000 N/m", re.sub(r"\s+", " ", text))

    def test_points_tell_the_leg_that_binds(self):
        text = self.text("evaluate", "--urdf", ORTHOGLIDE, *REACHABLE, "--tool-speed-min", 0.96, "--point", 0, 0, 0.7)
        self.assertRegex(re.sub(r"\s+", " ", text), r"the speed of the tool in every direction, as 'rail_[xy]' has it, "
                         r"is 0\.85697\d m/s, below 0\.96 m/s")

    def test_hinges_hold_where_asked_for(self):
        urdf = self.hinged("revolute_1", -0.4, 0.5)
        words = ("--urdf", urdf, *REACHABLE, "--center", 0, 0, 0, "--sides", 0.2, 0.2, 0.9)
        self.assertEqual(self.answer("check", *words)["verdict"], "inside")
        answer = self.answer("check", *words, "--hinge-limits", "on")
        self.assertEqual(answer["verdict"], "outside")
        self.assertRegex(answer["message"], r"passive joint 'revolute_1' would be beyond its (lower|upper) limit")
        self.assertTrue(answer["hinge_limits"])

    def test_what_cannot_be_proved_is_refused_by_name(self):
        for words, message in (
            (("--stiffness-min", 1e5), r"stiffness_min needs the stiffness of its drive \[N/m\] of joint "
                                       r"'rail_x': give joint_stiffness"),
            (("--position-error-max", 1e-4), "needs the largest error .m. of joint 'rail_x'"),
            (("--joint-stiffness", 1e6), "--joint-stiffness 1.*is without effect: it counts for --stiffness-min"),
            (("--joint-speed-max", 1), "--joint-speed-max 1.*is without effect: it counts for --tool-speed-min"),
            (("--tool-speed-min", -1), "--tool-speed-min"),
            (("--tool-speed-min", 0.5, "--joint-speed-max", 1, 2), "--joint-speed-max"),
            (("--strut-angle-max", 2), "--strut-angle-max"),
            (("--strut-angle-min", 0.7, "--strut-angle-max", 0.5), "strut_angle_max = 0.5 .*must be at least "
                                                                     "strut_angle_min = 0.7"),
            (("--tool-force-min", "nan"), "--tool-force-min"),
            (("--ball-axes", 0, 0, 0), "ball_axes: .*not a direction"),
        ):
            process = run("largest", "--urdf", ORTHOGLIDE, *words)
            self.assertEqual(process.returncode, 2, words)
            self.assertRegex(process.stderr, message)
        process = run("largest", "--urdf", self.hinged("revolute_1", -2, 0.5), "--hinge-limits", "on")
        self.assertEqual(process.returncode, 2)
        self.assertRegex(process.stderr, r"hinge_limits cannot be proved: joint 'revolute_1', lower limit -2 rad: ")

    def test_what_counts_is_said_in_words(self):
        words = re.sub(r"\s+", " ", self.text("check", "--urdf", self.hinged("revolute_1", -0.4, 0.5), *REACHABLE,
                                             "--center", 0, 0, 0, "--sides", 0.1, 0.1, 0.1, "--hinge-limits", "on",
                                             "--ball-tilt-max", 0.5, "--ball-axes", 1, 0, 0, 0, 1, 0, 0, 0, 1))
        self.assertIn("with ball joints tilted by at most 0.5 rad from the axes (1, 0, 0), (0, 1, 0), (0, 0, 1), with "
                      "all passive joints within their limits", words)

    def test_numbers_of_any_size(self):
        for speed, most in ((1e100, 1e-100), (1e-100, 1e100)):
            answer = self.answer("check", "--urdf", ORTHOGLIDE, *REACHABLE, "--tool-speed-min", speed,
                                 "--joint-speed-max", most, "--center", 0, 0, 0, "--sides", 0.1, 0.1, 0.1)
            self.assertEqual(answer["verdict"], "outside" if speed > most else "inside")

    def test_families_take_the_lesser_motors(self):
        answer = self.answer("study", "--urdf", ORTHOGLIDE, "--urdf", ORTHOGLIDE, "--range", 0, 1, *REACHABLE,
                             "--tool-speed-min", 0.85, "--accuracy", 0.05)
        self.assertEqual(answer["joint_speed_max"], [1.2, 1.2, 1.2])

    def test_a_urdf_without_speeds_needs_them(self):
        tree = ElementTree.parse(ORTHOGLIDE)
        for limit in tree.getroot().iter("limit"):
            limit.set("velocity", "0")
        urdf = self.file("slow.urdf", ElementTree.tostring(tree.getroot(), encoding="unicode"))
        process = run("largest", "--urdf", urdf, "--tool-speed-min", 0.5)
        self.assertEqual(process.returncode, 2)
        self.assertIn("of joint 'rail_z', which its URDF does not tell: give joint_speed_max", process.stderr)
        self.answer("largest", "--urdf", urdf, "--tool-speed-min", 0.5, "--joint-speed-max", 1)

    def test_ball_axes_turn_the_cones(self):
        straight = self.answer("largest", "--urdf", ORTHOGLIDE, *REACHABLE, *EACH["ball_tilt_max"])
        axes = (1, 0, 0, 0, 1, 0, 0, 0, 1)  # the same as at joint values 0
        same = self.answer("largest", "--urdf", ORTHOGLIDE, *REACHABLE, *EACH["ball_tilt_max"], "--ball-axes", *axes)
        self.assertAlmostEqual(same["size"], straight["size"], delta=2e-3)
        self.assertNotEqual(same["geometry_hash"], straight["geometry_hash"])
        leaning = self.answer("largest", "--urdf", ORTHOGLIDE, *REACHABLE, *EACH["ball_tilt_max"],
                              "--ball-axes", 1, 0.3, 0, 0, 1, 0, 0, 0, 1)
        self.assertLess(leaning["size_upper_bound"], straight["size"])
        self.assertEqual(leaning["ball_axes"], [[1, 0.3, 0], [0, 1, 0], [0, 0, 1]])
        self.assertNotIn("ball_axes", straight)

    def test_struts_have_tilts_of_their_own(self):
        words = ("--urdf", ORTHOGLIDE, *REACHABLE, *EACH["ball_tilt_max"])
        for tilts, least in (((0.5, 0.3, 0.5), 0.3), ((0.9, 0.5, 1.2), 0.5), ((0.2, ), 0.2)):
            answer = self.answer("largest", *words, "--strut-tilt-max", *tilts)
            edge = math.sqrt(2) * math.sin(least)  # across the strut that tilts least, as far as all may
            self.assertLessEqual(answer["size"], edge * (1 + 1e-12))
            self.assertGreaterEqual(answer["size_upper_bound"], edge * (1 - 1e-12))
            self.assertEqual(answer["strut_tilt_max"], list(tilts) * (3 // len(tilts)))
        self.assertIn("tilted by at most 0.5 rad and those of each strut by at most (0.5, 0.3, 0.5) rad from how",
                      re.sub(r"\s+", " ", self.text("largest", *words, "--strut-tilt-max", 0.5, 0.3, 0.5)))
        for tilts, message in (((0.3, ), "is without effect: it counts for --ball-tilt-max"), ((2, ), "1.5707963")):
            process = run("largest", "--urdf", ORTHOGLIDE, "--strut-tilt-max", *tilts)
            self.assertEqual(process.returncode, 2)
            self.assertIn(message, process.stderr)

    def test_each_machine_has_its_ball_axes(self):
        words = (*REACHABLE, *EACH["ball_tilt_max"], "--accuracy", 0.01)
        leaning = ("--ball-axes", 1, 0.3, 0, 0, 1, 0, 0, 0, 1)
        straight, other = self.answer("compare", "--urdf", ORTHOGLIDE, "--urdf", ORTHOGLIDE, *leaning,
                                      *words)["machines"]
        self.assertLess(other["size_upper_bound"], straight["size"])
        process = run("study", "--urdf", ORTHOGLIDE, "--urdf", ORTHOGLIDE, *leaning, "--range", 0, 1, *words)
        self.assertEqual(process.returncode, 2)
        self.assertIn("of the two machines have different ball axes: give both the same", process.stderr)
        answer = self.answer("study", "--urdf", ORTHOGLIDE, *leaning, "--urdf", ORTHOGLIDE, *leaning, "--range", 0, 1,
                             *words)
        self.assertLessEqual(answer["size"], other["size_upper_bound"])
        self.assertGreaterEqual(answer["size_upper_bound"], other["size"])


if __name__ == "__main__":
    unittest.main()
