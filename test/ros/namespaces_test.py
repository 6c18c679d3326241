#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The launch files of two machines in two namespaces, each with its own tf_prefix: they do not know of each other."""

import unittest

import rospy
import rostest
from pkm_workspace.msg import ErrorCode, Region, RegionRequest
from pkm_workspace.srv import ComputeLargestRegion
from sensor_msgs.msg import JointState
from visualization_msgs.msg import MarkerArray

PATIENCE = 60.0
MACHINES = {
    "left": ("orthoglide", Region.CUBE, 0.643950551, 0.0),
    "right": ("uranesx", Region.SQUARE, 0.51949, 1e-5),  # a search value: good to 1e-5
}


class NamespacesTest(unittest.TestCase):
    def test_each_answers_for_its_own_machine(self):
        for namespace, (machine, shape, size, slack) in MACHINES.items():
            region = rospy.wait_for_message(f"/{namespace}/pkm_workspace_node/region", Region, PATIENCE)
            self.assertEqual(machine, region.hypotheses.machine)
            self.assertEqual(shape, region.shape)
            self.assertEqual(f"{namespace}/base_link", region.header.frame_id)
            self.assertLessEqual(region.size, size + slack)
            self.assertGreaterEqual(region.size_upper_bound, size - slack)

    def test_each_publishes_in_its_own_frame(self):
        for namespace in MACHINES:
            markers = rospy.wait_for_message(f"/{namespace}/pkm_workspace_node/markers", MarkerArray, PATIENCE).markers
            self.assertEqual({f"{namespace}/base_link"}, {marker.header.frame_id for marker in markers})
            joints = rospy.wait_for_message(f"/{namespace}/joint_states", JointState, PATIENCE)
            region = rospy.wait_for_message(f"/{namespace}/pkm_workspace_node/region", Region, PATIENCE)
            self.assertLess({rail.joint for rail in region.joint_ranges}, set(joints.name))

    def test_each_knows_only_its_own_frame(self):
        name = "/left/pkm_workspace_node/compute_largest_region"
        rospy.wait_for_service(name, PATIENCE)
        request = RegionRequest()
        request.header.frame_id = "right/base_link"
        response = rospy.ServiceProxy(name, ComputeLargestRegion)(request)
        self.assertEqual(ErrorCode.UNKNOWN_FRAME, response.error_code)
        self.assertRegex(response.message, "'right/base_link' is not (known|connected).*'left/base_link'")


if __name__ == "__main__":
    rospy.init_node("namespaces_test")
    rostest.rosrun("pkm_workspace", "namespaces", NamespacesTest)
