#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm import: the URDF that it writes is the machine of the controller's configuration."""

import json
import math
import random
import unittest
from xml.etree import ElementTree

from pkm import DATA, ORTHOGLIDE, CommandTest, run

FIRMWARE = DATA / "firmware"
SEED = 20261127
FILES = {"klipper": "klipper.cfg", "marlin": "marlin_configuration.txt", "marlin-report": "marlin_report.txt",
         "reprapfirmware": "config.g", "linuxcnc": "ldelta.ini", "grblhal": "grblhal.txt"}


def carriages(towers, point):
    """z + sqrt(arm^2 - |tower - (x, y)|^2) for each (radius, degrees, arm), in mm."""
    x, y, z = point
    return [z + math.sqrt(arm**2 - (radius * math.cos(math.radians(angle)) - x)**2
                          - (radius * math.sin(math.radians(angle)) - y)**2) for radius, angle, arm in towers]


TOWERS = {
    "klipper": [(130.246113, 210.213, 269.0), (130.246113, 329.8665, 268.8125), (130.246113, 89.7, 269.0)],
    "marlin": [(130.35, 210.4, 269.0), (130.25, 329.7, 268.8), (130.05, 90.0, 269.1)],
    "marlin-report": [(130.25, 210.4, 269.0), (130.25, 329.7, 268.8), (130.25, 90.0, 269.1)],
    "linuxcnc": [(130.25, 90.0, 269.0), (130.25, 210.0, 269.0), (130.25, 330.0, 269.0)],
}


