#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""While a computation runs for longer than anyone waits, get_region answers at once, and an interrupt ends the node."""

import contextlib
import threading
import unittest

import rospy
import rostest
from node_process import NAME, PATIENCE, NodeProcess, urdf, wait_until
from pkm_workspace.msg import CriterionRequest, ErrorCode, Region, RegionRequest
from pkm_workspace.srv import ComputeConditioning, ComputeLargestRegion, GetRegion, SetCriterion

# Proofs of round regions to the last digits take thousands of parts each.
ENDLESS = {"shape": "sphere", "joint_limits": True, "accuracy": 1e-14}


def service(name, kind):
    rospy.wait_for_service(f"{NAME}/{name}", PATIENCE)
    return rospy.ServiceProxy(f"{NAME}/{name}", kind)


def ask_for_the_endless():
    compute = service("compute_largest_region", ComputeLargestRegion)
    with contextlib.suppress(rospy.ServiceException):  # the node may end before it has answered
        limits = CriterionRequest(joint_limits=CriterionRequest.ON)
        compute(RegionRequest(shape="sphere", accuracy=1e-14, criterion=limits))


def ask_for_the_endless_mean():
    with contextlib.suppress(rospy.ServiceException):
        service("compute_conditioning", ComputeConditioning)(accuracy=1e-12)


class LongComputationTest(unittest.TestCase):
    def test_get_region_is_not_ready_before_the_first_answer(self):
        with NodeProcess(urdf("uranesx"), {**ENDLESS, "time_limit": 86400}) as node:
            response = service("get_region", GetRegion)()
            self.assertEqual(ErrorCode.NOT_READY, response.error_code)
            self.assertRegex(response.message, "still running: largest sphere")
            node.interrupt()
            self.assertEqual(0, node.wait()[0])

    def test_get_region_is_ready_when_the_time_limit_is_over(self):
        with NodeProcess(urdf("uranesx"), {**ENDLESS, "time_limit": 1.0}):
            get_region = service("get_region", GetRegion)
            wait_until(lambda: get_region().error_code == ErrorCode.SUCCESS)
            region = get_region().region
            self.assertEqual(Region.STOPPED, region.status)
            self.assertGreater(region.size, 0.3)
            self.assertGreater(region.size_upper_bound, region.size + 1e-14)

    def test_another_criterion_ends_what_is_stale(self):
        with NodeProcess(urdf("uranesx"), {**ENDLESS, "time_limit": 86400}) as node:
            set_criterion = service("set_criterion", SetCriterion)
            node.wait_for_output("accuracy 1e-14")
            off = CriterionRequest(joint_limits=CriterionRequest.OFF)
            self.assertEqual(ErrorCode.SUCCESS, set_criterion(off, 1e-3).error_code)
            get_region = service("get_region", GetRegion)
            wait_until(lambda: get_region().error_code == ErrorCode.SUCCESS)
            region = get_region().region
            self.assertEqual((Region.PROVEN, False), (region.status, region.hypotheses.joint_limits))

    def test_an_interrupt_ends_a_mean_over_millions_of_boxes(self):
        with NodeProcess(urdf("orthoglide"), {"time_limit": 86400}) as node:
            endless = threading.Thread(target=ask_for_the_endless_mean, daemon=True)
            endless.start()
            node.wait_for_output("computing: global conditioning index")
            node.interrupt()
            self.assertEqual(0, node.wait()[0])
            endless.join(PATIENCE)
            self.assertFalse(endless.is_alive())

    def test_the_memory_of_the_node_ends_a_mean(self):
        with NodeProcess(urdf("orthoglide"), {"time_limit": 86400, "max_memory": 1000000}):
            response = service("compute_conditioning", ComputeConditioning)(accuracy=1e-9)
            self.assertEqual((ErrorCode.SUCCESS, False), (response.error_code, response.complete))
            self.assertRegex(response.message, "the limit of 1000000 bytes of memory ended it")
            self.assertLess(0.0, response.index.lower)

    def test_get_region_answers_while_a_request_is_computed(self):
        with NodeProcess(urdf("uranesx"), {"shape": "square", "time_limit": 86400}) as node:
            get_region = service("get_region", GetRegion)
            wait_until(lambda: get_region().error_code == ErrorCode.SUCCESS)
            before = get_region().region
            endless = threading.Thread(target=ask_for_the_endless, daemon=True)
            endless.start()
            node.wait_for_output("accuracy 1e-14")
            self.assertEqual([before] * 10, [get_region().region for _ in range(10)])
            node.interrupt()
            self.assertEqual(0, node.wait()[0])
            endless.join(PATIENCE)
            self.assertFalse(endless.is_alive())


if __name__ == "__main__":
    rospy.init_node("long_computation_test")
    rostest.rosrun("pkm_workspace", "long_computation", LongComputationTest)
