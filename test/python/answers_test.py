#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The core in Python against the command: the same names, the same numbers to the last bit, for all kinds of legs."""

import pickle
import random
import unittest
import warnings

import numpy as np
from support import DATA, FLAT, NAMES, URDF, CommandTest, core, machine, untimed, words_of

warnings.simplefilter("ignore", core.PkmWarning)
SEED = 19


def flat_or(name, flat, solid):
    return flat if name in FLAT else solid


class SameAsTheCommand(CommandTest):
    """Each answer beside that of the command."""

    def compare(self, command, name, **keywords):
        with self.subTest(command=command, machine=name, keywords=keywords):
            function = getattr(core, command)
            ours = function(machine(name), **keywords)
            theirs = self.answer(command, "--urdf", URDF / f"{name}.urdf", *words_of(keywords))
            self.assertEqual(untimed(ours), untimed(theirs))
            return ours

    def test_largest(self):
        for name in NAMES:
            shape = flat_or(name, "square", "cube")
            answer = self.compare("largest", name, shape=shape, accuracy=0.02, psi="auto",
                                  joint_limits=name == "tripod")
            self.assertEqual(answer.status, "proven")
            self.assertLess(answer.size, answer.size_upper_bound)

    def test_evaluate(self):
        points = random.Random(SEED)
        for name in NAMES:
            for _ in range(4):
                self.compare("evaluate", name, point=[points.uniform(-0.3, 0.3) for _ in range(3)], psi_min=0.4)

    def test_check(self):
        for name in NAMES:
            zero = core.evaluate(machine(name), point=(0, 0, 0))
            self.assertIn("satisfies", zero)
            for side in (0.01, 2.0):
                self.compare("check", name, center=(0, 0, 0), sides=(side, side, flat_or(name, 0, side)))

    def test_path(self):
        for name in NAMES:
            ours = core.path(machine(name), segment=["start 0 0 0", "line 0.01 0 0", "line 0.01 0.01 0"])
            theirs = self.answer("path", "--urdf", URDF / f"{name}.urdf", "--segment", "start 0 0 0", "--segment",
                                 "line 0.01 0 0", "--segment", "line 0.01 0.01 0")
            self.assertEqual(untimed(ours), untimed(theirs))

    def test_pave(self):
        for name in NAMES:
            answer = self.compare("pave", name, resolution=flat_or(name, 0.1, 0.2), psi_min=0.4, list_boxes=1000000)
            for kind, count in (("inside", answer.boxes_inside), ("undecided", answer.boxes_boundary)):
                self.assertEqual(answer.listed[kind].shape, (count, 3, 2))
                self.assertEqual(answer.listed[kind].dtype, np.float64)

    def test_conditioning_guarantee_and_singularities(self):
        for name in NAMES:
            region = {"center": (0, 0, 0), "sides": (0.02, 0.02, flat_or(name, 0, 0.02))}
            self.compare("conditioning", name, accuracy=0.1, **region)
            self.compare("guarantee", name, **region)
            self.compare("singularities", name, **region)

    def test_compare(self):
        names = ("orthoglide", "uranesx")
        ours = core.compare(*map(machine, names), shape="square", accuracy=0.01)
        files = [word for name in names for word in ("--urdf", URDF / f"{name}.urdf")]
        theirs = self.answer("compare", *files, "--shape", "square", "--accuracy", "0.01")
        self.assertEqual(untimed(ours), untimed(theirs))
        self.assertEqual(untimed(core.compare(urdf=[str(file) for file in files[1::2]], shape="square", accuracy=0.01)),
                         untimed(theirs))

    def test_the_best_of_a_family(self):
        keywords = {"machine": "uranesx", "parameter": "R-r", "range": (0.38, 0.39), "shape": "square",
                    "accuracy": 1e-3}
        self.assertEqual(untimed(core.best_of_family(**keywords)),
                         untimed(self.answer("study", *words_of(keywords))))

    def test_tolerances_conditions_and_zones(self):
        self.compare("largest", "orthoglide", accuracy=0.02, tolerance_length=1e-4)
        zone = {"keep_out": "sphere 0.1 0.1 0.1 0.2", "accuracy": 0.02, "kappa_max": 3.0}
        ours = core.largest(machine("orthoglide"), **zone)
        theirs = self.answer("largest", "--urdf", URDF / "orthoglide.urdf", "--keep-out", *zone["keep_out"].split(),
                             "--accuracy", 0.02, "--kappa-max", 3.0)
        self.assertEqual(untimed(ours), untimed(theirs))
        zone["keep_out"] = [["sphere", 0.1, 0.1, 0.1, 0.2]]
        self.assertEqual(untimed(core.largest(machine("orthoglide"), **zone)), untimed(theirs))
        built = machine("orthoglide", tolerance_length=[1e-4, 1e-4, 1e-4])
        self.assertEqual(untimed(core.largest(built, accuracy=0.02)),
                         untimed(core.largest(machine("orthoglide"), accuracy=0.02, tolerance_length=1e-4)))


