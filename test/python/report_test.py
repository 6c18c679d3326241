#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reports: one file each, with the brackets of the core rounded outward; what a browser makes of them."""

import decimal
import html.parser
import random
import re
import shutil
import subprocess
import unittest

from support import URDF, CommandTest, core, machine
from pkm import ORTHOGLIDE, PKM, URANESX
from pkm_workspace import report, study
from pkm_workspace.report.body import surface_of
from pkm_workspace.report.numbers import bracket, rounded_up

SEED = 1912
BROWSER = shutil.which("chromium")
SQUARES = {"shape": "square", "accuracy": 1e-2}


class Reader(html.parser.HTMLParser):
    """The cells of all tables, and whether tags close."""

    def __init__(self, text):
        super().__init__()
        self.open, self.rows, self.addresses, self.cell = [], [], [], None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        if tag not in ("meta",):
            self.open.append(tag)
        self.addresses += [value for name, value in attributes if name in ("src", "href") and not value.startswith("#")]
        if tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th"):
            self.cell = ""

    def handle_startendtag(self, tag, attributes):
        pass

    def handle_data(self, data):
        if self.cell is not None:
            self.cell += data

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag
        if tag in ("td", "th"):
            self.rows[-1].append(self.cell)
            self.cell = None


def numbers_in(text):
    return [float(word) for word in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", text)]


class Report(CommandTest):
    def read(self, name="page.html"):
        text = (self.folder / name).read_text(encoding="utf-8")
        reader = Reader(text)
        self.assertEqual((reader.open, reader.addresses), ([], []), "all tags close, and no other file is needed")
        return text, reader.rows

    def table(self):
        path = self.folder / "study.sqlite"
        designs = study.grid(rail_radius=(0.44, 0.56, 4), platform_radius=[0.05, 0.1])
        study.run(study.Catalogue(machine="uranesx"), designs, path, workers=1, **SQUARES)
        return path

    def test_brackets_are_rounded_outward(self):
        rng = random.Random(SEED)
        for _ in range(2000):
            lower = rng.choice((-1, 1)) * 10 ** rng.uniform(-12, 9)
            upper = lower + rng.choice((0, abs(lower) * 10 ** rng.uniform(-16, 3)))
            words = [decimal.Decimal(word) for word in bracket(lower, upper).split(" to ")]
            self.assertLessEqual(words[0], decimal.Decimal(lower))
            self.assertGreaterEqual(words[-1], decimal.Decimal(upper))
            slack = 0.03 * (upper - lower) + 3e-6 * max(abs(lower), abs(upper))
            self.assertLess(words[-1] - words[0], decimal.Decimal(upper - lower + slack))
            self.assertGreaterEqual(decimal.Decimal(rounded_up(upper)), decimal.Decimal(upper))
        self.assertEqual(bracket(0.64395, 0.644950001, "m"), "0.64395 to 0.64496 m")
        self.assertEqual(bracket(None, 1.0), "not known")

    def test_a_machine(self):
        for name, keywords in (("orthoglide", {}), ("uranesx", {"joint_limits": False}),
                               ("tripod", {"accuracy": 0.02})):
            with self.subTest(name):
                report.machine(machine(name), self.folder / "page.html", **keywords)
                text, rows = self.read()
                for shape in ("cube", "sphere"):
                    region = core.largest(machine(name), shape=shape, **keywords)
                    lower, upper = numbers_in(next(row for row in rows if row[0] == shape)[1])
                    self.assertLessEqual(lower, region.size)
                    self.assertGreaterEqual(upper, region.size_upper_bound)
                    self.assertLess(upper - lower, 1.1 * region.accuracy)
                self.assertEqual(text.count("<svg"), 4)
                self.assertIn("Proved: ", text)

    def test_it_says_what_was_asked(self):
        zones = ["sphere 0 0 0 0.1", "sphere 1 1 1 0.1"]
        given = [word for zone in zones for word in ("--keep-out", *zone.split())]
        page = self.folder / "page.html"
        for words, keywords, told in ((given, {"keep_out": zones}, "keep out sphere 0 0 0 0.1 sphere 1 1 1 0.1"),
                                      (["--search-box", *"-0.1 0.1 -0.1 0.1 0 0".split()],
                                       {"search_box": [-0.1, 0.1, -0.1, 0.1, 0, 0]},
                                       "with the search box that was asked")):
            process = self.command(ORTHOGLIDE, "--accuracy", 0.01, *words, "--output", page)
            self.assertEqual(process.returncode, 0, process.stderr)
            text, rows = self.read()
            region = core.largest(machine("orthoglide"), shape="cube", accuracy=0.01, **keywords)
            self.assertLessEqual(numbers_in(rows[1][1])[0], region.size)
            self.assertGreaterEqual(numbers_in(rows[1][1])[1], region.size_upper_bound)
            self.assertIn(told, text)

    def test_points_of_a_proved_region_have_no_negative_margin(self):
        made = machine("orthoglide")
        for shapes, keywords in (((("cylinder", {"ratio": [0.5, 0.5]}), ), {}), ((("disc", {}), ), {}),
                                 ((("box", {"proportions": [1, 3, 1]}), ), {"turned": True}), ((("sphere", {}), ), {})):
            region = core.largest(made, shape=shapes[0][0], accuracy=0.01, **shapes[0][1], **keywords)
            for point, answer in zip(surface_of(region), core.evaluate(made, points=surface_of(region)).points):
                self.assertGreaterEqual(answer.binding.margin, -1e-9, (shapes, point))
            report.machine(made, self.folder / "page.html", shapes=shapes, accuracy=0.01, **keywords)
            self.read()

    def test_names_are_text(self):
        urdf = (URDF / "orthoglide.urdf").read_text().replace("rail_x", "r$x$&lt;b&gt;")
        report.machine(core.Machine(urdf), self.folder / "page.html", accuracy=0.01)
        self.assertNotIn("<b>", self.read()[0])

    def test_the_same_machine_has_the_same_report(self):
        for name in ("one.html", "two.html"):
            report.machine(machine("orthoglide"), self.folder / name, accuracy=0.01)
        self.assertEqual(self.read("one.html")[0], self.read("two.html")[0])

    def test_machines_side_by_side(self):
        report.comparison([machine("orthoglide"), machine("uranesx")], self.folder / "page.html", joint_limits=False)
        text, rows = self.read()
        for row, name in zip(rows[1:3], ("orthoglide", "uranesx")):
            region = core.largest(machine(name), shape="cube", joint_limits=False)
            self.assertLessEqual(numbers_in(row[1])[0], region.size)
            self.assertGreaterEqual(numbers_in(row[1])[1], region.size_upper_bound)

    def test_a_study(self):
        report.study(self.table(), self.folder / "page.html")
        text, rows = self.read()
        names, designs = study.read(self.folder / "study.sqlite")
        self.assertIn(names, rows)
        best = max(row[names.index("size")] for row in designs)
        self.assertLessEqual(numbers_in(rows[1][-1])[0], best)
        self.assertIn(rounded_up(max(row[names.index("size_upper_bound")] for row in designs)), text)
        for heading in ("Size over each parameter", "Size against stroke", "Sensitivity", "All designs"):
            self.assertIn(heading, text)

    @staticmethod
    def command(*words):
        return subprocess.run([PKM, "report", *map(str, words)], capture_output=True, text=True)

    def test_the_command(self):
        page = self.folder / "page.html"
        for words in ((ORTHOGLIDE, "--accuracy", 0.01), (ORTHOGLIDE, URANESX, "--joint-limits", "off"),
                      (self.table(), )):
            process = self.command(*words, "--output", page)
            self.assertEqual((process.returncode, process.stdout), (0, f"report written: {page}\n"), process.stderr)
            self.read()
        for words, reason in (((self.folder / "none.urdf", ), "No such file"),
                              ((self.folder / "study.sqlite", "--psi-min", 0.4), "psi_min"),
                              ((ORTHOGLIDE, "--psi-min", -1), "psi_min -1"), (("none.sqlite", ), "unable to open")):
            process = self.command(*words, "--output", page)
            self.assertEqual(process.returncode, 2, process.stderr)
            self.assertIn(reason, process.stderr)

    @unittest.skipUnless(BROWSER, "needs chromium")
    def test_in_a_browser(self):
        report.study(self.table(), self.folder / "page.html")
        text, _ = self.read()
        click = """<script>const table = document.querySelector("table.sortable");
          const head = table.querySelectorAll("th")[5];
          const row = () => table.tBodies[0].rows[0].cells[5].dataset.value;
          head.click(); const least = row(); head.click(); const most = row();
          document.title = [least, most, document.body.scrollWidth <= innerWidth].join(" ");</script>"""
        (self.folder / "clicked.html").write_text(text.replace("</body>", click + "</body>"))
        names, designs = study.read(self.folder / "study.sqlite")
        sizes = [row[5] for row in designs]
        for width in (500, 1280):
            dump = self.browse("--dump-dom", f"--window-size={width},900", "clicked.html")
            self.assertIn(f"<title>{min(sizes)!r} {max(sizes)!r} true</title>", dump, (names[5], width))
        self.browse(f"--print-to-pdf={self.folder}/page.pdf", "page.html")
        self.assertEqual((self.folder / "page.pdf").read_bytes()[:5], b"%PDF-")

    def browse(self, *words):
        process = subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu",
                                  f"--user-data-dir={self.folder}/browser", *words[:-1],
                                  f"file://{self.folder}/{words[-1]}"], capture_output=True, text=True)
        self.assertEqual(process.returncode, 0, process.stderr)
        return process.stdout


if __name__ == "__main__":
    unittest.main()
