#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Goals of both actions: their feedback, what is left of them when they are cancelled, and who comes first."""

import threading
import time
import unittest

import actionlib
import rosgraph
import roslib.message
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from pkm_workspace.client import Goal
from pkm_workspace.msg import (ApproximateWorkspaceAction, ApproximateWorkspaceGoal, CriterionRequest, ErrorCode,
                               FindLargestRegionAction, FindLargestRegionGoal, PavingRequest, Region, RegionRequest,
                               Workspace)
from pkm_workspace.srv import ComputeLargestRegion, ComputeWorkspace
from visualization_msgs.msg import Marker, MarkerArray

NODE = "/pkm_workspace_node"
PATIENCE = 60.0
LIMITS = CriterionRequest(joint_limits=CriterionRequest.ON)
FREE = CriterionRequest(joint_limits=CriterionRequest.OFF)
# Proofs of round regions to the last digits take thousands of parts each.
ENDLESS = FindLargestRegionGoal(RegionRequest(shape="sphere", criterion=LIMITS, accuracy=1e-14, time_limit=86400.0))
ENDLESS_PAVING = ApproximateWorkspaceGoal(PavingRequest(criterion=LIMITS, resolution=1e-4, time_limit=86400.0))


class Sender:
    """Sends one goal: a SimpleActionClient may miss the end of one that ends at once."""

    def __init__(self, name, kind):
        self.client = actionlib.ActionClient(f"{NODE}/{name}", kind)
        self.goal = None
        assert self.client.wait_for_server(rospy.Duration(PATIENCE)), name

    def send_goal(self, goal, feedback_cb=None):
        self.goal = Goal(self.client, goal, feedback_cb, None)

    def cancel_goal(self):
        self.goal.cancel_goal()

    def get_state(self):
        return self.goal.get_state()

    def result(self):
        """What the goal ends with, once it has ended."""
        assert self.goal.wait_for_result(PATIENCE)
        return self.goal.get_result()


def finder():
    return Sender("find_largest_region", FindLargestRegionAction)


def paver():
    return Sender("approximate_workspace", ApproximateWorkspaceAction)


def service(name, kind):
    rospy.wait_for_service(f"{NODE}/{name}", PATIENCE)
    return rospy.ServiceProxy(f"{NODE}/{name}", kind)


class Feedback:
    """Sends a goal and keeps the first feedback that fits."""

    def __init__(self, client, goal, fits):
        self.there = threading.Event()
        self.message = None
        client.send_goal(goal, feedback_cb=lambda message: self.look(message, fits))

    def look(self, message, fits):
        if fits(message) and not self.there.is_set():
            self.message = message
            self.there.set()


