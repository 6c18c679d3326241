# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of studies share: a study in a file, families that live and die, what its table has to be."""

import os
import select
import sqlite3
import subprocess
import warnings

from support import CommandTest, core
from pkm import PKM
from pkm_workspace import study

SQUARE = {"shape": "square", "accuracy": 1e-3}
STUDY = """
family: {{function: family.py:{function}}}
designs: {{grid: {{difference: {{from: 0.36, to: 0.42, count: {count}}}}}}}
question: {{shape: square, accuracy: 1e-3}}
table: {table}
"""
FAMILY = """
import os, signal
import pkm_workspace as pkm

def plain(difference):
    return pkm.Machine.from_numbers(machine="uranesx", rail_radius=difference + 0.1, platform_radius=0.1)

def dies_once(difference):
    if difference > 0.39:
        try:
            os.close(os.open({marker!r}, os.O_CREAT | os.O_EXCL))
            os.kill(os.getpid(), signal.SIGKILL)
        except FileExistsError:
            pass
    return plain(difference)

def dies(difference):
    if difference > 0.4195:
        os.kill(os.getpid(), signal.SIGKILL)
    return plain(difference)

def logs(difference):
    with open({marker!r}, "a") as file:
        file.write("x")
    return plain(difference)

def tells(difference):
    with open({told!r}, "w") as pipe:
        pipe.write("x")
    return plain(difference)

def loud(difference):
    print("a family may print")
    return plain(difference)
"""


def linear_delta(difference):
    return core.Machine.from_numbers(machine="uranesx", rail_radius=difference + 0.1, platform_radius=0.1)


def untimed(table):
    names, rows = study.read(table)
    return names[:-1], [row[:-1] for row in rows]


def count_of(table):
    try:
        with sqlite3.connect(f"file:{table}?mode=ro", uri=True) as connection:
            return connection.execute("SELECT count(*) FROM results").fetchone()[0]
    except sqlite3.OperationalError:
        return 0


class StudyTest(CommandTest):
    def setUp(self):
        super().setUp()
        warnings.simplefilter("ignore", core.PkmWarning)
        self.table = self.folder / "table.sqlite"
        self.pipe = str(self.folder / "pipe")
        self.file("family.py", FAMILY.format(marker=str(self.folder / "marker"), told=self.pipe))

    def study(self, function="plain", count=60, table="table.sqlite"):
        return self.file(f"{function}.yaml", STUDY.format(function=function, count=count, table=self.folder / table))

    def begin(self, *words):
        """Starts a study of the family that tells of each design; its pipe never ends, and holds them all."""
        if not os.path.exists(self.pipe):
            os.mkfifo(self.pipe)
            self.told = os.open(self.pipe, os.O_RDWR | os.O_NONBLOCK)
            self.addCleanup(os.close, self.told)
        while select.select([self.told], [], [], 0)[0]:
            os.read(self.told, 4096)  # of workers that outlived their study
        return subprocess.Popen([PKM, "study", *map(str, words), "--quiet"], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def wait_for_designs(self, program, count):
        """Until so many have been begun, or the program says that it has ended."""
        while count > 0 and self.told in select.select([self.told, program.stdout], [], [])[0]:
            count -= len(os.read(self.told, count))

    def command(self, *words):
        return subprocess.run([PKM, "study", *map(str, words)], capture_output=True, text=True)

    def finished(self, *words):
        ended = self.command(*words, "--quiet")
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return ended.stdout

    def expected(self, count=60):
        """Made here, without workers."""
        rows = []
        warnings.simplefilter("ignore", core.PkmWarning)
        for number, difference in enumerate(study.designs.numbers_between(0.36, 0.42, count)):
            region = core.largest(linear_delta(difference), threads=1, **SQUARE)
            center = region.center or [None] * 3
            strokes = [joint.stroke for joint in region.joint_ranges] or [None] * 3
            rows.append((number, difference, region.status, region.message, region.size, region.size_upper_bound,
                         *center, *strokes))
        return rows
