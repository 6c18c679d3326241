#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a Python client of the node does: asks for a region, and reads the latched topics."""

import math
import unittest

import rospy
import rostest
from pkm_workspace.msg import CriterionRequest, ErrorCode, JointRanges, Region, RegionRequest
from pkm_workspace.srv import ComputeLargestRegion, GetRegion

NODE = "/pkm_workspace_node"
PATIENCE = 60.0
LARGEST_EDGE = 1.0 / math.sqrt(6.0) + 1.0 / (3.0 * math.sqrt(2.0))  # of the Orthoglide with psi in [0.5, 2] [m]


def service(name, kind):
    rospy.wait_for_service(f"{NODE}/{name}", PATIENCE)
    return rospy.ServiceProxy(f"{NODE}/{name}", kind)


class ClientTest(unittest.TestCase):
    def test_asks_for_a_region(self):
        compute = service("compute_largest_region", ComputeLargestRegion)
        response = compute(RegionRequest(shape=Region.CUBE, accuracy=1e-4))
        self.assertEqual(ErrorCode.SUCCESS, response.error_code, response.message)
        region = response.region
        self.assertEqual(Region.PROVEN, region.status)
        self.assertLessEqual(region.size, LARGEST_EDGE)
        self.assertGreaterEqual(region.size_upper_bound, LARGEST_EDGE)
        self.assertLessEqual(region.size_upper_bound - region.size, 1e-4)
        self.assertEqual((region.size,) * 3, region.solid.dimensions)

    def test_reads_the_last_answer_three_ways(self):
        computed = service("compute_largest_region", ComputeLargestRegion)(RegionRequest()).region
        got = service("get_region", GetRegion)().region
        latched = rospy.wait_for_message(f"{NODE}/region", Region, PATIENCE)
        ranges = rospy.wait_for_message(f"{NODE}/joint_ranges", JointRanges, PATIENCE)
        self.assertEqual(computed, got)
        self.assertEqual(computed.header.stamp, latched.header.stamp)
        self.assertEqual(computed.size, latched.size)
        self.assertEqual(computed.joint_ranges, ranges.rails)

    def test_is_told_what_is_wrong(self):
        request = RegionRequest(criterion=CriterionRequest(psi_min=-1.0))
        response = service("compute_largest_region", ComputeLargestRegion)(request)
        self.assertEqual(ErrorCode.INVALID_REQUEST, response.error_code)
        self.assertRegex(response.message, r"psi_min = -1 .*must be positive")


if __name__ == "__main__":
    rospy.init_node("client_test")
    rostest.rosrun("pkm_workspace", "client", ClientTest)
