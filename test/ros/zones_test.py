#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Zones to keep in and out of: the node's own and those of requests, in the root's frame and in others."""

import math
import unittest

import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import TransformStamped
from node_process import NAME, PATIENCE, NodeProcess, urdf
from pkm_workspace.client import Client, Refused, line, zone
from pkm_workspace.msg import BindingLimit, CriterionRequest, ToolZone
from visualization_msgs.msg import Marker, MarkerArray

ROOM = {"kind": "box", "name": "room", "center": [0.01, 0.02, 0.03], "sides": [0.4, 0.3, 0.35]}
COLUMN = {"kind": "cylinder", "name": "column", "center": [0.5, 0, 0], "radius": 0.05, "height": 9}
PILLAR = zone("keep_out", "box", "pillar", center=(0.1, 0, 0.1), sides=(0.1, 0.1, 0.1))
COLLISION = """<collision><origin xyz="0.1 0 0.1" rpy="0 0 0"/><geometry>{}</geometry></collision>"""


def with_collision(geometry):
    """The Orthoglide with this at its root link."""
    link = '<link name="base_link">'
    return urdf("orthoglide").replace(link, link + COLLISION.format(geometry), 1)


class ZonesOfRequests(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.node = NodeProcess(urdf("orthoglide"))
        cls.machine = Client(NAME, PATIENCE)
        cls.broadcaster = tf2_ros.StaticTransformBroadcaster()
        table = TransformStamped(child_frame_id="table")
        table.header.frame_id = "base_link"
        table.transform.translation.x = 0.3
        table.transform.rotation.z, table.transform.rotation.w = math.sin(0.2), math.cos(0.2)
        cls.broadcaster.sendTransform(table)

    @classmethod
    def tearDownClass(cls):
        cls.node.__exit__()

    def test_bound_regions_points_and_paths(self):
        room = zone("keep_in", **ROOM)
        region = self.machine.largest_region(zones=[room], accuracy=1e-6)
        self.assertLessEqual(region.size, 0.3)
        self.assertGreaterEqual(region.size_upper_bound, 0.3)
        self.assertLess(region.size_upper_bound - region.size, 1.1e-6)
        self.assertEqual([said.name for said in region.hypotheses.zones], ["room"])
        self.assertEqual(region.hypotheses.zones[0].sides.z, 0.35)
        smaller = self.machine.largest_region(zones=[room], tool_radius=0.02, accuracy=1e-6)
        self.assertAlmostEqual(smaller.size, 0.26, delta=2e-6)
        self.assertEqual(smaller.hypotheses.tool_radius, 0.02)
        there = self.machine.evaluate((0.1, 0, 0.1), zones=[PILLAR])
        self.assertEqual((there.verdict, there.limit.kind, there.limit.zone),
                         (Client.OUTSIDE, BindingLimit.KEEP_OUT, "box 'pillar'"))
        self.assertAlmostEqual(there.limit.value.lower, -0.05)
        way = [line((0, 0, 0), (0.2, 0, 0.2))]
        self.assertEqual(self.machine.check_path(way).verdict, Client.INSIDE)
        self.assertEqual(self.machine.check_path(way, zones=[PILLAR]).verdict, Client.OUTSIDE)

    def test_stand_in_the_frame_of_the_request_or_in_the_root(self):
        here = zone("keep_in", **ROOM)
        in_table = self.machine.largest_region(zones=[here], frame="table", accuracy=1e-5)
        self.assertLessEqual(in_table.size, 0.3, "the room is along the axes of the table")
        self.assertGreaterEqual(in_table.size_upper_bound, 0.3)
        self.assertFalse(in_table.hypotheses.zones[0].in_root)
        there = zone("keep_in", **ROOM, in_root=True)
        of_root = self.machine.largest_region(zones=[there], frame="table", accuracy=1e-5)
        edge = 0.3 / (math.sin(0.4) + math.cos(0.4))  # of a square turned within a strip
        self.assertLessEqual(of_root.size, edge + 1e-9)
        self.assertGreaterEqual(of_root.size_upper_bound, edge - 1e-9)
        self.assertTrue(of_root.hypotheses.zones[0].in_root)

    def test_are_refused_with_their_place(self):
        def refused(pattern, **fields):
            with self.assertRaisesRegex(Refused, pattern):
                self.machine.largest_region(**fields)

        refused(r"zones\[1\]: kind = 9 must be BOX = 1", zones=[PILLAR, ToolZone(use=1, kind=9)])
        refused(r"zones\[0\]: use = 0 must be KEEP_IN = 1 or KEEP_OUT = 2", zones=[ToolZone(kind=1)])
        refused(r"radius must be 0: a box has only name, pose.position, sides, pose.orientation",
                zones=[zone("keep_out", "box", sides=(1, 1, 1), radius=0.5)])
        refused(r"a box needs sides", zones=[zone("keep_out", "box")])
        refused(r"its radius \[m\] must be positive", zones=[zone("keep_out", "sphere", radius=-1)])
        refused(r"tool_radius = 0.1 m is without effect", tool_radius=0.1)
        refused(r"leaves nothing of it", zones=[zone("keep_in", **ROOM)], tool_radius=0.2)
        refused(r"at most 32 are allowed", zones=33 * [PILLAR])
        self.assertRaises(TypeError, zone, "keep_off", "box")
        self.assertRaises(TypeError, zone, "keep_in", "box", width=1)


class ZonesOfTheNode(unittest.TestCase):
    def test_count_in_every_answer(self):
        with NodeProcess(urdf("orthoglide"), {"keep_in": [ROOM], "keep_out": [COLUMN], "tool_radius": 0.02}):
            machine = Client(NAME, PATIENCE)
            own = machine.largest_region(accuracy=1e-6)
            self.assertAlmostEqual(own.size, 0.26, delta=2e-6)
            self.assertEqual([said.name for said in own.hypotheses.zones], ["room", "column"])
            free = machine.largest_region(own_zones=False, accuracy=1e-4)
            self.assertGreater(free.size, 0.6)
            self.assertEqual((len(free.hypotheses.zones), free.hypotheses.tool_radius), (0, 0))
            both = machine.largest_region(zones=[PILLAR], tool_radius=math.inf, accuracy=1e-4)
            self.assertEqual(len(both.hypotheses.zones), 3)
            self.assertLess(both.size, 0.3)
            shown = rospy.wait_for_message(f"{NAME}/markers", MarkerArray, PATIENCE).markers
            self.assertEqual([mark.type for mark in shown if mark.ns == "zones"], [Marker.CUBE, Marker.CYLINDER])
            machine.set_criterion(own_zones=False)
            self.assertGreater(machine.largest_region(accuracy=1e-4).size, 0.6)

    def test_that_are_set_stay_in_the_root(self):
        with NodeProcess(urdf("orthoglide")):
            machine = Client(NAME, PATIENCE)
            table = TransformStamped(child_frame_id="shifted")
            table.header.frame_id = "base_link"
            table.transform.translation.x, table.transform.rotation.w = 0.3, 1.0
            broadcaster = tf2_ros.StaticTransformBroadcaster()
            broadcaster.sendTransform(table)
            machine.set_criterion(zones=[PILLAR])
            edges = (0.02, 0.02, 0.02)
            self.assertEqual(machine.check_box((0.1, 0, 0.1), edges).verdict, Client.OUTSIDE)
            self.assertEqual(machine.check_box((-0.2, 0, 0.1), edges, frame="shifted").verdict, Client.OUTSIDE)
            self.assertEqual(machine.check_box((0.1, 0, 0.1), edges, frame="shifted").verdict, Client.INSIDE)

    def test_are_the_collision_geometry_of_links_that_stand_still(self):
        with NodeProcess(with_collision('<box size="0.1 0.1 0.1"/>'), {"keep_out_collisions": True}):
            there = Client(NAME, PATIENCE).evaluate((0.1, 0, 0.1))
            self.assertEqual((there.verdict, there.limit.zone), (Client.OUTSIDE, "box 'base_link'"))

    def test_bad_ones_end_the_node(self):
        for description, parameters, said in (
                (urdf("orthoglide"), {"keep_out": [{"kind": "box"}]}, "keep_out: zone 1: a box needs center"),
                (urdf("orthoglide"), {"keep_out": COLUMN}, "keep_out: it must be a list of zones"),
                (urdf("orthoglide"), {"keep_in": [{**ROOM, "sides": "wide"}]}, "sides must be a number or a list"),
                (urdf("orthoglide"), {"tool_radius": 0.1}, "tool_radius = 0.1 m is without effect"),
                (with_collision('<mesh filename="package://a/b.stl"/>'), {"keep_out_collisions": True},
                 "keep_out_collisions = true: link 'base_link' has a mesh")):
            with NodeProcess(description, parameters) as node:
                code, lines = node.wait()
            self.assertNotEqual(code, 0)
            self.assertIn(said, lines)


if __name__ == "__main__":
    rospy.init_node("zones_test")
    rostest.rosrun("pkm_workspace", "zones", "__main__")
