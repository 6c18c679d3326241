#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Python client: keywords for what requests hold, its exceptions, paths with arcs, and what becomes of goals whose
node dies, in both clients."""

import subprocess
import threading
import unittest

import roslib.packages
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from node_process import NAME, PATIENCE, NodeProcess, urdf
from pkm_workspace.client import Client, Refused, arc, line, turn
from pkm_workspace.msg import CriterionRequest, ErrorCode, Region
from shape_msgs.msg import SolidPrimitive

ENDLESS = {"set": "reachable", "resolution": 1e-4, "time_limit": 86400.0}  # a paving


class ClientsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.node = NodeProcess(urdf("orthoglide"))
        cls.machine = Client(NAME, PATIENCE)

    @classmethod
    def tearDownClass(cls):
        cls.node.__exit__()

    def test_keywords_are_fields_of_request_and_criterion(self):
        region = self.machine.largest_region(shape="box", proportions=(2, 1, 1), psi_min=0.4, kappa_max=4,
                                             joint_limits=False, frame="base_link", accuracy=0.01)
        self.assertEqual(region.shape, Region.BOX)
        self.assertEqual((region.proportions.x, region.proportions.y), (2, 1))
        said = region.hypotheses
        self.assertEqual((said.psi_min, said.psi_max, said.kappa_max, said.joint_limits), (0.4, 2, 4, False))
        cylinder = self.machine.largest_region(shape="cylinder", ratio=(1, 1), accuracy=0.01).solid.dimensions
        self.assertAlmostEqual(cylinder[0], cylinder[1], places=12)
        standing = self.machine.largest_region(shape="box", footprint=(0.1, 0.2), base_z=-0.25, accuracy=0.01)
        self.assertEqual((standing.base_z, list(standing.solid.dimensions[:2])), (-0.25, [0.1, 0.2]))
        turned = self.machine.largest_region(shape="square", turned=True, accuracy=0.01)
        self.assertTrue(turned.turned)
        self.assertFalse(self.machine.largest_region(shape="square", turned=False, accuracy=0.01).turned)
        corners = [(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.1)]
        self.assertEqual(self.machine.check_polytope((0, 0, 0), corners).verdict, self.machine.INSIDE)
        self.assertEqual(self.machine.largest_region(center=(0.125, 0, 0), accuracy=0.01).center.x, 0.125)
        near = self.machine.largest_region(search_box=((0, 0, 0), (0.05, 0.05, 0.05)), accuracy=0.01)
        self.assertLessEqual(max(near.center.x, near.center.y, near.center.z), 0.05)
        both = self.machine.largest_region(criterion=CriterionRequest(psi_min=0.4), psi_max=2.5, accuracy=0.01)
        self.assertEqual((both.hypotheses.psi_min, both.hypotheses.psi_max), (0.4, 2.5))
        self.assertEqual(self.machine.evaluate((0, 0, 0), set="reachable").hypotheses.psi_min, 0)
        self.assertEqual(self.machine.check_box((0, 0, 0), (0.1, 0.1, 0.1), psi_max=1.001).verdict, Client.OUTSIDE)

    def test_paths_have_arcs(self):
        start, over, end = (0.1, 0, 0), (0.0, 0.1, 0), (-0.1, 0, 0)
        way = [line((0, 0, 0), start), arc(start, over, end), turn(end, (0, 0, 0), (0, 0, 1), 3.0, 0.05)]
        answer = self.machine.check_path(way, tool_speed=0.1)
        self.assertEqual((answer.verdict, len(answer.segment_verdicts)), (Client.INSIDE, 3))
        self.assertEqual(self.machine.check_line([(0, 0, 0), (0.9, 0.9, 0)]).verdict, Client.OUTSIDE)
        for most in (1, (1, 1, 1)):
            way = [(0, 0, 0), (0.1, 0, 0)]
            rates = self.machine.check_line(way, largest_feed=True, joint_acceleration_max=most).rates
            self.assertEqual([*rates.acceleration_max], [1, 1, 1])
            self.assertGreater(rates.feed.lower, 0)

    def test_places_paths(self):
        way = [line((5, 0, 0), (5.2, 0, 0)), arc((5.2, 0, 0), (5.1, 0.1, 0), (5, 0, 0))]
        found = self.machine.place_path(way, largest_scale=True, tool_speed=0.1)
        self.assertEqual(found.status, found.PROVEN)
        self.assertLess(0.1, found.margin)
        self.assertLessEqual(found.margin, found.margin_upper_bound)
        self.assertLessEqual(1, found.scale)
        self.assertLessEqual(found.scale, found.scale_upper_bound)
        shift = found.translation
        there = [line(*([p.x + shift.x, p.y + shift.y, p.z + shift.z] for p in (way[0].start, way[0].end)))]
        self.assertEqual(self.machine.check_path(there, tool_speed=0.1).verdict, Client.INSIDE)
        far = self.machine.place_path(way, box=((0, 0, 0), (1, 1, 1)))
        self.assertEqual((far.status, far.margin_upper_bound), (far.NONE, 0))
        with self.assertRaisesRegex(Refused, "accuracy"):
            self.machine.place_path(way, accuracy=-1)
        with self.assertRaisesRegex(Refused, "joint_speeds_off"):
            self.machine.place_path(way, joint_speeds_off=True)

    def test_checks_jobs(self):
        job = "G90 G1 F600 X0 Y0 Z0\nX100\nX900 Y900\n"
        answer = self.machine.check_gcode(job, tool_at=(0, 0, 0), most_listed=5)
        self.assertEqual((answer.verdict, answer.lines, answer.moves), (Client.OUTSIDE, 3, 2))
        self.assertEqual([(line.line, line.verdict) for line in answer.offences], [(3, Client.OUTSIDE)])
        at = self.machine.check_gcode(job[:-12], origin=(0.1, 0, 0), work_offsets=[(0, 0, 0.1)])
        self.assertEqual(at.verdict, Client.INSIDE)
        with self.assertRaisesRegex(Refused, "gcode:2: .*G81"):
            self.machine.check_gcode("G1 X0 F600\nG81 X1\n")

    def test_exports_limits(self):
        box = SolidPrimitive(SolidPrimitive.BOX, [0.2, 0.2, 0.2])
        limits = self.machine.export_limits("linuxcnc", (0.1, 0, 0), box)
        self.assertEqual(len(limits.keys), 6)
        self.assertIn("[AXIS_X]\nMIN_LIMIT = ", limits.text)
        with self.assertRaisesRegex(Refused, "cannot be held"):
            self.machine.export_limits("klipper", (0.1, 0, 0), box)

    def test_hangs_sets_together(self):
        found = self.machine.workspace(resolution=0.1, components=True, connect=[(0, 0, 0), (0.2, 0.1, 0)])
        self.assertEqual((found.connection, found.zero_component), (found.CONNECTED, 0))
        self.assertGreater(len(found.connection_path), 1)
        tilted = self.machine.largest_region(accuracy=0.01, ball_tilt_max=0.5, strut_tilt_max=(0.3, 0.4, 0.5),
                                             ball_axes=[(1, 0, 0), (0, 1, 0), (0, 0, 1)]).hypotheses
        self.assertEqual(list(tilted.strut_tilt_max), [0.3, 0.4, 0.5])
        self.assertEqual([axis.x for axis in tilted.ball_axes], [1, 0, 0])

    def test_asks_of_all_machines_within_tolerances(self):
        built = {"tolerance_length": 1e-3, "tolerance_slider": [1e-3, 0, 0]}
        exact = self.machine.largest_region(accuracy=0.001)
        robust = self.machine.largest_region(accuracy=0.001, tolerances=built)
        self.assertLess(robust.size_upper_bound, exact.size)
        self.assertEqual([(it.kind, list(it.values)) for it in robust.hypotheses.tolerances],
                         [("tolerance_length", [1e-3]), ("tolerance_slider", [1e-3, 0, 0])])
        box = SolidPrimitive(SolidPrimitive.BOX, [0.2, 0.2, 0.2])
        with self.assertRaisesRegex(Refused, "believes the tool to be"):
            self.machine.export_limits("linuxcnc", (0.1, 0, 0), box, tolerances=built)
        with self.assertRaisesRegex(Refused, "~reload"):
            self.machine.set_criterion(tolerances=built)
        self.assertEqual(self.machine.evaluate((0, 0, 0), own_tolerances=False).hypotheses.tolerances, [])

    def test_sets_the_criterion(self):
        self.assertEqual(self.machine.set_criterion(psi_min=0.4, accuracy=0.02).psi_min, 0.4)
        said = self.machine.largest_region().hypotheses
        self.assertEqual((said.psi_min, said.accuracy), (0.4, 0.02))
        self.machine.set_criterion(psi_min=0.5)

    def test_wrong_words_and_types_are_type_errors(self):
        for fields, reason in (({"psi": "best"}, "psi = 'best'"),
                               ({"psy_min": 0.3}, "psy_min is not a field of Region"),
                               ({"psi_min": "small"}, "psi_min"), ({"accuracy": "fine"}, "accuracy"),
                               ({"shape": 3}, "shape"), ({"proportions": (1, 2)}, ""), ({"proportions": "abc"}, "")):
            with self.subTest(fields), self.assertRaisesRegex(TypeError, reason):
                self.machine.largest_region(**fields)
        with self.assertRaises(TypeError):
            self.machine.check_box(("x", 0, 0), (1, 1, 1))
        with self.assertRaises(Refused) as refused:
            self.machine.largest_region(psi_min=-1.0)
        self.assertEqual(refused.exception.error_code, ErrorCode.INVALID_REQUEST)
        with self.assertRaises(rospy.ROSException):
            Client("/nobody", 0.1).last_region()


class GoalsTest(unittest.TestCase):
    def test_goal_ends_when_its_node_does(self):
        with NodeProcess(urdf("orthoglide")) as node:
            running = threading.Event()
            goal = Client(NAME, PATIENCE).approximate_workspace(lambda _: running.set(), **ENDLESS)
            self.assertTrue(running.wait(PATIENCE))
            self.assertFalse(goal.wait_for_result(1.5))
            node.process.kill()
            self.assertTrue(goal.wait_for_result(PATIENCE))
            self.assertEqual((goal.get_state(), goal.get_result()), (GoalStatus.LOST, None))
        with NodeProcess(urdf("orthoglide")) as node:
            program = roslib.packages.find_node("pkm_workspace", "client_goal")[0]
            with subprocess.Popen([program], stdout=subprocess.PIPE, text=True) as client:
                self.assertEqual(client.stdout.readline(), "running\n")
                node.process.kill()
                self.assertEqual(client.stdout.read().split()[-1], "lost")


if __name__ == "__main__":
    rospy.init_node("clients_test")
    rostest.rosrun("pkm_workspace", "clients", "__main__")
