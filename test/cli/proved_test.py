#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every sentence of pkm that says 'proved', on seeded machines, against the oracle; and that the oracle objects."""

import random
import unittest
from types import SimpleNamespace

import sentences
from claims import Case
from crooked import crooked
from oracle import Machine, Region
from pkm import CommandTest, run
from reasons import Wrong
from spoils import WRONG

SEED = 20261126
SHAPES = (("cube", ), ("square", ), ("box", "--proportions", 2, 1, 1), ("sphere", ), ("disc", ),
          ("cylinder", "--ratio", 0.4, 0.6), ("cylinder", "--ratio", 0.5, 0.5))


class Proved(CommandTest):
    seen, caught = set(), set()  # claims, and the wrong versions of them that were refuted: (claim, number)
    begun = set()

    def setUp(self):
        super().setUp()
        self.begun.add(self.id())
        self.rng = random.Random(SEED)
        length = self.rng.uniform(0.2, 2)
        lam = self.rng.uniform(0, 0.1)
        drives = ("--joint-speed-max", 1, "--joint-effort-max", 1000)
        self.urdfs = {"orthoglide": self.text("urdf", "--machine", "orthoglide", "--length", length, *drives),
                      "uranesx": self.text("urdf", "--machine", "uranesx", "--lambda", lam, *drives),
                      "crooked": crooked(self.rng), "crooked too": crooked(self.rng)}
        self.machines = {name: Machine(text) for name, text in self.urdfs.items()}
        self.files = {name: self.file(name + ".urdf", text) for name, text in self.urdfs.items()}

    def case(self, text, words, **more):
        return Case(text=text, words=[str(word) for word in words], rng=self.rng, **more)

    def held(self, name, *words, machine=None, **more):
        """The text of pkm, all of whose sentences the oracle agrees with."""
        file = ("--urdf", self.files[name]) if name else ()
        process = run(*words[:1], *file, *words[1:])
        self.assertEqual(process.returncode, 0, process.stderr)
        case = self.case(process.stdout, words, machine=machine or self.machines.get(name), **more)
        with self.subTest(machine=name, words=words):
            names = sentences.check(case)
            self.assertTrue(names, process.stdout)
            for claim in names:
                self.refuted(claim, case)
        return process.stdout

    def refuted(self, claim, case):
        """Looks whether wrong versions of the text make the oracle object."""
        self.seen.add(claim)
        for k, spoil in enumerate(WRONG.get(claim, ())):
            text = spoil(case.text).replace("(GOOD)", "({}, {}, {}) m".format(*self.good_point(case)))
            if text != case.text and (claim, k) not in self.caught:
                try:
                    sentences.check(Case(**{**vars(case), "text": text}))
                except Wrong:
                    self.caught.add((claim, k))

    def good_point(self, case):
        leg = case.machine.legs[float][0]
        return [x + y for x, y in zip(leg.c, leg.zero)]

    def accuracy(self, name, share=0.02):
        return round(share * self.machines[name].span, 6)

    def test_largest(self):
        for name in self.urdfs:
            for shape in SHAPES:
                self.held(name, "largest", "--shape", *shape, "--accuracy", self.accuracy(name), "--max-boxes", 3000)

    def test_largest_elsewhere(self):
        for name in self.urdfs:
            center = self.good_point(SimpleNamespace(machine=self.machines[name]))
            box = [x + side for x in center for side in (0, 0.3 * self.machines[name].span)]
            accuracy = ("--accuracy", self.accuracy(name))
            self.held(name, "largest", "--center", *center, *accuracy)
            self.held(name, "largest", "--search-box", *box, "--shape", "disc", *accuracy)
            self.held(name, "largest", "--turned", "--shape", "square", *accuracy)
            for place in ([], ["--base-z", center[2]], ["--center", *center], ["--search-box", *box]):
                self.held(name, "largest", "--turned", *place, "--shape", "box", "--proportions", 2, 1, 1, *accuracy)
            for wish in (["cube"], ["disc"], ["box", "--proportions", 2, 1, 1], ["cylinder", "--ratio", 0.5, 1]):
                self.held(name, "largest", "--base-z", center[2], "--shape", *wish, *accuracy)
            span = self.machines[name].span
            for wish in (["--radius", 0.1 * span], ["--height", 0.1 * span], ["--radius", 3 * span]):
                self.held(name, "largest", "--shape", "cylinder", *wish, *accuracy)
                self.held(name, "largest", "--shape", "cylinder", *wish, "--base-z", center[2], *accuracy)
            self.held(name, "largest", "--shape", "box", "--footprint", 0.1 * span, 0.2 * span, "--base-z", center[2],
                      "--search-box", *box, *accuracy)
            self.held(name, "largest", "--psi-max", 1.05, "--psi-min", 0.96, *accuracy)
            self.held(name, "largest", "--psi-max", 1.0001, "--psi-min", 0.9999, *accuracy)

    def box_words(self, name, share):
        """A box about a good point, with sides of about this share of a strut."""
        span = self.machines[name].span
        center = self.good_point(SimpleNamespace(machine=self.machines[name]))
        return ("--center", *(x + self.rng.uniform(-0.05, 0.05) * span for x in center), "--sides",
                *(self.rng.uniform(0.8, 1.2) * share * span for _ in range(3)))

    def test_boxes(self):
        for name in self.urdfs:
            for share in (0.1, 0.25, 0.4, 0.7, 2):
                for more in ((), ("--joint-limits", "off"), ("--set", "reachable", "--aspect", "both")):
                    self.held(name, "check", *self.box_words(name, share), *more)
            words = ("--psi-min", 0.7, "--psi-max", 1.4)
            self.held(name, "check", *self.box_words(name, 0.3), *words)

    def test_round_bodies(self):
        for name in self.urdfs:
            span = self.machines[name].span
            for body in ((0.1, ), (0.5, ), (0.1, 0.1), (0.1, 0), (0.6, 0.3)):
                words = [word for pair in zip(("--radius", "--height"), [share * span for share in body])
                         for word in pair]
                for more in ((), ("--joint-limits", "off")):
                    self.held(name, "check", *self.box_words(name, 1)[:4], *words, *more)

    def test_boxes_of_one_aspect(self):
        """Also those that meet a sphere where two struts are one."""
        for name in self.urdfs:
            for share in (0.3, 1.5):
                for aspect in ("own", "other"):
                    self.held(name, "check", *self.box_words(name, share), "--set", "reachable", "--aspect", aspect)
        length = self.machines["orthoglide"].span
        self.held("orthoglide", "check", "--center", *[0.55 * length] * 3, "--sides", *[0.3 * length] * 3, "--set",
                  "reachable", "--aspect", "own", "--joint-limits", "off")

    def test_centers(self):
        for name in self.urdfs:
            center = self.good_point(SimpleNamespace(machine=self.machines[name]))
            span = self.machines[name].span
            for around, side in ((0.01, 0.1), (0.4, 0.2), (0.1, 1.5)):
                box = [x + end * around * span for x in center for end in (-1, 1)]
                self.held(name, "check", "--centers", *box, "--sides", *[side * span] * 3)

    def path_words(self, name, points):
        kinds = ["start"] + ["line"] * (len(points) - 1)
        return [word for kind, point in zip(kinds, points)
                for word in ("--segment", " ".join(map(str, (kind, *point))))]

    def test_paths(self):
        for name in self.urdfs:
            center = self.good_point(SimpleNamespace(machine=self.machines[name]))
            for width in (0.1, 0.5, 0.8, 0.8, 3):
                spread = width * self.machines[name].span
                points = [center] + [[x + self.rng.uniform(-spread, spread) for x in center] for _ in range(3)]
                self.held(name, "path", *self.path_words(name, points))
                self.held(name, "path", *self.path_words(name, points), "--joint-limits", "off")
                self.held(name, "path", *self.path_words(name, points[::-1]))

    def test_paths_at_speed(self):
        for name in self.urdfs:
            center = self.good_point(SimpleNamespace(machine=self.machines[name]))
            span = self.machines[name].span
            for width in (0.05, 0.3, 0.6):
                points = [center] + [[x + self.rng.uniform(-width, width) * span for x in center] for _ in range(3)]
                for speed in (0.3, 0.8, 3):
                    words = ("path", *self.path_words(name, points), "--tool-speed", speed, "--joint-limits", "off")
                    self.held(name, *words)
                    self.held(name, *words, "--joint-acceleration-max", 0.5 / span)
                self.held(name, *words[:-4], "--largest-feed")
                self.held(name, *words, "--joint-speeds-off")

    def test_placements(self):
        for name in self.urdfs:
            span = self.machines[name].span
            for width in (0.1, 0.3, 1.5):
                points = [[self.rng.uniform(-width, width) * span for _ in range(3)] for _ in range(4)]
                words = ("place", *self.path_words(name, points), "--accuracy", self.accuracy(name, 0.002))
                within = [side * span for side in (-2, 2) * 3]
                self.held(name, *words, "--largest-scale")
                self.held(name, *words, "--within", *within, "--joint-limits", "off")
                self.held(name, *words, "--tool-speed", 0.9, "--time-limit", 2)
            self.held(name, *words[:-2], "--max-boxes", 1)

    def test_a_path_that_touches(self):
        points = ((-0.079970593403865281, -0.22351999604761633, 0.18342168780574239),
                  (0.8108995385756147, -0.37194738107784847, -0.8025565924266686))
        self.urdfs["unit"] = self.text("urdf", "--machine", "orthoglide")
        self.files["unit"], self.machines["unit"] = self.machine("--machine", "orthoglide"), Machine(self.urdfs["unit"])
        self.held("unit", "path", *self.path_words("unit", points), "--psi-min", 0.7974806294181559)

    def test_volumes(self):
        for name in self.urdfs:
            for more in ((), ("--aspect", "other"), ("--set", "reachable", "--aspect", "both"),
                         ("--max-boxes", 300), ("--joint-limits", "off")):
                self.held(name, "pave", "--resolution", self.accuracy(name, 0.1), *more)

    def test_components(self):
        for name in self.urdfs:
            for more in (("--psi-min", 0.2, "--psi-max", 5), ("--set", "reachable")):
                self.held(name, "pave", "--components", "--resolution", self.accuracy(name, 0.05), *more)

    def test_connections(self):
        length = self.machines["orthoglide"].span
        factors = ("--psi-min", 0.2, "--psi-max", 5)
        self.held("orthoglide", "connect", "--to", *[0.65 * length] * 3, *factors, "--joint-limits", "off")
        for name in self.urdfs:
            center = self.good_point(SimpleNamespace(machine=self.machines[name]))
            for width in (0.1, 0.3, 0.5):
                spread = width * self.machines[name].span
                to = [x + self.rng.uniform(-spread, spread) for x in center]
                self.held(name, "connect", "--to", *to, *factors, point=to)

    def test_a_start_at_joint_limits(self):
        """The zero configuration stands at the lower limits: rounding puts a joint below."""
        urdf = self.machine("--linear-delta", "--rail-radius", 0.13, "--angle", 0, 120.4, 239.7,
                            "--platform-radius", 0.03, "--length", 0.269, 0.2688, 0.2691, "--travel", 0, 0.35,
                            "--mount", 0, 0, 0.75)
        words = ("connect", "--urdf", urdf, "--to", 0.02, 0, 0.9)
        answer = self.answer(*words, "--psi", "auto")
        self.assertEqual(answer["verdict"], "connected")
        joints = self.answer("evaluate", "--urdf", urdf, "--point", *answer["from"])["rho"]
        self.assertTrue(all(0 < joint < 1e-9 for joint in joints), joints)
        self.assertIn("the zero configuration: give --from X Y Z", self.answer(*words)["message"])

    def test_means(self):
        for name in self.urdfs:
            center = self.good_point(SimpleNamespace(machine=self.machines[name]))
            self.held(name, "conditioning", "--shape", "cube", "--center", *center, "--size",
                      0.3 * self.machines[name].span, definition="Reachable: all points, in either aspect.")
            self.held(name, "conditioning", "--accuracy", 0.1)
            self.held(name, "conditioning", "--max-boxes", 1)

    def test_guarantees(self):
        known = ("--joint-stiffness", 1e6, "--joint-error-max", 1e-5, "--joint-speed-max", 1, "--joint-effort-max",
                 1000)
        for name in self.urdfs:
            for share in (0.15, 0.3, 5):
                words = [*self.box_words(name, share)]
                region = Region("box", words[words.index("--sides") + 1:][:3], words[1:4])
                self.held(name, "guarantee", *words, *known, region=region,
                          definition="Reachable: all points, in either aspect.")

    def test_singularities(self):
        for name in self.urdfs:
            center = self.good_point(SimpleNamespace(machine=self.machines[name]))
            small = ("--shape", "cube", "--center", *center, "--size", 0.2 * self.machines[name].span)
            endless = () if name == "uranesx" else (("--joint-limits", "off"), )
            for words in ((), small, ("--aspect", "own"), ("--max-boxes", 1), *endless):
                self.held(name, "singularities", *words)

    def test_points(self):
        for name in self.urdfs:
            center = self.good_point(SimpleNamespace(machine=self.machines[name]))
            for width in [0.1, 0.3, 0.6, 1.0] * 3:
                spread = width * self.machines[name].span
                self.held(name, "evaluate", "--point", *[x + self.rng.uniform(-spread, spread) for x in center])

    def family(self, parameter):
        return Machine(self.text("urdf", "--machine", "uranesx", "--rail-radius", float(parameter) + 0.125,
                                 "--platform-radius", 0.125))

    def test_study(self):
        words = ("--machine", "uranesx", "--parameter", "R-r", "--shape", "square", "--accuracy", 0.05)
        self.held(None, "study", *words, "--range", 0.35, 0.5, family=self.family,
                  machine=self.family(0.35))
        self.held(None, "study", *words, "--range", 0.8, 0.9, "--psi-max", 1.1, "--psi-min", 0.9, family=self.family,
                  machine=self.family(0.8))

    def test_comparison(self):
        names = ("orthoglide", "crooked")
        words = ("--shape", "cube", "--accuracy", 0.01)
        largest = {name: self.text("largest", "--urdf", self.files[name], *words) for name in names}
        files = [word for name in names for word in ("--urdf", self.files[name])]
        self.held(None, "compare", *files, *words, machines=self.machines, largest=largest)

    @classmethod
    def tearDownClass(cls):
        """After all tests: every claim was met, every kind of wrong one refuted, and 50 digits were enough."""
        print("seed", SEED)
        unseen = set(sentences.CLAIMS) - cls.seen - {"nothing"}
        missed = {(claim, k) for claim, spoils in WRONG.items() for k in range(len(spoils))} - cls.caught
        is_all = len(cls.begun) == len(unittest.defaultTestLoader.getTestCaseNames(cls))
        if is_all and (unseen or missed) or Machine.undecided:
            raise AssertionError(f"never met: {unseen}; never refuted: {missed}; undecided points: {Machine.undecided}")


if __name__ == "__main__":
    unittest.main()
