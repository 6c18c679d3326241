#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pkm path at a tool speed: joint speeds and accelerations against their limits, and the largest feed."""

import math
import re
import unittest

from pkm import DATA, ORTHOGLIDE, CommandTest, run

SLOW = str(DATA / "slow_carriages.urdf")  # carriages that make 0.2 m/s, half of what the tool makes down to that


class PathSpeed(CommandTest):
    def words(self, *lines, options=(), urdf=SLOW):
        return ("path", "--urdf", urdf, *(word for line in lines for word in ("--segment", line)), *options)

    def path(self, *lines, **more):
        return self.answer(*self.words(*lines, **more))

    def refused(self, *options):
        process = run(*self.words("start 0 0 0", "line 0.01 0 0", options=options))
        self.assertEqual(process.returncode, 2, process.stdout)
        return " ".join(process.stderr.split())

    def without_velocity(self, *joints):
        with open(SLOW, encoding="utf-8") as file:
            text = file.read()
        for joint in joints:
            text = re.sub(rf'(name="{joint}".*?)velocity="0.2"', r'\1velocity="0"', text, flags=re.S)
        return self.file("unknown.urdf", text)

    def test_a_feed_that_the_motors_cannot_follow(self):
        """Straight up all three carriages go with the tool."""
        lines = ("start 0 0 0", "line 0 0 0.05")
        self.assertEqual(self.path(*lines, options=("--psi", "auto"))["verdict"], "inside", "of no speed")
        answer = self.path(*lines, options=("--psi", "auto", "--tool-speed", 0.5))
        self.assertEqual(answer["verdict"], "outside")
        binding = answer["first"]["binding"]
        self.assertIn(binding["joint"], ("tower_1", "tower_2", "tower_3"))
        self.assertEqual((binding["limit"], binding["bound"]), ("joint_speed_max", 0.2))
        self.assertAlmostEqual(binding["value"], 0.5, places=12)
        self.assertAlmostEqual(binding["margin"], -0.3, places=12)
        self.assertEqual(answer["first"]["bad_at"], 0)
        self.assertRegex(answer["message"], r"^Proved: at 0\.5 m/s the path is too fast for the joints on line 'line "
                         r"0 0 0\.05' \(line\), near t = 0 of its way: the speed of joint 'tower_\d' is 0\.5 m/s, "
                         r"above its limit of 0\.2 m/s\. The largest feed is proved to be .* m/s; at that 'tower_")
        self.assertBrackets(answer["rates"]["feed"]["lower"], 0.2, answer["rates"]["feed"]["upper"], 1e-12)
        faster = self.path(*lines, options=("--psi", "auto", "--tool-speed", 0.5, "--joint-speed-max", 0.6))
        self.assertEqual((faster["verdict"], faster["rates"]["joint_speed_max"]), ("inside", [0.6] * 3))
        idle = run("path", "--urdf", ORTHOGLIDE, "--segment", "start 0 0 0", "--joint-speed-max", 1)
        self.assertEqual(idle.returncode, 2)
        self.assertIn("counts for --tool-speed-min, and for --tool-speed and --largest-feed", idle.stderr)
        slow = self.path(*lines, options=("--psi", "auto", "--tool-speed", 0.1999))
        self.assertEqual(slow["verdict"], "inside")
        self.assertIn("At 0.1999 m/s the joints are proved to keep within their limits.", slow["message"])

    def test_the_feed_of_each_segment(self):
        answer = self.path("start 0 0 0", "line 0 0 0.01", "line 0.02 0 0.01", "line 0.05 0 0.01",
                           options=("--psi", "auto", "--largest-feed"))
        self.assertEqual((answer["verdict"], answer["tool_speed"]), ("inside", 1))
        feeds = [segment["rates"]["feed"] for segment in answer["segments"]]
        self.assertGreater(feeds[1]["lower"], feeds[2]["upper"], "it gets steeper")
        self.assertEqual(answer["rates"]["feed"]["lower"], min(feed["lower"] for feed in feeds))
        self.assertEqual(answer["rates"]["feed"]["upper"], min(feed["upper"] for feed in feeds))
        self.assertEqual(answer["rates"]["slowest_segment"], 0)
        for feed in feeds:
            self.assertLessEqual(feed["upper"], 1.0011 * feed["lower"])
            self.assertEqual(feed["limit"], "joint_speed_max")
        text = self.text(*self.words("start 0 0 0", "line 0 0 0.01", "line 0.02 0 0.01", "line 0.05 0 0.01",
                                     options=("--psi", "auto", "--largest-feed")))
        rows = re.findall(r"(?m)^  line 'line .*' \(line\) +(\S+) to (\S+) m/s +speed of '(tower_\d)'$", text)
        self.assertEqual([row[2] for row in rows], [feed["joint"] for feed in feeds])
        for row, feed in zip(rows, feeds):
            self.assertAlmostEqual(float(row[0]), feed["lower"], delta=1e-4)
            self.assertAlmostEqual(float(row[1]), feed["upper"], delta=1e-4)
        many = [f"line {0.0001 * (k * 7 % 23):.4f} 0 0.01" for k in range(1, 23)]
        text = self.text(*self.words("start 0 0 0.01", *many, options=("--psi", "auto", "--largest-feed")))
        self.assertIn("The 10 slowest of 22 segments (--json has them all):", text)
        lowers = [float(x) for x in re.findall(r"(?m)^  line '.* \(line\) +(\S+) to \S+ m/s", text)]
        self.assertEqual((len(lowers), lowers), (10, sorted(lowers)))
        text = self.text(*self.words("start 0 0 0", "line 0.02 0 0", options=("--psi", "auto", "--largest-feed")))
        self.assertNotIn("limited by", text)
        self.assertRegex(text, r"(?m)^  largest feed +0\.\d+ to 0\.\d+ m/s$")
        self.assertRegex(text, r"(?m)^  acceleration of 'tower_3' +up to \S+ m/s\^2$")

    def test_accelerations(self):
        """rho_2 = 1 - sqrt(1 - x^2) along x."""
        lines = ("start -0.2 0 0", "line 0.2 0 0")
        most = 0.96**-1.5
        free = self.path(*lines, urdf=ORTHOGLIDE, options=("--tool-speed", 0.5))
        self.assertBrackets(most / 4, free["rates"]["joint_acceleration"][1], 1.01 * most / 4)
        options = ("--tool-speed", 0.5, "--joint-acceleration-max")
        self.assertEqual(self.path(*lines, urdf=ORTHOGLIDE, options=(*options, 0.3))["verdict"], "inside")
        self.assertEqual(self.path(*lines, urdf=ORTHOGLIDE, options=(*options, 0.1, 0.3, 0.3))["verdict"], "inside")
        answer = self.path(*lines, urdf=ORTHOGLIDE, options=(*options, 1, 1, 0.255))
        self.assertEqual(answer["verdict"], "outside")
        self.assertEqual((answer["first"]["binding"]["joint"], answer["first"]["binding"]["limit"]),
                         ("rail_z", "joint_acceleration_max"))
        self.assertEqual(answer["rates"]["joint_acceleration_max"], [1, 1, 0.255])
        feed = answer["rates"]["feed"]
        self.assertBrackets(feed["lower"], math.sqrt(0.255 / most), feed["upper"])
        self.assertEqual((feed["joint"], feed["limit"]), ("rail_z", "joint_acceleration_max"))

    def test_what_has_no_limit_is_named(self):
        lines, options = ("start 0 0 0", "line 0 0 0.05"), ("--psi", "auto", "--tool-speed", 5)
        none = self.without_velocity("tower_1", "tower_2", "tower_3")
        answer = self.path(*lines, urdf=none, options=options)
        self.assertEqual(answer["verdict"], "inside")
        self.assertEqual(answer["message"], "Proved: every point of the path is in the set. Joint speeds are not held "
                         "against a limit: 'tower_1', 'tower_2' and 'tower_3' have none.")
        self.assertEqual(answer["rates"]["joint_speed_max"], [None] * 3)
        self.assertEqual(answer["rates"]["feed"], {"lower": None, "upper": None, "joint": None, "limit": None})
        one = self.path(*lines, urdf=self.without_velocity("tower_2"), options=options)
        self.assertEqual(one["verdict"], "outside")
        self.assertRegex(one["message"], "The speed of 'tower_2' is not held against a limit: it has none\\.$")
        aside = self.path(*lines, options=(*options, "--joint-speeds-off"))
        self.assertEqual(aside["verdict"], "inside")
        self.assertRegex(aside["message"], "Joint speeds are not held against a limit: they are left aside\\.$")

    def test_without_a_speed_nothing_is_said(self):
        answer = self.path("start 0 0 0", "line 0 0 0.05", options=("--psi", "auto"))
        self.assertNotIn("rates", answer)
        self.assertNotIn("rates", answer["segments"][0])
        self.assertEqual(answer["message"], "Proved: every point of the path is in the set.")

    def test_what_is_out_of_range_or_without_effect(self):
        for options, phrase in (
            (("--joint-acceleration-max", 1), "joint_acceleration_max is without effect: give tool_speed too, or ask "
             "for largest_feed"),
            (("--joint-speeds-off", ), "joint_speeds_off is without effect: joint speeds are held at a tool_speed"),
            (("--tool-speed", 1, "--joint-acceleration-max", 0), r"joint-acceleration-max.*> 0 m/s\^2"),
            (("--tool-speed", 1, "--joint-acceleration-max", 1, 2), "joint-acceleration-max"),
            (("--tool-speed", 0), "tool-speed 0: 0 is out of range; allowed: from 1e-09 to 1000000000 m/s")):
            with self.subTest(options):
                self.assertRegex(self.refused(*options), phrase)


if __name__ == "__main__":
    unittest.main()
