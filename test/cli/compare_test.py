#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm compare: its figures against closed forms and searches, and the paper's figures beside ours."""

import json
import math
import random
import unittest

from pkm import ORTHOGLIDE, URANESX, CommandTest, run

SEED = 20261126
AXES = [(11 / 26 * math.cos(turn), 11 / 26 * math.sin(turn)) for turn in (0, 2 * math.pi / 3, 4 * math.pi / 3)]
EDGE = 1 / math.sqrt(6) + 1 / (3 * math.sqrt(2))  # of the Orthoglide's largest cube [m]


def height(squared_distance):
    """How far a strut of the UraneSX, 1 m long, goes along its rail."""
    return math.sqrt(max(0.0, 1 - squared_distance))


def strokes_of(answer):
    """What the joints of the UraneSX take over a square or disc: the least values, and the longest stroke."""
    x, y, z = answer["center"]
    half = answer["size"] / 2
    least, strokes = [], []
    for a, b in AXES:
        if answer["shape"] == "square":
            near, far = (sum(max(0, abs(u - v) + side * half)**2 for u, v in ((x, a), (y, b))) for side in (-1, 1))
        else:
            distance = math.hypot(x - a, y - b)
            near, far = max(0, distance - 2 * half)**2, (distance + 2 * half)**2
        least.append(z + height(far))
        strokes.append(height(near) - height(far))
    return least, max(strokes)


def volume_of(least, stroke, count=150):
    """All that the UraneSX reaches with joint values from least to least + stroke: one seeded point in each cell of a
    grid across the rails, each with the length that is reached along them."""
    generator = random.Random(SEED)
    cell = 2 / count
    volume = 0.0
    for i in range(count):
        for j in range(count):
            x = (i + generator.random()) * cell - 1
            y = (j + generator.random()) * cell - 1
            squares = [(x - a)**2 + (y - b)**2 for a, b in AXES]
            if max(squares) <= 1:
                low = max(end - height(square) for end, square in zip(least, squares))
                high = min(end + stroke - height(square) for end, square in zip(least, squares))
                volume += max(0.0, high - low) * cell**2
    return volume


class Strokes(CommandTest):
    def test_volumes_are_those_of_the_true_strokes(self):
        """Near the border of reach, where a joint's largest value was once bounded a half too high."""
        for words in (("--set", "reachable", "--force-max", 2), ("--set", "reachable", "--kappa-max", 20),
                      ("--psi-max", 100), ("--psi-max", 100, "--shape", "disc")):
            with self.subTest(words=words, seed=SEED):
                shape = () if "--shape" in words else ("--shape", "square")
                answer = self.answer("compare", "--urdf", URANESX, *words, *shape, "--accuracy", 0.01, "--time-limit",
                                     0)["machines"][0]
                least, stroke = strokes_of(answer)
                figures = answer["figures"]
                self.assertBrackets(figures["stroke"][0], stroke, figures["stroke"][1], 1e-9)
                self.assertLess(figures["stroke"][1] - figures["stroke"][0], 1e-6)
                lower, upper = figures["workspace_volume"]
                self.assertBrackets(lower, volume_of(least, stroke), upper, 1e-3)
                self.assertLess(upper - lower, 0.01 * upper)
                for joint, begin in zip(answer["joint_ranges"], least):
                    self.assertBrackets(joint["lower"], begin, joint["inner"][0], 1e-9)
                    self.assertBrackets(joint["inner"][1], begin + stroke, joint["upper"], 1e-9)


