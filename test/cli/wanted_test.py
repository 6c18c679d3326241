#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Regions as people want them: on a plane, of given measures, of the tool's tip, of a workpiece."""

import itertools
import math
import struct
import unittest

from pkm import ORTHOGLIDE, CommandTest, run

CUBE = 1 / math.sqrt(6) + 1 / (3 * math.sqrt(2))  # largest cube of the unit Orthoglide, edge [m]
CORNERS = [(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def triangles():
    for a, b, c, d in FACES:
        for corners in ((a, b, c), (a, c, d)):
            yield [CORNERS[k] for k in corners]


def binary_stl(count=None):
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for corner in each for x in corner), 0) for each in triangles())
    return b"made by a test".ljust(80) + struct.pack("<I", count or len(body) // 50) + body


def ascii_stl():
    facets = ("".join(["facet normal 0 0 0\n outer loop\n",
                       *("  vertex {:e} {:e} {:e}\n".format(*corner) for corner in each), " endloop\nendfacet\n"])
              for each in triangles())
    return "solid cube\n" + "".join(facets) + "endsolid cube\n"


class Wanted(CommandTest):
    def largest(self, urdf, *words):
        return self.answer("largest", "--urdf", urdf, *words)

    def refusal(self, *words):
        process = run(*words)
        self.assertEqual((process.returncode, process.stdout), (2, ""), process.stderr)
        return process.stderr

    def binary(self, name, content):
        path = self.file(name, "")
        with open(path, "wb") as stream:
            stream.write(content)
        return path

    def test_regions_on_a_plane(self):
        cylinder = ("--shape", "cylinder", "--radius", 0.2)
        standing = self.largest(ORTHOGLIDE, *cylinder, "--base-z", -0.25)
        height, radius = standing["dimensions"]
        self.assertEqual((standing["shape"], standing["base_z"], radius), ("cylinder", -0.25, 0.2))
        self.assertAlmostEqual(height, standing["size"], delta=1e-15)
        self.assertAlmostEqual(standing["center"][2], -0.25 + height / 2, delta=1e-15)
        check = ("--urdf", ORTHOGLIDE, "--center", *standing["center"], "--radius", radius, "--height")
        self.assertEqual(self.answer("check", *check, height)["verdict"], "inside")
        self.assertIsNone(self.largest(ORTHOGLIDE, *cylinder)["base_z"])
        text = " ".join(self.text("largest", "--urdf", ORTHOGLIDE, *cylinder, "--base-z", -0.25).split())
        where = r"standing on z = -0\.25 m,"
        self.assertRegex(text, rf"this center and size, {where} is .* above \S+, {where} has all")
        lowest = self.largest(ORTHOGLIDE, "--base-z", -0.5, "--search-box", 0, 0, 0, 0, -1, 1)
        self.assertEqual(lowest["center"][:2], [0, 0])

    def test_regions_that_are_turned(self):
        box = ("--shape", "box", "--proportions", 2, 1, 0.5)
        straight, turned = self.largest(ORTHOGLIDE, *box), self.largest(ORTHOGLIDE, *box, "--turned")
        self.assertIsNone(straight["angle"])
        self.assertGreater(turned["size"], straight["size_upper_bound"] + 0.1)
        self.assertBrackets(turned["size"], 0.66912, turned["size_upper_bound"], 1e-5)
        c, s = math.cos(turned["angle"]), math.sin(turned["angle"])
        for factor, verdict in ((1 - 1e-9, "inside"), (turned["size_upper_bound"] / turned["size"] + 1e-3, "outside")):
            corners = [[factor * side * share for side, share in zip(turned["dimensions"], shares)]
                       for shares in itertools.product((-0.5, 0.5), repeat=3)]
            file = self.file("corners", "".join(f"{c * x - s * y!r} {s * x + c * y!r} {z!r}\n" for x, y, z in corners))
            check = self.answer("check", "--urdf", ORTHOGLIDE, "--shape", "polytope", "--vertices", file, "--size", 1,
                                "--center", *turned["center"])
            self.assertEqual(check["verdict"], verdict)
        text = " ".join(self.text("largest", "--urdf", ORTHOGLIDE, *box, "--turned").split())
        self.assertRegex(text, r"turned by 2\.356\d+ rad from x to y, 135 degrees")
        self.assertRegex(text, r"this center and size, turned by this angle about the vertical, is dextrous")
        self.assertIn("wherever its center and however it is turned about the vertical, has all its points", text)
        for shape in ("sphere", "disc"):
            self.assertIn(f"a {shape} turned about the vertical is the same {shape}",
                          self.refusal("largest", "--urdf", ORTHOGLIDE, "--shape", shape, "--turned"))
        self.assertIn("--turned", self.refusal("compare", "--urdf", ORTHOGLIDE, "--turned"))

    def test_a_tool_moves_every_answer(self):
        tip = [0.0625, -0.03125, -0.125]
        tool = ("--urdf", ORTHOGLIDE, "--tool", *tip)
        bare = ("--urdf", ORTHOGLIDE)
        moved = lambda point: [x + shift for x, shift in zip(point, tip)]  # exactly, for these numbers
        for point in ([0.125, 0.25, -0.125], [0.5, 0, 0.25], [0.875, 0.875, 0]):
            of_tip, of_platform = (self.answer("evaluate", *words, "--point", *at)
                                   for words, at in ((tool, moved(point)), (bare, point)))
            for entry in ("point", "geometry_hash", "message"):
                of_tip.pop(entry), of_platform.pop(entry)
            self.assertEqual(of_tip, of_platform)
            body = ("--shape", "cube", "--size", 0.125)
            self.assertEqual(self.answer("check", *tool, "--center", *moved(point), *body)["verdict"],
                             self.answer("check", *bare, "--center", *point, *body)["verdict"])
        region = self.answer("largest", *tool)
        self.assertBrackets(region["size"], CUBE, region["size_upper_bound"], 1e-12)
        center = [x - shift for x, shift in zip(region["center"], tip)]
        self.assertEqual(self.answer("check", *bare, "--center", *center, "--shape", "cube", "--size",
                                     region["size"] - 1e-9)["verdict"], "inside")
        standing = self.answer("largest", *tool, "--base-z", -0.5 + tip[2])
        self.assertAlmostEqual(standing["size"], self.answer("largest", *bare, "--base-z", -0.5)["size"], delta=1e-3)
        start, end = [0, 0, 0], [0.875, 0.875, 0]
        path = [word for name, point in (("start", start), ("line", end))
                for word in ("--segment", " ".join(map(str, [name, *moved(point)])))]
        self.assertEqual(self.answer("path", *tool, *path)["verdict"], "outside")
        reports = [self.answer("compare", "--urdf", ORTHOGLIDE, "--urdf", ORTHOGLIDE, *words)
                   for words in ([], ["--tool", *tip])]
        self.assertNotEqual(*reports)

    def test_given_measures(self):
        high = self.largest(ORTHOGLIDE, "--shape", "cylinder", "--radius", 0.25)
        wide = self.largest(ORTHOGLIDE, "--shape", "cylinder", "--height", high["size"])
        self.assertLessEqual(0.25, wide["size_upper_bound"])
        self.assertEqual(wide["dimensions"], [high["size"], wide["size"]])
        box = self.largest(ORTHOGLIDE, "--shape", "box", "--footprint", CUBE - 0.01, CUBE - 0.01)
        self.assertGreater(box["size"], CUBE - 0.01)
        self.assertEqual(box["dimensions"][:2], [CUBE - 0.01] * 2)

    def test_a_workpiece_by_its_vertices(self):
        text = "# a cube\n\n" + "".join("{} {} {}\n".format(*corner) for corner in [*CORNERS, (0, 0.1, 0.2)])
        lines = ascii_stl().splitlines()  # white space of any kind parts the words of an STL, in any case
        one_line = "\n".join([lines[0], " ".join(lines[1:-1]).replace("vertex", "VERTEX"), lines[-1]])
        files = [self.file("cube.txt", text), self.file("ascii.stl", ascii_stl()), self.file("one.stl", one_line),
                 self.binary("binary.stl", binary_stl())]
        answers = [self.largest(ORTHOGLIDE, "--shape", "polytope", "--vertices", path) for path in files]
        for answer in answers:
            self.assertEqual((answer["status"], answer["shape"]), ("proven", "polytope"))
            self.assertBrackets(answer["size"], CUBE, answer["size_upper_bound"], 1e-12)
            self.assertEqual(sorted(map(tuple, answer["vertices"])), CORNERS)
            self.assertEqual(answer["dimensions"], [])
            self.assertLessEqual(answer["volume"], answer["size"]**3 * (1 + 1e-12))
        millimetres = self.file("mm.txt", "".join("{} {} {}\n".format(*(1000 * x for x in corner))
                                                  for corner in CORNERS))
        small = self.largest(ORTHOGLIDE, "--shape", "polytope", "--vertices", millimetres)
        self.assertBrackets(small["size"], CUBE / 1000, small["size_upper_bound"], 1e-12)
        self.assertAlmostEqual(small["accuracy"], 1e-6, delta=1e-9)
        center = answers[0]["center"]
        check = ("check", "--urdf", ORTHOGLIDE, "--shape", "polytope", "--vertices", files[2], "--center", *center)
        self.assertEqual(self.answer(*check, "--size", answers[0]["size"])["verdict"], "inside")
        outside = self.answer(*check, "--size", answers[0]["size_upper_bound"] + 1e-6)
        self.assertEqual(outside["verdict"], "outside")
        for x, middle in zip(outside["bad_point"], center):
            self.assertLessEqual(abs(x - middle), outside["size"] / 2)
        self.assertIn("polytope of 8 corners", self.text(*check, "--size", 0.1))
        standing = self.largest(ORTHOGLIDE, "--shape", "polytope", "--vertices", files[2], "--base-z", -0.25)
        cube = self.largest(ORTHOGLIDE, "--base-z", -0.25)
        self.assertLessEqual(standing["size"], cube["size_upper_bound"])
        self.assertLessEqual(cube["size"], standing["size_upper_bound"])
        self.assertEqual((standing["center"][2], min(z for _, _, z in standing["vertices"])), (-0.25, 0))
        moved = self.largest(ORTHOGLIDE, "--shape", "polytope", "--vertices", files[0], "--seen-from", 0.5, 0.5, 0.5)
        self.assertBrackets(moved["size"], CUBE, moved["size_upper_bound"], 1e-12)
        self.assertEqual(max(moved["vertices"]), [0, 0, 0])

    def test_files_that_are_no_workpiece(self):
        far = self.file("far.txt", "".join("{} {} {}\n".format(*(x + 2 for x in corner)) for corner in CORNERS))
        bad = [("/no/such/file.stl", "/no/such/file.stl: .*No such file"),
               (self.file("empty.txt", "# nothing\n"), "has no point: expected an STL, or lines of X Y Z"),
               (self.file("two.txt", "0 0 0\n1 2\n"), r"line 2: needs 3 numbers \(X Y Z\), got 2"),
               (self.file("word.txt", "0 0 0\n1 2 x\n"), "line 2: 'x' is not a finite number"),
               (self.file("loop.stl", ascii_stl().replace("outer loop", "loop", 1)),
                "line [0-9]+: 'loop' stands where an STL has 'outer'"),
               (self.file("early.stl", ascii_stl().replace("endsolid cube", "")),
                "ends early: expected 'facet', as an STL has it"),
               (self.file("two.stl", ascii_stl().replace("vertex", "point", 1)),
                "'point' stands where an STL has 'vertex'"),
               (self.file("nan.stl", ascii_stl().replace("vertex -5", "vertex nan5")), "is not a finite number"),
               (self.file("flat.txt", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n"), "vertices lie in one plane"),
               (self.file("three.txt", "0 0 0\n1 0 0\n0 1 0\n"), "vertices are 3: a polytope has at least 4"),
               (far, r"lie around another point than \(0, 0, 0\) m.*such as \(2, 2, 2\) m"),
               (self.binary("cut.stl", binary_stl()[:-7]), "neither a text nor a whole binary STL: .* 12 triangles"),
               (self.binary("nan_binary.stl", binary_stl()[:96] + struct.pack("<f", math.nan) + binary_stl()[100:]),
                "has a corner that is not finite")]
        for path, reason in bad:
            refusal = self.refusal("largest", "--urdf", ORTHOGLIDE, "--shape", "polytope", "--vertices", path)
            self.assertRegex(refusal, reason)
        for words, reason in ((["--vertices", far], "a list of vertices is for the shape polytope only"),
                              (["--shape", "polytope"], "shape = polytope needs vertices"),
                              (["--seen-from", 0, 0, 0], "--seen-from is for a polytope by its --vertices")):
            self.assertRegex(self.refusal("largest", "--urdf", ORTHOGLIDE, *words), reason)


if __name__ == "__main__":
    unittest.main()
