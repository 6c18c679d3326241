#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Many points and lines take little memory; where there is none, pkm says so."""

import json
import os
import re
import resource
import subprocess
import tempfile
import unittest

from pkm import ORTHOGLIDE, PKM, CommandTest

MEGABYTE = 1 << 20
POINTS = 6000
LINES = 60000


# Within some 70 kB of what is needed to load it, the C++ runtime goes without its pool for exceptions: nothing can be
# thrown then.
NO_POOL = "terminate called without an active exception\n"


class Memory(CommandTest):
    def peak(self, *words):
        """The most memory that pkm held [bytes], and what it said on standard output."""
        with tempfile.TemporaryFile("w+") as out:
            process = subprocess.Popen([PKM, *map(str, words)], stdout=out)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = status
            self.assertEqual(status, 0)
            out.seek(0)
            return usage.ru_maxrss << 10, out.read()

    def within(self, limit, *words):
        """The finished process, which may have so much address space [bytes]."""
        return subprocess.run([PKM, *map(str, words)], capture_output=True, text=True,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))

    def setUp(self):
        super().setUp()
        self.points = self.file("points.txt", "".join(f"0.{k % 37} 0.{k % 41} {k % 3}\n" for k in range(POINTS)))
        self.lines = self.file("path.txt", "start 0 0 0\n" + LINES // 2 * "line 0.1 0 0.01\nline 0 0.1 0\n")

    def commands(self):
        return (("evaluate", "--urdf", ORTHOGLIDE, "--points", self.points),
                ("path", "--urdf", ORTHOGLIDE, "--file", self.lines))

    def test_answers_are_not_held(self):
        for count, words in zip((POINTS, LINES), self.commands()):
            base, _ = self.peak("evaluate", "--urdf", ORTHOGLIDE, "--point", 0, 0, 0)
            for json_too in ((), ("--json",)):
                with self.subTest((words, json_too)):
                    peak, answer = self.peak(*words, *json_too)
                    # what was read, and what was found: a million points or lines within 200 MB
                    self.assertLess(peak - base, count * 160 + 4 * MEGABYTE)
                    if json_too:
                        self.assertEqual(len(json.loads(answer)["points" if words[0] == "evaluate" else "segments"]),
                                         count)
                    elif words[0] == "evaluate":
                        self.assertEqual(len(re.findall(r"(?m) (yes|no|undecided)$", answer)), POINTS)

    def test_searches_keep_to_their_memory(self):
        orthoglide = ("--urdf", ORTHOGLIDE)
        cylinder = ("--shape", "cylinder", "--ratio", 0.5, 0.8)
        family = ("--machine", "uranesx", "--parameter", "R-r", "--range", 0.3, 0.5)
        for words, most in ((("largest", *orthoglide, "--accuracy", 1e-9), 4096),
                            (("largest", *orthoglide, *cylinder, "--accuracy", 0.01), 4096),
                            (("compare", *orthoglide, "--accuracy", 1e-9), 4096),
                            (("study", *family, "--shape", "square", "--accuracy", 1e-4), 4096),
                            (("singularities", *orthoglide), 4096),
                            (("conditioning", *orthoglide, "--accuracy", 1e-9), 4096),
                            (("pave", *orthoglide), 8192)):  # two runs share it
            with self.subTest(words):
                text = " ".join(self.text(*words, "--max-memory", most).split())
                self.assertIn(f"the limit of {most} bytes of memory", text)

    def test_without_memory_there_is_a_sentence(self):
        ended = []
        # pave lists more boxes than fit
        listing = ("pave", "--urdf", ORTHOGLIDE, "--resolution", 0.02, "--threads", 1, "--list-boxes", 10**6, "--json")
        for words in (*self.commands(), listing):
            for limit in range(12, 200, 3):
                process = self.within(limit * MEGABYTE, *words)
                if process.returncode == 127 or process.stderr == NO_POOL:
                    continue  # the system could not load it
                with self.subTest((words, limit)):
                    self.assertIn(process.returncode, (0, 1))
                    if process.returncode == 0:
                        break
                    self.assertRegex(process.stderr, "pkm: the (memory is used up|system refuses what is needed): ")
                    ended.append(words[0])
            self.assertEqual(process.returncode, 0)
        self.assertLessEqual({"path", "pave"}, set(ended))


if __name__ == "__main__":
    unittest.main()
