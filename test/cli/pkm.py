# SPDX-License-Identifier: BSD-3-Clause
"""Runs the command pkm, whose path is in the environment variable PKM, on the machines of urdf/."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest
from xml.etree import ElementTree

PKM = os.environ["PKM"]
URDF = pathlib.Path(__file__).resolve().parents[2] / "urdf"
DATA = pathlib.Path(__file__).resolve().parents[1] / "data"
ORTHOGLIDE = str(URDF / "orthoglide.urdf")
URANESX = str(URDF / "uranesx.urdf")
MACHINES = {"orthoglide": ORTHOGLIDE, "uranesx": URANESX}


def run(*words):
    """The finished process: returncode, stdout, stderr."""
    return subprocess.run([PKM, *map(str, words)], capture_output=True, text=True)


class CommandTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def text(self, *words):
        """What pkm says on standard output when it answers."""
        process = run(*words)
        self.assertEqual(process.returncode, 0, process.stderr)
        return process.stdout

    def answer(self, *words):
        """The one JSON object that pkm prints when it answers."""
        return json.loads(self.text(*words, "--json"))

    def file(self, name, content):
        path = self.folder / name
        path.write_text(content, encoding="utf-8")
        return str(path)

    def machine(self, *words):
        """The path of a URDF that `pkm urdf` writes."""
        return self.file("machine.urdf", self.text("urdf", *words))

    def with_limits(self, urdf, lower, upper):
        """The text of the URDF with these limits for every rail."""
        tree = ElementTree.parse(urdf)
        for limit in tree.getroot().findall("joint[@type='prismatic']/limit"):
            limit.set("lower", str(lower))
            limit.set("upper", str(upper))
        return ElementTree.tostring(tree.getroot(), encoding="unicode")

    def assertBrackets(self, lower, value, upper, slack=0.0):
        """lower <= value <= upper, where the value is known up to the slack only."""
        self.assertLessEqual(lower, value + slack)
        self.assertGreaterEqual(upper, value - slack)
