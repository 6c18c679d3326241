#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pip install . from the source tree, with what the build has made; with scripts/test --thorough from nothing, too."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ["PKM_BUILD"])
CODE = ("import sys, pkm_workspace as p; from pkm_workspace import study; print(p.__file__, study.__file__); "
        "print(p.largest(p.Machine.from_numbers(machine='orthoglide'), accuracy=0.05).status)")


class Install(unittest.TestCase):
    def pip(self, folder, *words):
        pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "install", ".", "--no-build-isolation"]
        return subprocess.run([*pip, "--no-deps", "--no-index", "--target", folder, *words], cwd=ROOT,
                              capture_output=True, text=True)

    def assertWorks(self, folder, **environment):
        ended = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, cwd="/",
                               env={"PATH": "/usr/bin", "PYTHONPATH": folder, **environment})
        self.assertEqual(ended.returncode, 0, ended.stderr)
        files, status = ended.stdout.splitlines()
        self.assertEqual(status, "proven")
        for file in files.split():
            self.assertTrue(file.startswith(folder), file)
        command = subprocess.run([pathlib.Path(folder) / "bin/pkm", "--version"], capture_output=True, text=True,
                                 env={"PATH": "/usr/bin", **environment})
        self.assertRegex(command.stdout, r"^pkm_workspace \d+\.\d+\.\d+\n$")

    def test_with_what_is_built(self):
        with tempfile.TemporaryDirectory(dir=BUILD) as folder:
            ended = self.pip(folder, "--config-settings", f"build={BUILD}")
            self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
            self.assertWorks(folder, LD_LIBRARY_PATH=os.environ["PKM_LIBRARIES"])

    @unittest.skipUnless(os.environ.get("PKM_WORKSPACE_TEST_CASES"), "takes minutes: scripts/test --thorough")
    def test_from_nothing(self):
        with tempfile.TemporaryDirectory(dir=BUILD) as folder:
            ended = self.pip(folder)
            self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
            self.assertWorks(folder)

    def test_a_folder_that_was_never_configured_is_refused(self):
        with tempfile.TemporaryDirectory(dir=BUILD) as folder:
            self.assertNotEqual(self.pip(folder, "--config-settings", f"build={folder}/none").returncode, 0)


if __name__ == "__main__":
    unittest.main()
