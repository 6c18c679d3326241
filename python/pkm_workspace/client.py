# SPDX-License-Identifier: BSD-3-Clause
"""A small client of pkm_workspace_node, for planners in Python.

    rospy.init_node("planner")
    machine = Client()                                           # of /pkm_workspace_node
    region = machine.largest_region(shape="cube", accuracy=1e-4)
    print(region.size, region.size_upper_bound)                  # certified bracket [m]
    if machine.check_box((0.1, 0.1, 0.1), (0.2, 0.2, 0.3)).verdict != machine.INSIDE:
        ...
    answer = machine.check_line([(0, 0, 0), (0.2, 0, 0), (0.2, 0.2, 0.1)])
    if answer.verdict == machine.OUTSIDE:
        print(answer.message)                                    # where along the path, and which limit binds
    print(machine.evaluate((0.1, 0, 0)).psi)                     # enclosures of the transmission factors

Lengths are metres. Every call raises Refused where the node refuses, with its error_code and message, and
rospy.ServiceException or rospy.ROSException where there is no node.
"""

import threading

import actionlib
import rospy
from geometry_msgs.msg import Point
from pkm_workspace.msg import (ApproximateWorkspaceAction, ApproximateWorkspaceGoal, CriterionRequest, ErrorCode,
                               FindLargestRegionAction, FindLargestRegionGoal, PavingRequest, RegionRequest,
                               ToolSegment)
from pkm_workspace.srv import (CheckPath, CheckPathRequest, CheckPathResponse, CheckRegion, CheckRegionRequest,
                               ComputeLargestRegion, ComputeWorkspace, EvaluatePoint, EvaluatePointRequest, GetRegion)
from shape_msgs.msg import SolidPrimitive
from std_msgs.msg import Header


class Refused(Exception):
    """The node has refused a request; error_code is a constant of ErrorCode."""

    def __init__(self, error_code, message):
        super().__init__(message)
        self.error_code = error_code


class Goal:
    """A goal that was sent. Unlike actionlib's SimpleActionClient it misses no goal that ends at once."""

    def __init__(self, client, goal, feedback, active):
        self.ended = threading.Event()
        self.active = active
        tell = (lambda _, message: feedback(message)) if feedback else None
        self.handle = client.send_goal(goal, self.change, tell)

    def change(self, handle):
        """What actionlib calls at each change of state."""
        if handle.get_comm_state() == actionlib.CommState.ACTIVE and self.active:
            self.active()
        if handle.get_comm_state() == actionlib.CommState.DONE:
            self.ended.set()

    def cancel_goal(self):
        """Asks the node to end it with the best proven so far."""
        self.handle.cancel()

    def wait_for_result(self, seconds):
        """Returns whether it has ended in time."""
        return self.ended.wait(seconds)

    def get_state(self):
        """A constant of actionlib_msgs/GoalStatus."""
        return self.handle.get_goal_status()

    def get_result(self):
        """What it has ended with."""
        return self.handle.get_result()


class Client:
    """Calls one node. Persistent connections: make one client and keep it; one for each thread."""

    INSIDE = CheckPathResponse.INSIDE
    OUTSIDE = CheckPathResponse.OUTSIDE
    UNDECIDED = CheckPathResponse.UNDECIDED

    def __init__(self, node="/pkm_workspace_node", timeout=10.0):
        """Waits up to timeout [s] for each service when it is first called."""
        self.node = node
        self.timeout = timeout
        self.services = {}
        self.actions = {}

    def largest_region(self, **fields):
        """The largest region for the fields of a RegionRequest, a Region."""
        return self.call("compute_largest_region", ComputeLargestRegion, RegionRequest(**fields)).region

    def last_region(self):
        """The last region that was computed, at once."""
        return self.call("get_region", GetRegion).region

    def workspace(self, **fields):
        """The set of all good points by boxes for the fields of a PavingRequest, a Workspace."""
        return self.call("compute_workspace", ComputeWorkspace, PavingRequest(**fields)).workspace

    def find_region(self, feedback=None, active=None, **fields):
        """Begins to look for the largest region. Returns the Goal.

        active is called when the computation begins. Cancel no sooner than that: actionlib's Python client may lose a goal
        that it cancels before the node has heard of it.
        """
        return self.send("find_largest_region", FindLargestRegionAction,
                         FindLargestRegionGoal(RegionRequest(**fields)), feedback, active)

    def approximate_workspace(self, feedback=None, active=None, **fields):
        """Begins to pave, as above."""
        return self.send("approximate_workspace", ApproximateWorkspaceAction,
                         ApproximateWorkspaceGoal(PavingRequest(**fields)), feedback, active)

    def check_box(self, center, sides, frame="", criterion=None):
        """Whether all of a box is good. Sides are along the axes of the frame."""
        return self.check_solid(center, SolidPrimitive(SolidPrimitive.BOX, list(sides)), frame, criterion)

    def check_solid(self, center, solid, frame="", criterion=None):
        """The same for any SolidPrimitive but a cone."""
        return self.call("check_region", CheckRegion,
                         CheckRegionRequest(header=Header(frame_id=frame), solid=solid, center=Point(*center),
                                            criterion=criterion or CriterionRequest()))

    def check_line(self, points, frame="", criterion=None, tool_speed=0.0):
        """Whether all of the way through these points is good."""
        segments = [ToolSegment(kind=ToolSegment.LINE, start=Point(*a), end=Point(*b))
                    for a, b in zip(points, points[1:])]
        return self.check_path(segments, frame, criterion, tool_speed)

    def check_path(self, segments, frame="", criterion=None, tool_speed=0.0):
        """The same for lines, arcs and helices."""
        return self.call("check_path", CheckPath,
                         CheckPathRequest(header=Header(frame_id=frame), segments=segments, tool_speed=tool_speed,
                                          criterion=criterion or CriterionRequest()))

    def evaluate(self, point, frame="", criterion=None):
        """How the machine stands at a point."""
        return self.call("evaluate_point", EvaluatePoint,
                         EvaluatePointRequest(header=Header(frame_id=frame), point=Point(*point),
                                              criterion=criterion or CriterionRequest()))

    def call(self, name, kind, *request):
        """Calls a service of the node by name. Raises Refused unless it succeeds."""
        if name not in self.services:
            rospy.wait_for_service(f"{self.node}/{name}", self.timeout)
            self.services[name] = rospy.ServiceProxy(f"{self.node}/{name}", kind, persistent=True)
        try:
            response = self.services[name](*request)
        except rospy.ServiceException:
            self.services.pop(name).close()  # the next call connects again
            raise
        if response.error_code != ErrorCode.SUCCESS:
            raise Refused(response.error_code, response.message)
        return response

    def send(self, name, kind, goal, feedback, active):
        """Sends a goal; connects to each action once."""
        if name not in self.actions:
            self.actions[name] = actionlib.ActionClient(f"{self.node}/{name}", kind)
        client = self.actions[name]
        if not client.wait_for_server(rospy.Duration(self.timeout)):
            raise rospy.ROSException(f"{self.node}/{name} is not offered")
        return Goal(client, goal, feedback, active)