class Compare(CommandTest):
    def assertEncloses(self, interval, value, slack=0.0):
        self.assertBrackets(interval[0], value, interval[1], slack)

    def compare(self, *words):
        return self.answer("compare", "--urdf", ORTHOGLIDE, "--urdf", URANESX, *words)["machines"]

    def test_two_machines(self):
        orthoglide, uranesx = self.compare()
        self.assertEqual([orthoglide["machine"], uranesx["machine"]], ["orthoglide", "uranesx"])
        for machine, edge, volume in ((orthoglide, EDGE, 0.5742), (uranesx, 0.51949, 0.5701)):
            self.assertEncloses(machine["figures"]["size"], edge, 1e-5)
            self.assertEqual(machine["figures"]["size"], [machine["size"], machine["size_upper_bound"]])
            self.assertEncloses(machine["figures"]["workspace_volume"], volume, 1e-3)
            lower, upper = machine["figures"]["workspace_volume"]
            self.assertLess(upper - lower, 0.02 * upper)
            for kind in ("figures", "scaled"):
                cube = machine[kind]["region_volume"]
                ratio = [cube[0] / machine[kind]["workspace_volume"][1], cube[1] / machine[kind]["workspace_volume"][0]]
                self.assertEncloses(machine[kind]["volume_ratio"], sum(ratio) / 2)
            self.assertEncloses(machine["scaled"]["strut"], 1 / machine["size"], 1e-12)
            self.assertEncloses(machine["scaled"]["region_volume"], 1, 1e-12)
        self.assertEncloses(orthoglide["figures"]["stroke"], 1 + 1 / (3 * math.sqrt(2)) - 1 / math.sqrt(6), 1e-3)
        self.assertEncloses(orthoglide["figures"]["across"], 1 - math.sqrt(2 / 3), 1e-3)
        self.assertEncloses(orthoglide["figures"]["other_aspect_volume"], 0.0071, 1e-4)

    def test_strokes_are_equalised(self):
        for machine in self.compare():
            for joint in machine["joint_ranges"]:
                self.assertAlmostEqual(joint["upper"] - joint["lower"], machine["figures"]["stroke"][1], delta=1e-12)

    def test_singularities(self):
        orthoglide, uranesx = self.compare()
        for machine in (orthoglide, uranesx):
            for found in machine["singularities"]["region"].values():
                self.assertIs(found["exists"], False)
                self.assertGreater(found["least"][0], 0)
            self.assertIs(machine["singularities"]["joint_ranges"]["serial"]["exists"], True)
        parallel = orthoglide["singularities"]["joint_ranges"]["parallel"]
        self.assertIs(parallel["exists"], True)
        self.assertEqual(parallel["least"], [0, 0])
        for lower, upper in zip(parallel["box"]["lower"], parallel["box"]["upper"]):
            self.assertLess(upper, 0)
            self.assertLess(upper - lower, 1e-5)
        parallel = uranesx["singularities"]["joint_ranges"]["parallel"]
        self.assertIs(parallel["exists"], False)
        self.assertGreater(parallel["least"][0], 0.42)

    def test_one_machine_and_flat_shapes(self):
        answer = self.answer("compare", "--urdf", URANESX, "--shape", "square", "--joint-limits", "off")["machines"]
        self.assertEqual(len(answer), 1)
        self.assertNotIn("volume_ratio", answer[0]["figures"])
        for stroke, across in zip(answer[0]["figures"]["stroke"], answer[0]["figures"]["across"]):
            self.assertAlmostEqual(stroke, across, delta=1e-14)  # only eta changes in a plane across the rails

    def test_cylinder_of_free_ratio(self):
        answer = self.answer("compare", "--urdf", ORTHOGLIDE, "--shape", "cylinder", "--ratio", 0.4, 0.8)["machines"][0]
        self.assertEqual(answer["shape"], "cylinder")
        height, volume = answer["size"], answer["figures"]["region_volume"][0]
        self.assertTrue(0.4 <= math.sqrt(volume / (math.pi * height**3)) <= 0.8)
        for found in answer["singularities"]["region"].values():
            self.assertIs(found["exists"], False)

    def test_the_other_aspect(self):
        own, other = (self.answer("compare", "--urdf", ORTHOGLIDE, "--aspect", aspect)["machines"][0]
                      for aspect in ("own", "other"))
        self.assertEncloses(other["figures"]["size"], 0.062854514, 1e-9)  # docs/values.md
        lower, upper = other["figures"]["workspace_volume"]
        self.assertLess(upper - lower, 0.006 * upper)
        self.assertGreater(lower, other["figures"]["region_volume"][1])
        self.assertEqual((own["aspect"], other["aspect"]), ("own", "other"))

    def test_no_region_has_no_figures(self):
        answer = self.answer("compare", "--urdf", ORTHOGLIDE, "--psi-min", 1.2, "--psi-max", 1.3)["machines"][0]
        self.assertEqual(answer["size"], 0)
        self.assertEqual(answer["figures"], {})
        self.assertNotIn("singularities", answer)

    def test_a_machine_without_a_region_has_a_line_that_says_why(self):
        tight = self.file("tight.urdf", self.with_limits(ORTHOGLIDE, 0, 0))
        for urdfs in (("--urdf", tight), ("--urdf", URANESX, "--urdf", tight)):
            words = ("compare", *urdfs, "--shape", "square", "--accuracy", 0.01)
            answer, text = self.answer(*words)["machines"][-1], self.text(*words)
            self.assertEqual(answer["status"], "none")
            self.assertRegex(answer["message"], r"^No region .*\.$")
            self.assertRegex(text, r"(?m)^  square: edge \[m\] +orthoglide +none +\(no region .*\)$")
            self.assertRegex(text, r"(?m)^  in the region +orthoglide +no region$")

    def test_the_time_limit_is_told_as_it_was_given(self):
        words = ("compare", "--urdf", ORTHOGLIDE, "--urdf", URANESX, "--time-limit", 1e-3, "--accuracy", 1e-9)
        for machine in self.answer(*words)["machines"]:
            self.assertIn(" s, its share of the time limit of 0.001 s ended the search", machine["message"])

    def test_budget_ends_with_honest_brackets(self):
        answer = self.answer("compare", "--urdf", ORTHOGLIDE, "--accuracy", 1e-6, "--max-boxes", 200)["machines"][0]
        self.assertEncloses(answer["figures"]["size"], EDGE)

    def test_rails_and_tcp_links_follow_their_machine(self):
        rails = ("rail_x", "rail_y", "rail_z")
        words = ("--urdf", ORTHOGLIDE, "--rails", *rails, "--urdf", URANESX, "--tcp-links", "tcp_1", "tcp_2", "tcp_3")
        named = self.answer("compare", *words)["machines"]
        self.assertEqual([machine["geometry_hash"] for machine in named],
                         [machine["geometry_hash"] for machine in self.compare()])

    def test_text_has_a_line_for_each_machine(self):
        text = self.text("compare", "--urdf", ORTHOGLIDE, "--urdf", URANESX)
        for machine in ("orthoglide", "uranesx"):
            self.assertRegex(text, rf"(?m)^  cube: edge .*  {machine} .* to ")
        self.assertRegex(text, r"(?m)^  within the strokes  orthoglide .* at \(.* at \(")


