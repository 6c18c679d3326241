#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The help texts: complete, with units, ranges and defaults, and their examples run."""

import os
import re
import shlex
import subprocess
import unittest
from xml.etree import ElementTree

from pkm import DATA, MACHINES, ORTHOGLIDE, URDF, CommandTest

TOLERANCES = {"tolerance-" + name for name in ("length", "slider", "slider-ball", "platform", "platform-ball",
                                               "direction", "zero")} | {"tolerances"}
MACHINE = {"urdf", "rails", "tcp-links", "tool-link", "tool", "ball-axes"} | TOLERANCES
REQUEST = (URDF.parent / "msg" / "CriterionRequest.msg").read_text()
BOUNDS = {name.replace("_", "-") for name in re.findall(r"(?m)^float64(?:\[\])? (\w+)$", REQUEST)}
JOINT_DATA = {name.replace("_", "-") for name in re.findall(r"(?m)^float64\[\] (\w+)$", REQUEST)}
ZONES = {"keep-in", "keep-out", "zones", "tool-radius"}
SHARED_CRITERION = {"set", "aspect", "joint-limits", "hinge-limits"} | ZONES | BOUNDS  # of several machines
CRITERION = SHARED_CRITERION | {"psi", "keep-out-collisions"}
SHAPE = {"shape", "proportions", "ratio", "vertices", "seen-from"}
MEASURES = {"radius", "height", "footprint"}  # of which the size is what they leave
BODY = SHAPE | {"size", "sides", "radius", "height"}
TIME = {"time-limit", "progress"}
BUDGET = TIME | {"max-boxes", "threads", "max-memory"}
COMMON = {"json", "help"}
OPTIONS = {
    "evaluate": MACHINE | CRITERION | COMMON | TIME | {"point", "points"},
    "largest": MACHINE | CRITERION | BUDGET | COMMON
    | SHAPE | MEASURES | {"accuracy", "search-box", "center", "base-z", "turned", "multi-precision",
                        "certificate"},
    "check": MACHINE | CRITERION | COMMON | BODY | TIME | {"center", "centers", "max-boxes", "multi-precision",
                                                           "certificate"},
    "verify": COMMON | {"file", "progress"},
    "path": MACHINE | CRITERION | COMMON | TIME
    | {"file", "segment", "tool-speed", "largest-feed", "joint-speeds-off", "joint-acceleration-max", "max-looks",
       "gcode", "interpreter", "origin", "tool-at", "work-offset", "tool-length", "tool-diameter", "rapid-feed",
       "most-listed", "certificate"},
    "pave": MACHINE | CRITERION | BUDGET | COMMON | {"resolution", "box", "volume-to", "mesh", "outer-mesh", "octomap",
                                                     "save", "resume", "list-boxes", "components", "certificate"},
    "connect": MACHINE | CRITERION | BUDGET | COMMON | {"from", "to", "resolution", "box"},
    "compare": MACHINE | SHARED_CRITERION | BUDGET | COMMON
    | SHAPE | MEASURES | {"paper", "accuracy", "multi-precision"},
    "study": MACHINE | SHARED_CRITERION | BUDGET | COMMON
    | SHAPE | {"machine", "parameter", "range", "parts", "accuracy"},
    "singularities": MACHINE | BUDGET | COMMON
    | BODY | {"center", "aspect", "joint-limits", "accuracy"},
    "conditioning": MACHINE | CRITERION | BUDGET | COMMON
    | BODY | {"center", "accuracy"},
    "guarantee": MACHINE | BUDGET | COMMON | BODY | (JOINT_DATA - {"strut-tilt-max"})
    | {"center", "aspect", "accuracy", "quantity"},
    "tolerate": MACHINE | CRITERION | BUDGET | COMMON | BODY | {"center", "accuracy"},
    "export": MACHINE | CRITERION | COMMON | BODY
    | {"time-limit", "center", "format", "origin", "top-by-slicer", "output"},
    "import": COMMON | TOLERANCES | {"file", "format", "name", "output"},
    "urdf": COMMON | TOLERANCES | {"linear-delta", "from", "template", "orthoglide", "uranesx", "machine", "lambda",
                      "output", "name", "joint", "angle", "rail-radius", "x", "y", "lean", "length", "platform-radius",
                      "slider-joint", "platform-joint", "travel", "home", "home-height", "working-mode", "kind",
                      "crank", "base-radius", "base-height", "crank-zero", "turn", "axis-lean",
                      "joint-speed-max", "joint-effort-max", "tool",
                      "mount", "mount-rpy", "assembly"},
}


