#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm pave --mesh: the files, and what is said of them."""

import math
import re
import struct
import subprocess
import unittest

from pkm import ORTHOGLIDE, PKM, URANESX, CommandTest


def stl(path):
    """Triangles, by their corners."""
    content = path.read_bytes()
    count, = struct.unpack_from("<I", content, 80)
    assert len(content) == 84 + 50 * count and not content.startswith(b"solid")
    return [tuple(struct.unpack_from("<3f", content, 96 + 50 * n + 12 * k) for k in range(3)) for n in range(count)]


def ply(path):
    header, rest = path.read_bytes().split(b"end_header\n", 1)
    vertices, faces = (int(re.search(rb"element %s (\d+)" % name, header)[1]) for name in (b"vertex", b"face"))
    points = [struct.unpack_from("<3f", rest, 12 * n) for n in range(vertices)]
    corners = [struct.unpack_from("<B3i", rest, 12 * vertices + 13 * n) for n in range(faces)]
    assert len(rest) == 12 * vertices + 13 * faces and {count for count, *_ in corners} == {3}
    return [tuple(points[k] for k in triangle) for _, *triangle in corners]


def signed_volume(triangles):
    return math.fsum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                     a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in triangles) / 6


class Surface(CommandTest):
    def test_surfaces_as_stl_and_as_ply(self):
        inner, outer = self.folder / "inner.stl", self.folder / "outer.ply"
        words = ("--resolution", 0.1, "--mesh", inner, "--outer-mesh", outer)
        told = self.answer("pave", "--urdf", ORTHOGLIDE, *words)["surfaces"]
        for name, triangles in (("inner", stl(inner)), ("outer", ply(outer))):
            self.assertEqual(len(triangles), told[name]["triangles"])
            edges = [(triangle[k], triangle[(k + 1) % 3]) for triangle in triangles for k in range(3)]
            self.assertEqual(len(edges), len(set(edges)), "each edge once in each direction")
            self.assertEqual(set(edges), {(b, a) for a, b in edges})
            lower, upper = told[name]["volume"]
            self.assertBrackets(lower, signed_volume(triangles), upper, 1e-9)
        self.assertLess(told["inner"]["volume"][1], 1.632)
        self.assertGreater(told["outer"]["volume"][0], 1.632)
        self.assertGreater(told["distance"], 0)
        self.assertRegex(self.text("pave", "--urdf", ORTHOGLIDE, *words), r"outer surface .* nowhere farther than ")

    def test_surfaces_that_there_are_not(self):
        for urdf, words, reason in ((ORTHOGLIDE, ("--mesh", "set.obj"), "must end in .stl or .ply"),
                                    (URANESX, ("--joint-limits", "off", "--mesh", "set.stl"), "flat"),
                                    (ORTHOGLIDE, ("--resolution", 1e-3, "--max-boxes", 9, "--mesh", "set.stl"),
                                     "1/400"),
                                    (ORTHOGLIDE, ("--mesh", "set.stl", "--outer-mesh", "./set.stl"), "one file"),
                                    (ORTHOGLIDE, ("--mesh", "set.stl", "--save", "./set.stl"), "one file")):
            process = subprocess.run([PKM, "pave", "--urdf", urdf, *map(str, words)], capture_output=True, text=True,
                                     cwd=self.folder)
            self.assertEqual(process.returncode, 2, words)
            self.assertIn(reason, process.stderr)
            self.assertEqual((process.stdout, list(self.folder.iterdir())), ("", []))

    def test_without_a_surface_the_paving_is_told_all_the_same(self):
        small = (-0.01, 0.01, -0.01, 0.01, -0.01, 0.01)
        for words, reason in ((("--box", 0.8, 0.9, 0.8, 0.9, 0.8, 0.9), "no point of the box belongs to the set"),
                              (("--box", *small, "--resolution", 1), "finer --resolution"),
                              (("--resolution", 0.01, "--time-limit", 0.3), "give more time or a coarser")):
            files = ("--mesh", "set.stl", "--save", "set.pkm")
            process = subprocess.run([PKM, "pave", "--urdf", ORTHOGLIDE, *map(str, words), *files],
                                     capture_output=True, text=True, cwd=self.folder)
            self.assertNotEqual(process.returncode, 0)
            self.assertIn("volume", process.stdout)
            self.assertRegex(process.stderr, "not saved: .*" + reason)
            self.assertEqual([file.name for file in self.folder.iterdir()], ["set.pkm"])
            (self.folder / "set.pkm").unlink()


if __name__ == "__main__":
    unittest.main()
