#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm export: what a controller with these limits lets pass, by its own rules, lies in the region that is proved."""

import math
import random
import re
import unittest
from xml.etree import ElementTree

from pkm import DATA, ORTHOGLIDE, CommandTest, run

SEED = 20261127
CYLINDER = ("--center", 0, 0, 0.16, "--radius", 0.06, "--height", 0.3)
BOX = ("--center", 0, 0, 0.1, "--sides", 0.08, 0.08, 0.1)
SOURCES = {"klipper": "klipper.cfg", "marlin": "marlin_configuration.txt", "reprapfirmware": "config.g",
           "linuxcnc": "ldelta.ini"}
RADIUS = {"klipper": r"(?m)^print_radius: (\S+)$", "marlin": r"(?m)^#define PRINTABLE_RADIUS (\S+)$",
          "reprapfirmware": r"(?m)^M665 B(\S+)$"}
LOWEST = {"klipper": r"(?m)^minimum_z_position: (\S+)$", "marlin": r"(?m)^#define Z_MIN_POS (\S+)$",
          "reprapfirmware": r"(?m)^M208 Z(\S+) S1$"}


class Export(CommandTest):
    def delta(self, form):
        source = DATA / "firmware" / SOURCES[form]
        if form == "reprapfirmware":  # on a level bed
            source = self.file("config.g", re.sub(r"(?m)^(M666 .*?) A\S+ B\S+", r"\1", source.read_text()))
        return self.file(f"{form}.urdf", self.text("import", source))

    def raised(self, form):
        """The machine, moved in its root frame."""
        tree = ElementTree.parse(self.delta(form)).getroot()
        root = {link.get("name") for link in tree.findall("link")}
        root -= {joint.find("child").get("link") for joint in tree.findall("joint")}
        for joint in tree.findall("joint"):
            if joint.find("parent").get("link") in root:
                origin = joint.find("origin")
                if origin is None:
                    origin = ElementTree.SubElement(joint, "origin", xyz="0 0 0")
                place = [float(x) for x in origin.get("xyz", "0 0 0").split()]
                origin.set("xyz", " ".join(repr(a + b) for a, b in zip(place, (0.25, -0.125, 0.75))))
        return ElementTree.tostring(tree, encoding="unicode")

    def export(self, form, *words, urdf=None):
        return self.text("export", "--urdf", urdf or self.delta(form), "--psi", "auto", *words, "--format", form)

    def highest(self, urdf, x, y):
        """Where the first carriage is at its switch, straight up from (x, y) [mm]."""
        rails = ElementTree.parse(urdf).getroot().findall("joint[@type='prismatic']/limit")
        rho = self.answer("evaluate", "--urdf", urdf, "--point", x / 1000, y / 1000, 0.1)["rho"]
        return min(1000 * (float(rail.get("upper")) - q + 0.1) for rail, q in zip(rails, rho))

    def test_a_cylinder_holds_what_the_controller_lets_pass(self):
        rng = random.Random(SEED)
        for form, pattern in RADIUS.items():
            with self.subTest(form):
                urdf = self.delta(form)
                text = self.export(form, *CYLINDER, "--joint-limits", "off", urdf=urdf)
                radius, lowest = (float(re.search(p, text)[1]) for p in (pattern, LOWEST[form]))
                self.assertLess(radius, 60)
                self.assertGreater(radius, 59.99)
                self.assertGreater(lowest, 10)
                self.assertLess(lowest, 10.01)
                for k in range(12):
                    turn, share = rng.uniform(0, 2 * math.pi), math.sqrt(rng.random()) if k else 0
                    x, y = radius * share * math.cos(turn), radius * share * math.sin(turn)
                    self.assertLess(self.highest(urdf, x, y), 310)  # the proved top

    def test_a_box_holds_what_the_controller_lets_pass(self):
        text = self.export("linuxcnc", *BOX, "--joint-limits", "off")
        sections = dict(re.findall(r"(?m)^\[AXIS_(.)\]\nMIN_LIMIT = (\S+\nMAX_LIMIT = \S+)$", text))
        for axis, ends in zip("XYZ", ((-40, 40), (-40, 40), (50, 150))):
            lower, upper = map(float, sections[axis].split("\nMAX_LIMIT = "))
            self.assertTrue(ends[0] < lower < ends[0] + 0.01 and ends[1] - 0.01 < upper < ends[1], sections)

    def test_the_proof_s_hypotheses_are_comments(self):
        text = " ".join(self.export("klipper", *CYLINDER, "--joint-limits", "off").split())
        for fact in ("Machine 'klipper_delta', geometry ", "radius 0.06 m", "Proved: every point of the cylinder is",
                     "velocity transmission factors in ["):
            self.assertIn(fact, text)

    def test_limits_are_seen_from_the_controller_s_zero(self):
        """The same machine on a mount, with its zero at that: the same limits."""
        raised = self.file("raised.urdf", self.raised("klipper"))
        plain = self.export("klipper", *CYLINDER, "--joint-limits", "off")
        moved = ("--center", 0.25, -0.125, 0.91, *CYLINDER[4:], "--joint-limits", "off")
        there = self.export("klipper", *moved, "--origin", 0.25, -0.125, 0.75, urdf=raised)
        for pattern in (RADIUS, LOWEST):
            self.assertAlmostEqual(float(re.search(pattern["klipper"], there)[1]),
                                   float(re.search(pattern["klipper"], plain)[1]), delta=0.002)
        self.assertIn("zero is taken to be at (0.25, -0.125, 0.75) m of the frame", " ".join(there.split()))
        for words, reason in ((moved, "about another axis cannot be held; give a --center above the --origin"),
                              (("--center", 0.25, -0.125, 0.8, *moved[4:], "--origin", 0.25, -0.125, 0.2),
                               "let the tool up to 0.8.* above its zero, and the region ends 0.7.* m above it; the "
                               "zero is at .0.25, -0.125, 0.2. m of the root link"),
                              ((*moved, "--origin", 0, 0, 1e10), "out of range; allowed: a number .m. within")):
            process = run("export", "--urdf", raised, "--psi", "auto", *words, "--format", "klipper")
            self.assertEqual(process.returncode, 2)
            self.assertRegex(process.stderr, reason)
        box = self.text("export", "--urdf", raised, "--psi", "auto", "--center", 0.25, -0.125, 0.85, *BOX[4:],
                        "--origin", 0.25, -0.125, 0.75, "--joint-limits", "off", "--format", "linuxcnc")
        self.assertEqual([round(float(x)) for x in re.findall(r"(?m)^M.._LIMIT = (\S+)$", box)],
                         [-40, 40, -40, 40, 50, 150])

    def test_written_limits_are_imported_again(self):
        """Klipper's file with the new limits in place of its own: the lowest carriages follow from them."""
        text = self.export("klipper", *CYLINDER, "--joint-limits", "off")
        config = (DATA / "firmware" / "klipper.cfg").read_text()
        for key, pattern in (("print_radius", RADIUS), ("minimum_z_position", LOWEST)):
            config, count = re.subn(rf"(?m)^{key} *[:=].*$", re.search(pattern["klipper"], text)[0], config)
            self.assertEqual(count, 1)
        taken = self.answer("import", self.file("new.cfg", config), "--format", "klipper")["taken"]
        values = {entry["key"]: float(entry["value"]) for entry in taken if entry["value"][-1].isdigit()}
        self.assertAlmostEqual(values["printer print_radius"], 60, delta=0.01)
        self.assertAlmostEqual(values["printer minimum_z_position"], 10, delta=0.01)

    def test_refusals(self):
        off = ("--joint-limits", "off")
        low = ("--center", 0, 0, 0.1, "--radius", 0.06, "--height", 0.1)
        for form, words, reason in (
            ("klipper", (*BOX, *off), "a box cannot be held; give a cylinder"),
            ("klipper", ("--center", 0, 0, 0.16, "--radius", 0.05, *off), "a sphere cannot be held; give a cylinder"),
            ("marlin", ("--center", 0.01, 0, 0.16, *CYLINDER[4:], *off), "about another axis cannot be held"),
            ("linuxcnc", (*CYLINDER, *off), "a cylinder cannot be held; give a box"),
            ("reprapfirmware", (*low, *off), "no limit for the upper end .* but its switches.*--top-by-slicer"),
            ("klipper", (*CYLINDER[:5], 0.25, *CYLINDER[6:], *off), "nothing is written, as the region is outside"),
            ("klipper", ("--center", 0, 0, 0.16), "give the region: --radius R --height H")):
            with self.subTest((form, words)):
                process = run("export", "--urdf", self.delta(form), "--psi", "auto", *words, "--format", form)
                self.assertEqual((process.returncode, process.stdout), (2, ""))
                self.assertRegex(process.stderr, reason)
        sloping = self.file("sloping.urdf", self.text("import", DATA / "firmware" / "config.g"))
        process = run("export", "--urdf", sloping, *CYLINDER, "--format", "reprapfirmware")
        self.assertRegex(process.stderr, "joint 'tower_x' is not along z")
        process = run("export", "--urdf", ORTHOGLIDE, *CYLINDER, "--format", "klipper")
        self.assertRegex(process.stderr, "joint '.*' is not along z")

    def test_what_only_the_slicer_holds_is_said(self):
        low = ("--center", 0, 0, 0.1, "--radius", 0.06, "--height", 0.1, "--joint-limits", "off", "--top-by-slicer")
        self.assertIn("# NOT held by the controller: z above 149.99", self.export("klipper", *low))


if __name__ == "__main__":
    unittest.main()