class ComparePaper(CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.process = run("compare", "--paper", "--accuracy", 1e-4, "--json")
        cls.said = json.loads(cls.process.stdout)
        cls.rows = cls.said["rows"]

    def holds(self, place, start):
        found = [row["holds"] for row in self.rows if row["place"] == place and row["what"].startswith(start)]
        self.assertTrue(found, (place, start))
        return found

    def test_progress_tells_what_is_computed(self):
        self.assertEqual(self.process.returncode, 0)
        words = ("--shape", "sphere", "--accuracy", 1e-12, "--time-limit", 60)
        long = run("compare", "--urdf", ORTHOGLIDE, "--urdf", ORTHOGLIDE, "--urdf", ORTHOGLIDE, *words, "--progress")
        self.assertRegex(long.stderr, r"(?m)^\d+ s: orthoglide, ")

    def test_the_criterion_is_told(self):
        told = {key: value for key, value in self.said.items() if key != "rows"}
        self.assertEqual(told, {"set": "dextrous", "aspect": "own", "joint_limits": False,
                                "psi_min": 0.5, "psi_max": 2})

    def test_brackets_are_the_numbers_of_the_texts(self):
        for row in self.rows:
            if row["bracket"] is not None:
                lower, upper = [float(word) for word in row["ours"].split(" to ")]
                self.assertLessEqual(lower, row["bracket"][0])
                self.assertGreaterEqual(upper, row["bracket"][1])
                self.assertLess(upper - lower, 1.2 * (row["bracket"][1] - row["bracket"][0]) + 1e-8)

    def test_every_table_is_there(self):
        for table, rows in ((1, 4), (2, 10), (3, 6), (4, 6)):
            self.assertEqual(sum(row["place"] == f"table {table}" for row in self.rows), rows)

    def test_what_holds_and_what_does_not(self):
        """docs/values.md: the cube holds; the squares are 0.01 off; the cube's stroke is not 0.825."""
        self.assertIs(self.holds("section 4.3", "edge of the cube")[-1], True)
        self.assertEqual(set(self.holds("table 2", "edge of the square")), {False})
        self.assertEqual(self.holds("section 4.3", "edge of the square"), [False])
        self.assertEqual(self.holds("section 4.4", "Orthoglide, Delta rho"), [False])
        self.assertEqual(self.holds("table 3", "Orthoglide, workspace"), [False])
        self.assertEqual(self.holds("table 4", "Orthoglide, strut"), [True])
        self.assertEqual(self.holds("section 4.3", "Orthoglide, parallel"), [False])
        self.assertEqual(self.holds("section 4.3", "UraneSX, parallel"), [True])
        self.assertEqual(self.holds("section 4.3", "UraneSX, serial"), [True])
        self.assertEqual(set(self.holds("table 1", "seconds")), {None})


if __name__ == "__main__":
    unittest.main()
