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

    def test_titles_are_whole_and_endings_of_any_case(self):
        for words, told in (((), "within, dextrous with psi in [0.5, 2]"),
                            (("--strut-angle-max", 0.6, "--psi-min", 0.123456, "--psi-max", 3.4567891), "m, within")):
            path = self.folder / "set.STL"
            self.answer("pave", "--urdf", ORTHOGLIDE, "--resolution", 0.2, *words, "--mesh", path)
            title = path.read_bytes()[:80].decode().rstrip()
            self.assertTrue(title.startswith("STL of orthoglide, pkm_workspace, m"))
            self.assertEqual(title.count("["), title.count("]"))
            self.assertIn(told, title)
            part = title.rsplit(", ", 1)[-1]
            whole = self.folder / "set.Ply"
            self.answer("pave", "--urdf", ORTHOGLIDE, "--resolution", 0.2, *words, "--mesh", whole)
            comment = re.search(rb"comment (.*)\n", whole.read_bytes())[1].decode()
            self.assertTrue(comment.startswith(title[len("STL of "):]))
            self.assertRegex(comment, re.escape(part) + r"(,|$)")

    def test_progress_of_surfaces_is_told(self):
        words = ("--resolution", "0.03", "--threads", "1", "--progress", "--time-limit", "900")
        process = subprocess.run([PKM, "pave", "--urdf", ORTHOGLIDE, *words, "--mesh", str(self.folder / "set.stl")],
                                 capture_output=True, text=True)
        self.assertEqual(process.returncode, 0, process.stderr)
        self.assertRegex(process.stderr, r"\d+ s: (inner|outer) surface, \d+ cubes at it, \d+ not proved\n")

    def test_a_box_that_is_one_cube(self):
        for edge in (0.1, 0.05, 0.3):
            files = self.folder / "set.stl", self.folder / "set.bt"
            told = self.answer("pave", "--urdf", ORTHOGLIDE, "--resolution", edge, "--box", 0, edge, 0, edge, 0, edge,
                               "--mesh", files[0], "--octomap", files[1])
            volume = signed_volume(stl(files[0]))
            self.assertLess(volume, edge**3)
            self.assertGreater(volume, 0.4 * edge**3)  # with one vertex of the lattice in it
            lower, upper = told["surfaces"]["inner"]["volume"]
            self.assertBrackets(lower, volume, upper, 1e-9)
            self.assertGreater(told["surfaces"]["outer"]["volume"][0], edge**3)

    def test_a_map_for_planners(self):
        path = self.folder / "set.BT"
        words = ("pave", "--urdf", ORTHOGLIDE, "--resolution", 0.0512345678, "--octomap", path)
        told = self.answer(*words)["octomap"]
        self.assertEqual(told["resolution"], 0.0512345)
        self.assertLess(told["free_volume"][1], 1.632)
        self.assertGreater(told["free_volume"][0], 1.2)
        self.assertBrackets(told["free_volume"][0], told["free_voxels"] * 0.0512345**3, told["free_volume"][1], 1e-12)
        header, tree = path.read_bytes().split(b"data\n", 1)
        self.assertTrue(header.startswith(b"# Octomap OcTree binary file\n# orthoglide, pkm_workspace, m, free: dex"))
        self.assertIn(b"\nid OcTree\nsize ", header)
        self.assertIn(b"\nres 0.0512345\n", header)
        self.assertEqual(len(tree) % 2, 0)
        self.assertRegex(self.text(*words), rf"map +{told['free_voxels']} free voxels, .* occupied ones of 0.0512345 m")

    def test_surfaces_that_there_are_not(self):
        for urdf, words, reason in ((ORTHOGLIDE, ("--mesh", "set.obj"), "must end in .stl or .ply"),
                                    (URANESX, ("--joint-limits", "off", "--mesh", "set.stl"), "flat"),
                                    (ORTHOGLIDE, ("--resolution", 1e-3, "--max-boxes", 9, "--mesh", "set.stl"),
                                     "1/400"),
                                    (ORTHOGLIDE, ("--octomap", "set.ot"), "must end in .bt"),
                                    (URANESX, ("--joint-limits", "off", "--octomap", "set.bt"), "flat"),
                                    (ORTHOGLIDE, ("--resolution", 1e-3, "--max-boxes", 9, "--octomap", "set.bt"),
                                     "1/400"),
                                    (ORTHOGLIDE, ("--octomap", "set.bt", "--save", "./set.bt"), "one file"),
                                    (ORTHOGLIDE, ("--mesh", "set.stl", "--outer-mesh", "./set.stl"), "one file"),
                                    (ORTHOGLIDE, ("--mesh", "set.stl", "--save", "./set.stl"), "one file")):
            process = subprocess.run([PKM, "pave", "--urdf", urdf, *map(str, words)], capture_output=True, text=True,
                                     cwd=self.folder)
            self.assertEqual(process.returncode, 2, words)
            self.assertIn(reason, process.stderr)
            self.assertEqual((process.stdout, list(self.folder.iterdir())), ("", []))

    def test_without_a_surface_the_paving_is_told_all_the_same(self):
        small = (-0.01, 0.01, -0.01, 0.01, -0.01, 0.01)
        for words, reason in ((("--resolution", 0.006, "--time-limit", 0.3, "--octomap", "set.bt"), "give more time"),
                              (("--box", 0.8, 0.9, 0.8, 0.9, 0.8, 0.9), "no point of the box belongs to the set"),
                              (("--box", *small, "--resolution", 1), "finer --resolution"),
                              (("--resolution", 0.01, "--time-limit", 0.3), "or a coarser --resolution")):
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
