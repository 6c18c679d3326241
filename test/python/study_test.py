#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Studies: each row is what the core says of that design, each design is computed once."""

import csv
import sqlite3
import unittest
from unittest import mock

from support import core
from pkm_workspace import study
from study_support import SQUARE, StudyTest, linear_delta, untimed


class Designs(unittest.TestCase):
    def test_grids(self):
        self.assertEqual(study.grid(a=(0, 1, 3), b=[5, 6]), [{"a": a, "b": b} for a in (0, 0.5, 1) for b in (5, 6)])

    def test_samples_fill_evenly_and_go_on(self):
        few, many = (study.sample(n, a=(0, 1), b=(-2, 2)) for n in (64, 128))
        self.assertEqual(few, many[:64])
        self.assertEqual(study.sample(64, 64, a=(0, 1), b=(-2, 2)), many[64:])
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
        table = self.folder / "a#b%41?.sqlite"
        study.run(study.Files(), [{"urdf": file} for file in made], table, **SQUARE)
        for row, size in zip(study.read(table)[1], (sizes[0], sizes[2])):  # a mixture is written with other last digits
            self.assertAlmostEqual(row[4], size, delta=1e-12)
        self.file("b.urdf", linear_delta(0.36).urdf)
        with self.assertRaisesRegex(core.PkmError, "its family differ"):
            study.run(study.Files(), [{"urdf": file} for file in made], table, **SQUARE)

    def test_another_function_is_another_family(self):
        study.run(lambda difference: linear_delta(difference), [{"difference": 0.4}], self.table, **SQUARE)
        with self.assertRaisesRegex(core.PkmError, "its family differ"):
            study.run(lambda difference: linear_delta(difference + 0.01), [{"difference": 0.4}], self.table, **SQUARE)

    def test_what_fails_in_one_design_is_told_in_its_row(self):
        def family(difference):
            return {}["nothing"] if difference > 0.4 else linear_delta(difference)
        designs = [{"difference": 0.39}, {"difference": 0.41}]
        study.run(family, designs, self.table, volumes={"resolution": -1.0}, **SQUARE)
        first, second = study.read(self.table)[1]
        self.assertEqual(first[2], "proven")
        self.assertIn("Not computed: volumes or guarantees: resolution -1", first[3])
        self.assertEqual(second[2:4], ("refused", "KeyError: 'nothing'"))
        for name in ("Size", "seconds"):
            with self.assertRaisesRegex(core.PkmError, f"cannot be called {name}"):
                study.run(family, [{name: 1}], self.folder / "other.sqlite", **SQUARE)


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

    def test_nothing_is_computed_twice(self):
        self.finished(self.study("logs"))
        with sqlite3.connect(self.table) as connection:
            connection.execute("DELETE FROM results WHERE design < 7")
        self.finished(self.study("logs"))
        self.assertEqual(len((self.folder / "marker").read_text(encoding="utf-8")), 60 + 7)
        self.assertEqual(untimed(self.table)[1], self.expected())

    def test_a_table_is_made_whole_or_not_at_all(self):
        made = study.Table._create

        def fails(table, told):
            made(table, told)
            raise KeyboardInterrupt
        designs = study.grid(difference=(0.36, 0.42, 60))
        with mock.patch.object(study.Table, "_create", fails), self.assertRaises(KeyboardInterrupt):
            study.run(linear_delta, designs, self.table, **SQUARE)
        with sqlite3.connect(self.table) as connection:
            self.assertEqual(connection.execute("SELECT name FROM sqlite_master").fetchall(), [])
        self.assertEqual(study.run(linear_delta, designs, self.table, **SQUARE), 60)

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
        delta = "family: {machine: delta}\n"
        for text, said in (("designs: []", "'family' is missing"), ("family: {machine: delta}", "'designs' is missing"),
                           ("nonsense: 1", "'nonsense' is not known; allowed"), ("[", "is not YAML"),
                           ("family: {mix: [a]}\ndesigns: []", "two URDFs are mixed"),
                           (delta + "designs: {grid: {crank: {from: 1}}}", "'to' is missing"),
                           (delta + "designs: {sample: {crank: [0, 1]}}", "'count' is missing"),
                           (delta + "designs: [{crank: 1}]\nvolumes: yes", "volumes: names and values"),
                           (delta + "designs: [{crank: 1}]\nquestion: {table: 2}", "'table' is not known"),
                           (delta + "designs: {grid: {}}", "have no parameters"),
                           (delta + "designs: {sample: {count: 3}}", "have no parameters"),
                           (delta + "designs: {grid: {crank: {from: 1, to: abc, count: 2}}}", "two numbers"),
                           (delta + "designs: {sample: {count: 2, crank: [0, abc]}}", "two numbers"),
                           ("family: {function: family.py:nobody}\ndesigns: [{a: 1}]", "cannot be loaded")):
            ended = self.command(self.file("bad.yaml", text))
            self.assertEqual(ended.returncode, 2, text)
            self.assertIn(said, ended.stderr)


if __name__ == "__main__":
    unittest.main()
