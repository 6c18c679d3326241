#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""~reload takes another robot_description; until its answer stands the old one is there."""

import unittest

import rospy
import rostest
from node_process import NAME, PATIENCE, NodeProcess, urdf, wait_until
from pkm_workspace.msg import ErrorCode, Region
from pkm_workspace.srv import EvaluatePoint, EvaluatePointRequest, GetRegion, Reload


def service(name, kind):
    rospy.wait_for_service(f"{NAME}/{name}", PATIENCE)
    return rospy.ServiceProxy(f"{NAME}/{name}", kind)


def machine_of(name, kind, *request):
    return getattr(service(name, kind)(*request), "hypotheses").machine


class ReloadTest(unittest.TestCase):
    def reload(self):
        return service("reload", Reload)()

    def region(self):
        wait_until(lambda: service("get_region", GetRegion)().error_code == ErrorCode.SUCCESS)
        return service("get_region", GetRegion)().region

    def test_takes_another_machine(self):
        with NodeProcess(urdf("orthoglide")):
            old = self.region()
            rospy.set_param("/robot_description", urdf("orthoglide_prototype"))
            answer = self.reload()
            self.assertEqual(ErrorCode.SUCCESS, answer.error_code, answer.message)
            self.assertEqual("orthoglide_prototype", answer.hypotheses.machine)
            new = service("get_region", GetRegion)()
            self.assertEqual(ErrorCode.SUCCESS, new.error_code, "its answer does not stand at once")
            self.assertEqual(answer.hypotheses.geometry_hash, new.region.hypotheses.geometry_hash)
            self.assertNotEqual(old.hypotheses.geometry_hash, new.region.hypotheses.geometry_hash)
            self.assertAlmostEqual(0.31058, new.region.size / old.size, delta=0.01)
            latched = rospy.wait_for_message(f"{NAME}/region", Region, PATIENCE)
            self.assertEqual(new.region.hypotheses, latched.hypotheses)
            self.assertEqual("orthoglide_prototype",
                             machine_of("evaluate_point", EvaluatePoint, EvaluatePointRequest()))

    def test_takes_tolerances(self):
        with NodeProcess(urdf("orthoglide"), {"accuracy": 1e-4}):
            exact = self.region()
            self.assertEqual([], exact.hypotheses.tolerances)
            rospy.set_param(f"{NAME}/tolerance_slider", 1e-4)
            rospy.set_param(f"{NAME}/tolerance_length", [1e-4] * 3)
            answer = self.reload()
            self.assertEqual(ErrorCode.SUCCESS, answer.error_code, answer.message)
            robust = self.region()
            self.assertLessEqual(robust.size, 0.6436538)
            self.assertGreaterEqual(robust.size_upper_bound, 0.6436518)
            self.assertLess(robust.size_upper_bound, exact.size)
            self.assertEqual([("tolerance_length", (1e-4, ), "m"), ("tolerance_slider", (1e-4, ), "m")],
                             [(it.kind, tuple(it.values), it.unit) for it in robust.hypotheses.tolerances])
            rospy.set_param(f"{NAME}/tolerance_length", -1e-4)
            answer = self.reload()
            self.assertEqual(ErrorCode.INVALID_REQUEST, answer.error_code)
            self.assertIn("tolerance_length", answer.message)
            for name in ("tolerance_slider", "tolerance_length"):
                rospy.delete_param(f"{NAME}/{name}")

    def test_refuses_what_would_not_start_and_changes_nothing(self):
        with NodeProcess(urdf("orthoglide")):
            old = self.region()
            for text, reason in (("<robot name='stool'><link name='seat'/></robot>", "0 prismatic joints"),
                                 ("<robot", "not well-formed XML")):
                rospy.set_param("/robot_description", text)
                answer = self.reload()
                self.assertEqual(ErrorCode.INVALID_REQUEST, answer.error_code)
                self.assertIn(reason, answer.message)
                self.assertEqual(old, self.region())

    def test_reloads_as_often_as_asked_and_ends(self):
        with NodeProcess(urdf("orthoglide"), {"accuracy": 0.01}) as node:
            self.region()
            for _ in range(5):
                self.assertEqual(ErrorCode.SUCCESS, self.reload().error_code)
            node.interrupt()
            code, _ = node.wait()
            self.assertEqual(0, code)


if __name__ == "__main__":
    rospy.init_node("reload_test")
    rostest.rosrun("pkm_workspace", "reload", ReloadTest)