class Machines(CommandTest):
    def test_from_numbers(self):
        for words in ({"machine": "uranesx", "rail_radius": 0.45, "platform_radius": 0.1},
                      {"machine": "delta", "crank": 0.5}, {"kind": "rail", "rail_radius": 0.13, "length": 0.269,
                                                           "platform_radius": 0.03, "travel": (0, 0.35)}):
            made = core.Machine.from_numbers(**words)
            self.assertEqual(made.urdf, self.text("urdf", *words_of(words)))
            self.assertEqual(made.answer.machine, made.name)

    def test_from_firmware(self):
        file = DATA / "firmware/klipper.cfg"
        made = core.Machine.from_firmware(file)
        self.assertEqual(made.urdf, self.text("import", file))
        self.assertTrue(made.answer.taken)

    def test_from_text_and_file_and_pickle(self):
        file = URDF / "delta.urdf"
        machines = [core.Machine(file), core.Machine(str(file)), core.Machine(file.read_text(encoding="utf-8"))]
        machines += [pickle.loads(pickle.dumps(machines[0]))]
        answers = [untimed(core.evaluate(each, point=(0, 0, 0.1))) for each in machines]
        self.assertTrue(all(answer == answers[0] for answer in answers))
        tip = core.Machine(file, tool=(0, 0, -0.05))
        self.assertEqual(untimed(core.evaluate(pickle.loads(pickle.dumps(tip)), point=(0, 0, 0.1))),
                         untimed(core.evaluate(machines[0], point=(0, 0, 0.1), tool=(0, 0, -0.05))))


class Arrays(CommandTest):
    def test_points(self):
        points = np.random.default_rng(SEED).uniform(-0.3, 0.3, (50, 3))
        many = core.evaluate(machine("orthoglide"), points=points)
        self.assertEqual(many.points_left, 0)
        for k in (0, 17, 49):
            one = core.evaluate(machine("orthoglide"), point=points[k])
            self.assertEqual({key: one[key] for key in many.points[k]}, many.points[k])

    def test_vertices(self):
        octahedron = np.vstack([np.eye(3), -np.eye(3)])
        answer = core.largest(machine("orthoglide"), shape="polytope", vertices=octahedron, accuracy=0.05)
        self.assertEqual(sorted(answer.vertices), sorted(octahedron.tolist()))

    def test_boxes_are_within_the_box_that_was_paved(self):
        answer = core.pave(machine("orthoglide"), box=[[-0.5, 0.5], [-0.4, 0.4], [-0.3, 0.3]], resolution=0.1)
        boxes = np.concatenate([answer.listed.inside, answer.listed.undecided])
        self.assertTrue((boxes[:, :, 0] < boxes[:, :, 1]).all())
        self.assertTrue((boxes[:, :, 0] >= np.array(answer.box.lower)).all())
        self.assertTrue((boxes[:, :, 1] <= np.array(answer.box.upper)).all())
        volume = (answer.listed.inside[:, :, 1] - answer.listed.inside[:, :, 0]).prod(axis=1).sum()
        self.assertAlmostEqual(volume, answer.volume_inside, delta=1e-9)

    def test_numbers_of_numpy_are_numbers(self):
        plain = core.largest(machine("orthoglide"), accuracy=0.05, psi_min=0.25, threads=1)
        for kind in (np.float64, np.float32):
            self.assertEqual(untimed(core.largest(machine("orthoglide"), accuracy=0.05, psi_min=kind(0.25),
                                                  threads=np.int64(1))), untimed(plain))


if __name__ == "__main__":
    unittest.main()