class ActionsTest(unittest.TestCase):
    def diagnosis(self, question):
        """The status of the last computation, once it is that question."""
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline:
            for status in rospy.wait_for_message("/diagnostics", DiagnosticArray, PATIENCE).status:
                if any(value.key == "question" and question in value.value for value in status.values):
                    return status
        raise AssertionError(f"no diagnosis of {question}")

    def start(self, client, goal, fits):
        feedback = Feedback(client, goal, fits)
        self.assertTrue(feedback.there.wait(PATIENCE), "no feedback came")
        return feedback.message

    def test_finds_what_the_service_finds(self):
        client = finder()
        client.send_goal(FindLargestRegionGoal(RegionRequest(accuracy=1e-4)))
        result = client.result()
        self.assertEqual(GoalStatus.SUCCEEDED, client.get_state())
        self.assertEqual(ErrorCode.SUCCESS, result.error_code)
        self.assertEqual(Region.PROVEN, result.region.status)
        region = service("compute_largest_region", ComputeLargestRegion)(RegionRequest(accuracy=1e-4)).region
        self.assertEqual(region.size, result.region.size)
        self.assertEqual(region.size_upper_bound, result.region.size_upper_bound)

    def test_tells_how_far_it_is_and_keeps_it_when_cancelled(self):
        client = finder()
        feedback = self.start(client, ENDLESS, lambda message: message.size > 0.0)
        self.assertGreaterEqual(feedback.size_upper_bound, feedback.size)
        self.assertGreater(feedback.boxes_done + feedback.boxes_open, 0)
        client.cancel_goal()
        result = client.result()
        self.assertEqual(GoalStatus.PREEMPTED, client.get_state())
        self.assertEqual(ErrorCode.SUCCESS, result.error_code)
        self.assertEqual(Region.STOPPED, result.region.status)
        self.assertGreaterEqual(result.region.size, feedback.size)
        self.assertLessEqual(result.region.size_upper_bound, feedback.size_upper_bound)
        self.assertEqual(DiagnosticStatus.WARN, self.diagnosis("accuracy 1e-14").level)

    def test_a_new_goal_preempts_older_ones(self):
        running, waiting, last = finder(), finder(), finder()
        self.start(running, ENDLESS, lambda message: message.size > 0.0)
        waiting.send_goal(ENDLESS)
        last.send_goal(FindLargestRegionGoal(RegionRequest(accuracy=0.01)))
        self.assertEqual(Region.STOPPED, running.result().region.status)
        self.assertEqual(GoalStatus.PREEMPTED, running.get_state())
        waiting.result()
        self.assertIn(waiting.get_state(), (GoalStatus.PREEMPTED, GoalStatus.RECALLED))
        self.assertEqual(Region.PROVEN, last.result().region.status)
        self.assertEqual(GoalStatus.SUCCEEDED, last.get_state())

    def test_refuses_bad_goals(self):
        for client, goal, message in [
            (finder(), FindLargestRegionGoal(RegionRequest(accuracy=-1.0)), "accuracy = -1"),
            (finder(), FindLargestRegionGoal(RegionRequest(time_limit=86401.0)),
             "time_limit = 86401 s must be positive and at most 86400 s, or 0 for the node's ~time_limit, 60 s"),
            (paver(), ApproximateWorkspaceGoal(PavingRequest(criterion=CriterionRequest(aspect=4))),
             "aspect = 4 must be OWN"),
        ]:
            client.send_goal(goal)
            result = client.result()
            self.assertEqual(GoalStatus.ABORTED, client.get_state())
            self.assertEqual(ErrorCode.INVALID_REQUEST, result.error_code)
            self.assertRegex(result.message, message)

    def test_paves_with_feedback_until_it_is_cancelled(self):
        client = paver()
        feedback = self.start(client, ENDLESS_PAVING, lambda message: message.boxes > 0)
        self.assertGreater(feedback.boxes_per_second, 0.0)
        self.assertGreater(feedback.volume_boundary, 0.0)
        client.cancel_goal()
        workspace = client.result().workspace
        self.assertEqual(GoalStatus.PREEMPTED, client.get_state())
        self.assertFalse(workspace.complete)
        self.assertGreater(workspace.boxes_pending, 0)
        self.assertLessEqual(workspace.volume_lower_bound, workspace.volume_upper_bound)

    def test_others_are_answered_while_a_goal_runs(self):
        endless = paver()
        self.start(endless, ENDLESS_PAVING, lambda message: message.boxes > 0)
        region = service("compute_largest_region", ComputeLargestRegion)(RegionRequest(accuracy=0.01)).region
        self.assertEqual(Region.PROVEN, region.status)
        client = finder()
        client.send_goal(FindLargestRegionGoal(RegionRequest(accuracy=0.01)))
        self.assertEqual(region.size, client.result().region.size)
        self.assertEqual(GoalStatus.ACTIVE, endless.get_state())
        endless.cancel_goal()
        self.assertFalse(endless.result().workspace.complete)

    def test_shows_the_set_by_verdict(self):
        computed = service("compute_workspace", ComputeWorkspace)(
            PavingRequest(criterion=FREE, resolution=0.01)).workspace
        latched = rospy.wait_for_message(f"{NODE}/workspace", Workspace, PATIENCE)
        while latched.header.stamp != computed.header.stamp:  # the answer is there first
            latched = rospy.wait_for_message(f"{NODE}/workspace", Workspace, PATIENCE)
        self.assertEqual(computed.volume_lower_bound, latched.volume_lower_bound)
        markers = rospy.wait_for_message(f"{NODE}/workspace_markers", MarkerArray, PATIENCE).markers
        self.assertEqual(Marker.DELETEALL, markers[0].action)
        self.assertEqual({"inside", "boundary"}, {marker.ns for marker in markers[1:]})
        colors = {(marker.ns, marker.color.r, marker.color.g, marker.color.b)
                  for marker in markers[1:] if marker.points}
        self.assertEqual(2, len(colors))

    def test_stock_tools_resolve_the_types(self):
        for name, action in (("find_largest_region", FindLargestRegionAction),
                             ("approximate_workspace", ApproximateWorkspaceAction)):
            finder(), paver()
            goal_type = dict(rosgraph.Master(rospy.get_name()).getTopicTypes())[f"{NODE}/{name}/goal"]
            self.assertTrue(goal_type.endswith("Goal"))
            self.assertIs(action, roslib.message.get_message_class(goal_type[:-len("Goal")]))


if __name__ == "__main__":
    rospy.init_node("actions_test")
    rostest.rosrun("pkm_workspace", "actions", ActionsTest)