class Help(CommandTest):
    def test_overview_names_every_command(self):
        text = self.text("--help")
        for command in OPTIONS:
            self.assertRegex(text, rf"(?m)^  {command}  +\w")
        for word in ("metres", "seconds", "Exit code", "--json", "--version"):
            self.assertIn(word, text)

    def test_each_command_names_exactly_its_options(self):
        for command, options in OPTIONS.items():
            listed = re.findall(r"(?m)^  --([a-z-]+)", self.text(command, "--help"))
            self.assertEqual(sorted(listed), sorted(options), command)

    def test_options_tell_range_and_default(self):
        text = re.sub(r"\s+", " ", self.text("largest", "--help"))
        for option, fact in (("--psi-min NUMBER", "> 0, without unit [default 0.5]"),
                             ("--psi-max NUMBER", "> 0, without unit [default 2]"),
                             ("--accuracy NUMBER", "a thousandth of the longest strut, to one digit; > 0 m"),
                             ("--joint-limits on|off", "[default on]"),
                             ("--shape cube|square|box|sphere|disc|cylinder|polytope", "[default cube]"),
                             ("--threads COUNT", "from 1 to 1024 [default "),
                             ("--search-box X0 X1 Y0 Y1 Z0 Z1", "[m]"),
                             ("--time-limit NUMBER", ">= 0 s [default 60 s]"),
                             ("--urdf FILE", "required")):
            entry = re.search(re.escape(option) + r"((?! --[a-z]).)*", text)
            self.assertIsNotNone(entry, option)
            self.assertIn(fact, entry.group())

    def test_help_wins_over_mistakes(self):
        self.assertEqual(self.text("largest", "--psi-min", "x", "--help"), self.text("largest", "--help"))

    def test_examples_run(self):
        os.chdir(self.folder)
        self.addCleanup(os.chdir, "/")
        for name, path in MACHINES.items():
            (self.folder / f"{name}.urdf").symlink_to(path)
        self.file("delta.urdf", self.text("import", DATA / "firmware" / "klipper.cfg"))
        (self.folder / "printer.cfg").symlink_to(DATA / "firmware" / "klipper.cfg")
        self.text("largest", "--urdf", ORTHOGLIDE, "--certificate", "cube.json")
        for command in OPTIONS:
            examples = re.findall(r"(?m)^  pkm (.*)$", self.text(command, "--help"))
            self.assertGreater(len(examples), 0, command)
            for example in examples:
                with self.subTest(example):
                    words = [word.replace(".urdf", "_new.urdf") if command == "urdf" else word
                             for word in shlex.split(example)]
                    # surfaces that the time limit ends are no answer: the default one would count on an idle machine
                    self.text(*words, *(("--time-limit", 3600) if "--mesh" in words else ()))

    def test_scripts_tell_their_use_without_what_they_need(self):
        for name in ("matplotlib", "numpy", "rospy"):
            self.file(f"{name}.py", "raise ImportError('it is not installed')\n")
        environment = {**os.environ, "PYTHONPATH": str(self.folder)}
        for script in ("bench", "demo", "figures", "pictures", "real_machines", "setup", "stress"):
            process = subprocess.run([str(URDF.parent / "scripts" / script), "--help"], env=environment,
                                     capture_output=True, text=True)
            self.assertEqual(process.returncode, 0, process.stderr)
            self.assertIn("usage: ", process.stdout, script)

    def test_version_is_the_package_s(self):
        version = ElementTree.parse(URDF.parent / "package.xml").getroot().findtext("version")
        self.assertEqual(self.text("--version"), f"pkm_workspace {version}\n")


if __name__ == "__main__":
    unittest.main()
