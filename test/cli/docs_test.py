#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every command pkm that README.md and docs/*.md print runs as it is printed, each document in a folder of its own.
Files that are the reader's are put there: what stands for them is below. What may take long gets a time limit."""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import unittest

from pkm import DATA, ORTHOGLIDE, PKM, CommandTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
TIME_LIMIT = "3"
COMMAND = re.compile(r"^(?:\$ )?(?:rosrun pkm_workspace )?pkm (.*)$")
CORNERS = [(x, y, z) for x in (0, 40) for y in (0, 30) for z in (0, 20)]
FACES = [(0, 1, 2), (1, 3, 2), (4, 6, 5), (5, 6, 7), (0, 4, 1), (1, 4, 5), (2, 3, 6), (3, 7, 6), (0, 2, 4), (2, 6, 4),
         (1, 5, 3), (3, 5, 7)]


def stl(scale):
    """A block of 40 x 30 x 20 mm."""
    lines = ["solid block"]
    for face in FACES:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(str(scale * x) for x in CORNERS[k]) for k in face]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid block", ""])


# What a reader has. By document where they differ: a job for the machine that it is about.
FILES = {
    "job.ngc": "G21 G90\nG0 X0 Y0 Z20\nG1 X30 Y10 F1200\nX0\nM2\n",
    "part.gcode": "G21 G90\nG1 X0 Y0 Z0 F1200\nX30\nY20\nX0 Y0\n",
    "job.txt": "start 0 0 0\nline 0.03 0.01 0\n",
    "part.stl": stl(0.001),
    "workpiece.stl": stl(1),
    "table.yaml": "keep_in:\n  - {kind: half_space, point: [0, 0, -1], normal: [0, 0, 1]}\n",
    "designs.yaml": "family: {machine: uranesx}\ndesigns: [{length: 1}]\nquestion: {shape: square, accuracy: 0.1}\n",
    "wrong.cfg": (DATA / "firmware" / "klipper.cfg").read_text().replace("angle = 210.213", "angle = left"),
}
REFUSED = {"import wrong.cfg"}  # and printed with the reason


def blocks(text):
    """Lines of code: between fences, or indented."""
    fenced = False
    for line in text.splitlines():
        if line.startswith("```"):
            fenced = not fenced
        elif fenced or line.startswith("    "):
            yield line.strip()


def commands(text):
    """Each as its words after pkm; a backslash continues a line, && begins another command."""
    lines = re.sub(r"\\\n\s*", "", "\n".join(blocks(text))).splitlines()
    for line in lines:
        found = COMMAND.match(line)
        for part in re.split(r"\s&&\s", found.group(1)) if found else []:
            words = shlex.split(re.sub(r"^pkm ", "", part), comments=True)
            if words and not words[0].startswith("$"):
                yield words


class Documents(CommandTest):
    def prepare(self):
        for name, content in FILES.items():
            self.file(name, content)
        shutil.copy(DATA / "firmware" / "klipper.cfg", self.folder / "printer.cfg")
        shutil.copy(DATA / "firmware" / "klipper.cfg", self.folder / "klipper.cfg")
        (self.folder / "urdf").symlink_to(ROOT / "urdf")
        shutil.copy(ORTHOGLIDE, self.folder / "orthoglide.urdf")
        for name in ("my_machine.urdf", "other.urdf"):  # where a document does not make it
            self.run_pkm("urdf", "--orthoglide", "--length", "0.5", "--output", name)
        self.run_pkm("import", "printer.cfg", "--output", "delta.urdf")
        self.run_pkm(*next(words for words in commands(DOCUMENTS[0].read_text()) if "--linear-delta" in words))

    def run_pkm(self, *words):
        return subprocess.run([PKM, *words], cwd=self.folder, capture_output=True, text=True)

    def limited(self, words):
        is_file = words[0] in ("study", "report") and not words[1].startswith("--")
        has_limit = words[0] in self.with_limit and not is_file and not {"--time-limit", "--help"} & set(words)
        # surfaces that the time limit ends are no answer
        return [*words, "--time-limit", "3600" if "--mesh" in words else TIME_LIMIT] if has_limit else words

    def test_every_command_runs(self):
        listed = re.findall(r"(?m)^  (\w+)  +\w", self.text("--help"))
        self.with_limit = {name for name in listed if "--time-limit" in self.text(name, "--help")}
        count = 0
        for document in DOCUMENTS:
            for path in list(self.folder.iterdir()):
                path.unlink()
            self.prepare()
            for words in commands(document.read_text(encoding="utf-8")):
                if "rs274" in words and not shutil.which("rs274"):
                    continue
                count += 1
                with self.subTest(f"{document.name}: pkm {shlex.join(words)}"):
                    process = self.run_pkm(*self.limited(words))
                    wanted = 2 if " ".join(words) in REFUSED else 0
                    self.assertEqual(process.returncode, wanted, process.stderr)
        self.assertGreater(count, 60)


if __name__ == "__main__":
    unittest.main()
