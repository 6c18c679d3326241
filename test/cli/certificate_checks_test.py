#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each single thing that the checkers hold against a certificate: where only that is wrong, both refuse it."""

import copy
import json
import unittest

from checkers import by_pkm, by_python
from pkm import ORTHOGLIDE, URANESX, URDF, CommandTest

CUBE = ("largest", "--urdf", ORTHOGLIDE, "--accuracy", 0.05)
BOX = ("check", "--urdf", ORTHOGLIDE, "--center", 0.08, 0.08, 0.08, "--sides", 0.55, 0.55, 0.55)
BALL = ("check", "--urdf", ORTHOGLIDE, "--center", 0.3, 0.3, 0.3, "--radius", 0.125)
LIMITED = ("check", "--urdf", URDF / "mixed_legs.urdf", "--joint-limits", "on", "--center", 0.13, 0, -0.18,
           "--sides", 0.2, 0.2, 0.2)
SQUARE = ("largest", "--urdf", URANESX, "--shape", "square", "--accuracy", 0.01)
PATH = ("path", "--urdf", ORTHOGLIDE, "--segment", "start 0 0 0", "--segment", "line 0.1 0.1 0.1")
SET = ("pave", "--urdf", ORTHOGLIDE, "--resolution", 0.4)


class CertificateChecks(CommandTest):
    def written(self, words):
        path = self.folder / "certificate.json"
        self.answer(*words, "--certificate", path)
        return json.loads(path.read_text())

    def refused(self, words, *spoils):
        """Both accept what is written, and refuse it after each of the changes."""
        good = self.written(words)
        self.assertEqual(by_python(good), by_pkm(json.dumps(good)))
        self.assertTrue(by_python(good))
        for k, spoil in enumerate(spoils):
            false = copy.deepcopy(good)
            spoil(false)
            with self.subTest(words=words[:3], spoil=k):
                self.assertIsNone(by_pkm(json.dumps(false)), "pkm verify")
                self.assertIsNone(by_python(false), "check_certificate.py")

    @staticmethod
    def grown(data, factor):
        """A larger region, with a box that holds it, and nothing else."""
        region = data["region"]
        region["size"] *= factor
        for corner in region["box"]:
            corner[:] = [c + (1 + 1e-12) * factor * (x - c) for c, x in zip(region["center"], corner)]

    @staticmethod
    def set_to(path, value):
        def spoil(data):
            for name in path[:-1]:
                data = data[name]
            data[path[-1]] = value
        return spoil

    def test_every_part_of_a_region(self):
        self.refused(BOX, lambda data: self.grown(data, 1.3), lambda data: self.grown(data, 1.16),
                     self.set_to(("criterion", "psi_min"), 0.98),
                     self.set_to(("criterion", "psi_max"), 1.02), self.set_to(("criterion", "aspect"), -1))
        self.refused(BALL, lambda data: self.grown(data, 1.44))

    def test_a_region_lies_in_the_box_of_its_proof(self):
        def smaller(data):
            data["region"]["box"][1][0] -= 1e-3

        self.refused(BOX, smaller)

    def test_trees_have_no_less_and_no_more_leaves_than_their_cuts(self):
        self.refused(BOX, lambda data: data["region"]["tree"].pop(), lambda data: data["region"]["tree"].append(0))

    def test_joint_limits_of_every_leg_at_either_end(self):
        def spoil(leg, side):
            def narrow(data):
                lower, upper = data["machine"]["legs"][leg]["limits"]
                data["machine"]["legs"][leg]["limits"][side] = (upper - 1e-3, lower + 1e-3)[side]
            return narrow

        self.refused(LIMITED, *(spoil(leg, side) for leg in range(3) for side in (0, 1)))

    def test_every_leaf_of_a_bound(self):
        def leaf(data):
            return next(node for node in data["bound"]["tree"] if isinstance(node, dict))

        def combination(data):
            return next(node for node in data["bound"]["tree"] if isinstance(node, dict) and len(node["terms"]) > 1)

        def larger(data):
            leaf(data)["size"] = 1.01 * data["bound"]["size"]

        def negative(data):
            combination(data)["terms"].append({"at": 0, "of": "psi_min", "v": [1, 0, 0], "weight": -1e-9})

        self.refused(CUBE, lambda data: leaf(data).update(terms=[]), larger, negative)

    def test_a_bound_is_of_all_centers(self):
        def one_leaf(data):
            bound = data["bound"]
            lower, upper = copy.deepcopy(bound["centers"])
            for node in bound["tree"]:
                if isinstance(node, dict):
                    break
                upper[node[0]] = node[1]
            bound.update(centers=[lower, upper], tree=[node])

        self.refused(CUBE, one_leaf)

    def test_points_of_a_bound(self):
        self.refused(CUBE, lambda data: data["bound"]["points"].append({"fixed": [0, 0, 0], "per_size": [0, 2, 0]}),
                     lambda data: data["bound"]["bad"].append({"point": data["region"]["center"], "of": "psi_min",
                                                               "v": [1, 0, 0]}))

    def test_points_that_are_bad_at_one_height(self):
        """Along parallel rails a point is bad for all regions only where it is so without joint limits."""
        def beyond(name):
            def spoil(data):
                x, y, z = data["region"]["center"]
                data["bound"]["bad"].append({"point": [x, y, z + 5], "of": name, "leg": 0})
            return spoil

        self.refused(SQUARE, beyond("joint_lower"), beyond("joint_upper"))

    def test_every_box_of_a_set(self):
        def replace(old, new):
            def spoil(data):
                tree = data["boxes"]["tree"]
                tree[next(k for k, node in enumerate(tree) if isinstance(node, old))] = new
            return spoil

        def in_other_aspect(data):
            data["boxes"]["tree"] = [0 if isinstance(node, dict) else node for node in data["boxes"]["tree"]]
            data["criterion"]["aspect"] *= -1

        self.refused(SET, replace(dict, 1), replace(int, {"of": "reach", "leg": 0}), in_other_aspect)

    def test_every_piece_of_a_path(self):
        self.refused(PATH, self.set_to(("path", 0, 2), [0, 0.5]), self.set_to(("path", 0, 2), [0.5, 1]),
                     self.set_to(("path", 0, 2), [0, 0.6, 0.4, 1]), self.set_to(("path", 0, 1, 2), 0.8),
                     self.set_to(("criterion", "aspect"), -1))


if __name__ == "__main__":
    unittest.main()
