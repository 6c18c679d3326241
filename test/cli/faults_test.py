#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A disk that is full, and a kill, at every call that changes a file: files are the old or the new ones, whole."""

import os
import subprocess
import unittest

from pkm import ORTHOGLIDE, PKM, CommandTest, run

MOST_CALLS = 200
PAVING = ("pave", "--urdf", ORTHOGLIDE, "--resolution", 0.4)
OLD = b"what was there before\n"


def failing_at(call, how, words):
    """The finished process, whose call of that number fails."""
    env = {**os.environ, "LD_PRELOAD": os.environ["FAILING_DISK"], "FAILING_CALL": str(call), "FAILING_HOW": how}
    return subprocess.run([PKM, *map(str, words)], capture_output=True, text=True, env=env)


class Faults(CommandTest):
    def setUp(self):
        super().setUp()
        names = ("set.paving", "set.json", "set.stl", "set.bt")
        self.pave = (*PAVING, *self.outputs(zip(("--save", "--certificate", "--mesh", "--octomap"), names)))
        self.commands = ((self.pave, names),
                         (("largest", "--urdf", ORTHOGLIDE, *self.outputs([("--certificate", "cube.json")])),
                          ["cube.json"]),
                         (("urdf", "--machine", "delta", *self.outputs([("--output", "delta.urdf")])), ["delta.urdf"]))

    def outputs(self, options):
        return [word for option, name in options for word in (option, self.folder / name)]

    def contents(self):
        return {path.name: path.read_bytes() for path in self.folder.iterdir()}

    def test_files_are_old_or_new_whatever_fails(self):
        for words, names in self.commands:
            for path in self.folder.iterdir():
                path.unlink()
            self.text(*words)
            new = {name: (self.folder / name).read_bytes() for name in names}
            for how in ("full", "kill"):
                failures = unharmed = 0
                for call in range(1, MOST_CALLS):
                    for name in names:
                        (self.folder / name).write_bytes(OLD)
                    process = failing_at(call, how, words)
                    with self.subTest(command=words[0], how=how, call=call):
                        after = self.contents()
                        for name in names:
                            self.assertIn(after[name], (OLD, new[name]), name)
                    if how == "full":
                        self.assert_told(process, words, after, new)
                    unharmed = unharmed + 1 if process.returncode == 0 and after == new else 0
                    if unharmed == 2:  # one may be a folder that could not be flushed
                        break
                    failures += 1
                self.assertGreaterEqual(failures, 5 * len(names))
                self.assertLess(failures, MOST_CALLS - 1)

    def assert_told(self, process, words, after, new):
        """The folder of a file that is in its place could not be flushed: nobody can do anything about it."""
        self.assertEqual(sorted(after), sorted(new), "drafts are removed")
        if process.returncode == 0:
            return self.assertEqual(after, new)
        self.assertRegex(process.stderr, "cannot be written: No space left on device")
        if process.returncode == 2:  # that is tried before anything is computed
            return self.assertEqual(process.stdout, "")
        self.assertEqual(process.returncode, 1)
        if words[0] != "urdf":
            self.assertIn("Proved" if words[0] == "pave" else "proved", process.stdout)

    def test_a_run_after_a_kill_removes_what_was_left(self):
        left = 0
        for call in range(1, MOST_CALLS):
            if failing_at(call, "kill", self.pave).returncode == 0:
                break
            left += any(name.count(".") > 1 for name in self.contents())
        self.assertGreater(left, 8, "drafts")
        self.text(*self.pave)
        self.assertEqual(sorted(self.contents()), ["set.bt", "set.json", "set.paving", "set.stl"])

    def test_a_paving_that_was_saved_before_the_kill_goes_on(self):
        saved = str(self.folder / "it.paving")
        coarse = (*PAVING[:-1], 0.8, "--save", saved)
        self.text(*coarse)
        for call in range(1, 5):
            failing_at(call, "kill", (*PAVING, "--resume", saved, "--save", saved))
            answer = self.answer(*PAVING, "--resume", saved)
            self.assertEqual(answer["boxes"], self.answer(*PAVING)["boxes"])


if __name__ == "__main__":
    unittest.main()
