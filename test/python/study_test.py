#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Studies: each row is what the core says of that design, and the table is the same however it was made."""

import csv
import os
import random
import signal
import sqlite3
import subprocess
import sys
import time
import unittest
import warnings

from support import CommandTest, core
from pkm import PKM
from pkm_workspace import study

SEED = 1910
MOMENTS = 10
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
        self.file("family.py", FAMILY.format(marker=str(self.folder / "marker")))

    def study(self, function="plain", count=60, table="table.sqlite"):
        return self.file(f"{function}.yaml", STUDY.format(function=function, count=count, table=self.folder / table))

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


class Designs(unittest.TestCase):
    def test_grids(self):
        self.assertEqual(study.grid(a=(0, 1, 3), b=[5, 6]), [{"a": a, "b": b} for a in (0, 0.5, 1) for b in (5, 6)])

    def test_samples_fill_evenly_and_go_on(self):
        few, many = (study.sample(n, a=(0, 1), b=(-2, 2)) for n in (64, 128))
        self.assertEqual(few, many[:64])
        for name, least, most in (("a", 0, 1), ("b", -2, 2)):
            for k in range(4):  # each quarter has a quarter of them, within two
                low, high = (least + (most - least) * j / 4 for j in (k, k + 1))
                self.assertAlmostEqual(sum(low <= design[name] < high for design in many), 32, delta=2)

    def test_refusals(self):
        for designs, text in (([], "no designs"), ([{"a": 1}, {"b": 1}], "design 1 has the parameters b"),
                              ([{"a": float("nan")}], "not finite"), ([{"a": [1]}], "no number"),
                              ([{"size": 1}], "cannot be called size")):
            with self.assertRaisesRegex(core.PkmError, text):
                study.run(linear_delta, designs, "/nowhere/x.sqlite" if "called" not in text else ":memory:", **SQUARE)
        with self.assertRaisesRegex(core.PkmError, "acuracy: .*did you mean accuracy"):
            study.run(linear_delta, [{"difference": 0.4}], ":memory:", acuracy=1)


class Rows(StudyTest):
    def test_are_what_the_core_says(self):
        for count in (1, 2):
            table = self.folder / f"{count}.sqlite"
            written = study.run(linear_delta, study.grid(difference=(0.36, 0.42, 60)), table, workers=count, **SQUARE)
            self.assertEqual(written, 60)
            self.assertEqual(untimed(table)[1], self.expected())

    def test_volumes_and_guarantees(self):
        study.run(linear_delta, [{"difference": 0.4}], self.table, volumes={"resolution": 0.1},
                  guarantees={"quantity": ["kappa_max"]}, **SQUARE)
        names, (row,) = study.read(self.table)
        row = dict(zip(names, row))
        paving = core.pave(linear_delta(0.4), resolution=0.1)
        self.assertEqual((row["measure_lower"], row["measure_upper"]), (paving.volume_lower, paving.volume_upper))
        known = core.guarantee(linear_delta(0.4), center=[row[f"center_{axis}"] for axis in "xyz"], shape="square",
                               size=row["size"], quantity="kappa_max").guarantees[0].value
        self.assertEqual([row["kappa_max_lower"], row["kappa_max_upper"]], known)

    def test_a_design_without_a_machine_has_its_reason(self):
        study.run(study.Catalogue(machine="uranesx", platform_radius=0.1),
                  [{"rail_radius": 0.5}, {"rail_radius": -1}, {"rail_radius": 5}], self.table, **SQUARE)
        rows = study.read(self.table)[1]
        self.assertEqual([row[2] for row in rows], ["proven", "refused", "refused"])
        self.assertIn("rail_radius -1: -1 is out of range", rows[1][3])

    def test_mixtures_and_files(self):
        made = self.file("a.urdf", linear_delta(0.38).urdf), self.file("b.urdf", linear_delta(0.42).urdf)
        study.run(study.Mixture(*made), [{"share": share} for share in (0, 0.5, 1)], self.table, **SQUARE)
        sizes = [row[4] for row in study.read(self.table)[1]]
        for share, size in zip((0.38, 0.40, 0.42), sizes):
            region = core.largest(linear_delta(share), **SQUARE)
            self.assertLessEqual(size, region.size_upper_bound + 1e-9)
            self.assertLessEqual(region.size, size + SQUARE["accuracy"] + 1e-9)
        table = self.folder / "files.sqlite"
        study.run(study.Files(), [{"urdf": file} for file in made], table, **SQUARE)
        for row, size in zip(study.read(table)[1], (sizes[0], sizes[2])):  # a mixture is written with other last digits
            self.assertAlmostEqual(row[4], size, delta=1e-12)