class Import(CommandTest):
    def urdf(self, format_name, *words):
        path = self.folder / f"{format_name}.urdf"
        return path, self.answer("import", FIRMWARE / FILES[format_name], "--output", path, *words)

    def test_joint_values_are_the_controller_s(self):
        chance = random.Random(SEED)
        points = [[chance.uniform(-70, 70), chance.uniform(-70, 70), chance.uniform(-20, 300)] for _ in range(1000)]
        table = self.file("points.txt", "".join(" ".join(repr(c / 1000) for c in p) + "\n" for p in points))
        for name, towers in TOWERS.items():
            path, answer = self.urdf(name)
            self.assertEqual(answer["format"], name)
            found = self.answer("evaluate", "--urdf", path, "--points", table, "--joint-limits", "off")["points"]
            self.assertEqual(len(found), 1000)
            for point, there in zip(points, found):
                for joint, wanted in zip(there["rho"], carriages(towers, point)):
                    self.assertAlmostEqual(joint, wanted / 1000, delta=1e-9, msg=f"{name}, seed {SEED}, {point}")

    def test_rotary_deltas_have_their_cranks_where_the_controller_has_them(self):
        """From the geometry: the forearm is as long as the controller says, and the elbow is out."""
        def span(angle, leg, point, base, crank, platform):
            direction = math.radians(leg)
            out = base + crank * math.cos(angle) - platform
            elbow = (out * math.cos(direction), out * math.sin(direction), -crank * math.sin(angle))
            return math.dist(elbow, [c / 1000 for c in point])

        side = 1 / math.sqrt(12)  # radius of the circle within a triangle
        for file, base, crank, forearm, platform in (
                ("rdelta.ini", 0.10025, 0.15, 0.3505, 0.0455),
                ("grblhal.txt", 0.1875 * side, 0.102, 0.3105, 0.06225 * side)):
            path = self.folder / "rotary.urdf"
            self.answer("import", FIRMWARE / file, "--output", path)
            for point in ((0, 0, -300), (60, -30, -260), (-40, 50, -320)):
                rho = self.answer("evaluate", "--urdf", path, "--point", *(c / 1000 for c in point))["rho"]
                for angle, leg in zip(rho, (270, 30, 150)):
                    self.assertAlmostEqual(span(angle, leg, point, base, crank, platform), forearm, delta=1e-12)
                    self.assertLess(abs(angle), 1.7)
            answer = self.answer("largest", "--urdf", path, "--psi", "auto", "--accuracy", 0.005)
            self.assertEqual([row["unit"] for row in answer["joint_ranges"]], ["rad"] * 3)
            self.assertGreater(answer["size"], 0.05)

    def test_a_sloping_bed_is_level_in_the_world(self):
        path, answer = self.urdf("reprapfirmware")
        tree = ElementTree.parse(path).getroot()
        mount = next(joint for joint in tree.findall("joint") if joint.find("parent").get("link") == "world")
        roll, pitch, yaw = map(float, mount.find("origin").get("rpy").split())
        self.assertEqual(yaw, 0.0)
        towers = [(130.246, 209.895, 269.0), (130.246, 330.161, 268.8), (130.246, 90.0, 269.1)]
        for x, y, z in ((0, 0, 0), (80, 0, 100), (0, -80, 200), (-50, 60, 5)):
            lifted = z + 0.0011 * x - 0.0008 * y  # in the towers' axes, where the controller goes for (x, y, z)
            side, up = (y * math.cos(roll) - lifted * math.sin(roll), y * math.sin(roll) + lifted * math.cos(roll))
            world = (x * math.cos(pitch) + up * math.sin(pitch), side, up * math.cos(pitch) - x * math.sin(pitch))
            self.assertAlmostEqual(world[2], z, delta=1e-3)
            rho = self.answer("evaluate", "--urdf", path, "--point", *(c / 1000 for c in world))["rho"]
            for joint, wanted in zip(rho, carriages(towers, (x, y, lifted))):
                self.assertAlmostEqual(joint, wanted / 1000, delta=1e-9)
        self.assertEqual(answer["machine"], "reprapfirmware_delta")

    def test_lists_what_it_took_and_what_not(self):
        process = run("import", FIRMWARE / "klipper.cfg")
        self.assertEqual(process.returncode, 0)
        self.assertTrue(process.stdout.startswith("<?xml"))
        self.assertIn("took stepper_b arm_length = 268.812500: strut of stepper_b: 0.2688125 m", process.stderr)
        self.assertRegex(process.stderr, r"klipper.cfg:\d+: left aside stepper_a step_pin: ")
        path, answer = self.urdf("klipper")
        self.assertEqual(path.read_text(encoding="utf-8"), process.stdout)
        self.assertIn({"file": str(FIRMWARE / "klipper.cfg"), "line": 65, "key": "stepper_b position_endstop",
                       "value": "297.126500",
                       "meaning": "z of the tool in the middle, with stepper_b at its endstop: 0.2971265 m"},
                      answer["taken"])
        self.assertIn("[extruder]", [left["key"] for left in answer["left_aside"]])
        text = self.text("import", FIRMWARE / "klipper.cfg", "--output", path)
        self.assertRegex(text, r"^.*: took printer kinematics = delta(.|\n)*\nWrote machine 'klipper_delta' to ")
        self.assertIn("left aside", text)

    def test_name_and_format_are_those_asked_for(self):
        path, answer = self.urdf("marlin-report", "--name", "shop <1>", "--format", "marlin-report")
        self.assertEqual(answer["machine"], "shop <1>")
        self.assertEqual(json.loads(self.text("import", "--file", FIRMWARE / "config.g", "--json"))["format"],
                         "reprapfirmware")

    def test_what_is_wrong_is_told_at_once_and_writes_nothing(self):
        text = (FIRMWARE / "klipper.cfg").read_text(encoding="utf-8")
        path = self.file("wrong.cfg", text.replace("angle = 210.213000", "angle = left").replace("= delta", "= scara")
                         .replace("kinematics: delta", "kinematics: scara"))
        process = run("import", path, "--output", self.folder / "x.urdf")
        self.assertEqual((process.returncode, process.stdout), (2, ""))
        self.assertRegex(process.stderr, r"pkm: .*wrong.cfg:8: printer kinematics = 'scara' is not a linear delta")
        self.assertRegex(process.stderr, r"pkm: .*wrong.cfg:58: stepper_a angle = 'left' is not a number; allowed: ")
        self.assertFalse((self.folder / "x.urdf").exists())
        for words, reason in ((("import",), "--file FILE: the option is missing"),
                              (("import", path, path), "needs one value"),
                              (("import", "/no/such"), "/no/such: cannot be read: No such file"),
                              (("import", path, "--format", "grbl"), "'grbl' is not known; allowed: klipper, marlin"),
                              (("import", path, "--name", ""), "the text is empty"),
                              (("import", FIRMWARE / "config.g", "--format", "marlin"), "#define DELTA is missing"),
                              (("import", ORTHOGLIDE), "looks like none of the formats")):
            process = run(*words)
            self.assertEqual(process.returncode, 2)
            self.assertIn(reason, process.stderr)

    def test_the_set_is_found_without_more_options(self):
        path, _ = self.urdf("linuxcnc")
        disc = self.answer("largest", "--urdf", path, "--shape", "disc", "--set", "reachable", "--accuracy", 1e-4)
        self.assertBrackets(disc["size"], 0.269 - 0.13025, disc["size_upper_bound"])


if __name__ == "__main__":
    unittest.main()
