#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm urdf: what it writes is read by the other commands as the machine that was asked for."""

import json
import math
import re
import re
import unittest
from xml.etree import ElementTree

from pkm import URDF, CommandTest, run


class Urdf(CommandTest):
    def test_machines_of_the_repository_are_the_catalogue_s(self):
        for name, speeds, efforts in (("orthoglide", [1.2], [280]), ("orthoglide_prototype", [1.2], [280]),
                                      ("uranesx", [1.6], [2000]), ("delta", [10], [200]), ("tripod", [0.5], [1500]),
                                      ("mixed_legs", [1, 0.5, 5], [300, 500, 150])):
            text = self.text("urdf", "--machine", name, "--joint-speed-max", *speeds, "--joint-effort-max", *efforts)
            file = (URDF / f"{name}.urdf").read_text(encoding="utf-8")
            self.assertEqual(text, re.sub("<!--.*?-->\n", "", file))

    def drives(self, *words):
        root = ElementTree.fromstring(self.text("urdf", *words))
        return [[float(limit.get(name)) for name in ("velocity", "effort")] for limit in root.iter("limit")]

    def test_drives_are_those_that_are_given(self):
        delta = ("--rail-radius", 0.13, "--length", 0.269, "--travel", 0, 0.35)
        for words in (delta, ("--machine", "uranesx")):
            self.assertEqual(self.drives(*words), [[0, 0]] * 3)
            self.assertEqual(self.drives(*words, "--joint-speed-max", 0.5, "--joint-effort-max", 1, 2, 3),
                             [[0.5, 1], [0.5, 2], [0.5, 3]])
            for value in (0, -1, "nan"):
                for option, unit in (("--joint-speed-max", "m/s"), ("--joint-effort-max", "N")):
                    process = run("urdf", *words, option, value)
                    self.assertEqual(process.returncode, 2)
                    self.assertRegex(process.stderr, rf"{option} {value}: .*{unit}")
        file = self.file("machine.yaml", "name: m\nunit: mm\nall_legs: {rail_radius: 130, length: 269, "
                                         "travel: [0, 350], joint_speed_max: 0.5}\n")
        self.assertEqual(self.drives("--from", file), [[0.5, 0]] * 3)
        wrong = self.file("wrong.yaml", "all_legs: {rail_radius: 0.13, length: 0.269, travel: [0, 0.35], "
                                        "joint_effort_max: 0}\n")
        self.assertIn("joint_effort_max = '0', expected a positive number [N]", run("urdf", "--from", wrong).stderr)

    def test_output_file(self):
        path = self.folder / "machine.urdf"
        answer = self.answer("urdf", "--machine", "orthoglide", "--output", path)
        self.assertEqual(answer["output"], str(path))
        self.assertEqual(path.read_text(encoding="utf-8"), self.text("urdf", "--machine", "orthoglide"))
        point = self.answer("evaluate", "--urdf", path, "--point", 0, 0, 0)
        self.assertEqual(point["geometry_hash"], answer["geometry_hash"])

    def test_json_holds_the_urdf(self):
        answer = self.answer("urdf", "--machine", "uranesx")
        self.assertEqual(answer["urdf"], self.text("urdf", "--machine", "uranesx"))
        self.assertEqual(answer["machine"], "uranesx")

    def test_dimensions_are_those_asked_for(self):
        urdf = self.machine("--machine", "uranesx", "--length", 2.5, "--rail-radius", 2, "--platform-radius", 0.5)
        answer = self.answer("evaluate", "--urdf", urdf, "--point", 0, 0, 0)
        self.assertEqual(len(answer["rho"]), 3)
        for rho in answer["rho"]:
            self.assertAlmostEqual(rho, 2, places=12)  # 2^2 + (2 - 0.5)^2 = 2.5^2

    def test_the_longest_strut_is_allowed_for_both(self):
        for name in ("orthoglide", "uranesx"):
            self.machine("--machine", name, "--length", "1e9")

    def test_lambda_moves_the_rails(self):
        widened = self.machine("--machine", "uranesx", "--lambda", 0.1, "--length", 2)
        psi = self.answer("evaluate", "--urdf", widened, "--point", 0, 0, 0)["psi"]
        by_radius = self.machine("--machine", "uranesx", "--rail-radius", 2 * (7 / 13 + 0.1), "--platform-radius",
                                 2 * 3 / 26, "--length", 2)
        for value, wanted in zip(psi, self.answer("evaluate", "--urdf", by_radius, "--point", 0, 0, 0)["psi"]):
            self.assertAlmostEqual(value, wanted, places=12)

    NUMBERS = ("--name", "cnc", "--rail-radius", 0.130, "--angle", 0, 120.4, 239.7, "--platform-radius", 0.030,
               "--length", 0.2690, 0.2688, 0.2691, "--travel", 0, 0.35, "--tool", 0, 0, -0.040,
               "--mount", 0, 0, 0.75, "--mount-rpy", 0, 0, 15)

    def test_numbers_and_machine_file_are_one_machine(self):
        template = self.folder / "machine.yaml"
        self.answer("urdf", "--template", "--output", template)
        template.write_text(template.read_text(encoding="utf-8").replace("my_machine", "cnc"), encoding="utf-8")
        self.assertEqual(self.text("urdf", "--from", template), self.text("urdf", *self.NUMBERS))

    def test_a_machine_from_numbers_meets_its_struts(self):
        urdf = self.machine(*self.NUMBERS)
        point = (0.02, -0.03, 0.87)
        rho = self.answer("evaluate", "--urdf", urdf, "--point", *point)["rho"]
        turn = math.radians(15)
        x = math.cos(turn) * point[0] + math.sin(turn) * point[1]
        y = math.cos(turn) * point[1] - math.sin(turn) * point[0]
        z = point[2] - 0.75 + 0.040
        lengths = (0.2690, 0.2688, 0.2691)
        # the tool touches z = 0 with all sliders at the lower end: what is left of each equation is their height
        heights = []
        for angle, length, value in zip((0, 120.4, 239.7), lengths, rho):
            outwards = (math.cos(math.radians(angle)), math.sin(math.radians(angle)))
            across = math.hypot(x - 0.1 * outwards[0], y - 0.1 * outwards[1])
            heights.append(z + math.sqrt(length ** 2 - across ** 2) - value)
        self.assertAlmostEqual(heights[0], heights[1], places=12)
        self.assertAlmostEqual(heights[0], heights[2], places=12)
        self.assertAlmostEqual(heights[0], 0.25 + 0.040, places=3)

    def test_cranks_and_struts_of_variable_length_are_made_from_numbers(self):
        """Each leg is as long as its numbers say, whatever the others are."""
        urdf = self.machine("--kind", "rail", "telescope", "crank", "--rail-radius", 0.13, "--base-radius", 0.06,
                            "--base-height", 0.3, "--crank", 0.09, "--length", 0.27, "--home-height", 0.3,
                            "--turn", -1, "--crank-zero", 10, "--travel", 0, 0.35, -0.05, 0.05, -60, 90)
        x, y, z = point = (0.005, -0.01, 0.03)
        rail, strut, crank = self.answer("evaluate", "--urdf", urdf, "--point", *point)["rho"]
        self.assertAlmostEqual(math.hypot(x - 0.13, y, z - 0.3 - rail), 0.27, places=12)
        along = [(math.cos(a), math.sin(a)) for a in (2 * math.pi / 3, 4 * math.pi / 3)]
        foot = [0.06 * side for side in along[0]]
        self.assertAlmostEqual(math.hypot(x - foot[0], y - foot[1], z - 0.3), 0.27 + strut, places=12)
        down = math.radians(10) - crank
        tip = [(0.06 + 0.09 * math.cos(down)) * side for side in along[1]]
        self.assertAlmostEqual(math.hypot(x - tip[0], y - tip[1], z - 0.3 + 0.09 * math.sin(down)), 0.27, places=12)

    def test_templates_of_every_kind_are_machines(self):
        for kind, unit in (("rail", "m"), ("telescope", "m"), ("crank", "rad")):
            template = self.file("machine.yaml", self.text("urdf", "--template", "--kind", kind))
            urdf = self.file("machine.urdf", self.text("urdf", "--from", template))
            answer = self.answer("largest", "--urdf", urdf, "--psi", "auto", "--accuracy", 0.05)
            self.assertEqual([row["unit"] for row in answer["joint_ranges"]], [unit] * 3)
        for words, reason in ((("--template", "--kind", "rail", "crank", "crank"), "cannot be given together"),
                              (("--template", "--crank", 1), "cannot be given together"),
                              (("--template", "--kind", "cranks"), "--kind cranks: .*rail, telescope, crank"),
                              (("--machine", "delta", "--rail-radius", 1), "no such dimension: --rail-radius"),
                              (("--linear-delta", "--kind", "crank"), "leave --linear-delta or --kind out"),
                              (("--machine", "delta", "--travel", 3, 2), "the lower end comes first")):
            process = run("urdf", *words)
            self.assertEqual(process.returncode, 2, words)
            self.assertRegex(process.stderr, reason)

    def test_dimensions_of_a_delta_and_a_tripod(self):
        delta = self.machine("--machine", "delta", "--base-radius", 0.1, "--crank", 0.2, "--length", 0.4,
                             "--platform-radius", 0.05, "--travel", -30, 60)
        height = math.sqrt(0.4 ** 2 - 0.25 ** 2)
        for rho in self.answer("evaluate", "--urdf", delta, "--point", 0, 0, -height)["rho"]:
            self.assertAlmostEqual(rho, 0, places=12)
        limits = ElementTree.parse(delta).getroot().find("joint[@name='crank_1']/limit")
        self.assertAlmostEqual(float(limits.get("upper")), math.pi / 3, places=12)
        tripod = self.machine("--machine", "tripod", "--base-radius", 0.5, "--length", 0.6, "--platform-radius", 0.2)
        for rho in self.answer("evaluate", "--urdf", tripod, "--point", 0, 0, 0.4)["rho"]:
            self.assertAlmostEqual(rho, -0.1, places=12)

    def test_x_and_y_say_the_same_as_angle_and_radius(self):
        places = [(0.2 * math.cos(a), 0.2 * math.sin(a)) for a in (0.1, 2.2, 4.1)]
        by_place = self.machine("--x", *(p[0] for p in places), "--y", *(p[1] for p in places), "--length", 0.4,
                                "--travel", -0.1, 0.5)
        by_angle = self.machine("--rail-radius", 0.2, "--angle", *(math.degrees(a) for a in (0.1, 2.2, 4.1)),
                                "--length", 0.4, "--travel", -0.1, 0.5)
        first, second = (self.answer("evaluate", "--urdf", urdf, "--point", 0.01, 0.02, 0.1)["rho"]
                         for urdf in (by_place, by_angle))
        for one, other in zip(first, second):
            self.assertAlmostEqual(one, other, places=12)

    def test_the_zero_of_the_controller_is_kept(self):
        """Homed at the upper end, which the controller counts as 0."""
        urdf = self.machine("--linear-delta", "--rail-radius", 0.1, "--length", 0.25, "--travel", -0.3, 0,
                            "--home-height", 0.5)
        height = 0.4 - math.sqrt(0.25 ** 2 - 0.1 ** 2)
        for value in self.answer("evaluate", "--urdf", urdf, "--point", 0, 0, height)["rho"]:
            self.assertAlmostEqual(value, -0.1, places=9)

    def test_the_recipe_of_the_documentation_is_a_machine(self):
        text = (URDF.parent / "docs" / "urdf.md").read_text(encoding="utf-8")
        recipe = re.search(r"```xml\n(.*?)```", text, re.DOTALL).group(1)
        head, rest = recipe.split("  <!-- leg 1 -->\n")
        leg, tail = rest.split("  <!-- legs 2 and 3 -->\n")
        legs = [leg.replace('_1"', f'_{number}"').replace('rpy="0 0 0"', f'rpy="0 0 {yaw}"')
                for number, yaw in ((1, 0), (2, 2.0944), (3, -2.0944))]
        urdf = self.file("recipe.urdf", head + "".join(legs) + tail)
        process = run("evaluate", "--urdf", urdf, "--point", 0, 0, 0.9, "--json")
        self.assertEqual(process.returncode, 0, process.stderr)
        self.assertIn("drawn up to", process.stderr)  # its lean is rounded: the zero is where the struts meet
        for rho in json.loads(process.stdout)["rho"]:
            self.assertAlmostEqual(rho, 0.15 + 0.04 - 0.29 + math.sqrt(0.269 ** 2 - 0.1 ** 2), places=9)


if __name__ == "__main__":
    unittest.main()
