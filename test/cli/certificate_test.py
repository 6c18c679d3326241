#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Certificates: both checkers hold them to their claims, and refuse what is altered."""

import json
import os
import random
import re
import subprocess
import unittest

from alterations import altered
from checkers import by_pkm, by_python, check_certificate
from crooked import crooked
from pkm import DATA, ORTHOGLIDE, PKM, URANESX, URDF, CommandTest, run

SEED = 20261128
ALTERED = 12 * int(os.environ.get("PKM_WORKSPACE_TEST_CASES", 1))
PROTOTYPE = str(URDF / "orthoglide_prototype.urdf")


def spoiled(rng, data):
    """The bytes with one of them changed, some missing, or some twice."""
    first, last = sorted(rng.sample(range(len(data) + 1), 2))
    change = rng.choice(("bit", "byte", "cut", "hole", "twice"))
    if change == "bit":
        return data[:first] + bytes([data[first] ^ 1 << rng.randrange(8)]) + data[first + 1:]
    if change == "byte":
        return data[:first] + bytes([rng.randrange(256)]) + data[first + 1:]
    if change == "cut":
        return data[:first]
    last = min(last, first + 64)
    return data[:first] + (data[first:last] * 2 if change == "twice" else b"") + data[last:]


class Certificate(CommandTest):
    def write(self, *words, command="largest"):
        """@return the answer, and what the certificate says"""
        path = self.folder / "certificate.json"
        answer = self.answer(command, *words, "--certificate", path)
        return answer, json.loads(path.read_text()), path

    def check_both(self, data, *claims):
        self.assertEqual(by_python(data), list(claims))
        self.assertEqual(by_pkm(json.dumps(data)), list(claims))

    REGION = "every point of the region satisfies the criterion"

    def test_both_checkers_hold_every_kind_of_search_to_its_bracket(self):
        urdf = self.folder / "crooked.urdf"
        urdf.write_text(crooked(random.Random(SEED)))
        printer = self.folder / "printer.urdf"  # whose bad points violate joint limits most
        self.text("import", DATA / "firmware" / "klipper.cfg", "--output", printer)
        for words in (("--urdf", ORTHOGLIDE, "--accuracy", 1e-4),
                      ("--urdf", ORTHOGLIDE, "--aspect", "other", "--accuracy", 1e-3),
                      ("--urdf", ORTHOGLIDE, "--shape", "sphere", "--accuracy", 1e-3),
                      ("--urdf", ORTHOGLIDE, "--shape", "cylinder", "--radius", 0.2, "--accuracy", 1e-3),
                      ("--urdf", ORTHOGLIDE, "--shape", "disc", "--accuracy", 1e-3),
                      ("--urdf", ORTHOGLIDE, "--base-z", 0.1, "--accuracy", 1e-3),
                      ("--urdf", ORTHOGLIDE, "--search-box", -0.1, 0.1, -0.1, 0.1, 0.1, 0.2, "--accuracy", 1e-3),
                      ("--urdf", ORTHOGLIDE, "--set", "reachable", "--force-min", 0.6, "--accuracy", 1e-3),
                      ("--urdf", PROTOTYPE, "--accuracy", 1e-4),
                      ("--urdf", URANESX, "--shape", "square", "--accuracy", 1e-4),
                      ("--urdf", URANESX, "--shape", "sphere", "--accuracy", 1e-2),
                      ("--urdf", URANESX, "--shape", "square", "--search-box", -0.1, 0, -0.1, 0, -1, 1),
                      ("--urdf", URANESX, "--search-box", -0.3, 0.3, -0.3, 0.3, 0.017, 0.117, "--accuracy", 1e-2),
                      ("--urdf", urdf, "--accuracy", 1e-3),
                      ("--urdf", URDF / "tripod.urdf", "--joint-limits", "on", "--accuracy", 1e-3),
                      ("--urdf", URDF / "mixed_legs.urdf", "--joint-limits", "on", "--accuracy", 1e-2),
                      ("--urdf", printer, "--psi", "auto", "--shape", "cylinder", "--ratio", 0.8, 0.8),
                      ("--urdf", URDF / "delta.urdf", "--accuracy", 0.05)):
            with self.subTest(words=words):
                answer, data, path = self.write(*words)
                self.assertLess(path.stat().st_size, 200000)
                self.assertEqual(data["region"]["size"], answer["size"])
                where = " with its center in the search box" if "--search-box" in words or "--base-z" in words else ""
                self.check_both(data, self.REGION,
                                "no region larger than %r%s satisfies it" % (answer["size_upper_bound"], where))

    def test_a_region_that_is_checked_has_one(self):
        region = ("--center", 0.08, 0.08, 0.08, "--sides", 0.6, 0.55, 0.5)
        _, data, _ = self.write("--urdf", ORTHOGLIDE, *region, command="check")
        self.assertIsNone(data["bound"])
        self.check_both(data, self.REGION)
        _, data, _ = self.write("--urdf", PROTOTYPE, "--center", 0, 0, 0, "--radius", 0.05, command="check")
        self.check_both(data, self.REGION)

    def test_pavings_have_boxes_and_paths_have_pieces(self):
        for words in (("--urdf", ORTHOGLIDE, "--resolution", 0.2), ("--urdf", PROTOTYPE, "--resolution", 0.05),
                      ("--urdf", URANESX, "--joint-limits", "off", "--resolution", 0.05),
                      ("--urdf", URDF / "delta.urdf", "--resolution", 0.2, "--time-limit", 600)):
            answer, data, _ = self.write(*words, command="pave")
            leaves = [node for node in data["boxes"]["tree"] if not isinstance(node, list)]
            counts = (leaves.count(1), sum(isinstance(leaf, dict) for leaf in leaves))
            self.assertEqual(counts[0], answer["boxes_inside"])
            self.assertLess(leaves.count(0) - answer["boxes_boundary"], 0.1 * counts[1])  # what no single form says
            self.check_both(data, "every point of the boxes inside satisfies the criterion (%d), no point of those "
                                  "outside (%d)" % counts)
            bad = json.loads(json.dumps(data))
            outside = next(k for k, node in enumerate(bad["boxes"]["tree"]) if isinstance(node, dict))
            bad["boxes"]["tree"][outside] = 1
            self.assertEqual((by_python(bad), by_pkm(json.dumps(bad))), (None, None))
        segments = ("--segment", "start 0 0 0", "--segment", "line 0.1 0 0", "--segment", "line 0.1 0.2 0.29")
        _, data, _ = self.write("--urdf", ORTHOGLIDE, *segments, command="path")
        pieces = sum(len(cuts) - 1 for _, _, cuts in data["path"])
        self.check_both(data, "every point of the path satisfies the criterion (segments: 2, pieces: %d)" % pieces)
        for spoil in (lambda path: path[0][2].pop(), lambda path: path[1][1].__setitem__(2, 0.8),
                      lambda path: path[0][2].insert(1, 1.5), lambda path: path[0][0].__setitem__(0, -1.5)):
            bad = json.loads(json.dumps(data))
            spoil(bad["path"])
            self.assertEqual((by_python(bad), by_pkm(json.dumps(bad))), (None, None))

    def test_whatever_is_altered_is_refused_by_both(self):
        rng = random.Random(SEED)
        for words in (("--urdf", ORTHOGLIDE), ("--urdf", ORTHOGLIDE, "--shape", "sphere", "--accuracy", 0.01),
                      ("--urdf", URANESX, "--shape", "square"), ("--urdf", PROTOTYPE),
                      ("--urdf", ORTHOGLIDE, "--shape", "cylinder", "--radius", 0.2, "--accuracy", 0.01)):
            _, data, _ = self.write(*words)
            for k in range(ALTERED):
                false, how = altered(rng, data)
                with self.subTest(words=words, how=how, number=k, seed=SEED):
                    self.assertIsNone(by_python(false))
                    self.assertIsNone(by_pkm(json.dumps(false)))

    def test_bytes_that_a_disk_spoils_are_refused_or_proved_by_both(self):
        rng = random.Random(SEED)
        _, data, path = self.write("--urdf", URANESX, "--shape", "square", "--accuracy", 0.05)
        whole = path.read_bytes()
        whole_says = by_python(data)
        refused = 0
        for number in range(10 * ALTERED):
            text = spoiled(rng, whole).decode("latin-1")
            with self.subTest(number=number, seed=SEED):
                try:
                    says = by_python(json.loads(text, object_pairs_hook=check_certificate.once))
                except (check_certificate.Refused, *check_certificate.NOT_UNDERSTOOD):
                    says = None
                self.assertEqual(by_pkm(text), says)
                refused += says is None
                if says == whole_says:  # then it is about what it was about, but for names
                    changed = [name for name in ("criterion", "body") if json.loads(text)[name] != data[name]]
                    self.assertEqual(changed, [])
        self.assertGreater(refused, 5 * ALTERED)

    def test_what_certificates_do_not_know_is_refused_before_the_search(self):
        path = self.folder / "arc.json"
        arc = ("--segment", "start 0 0 0", "--segment", "arc 0.2 0.1 0 0.1 0.2 0")
        process = subprocess.run([PKM, "path", "--urdf", ORTHOGLIDE, *arc, "--certificate", path], capture_output=True,
                                 text=True)
        self.assertEqual(process.returncode, 1)
        self.assertIn("do not know arcs yet", process.stderr)
        self.assertFalse(path.exists())
        for words, what in ((("--stiffness-min", 1e6, "--joint-stiffness", 1e8), "stiffness"),
                            (("--kappa-max", 3), "the condition number"),
                            (("--turned",), "turned regions"),
                            (("--shape", "cylinder", "--ratio", 0.4, 0.6), "free ratio"),
                            (("--tolerance-length", 1e-4), "tolerances")):
            path = self.folder / "none.json"
            process = subprocess.run([PKM, "largest", "--urdf", ORTHOGLIDE, *map(str, words), "--certificate", path],
                                     capture_output=True, text=True)
            self.assertEqual((process.returncode, process.stdout), (2, ""), words)
            self.assertRegex(process.stderr, "certificates do not know .*%s.*leave it out" % what)
            self.assertFalse(path.exists())
        corners = self.file("corners.txt", "0.1 0 0\n-0.1 0 0\n0 0.1 0\n0 -0.1 0\n0 0 0.1\n0 0 -0.1\n")
        process = run("check", "--urdf", ORTHOGLIDE, "--center", 0, 0, 0, "--shape", "polytope", "--vertices", corners,
                      "--size", 1, "--certificate", path)
        self.assertEqual((process.returncode, process.stdout), (2, ""), process.stderr)
        self.assertIn("certificates do not know regions of this shape", process.stderr)

    def test_a_paving_of_more_boxes_than_memory_has_none(self):
        path = self.folder / "none.json"
        process = run("pave", "--urdf", ORTHOGLIDE, "--resolution", 0.1, "--max-memory", 1000000, "--certificate", path)
        self.assertEqual(process.returncode, 1)
        self.assertIn("ask for a coarser resolution", process.stderr)
        self.assertFalse(path.exists())

    def test_what_attackers_write_is_refused(self):
        """Each of these was once accepted by one of the two."""
        _, good, _ = self.write("--urdf", URANESX, "--shape", "square", "--accuracy", 1e-2)
        _, tripod, _ = self.write("--urdf", URDF / "tripod.urdf", "--joint-limits", "on", "--accuracy", 1e-2)

        def copy(data):
            return json.loads(json.dumps(data))

        def far_places(data):
            """A bad point that is said to push against the travel."""
            bound = data["bound"]
            bound.update(size=0.4, points=[{"fixed": [0, 0, 0], "per_size": [0, 0, 0]}], bad=[
                {"point": [50, y, 1000], "of": "reach", "leg": 0} for y in (-0.37, -0.125, 0.125, 0.37)])
            for corner in bound["centers"]:
                corner[2] = 1000
            upper = {"at": 0, "of": "joint_upper", "leg": 0, "weight": 1}
            leaves = [{"size": 0.4, "terms": [upper, {"bad": k, "weight": 1, "of": "joint_lower", "leg": 0}]}
                      for k in range(4)]
            bound["tree"] = [[1, 0], [1, -0.25], *leaves[:2], [1, 0.25], *leaves[2:]]

        def beyond_numbers(data):
            lower = {"at": 0, "of": "joint_lower", "leg": 0, "weight": 1}
            data["bound"].update(size=1e-9, centers=[[-1e300] * 3, [1e300] * 3], bad=[],
                                 points=[{"fixed": [0, 0, 0], "per_size": [0, 0, 0]}],
                                 tree=[{"size": 1e-9, "terms": [lower]}])

        def no_axis(axis):
            return lambda data: data["bound"]["tree"].__setitem__(0, [axis, 0])

        for data, spoil in ((good, far_places), (tripod, beyond_numbers), (good, no_axis(2 ** 32)),
                            (good, no_axis(2 ** 61 + 1)), (good, lambda d: d["body"]["box"]["upper"].pop()),
                            (good, lambda d: d["machine"]["legs"][0].update(limits=[])),
                            (good, lambda d: d["criterion"].update(joint_limits="false")),
                            (good, lambda d: d["body"].update(ball={"radius": [0, 1]})),
                            (good, lambda d: d["body"]["box"].update(turned=45)),
                            (good, lambda d: d["machine"]["legs"][0].update(direction=0.9)),
                            (good, lambda d: d["region"]["center"].__setitem__(2, 2 ** 53 + 1)),
                            (good, lambda d: d["criterion"].update(psi_min=-0.5))):
            false = copy(data)
            spoil(false)
            self.assertIsNone(by_python(false))
            self.assertIsNone(by_pkm(json.dumps(false)))
        twice = json.dumps(good).replace('"version": 1', '"version": 2, "version": 1')
        self.assertIsNone(by_pkm(twice))
        with self.assertRaises(check_certificate.Refused):
            json.loads(twice, object_pairs_hook=check_certificate.once)

    def test_a_bound_that_is_left_out_is_named(self):
        for words in (("--max-boxes", 20), ("--set", "reachable")):  # stopped; by spheres of struts
            path = self.folder / "region.json"
            process = run("largest", "--urdf", ORTHOGLIDE, *words, "--certificate", path)
            self.assertEqual(process.returncode, 0, process.stderr)
            self.assertIn("the certificate has no bound", process.stderr)
            self.check_both(json.loads(path.read_text()), self.REGION)

    def test_where_there_is_nothing_to_certify_it_says_so(self):
        process = run("largest", "--urdf", ORTHOGLIDE, "--psi-max", 0.9, "--psi-min", 0.1, "--certificate",
                      self.folder / "none.json")
        self.assertEqual(process.returncode, 1)
        self.assertIn("nothing to certify", process.stderr)

    def test_what_is_no_json_is_bad_input(self):
        process = run("verify", ORTHOGLIDE)
        self.assertEqual((process.returncode, process.stdout), (2, ""))
        self.assertIn("not a certificate, which is a JSON object", process.stderr)

    def test_a_region_that_is_not_inside_has_none(self):
        path = self.folder / "none.json"
        process = subprocess.run([PKM, "check", "--urdf", ORTHOGLIDE, "--center", "0", "0", "0", "--sides", "2", "2",
                                  "2", "--certificate", path], capture_output=True, text=True)
        self.assertEqual(process.returncode, 1)
        self.assertIn("outside", process.stdout)
        self.assertIn("nothing to certify", process.stderr)
        self.assertFalse(path.exists())

    def test_the_script_says_what_it_has_verified_or_what_does_not_hold(self):
        _, data, path = self.write("--urdf", ORTHOGLIDE)
        script = [URDF.parent / "scripts" / "check_certificate.py", path]  # as the documents say
        process = subprocess.run(script, capture_output=True, text=True)
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertRegex(process.stdout, r"^Verified: every point of the .*\nVerified: no region larger than .*\n$")
        data["region"]["size"] *= 1.1
        path.write_text(json.dumps(data))
        process = subprocess.run(script, capture_output=True, text=True)
        self.assertEqual((process.returncode, process.stdout), (1, ""))
        self.assertIn("refused: the region reaches beyond the box of its proof", process.stderr)


if __name__ == "__main__":
    unittest.main()