class Files(StudyTest):
    def test_a_study_in_a_file(self):
        said = self.finished(self.study(), "--export", self.folder / "t.csv", "--export", self.folder / "t.h5")
        self.assertIn("60 of 60 designs evaluated", said)
        names, rows = study.read(self.table)
        self.assertEqual([row[:-1] for row in rows], self.expected())
        with open(self.folder / "t.csv", encoding="utf-8") as file:
            written = list(csv.reader(file))
        self.assertEqual(written[0], names)
        for text, row in zip(written[1:], rows):
            self.assertEqual([float(word) if isinstance(value, float) else word for word, value in zip(text, row)],
                             ["" if value is None else value if isinstance(value, (float, str)) else str(value)
                              for value in row])
        self.assertIn("0 of 60 designs evaluated", self.finished(self.study()))
        try:
            import tables
        except ImportError:
            self.skipTest("PyTables is missing")
        with tables.open_file(self.folder / "t.h5") as file:
            self.assertEqual(file.root.study[:]["size"].tolist(), [row[4] for row in rows])

    def test_another_study_does_not_go_on_with_the_table(self):
        self.finished(self.study())
        for other, text in ((self.study(count=61), "designs differ"), (self.study("loud"), "family differ")):
            ended = self.command(other)
            self.assertEqual(ended.returncode, 2)
            self.assertIn(text, ended.stderr)
        self.file("table.sqlite", "this is no table, but text enough for a page of one\n" * 99)
        self.assertIn("cannot be used as the table", self.command(self.study()).stderr)

    def test_what_a_family_prints_is_not_mixed_with_rows(self):
        self.finished(self.study("loud"))
        self.assertEqual(untimed(self.table)[1], self.expected())

    def test_refusals(self):
        for text, said in (("designs: []", "'family' is missing"), ("family: {machine: delta}", "'designs' is missing"),
                           ("nonsense: 1", "'nonsense' is not known; allowed"), ("[", "is not YAML"),
                           ("family: {mix: [a]}\ndesigns: []", "two URDFs are mixed"),
                           ("family: {machine: delta}\ndesigns: {grid: {crank: {from: 1}}}", "'to' is missing"),
                           ("family: {machine: delta}\ndesigns: {sample: {crank: [0, 1]}}", "'count' is missing"),
                           ("family: {function: family.py:nobody}\ndesigns: [{a: 1}]", "cannot be loaded")):
            ended = self.command(self.file("bad.yaml", text))
            self.assertEqual(ended.returncode, 2, text)
            self.assertIn(said, ended.stderr)


class Deaths(StudyTest):
    def test_a_worker_that_dies_is_replaced(self):
        self.finished(self.study("dies_once"))
        self.assertTrue((self.folder / "marker").exists())
        self.assertEqual(untimed(self.table)[1], self.expected())

    def test_a_design_that_kills_workers_is_given_up(self):
        self.finished(self.study("dies"))
        rows = untimed(self.table)[1]
        self.assertEqual(rows[:-1], self.expected()[:-1])
        self.assertEqual(rows[-1][2:4], ("lost", "3 workers died of it"))

    def test_killed_at_any_moment_it_goes_on(self):
        moments, file, count = random.Random(SEED), self.study(count=1000), 0
        for moment in sorted(moments.randrange(1000) for _ in range(MOMENTS)):
            program = subprocess.Popen([PKM, "study", file, "--quiet"], stdout=subprocess.PIPE)
            while program.poll() is None and count_of(self.table) < moment:
                time.sleep(0.002)
            program.kill()
            program.communicate()
            self.assertGreaterEqual(count_of(self.table), count)
            count = count_of(self.table)
        self.assertIn(f"{1000 - count} of 1000 designs evaluated", self.finished(file))
        self.assertEqual(untimed(self.table)[1], self.expected(1000))

    def test_a_scheduler_whose_worker_is_killed(self):
        try:
            import distributed  # noqa: F401
        except ImportError:
            self.skipTest("distributed is missing")
        self.finished(self.study(count=400, table="local.sqlite"))
        with Cluster(self.folder) as cluster:
            program = subprocess.Popen([PKM, "study", self.study(count=400), "--quiet", "--scheduler", cluster.address],
                                       stderr=subprocess.PIPE, text=True)
            while program.poll() is None and count_of(self.table) < 200:
                time.sleep(0.01)
            self.assertIsNone(program.poll())
            cluster.workers[0].kill()
            self.assertEqual(program.wait(), 0, program.communicate()[1])
        self.assertEqual(untimed(self.table), untimed(self.folder / "local.sqlite"))


class Cluster:
    """Dask's scheduler and two workers."""

    def __init__(self, folder):
        self.folder = folder
        self.workers = []

    def start(self, module, *words):
        return subprocess.Popen([sys.executable, "-m", f"distributed.cli.{module}", *words], cwd=self.folder,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))})

    def __enter__(self):
        file = self.folder / "scheduler.json"
        self.scheduler = self.start("dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard",
                                    "--scheduler-file", str(file))
        while not file.exists() and self.scheduler.poll() is None:
            time.sleep(0.05)
        from distributed import Client
        with Client(scheduler_file=str(file)) as client:
            self.address = client.scheduler.address
            self.workers = [self.start("dask_worker", self.address, "--nthreads", "1", "--no-nanny", "--no-dashboard")
                            for _ in range(2)]
            client.wait_for_workers(2)
        return self

    def __exit__(self, *_):
        for process in [*self.workers, self.scheduler]:
            process.send_signal(signal.SIGKILL)
            process.wait()


if __name__ == "__main__":
    unittest.main()
