#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm urdf: what it writes is read by the other commands as the machine that was asked for."""

import unittest

from pkm import URDF, CommandTest


class Urdf(CommandTest):
    def test_machines_of_the_repository_are_the_catalogue_s(self):
        for name in ("orthoglide", "orthoglide_prototype", "uranesx"):
            self.assertEqual(self.text("urdf", "--machine", name), (URDF / f"{name}.urdf").read_text(encoding="utf-8"))

    def test_output_file(self):
        path = self.folder / "machine.urdf"
        answer = self.answer("urdf", "--machine", "orthoglide", "--output", path)
        self.assertEqual(answer["output"], str(path))
        self.assertEqual(path.read_text(encoding="utf-8"), self.text("urdf", "--machine", "orthoglide"))
        point = self.answer("evaluate", "--urdf", path, "--point", 0, 0, 0)
        self.assertEqual(point["geometry_hash"], answer["geometry_hash"])

    def test_json_holds_the_urdf(self):
        answer = self.answer("urdf", "--machine", "uranesx")
        self.assertEqual(answer["urdf"], self.text("urdf", "--machine", "uranesx"))
        self.assertEqual(answer["machine"], "uranesx")

    def test_dimensions_are_those_asked_for(self):
        urdf = self.machine("--machine", "uranesx", "--length", 2.5, "--rail-radius", 2, "--platform-radius", 0.5)
        answer = self.answer("evaluate", "--urdf", urdf, "--point", 0, 0, 0)
        self.assertEqual(len(answer["rho"]), 3)
        for rho in answer["rho"]:
            self.assertAlmostEqual(rho, 2, places=12)  # 2^2 + (2 - 0.5)^2 = 2.5^2

    def test_the_longest_strut_is_allowed_for_both(self):
        for name in ("orthoglide", "uranesx"):
            self.machine("--machine", name, "--length", "1e9")

    def test_lambda_moves_the_rails(self):
        widened = self.machine("--machine", "uranesx", "--lambda", 0.1, "--length", 2)
        psi = self.answer("evaluate", "--urdf", widened, "--point", 0, 0, 0)["psi"]
        by_radius = self.machine("--machine", "uranesx", "--rail-radius", 2 * (7 / 13 + 0.1), "--platform-radius",
                                 2 * 3 / 26, "--length", 2)
        for value, wanted in zip(psi, self.answer("evaluate", "--urdf", by_radius, "--point", 0, 0, 0)["psi"]):
            self.assertAlmostEqual(value, wanted, places=12)


if __name__ == "__main__":
    unittest.main()
