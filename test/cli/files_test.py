#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Files: read as a whole or refused, written as a whole or not at all; what was computed is not lost with a disk."""

import json
import os
import resource
import subprocess
import unittest

from pkm import ORTHOGLIDE, PKM, CommandTest, run

PAVE = ("pave", "--urdf", ORTHOGLIDE, "--resolution", 0.1)
LEAVING = "start 0 0 0\n" + 600 * "line 0.1 0 0\n" + "line 0.9 0.9 0.9\n"  # its last segment is outside


def failing(file, after, *words):
    """The finished process, where the disk fails after so many bytes of the file."""
    env = {**os.environ, "LD_PRELOAD": os.environ["FAILING_DISK"], "FAILING_FILE": file, "FAILING_AFTER": str(after)}
    return subprocess.run([PKM, *map(str, words)], capture_output=True, text=True, env=env)


def with_full_disk(*words, output=subprocess.PIPE):
    """The same, where no file may have more than 64 bytes."""
    return subprocess.run([PKM, *map(str, words)], stdout=output, stderr=subprocess.PIPE, text=True,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (64, 64)))


class Files(CommandTest):
    def assertRefused(self, process, reason):
        self.assertEqual((process.returncode, process.stdout), (2, ""), process.stderr)
        self.assertRegex(process.stderr, reason)

    def names(self):
        return sorted(path.name for path in self.folder.iterdir())

    def test_a_file_that_fails_on_the_way_is_refused(self):
        path = self.file("path.txt", LEAVING)
        points = self.file("points.txt", 900 * "0 0 0\n")
        urdf = self.file("machine.urdf", self.text("urdf", "--machine", "orthoglide"))
        paving = str(self.folder / "it.paving")
        self.text(*PAVE, "--save", paving)
        for file, words in ((path, ("path", "--urdf", ORTHOGLIDE, "--file", path)),
                            (points, ("evaluate", "--urdf", ORTHOGLIDE, "--points", points)),
                            (urdf, ("evaluate", "--urdf", urdf, "--point", 0, 0, 0)),
                            (paving, (*PAVE, "--resume", paving))):
            whole = failing(file, 1 << 40, *words)
            self.assertEqual(whole.returncode, 0, whole.stderr)
            for after in (0, 12, 1200, os.path.getsize(file)):
                with self.subTest((file, after)):
                    self.assertRefused(failing(file, after, *words), f"{file}: cannot be read: Input/output error")

    def test_what_is_no_file_is_called_that(self):
        for words in (("path", "--urdf", ORTHOGLIDE, "--file"), ("evaluate", "--urdf", ORTHOGLIDE, "--points"),
                      ("evaluate", "--point", 0, 0, 0, "--urdf"), (*PAVE, "--resume")):
            for file, reason in ((self.folder, "it is a folder"), (self.folder / "none", "No such file or directory"),
                                 ("/dev/zero", "it is not a regular file"), ("/proc/self/mem", "Input/output error")):
                with self.subTest((words, file)):
                    process = run(*words, file)
                    self.assertRefused(process, f"{file}: cannot be read: {reason}")
                    self.assertNotIn("missing", process.stderr)

    def test_pipes_are_read(self):
        command = [PKM, "path", "--urdf", ORTHOGLIDE, "--json", "--file", "/dev/stdin"]
        process = subprocess.run(command, input=LEAVING, capture_output=True, text=True)
        self.assertEqual(json.loads(process.stdout)["verdict"], "outside")

    def test_lines_without_end_are_refused(self):
        long = self.file("long.txt", "start 0 0 0\n# " + 70000 * "x")
        self.assertRefused(run("path", "--urdf", ORTHOGLIDE, "--file", long), "line 2 has more than the 65536 bytes")
        wrong = self.file("wrong.txt", 100000 * "line\n")
        process = run("path", "--urdf", ORTHOGLIDE, "--file", wrong)
        self.assertRefused(process, "wrong.txt:1: line needs 3 numbers, got 0(.|\n)*and 81 more")

    def test_zero_bytes_hide_nothing(self):
        path = self.file("path.txt", "start 0 0 0\nline 0.1\0garbage 0 0\n")
        self.assertRefused(run("path", "--urdf", ORTHOGLIDE, "--file", path), r"path.txt:2: '0.1\\0garbage' is not a n")
        points = self.file("points.txt", "0 0\0 0\n")
        self.assertRefused(run("evaluate", "--urdf", ORTHOGLIDE, "--points", points), r"line 1: '0\\0' is not a number")

    def test_commas_are_refused(self):
        for line in ("line 0,01 0", "line 0.1, 0, 0", "line 0,1,2"):
            path = self.file("path.txt", f"start 0 0 0\n{line}\n")
            self.assertRefused(run("path", "--urdf", ORTHOGLIDE, "--file", path), "path.txt:2: .*")
        self.assertRefused(run("path", "--urdf", ORTHOGLIDE, "--segment", "start 0 0,1 0"),
                           "'0,1' has a comma; write a decimal point, and blanks between numbers")
        points = self.file("points.txt", "0, 0, 0\n")
        self.assertRefused(run("evaluate", "--urdf", ORTHOGLIDE, "--points", points), "line 1: '0,' has a comma")

    def test_a_full_disk_takes_no_answer(self):
        file = self.folder / "it.paving"
        self.text(*PAVE, "--save", file)
        before = file.read_bytes()
        for words, wanted in ((PAVE, "volume"), ((*PAVE, "--json"), '"volume_lower"')):
            process = with_full_disk(*words, "--save", file)
            self.assertEqual(process.returncode, 1, process.stderr)
            self.assertIn(wanted, process.stdout)
            self.assertRegex(process.stderr,
                             f"answer is complete, but it was not saved: {file}: cannot be written: File too large; ")
            self.assertEqual((file.read_bytes(), self.names()), (before, ["it.paving"]))

    def test_a_full_disk_takes_no_urdf(self):
        file = self.file("it.urdf", "a machine")
        process = with_full_disk("urdf", "--machine", "orthoglide", "--output", file)
        self.assertEqual((process.returncode, process.stdout), (1, ""), process.stderr)
        self.assertRegex(process.stderr, f"^pkm: --output {file}: cannot be written: File too large; ")
        self.assertEqual((self.folder / "it.urdf").read_text(), "a machine")
        self.assertEqual(self.names(), ["it.urdf"])

    def test_boxes_are_saved_though_nobody_reads_the_answer(self):
        reading, writing = os.pipe()
        os.close(reading)
        with open("/dev/full", "w") as full, os.fdopen(writing, "w") as closed:
            for number, output in enumerate((full, closed)):
                file = self.folder / f"{number}.paving"
                process = subprocess.run([PKM, *map(str, PAVE), "--save", file], stdout=output, stderr=subprocess.PIPE,
                                         text=True)
                self.assertEqual(process.returncode, 1)
                self.assertEqual(process.stderr, "pkm: standard output cannot be written\n")
                self.assertEqual(self.answer(*PAVE, "--resume", file)["boxes_here"], 0)


if __name__ == "__main__":
    unittest.main()
