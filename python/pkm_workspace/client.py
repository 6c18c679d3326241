# SPDX-License-Identifier: BSD-3-Clause
"""A small client of pkm_workspace_node, for planners in Python.

    rospy.init_node("planner")
    machine = Client()                                           # of /pkm_workspace_node
    region = machine.largest_region(shape="cube", psi_min=0.4, accuracy=1e-4)
    print(region.size, region.size_upper_bound)                  # certified bracket [m]
    if machine.check_box((0.1, 0.1, 0.1), (0.2, 0.2, 0.3), frame="table").verdict != machine.INSIDE:
        ...
    answer = machine.check_path([line((0, 0, 0), (0.2, 0, 0)), arc((0.2, 0, 0), (0.3, 0.1, 0), (0.2, 0.2, 0))])
    if answer.verdict == machine.OUTSIDE:
        print(answer.message)                                    # where along the path, and which limit binds
    print(machine.evaluate((0.1, 0, 0)).psi)                     # enclosures of the transmission factors

Lengths are metres, angles radians. Keywords are the fields of the request and of its criterion by their names (psi_min,
kappa_max, ...), and besides: frame, ratio (least and largest), search_box and box (two corners each), joint_limits and
hinge_limits as True or False, tolerances as {"tolerance_length": 1e-4}, one number for all legs where there may be three, points and axes as lists of three
numbers, set, aspect and psi as text ("dextrous", "own", "auto"). Every call raises TypeError for a keyword that there is
not and for a value of another type, Refused where the node refuses, with its error_code and message, and
rospy.ServiceException or rospy.ROSException where there is no node.
"""

import copy
import threading
import time
import xmlrpc.client

import actionlib
import genpy
import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Point, Pose, Quaternion, Vector3
from pkm_workspace.msg import (ApproximateWorkspaceAction, ApproximateWorkspaceGoal, CriterionRequest, ErrorCode,
                               FindLargestRegionAction, FindLargestRegionGoal, PavingRequest, RegionRequest,
                               Tolerance, ToolSegment, ToolZone)
from pkm_workspace.srv import (CheckGcode, CheckGcodeRequest, CheckPath, CheckPathRequest, CheckPathResponse, CheckRegion,
                               CheckRegionRequest, ComputeLargestRegion, ComputeWorkspace, EvaluatePoint,
                               EvaluatePointRequest, ExportLimits, ExportLimitsRequest, GetRegion, PlacePath, PlacePathRequest, SetCriterion, SetCriterionRequest)
from shape_msgs.msg import SolidPrimitive
from std_msgs.msg import Header


class Refused(Exception):
    """The node has refused a request; error_code is a constant of ErrorCode."""

    def __init__(self, error_code, message):
        super().__init__(message)
        self.error_code = error_code


TRIPLES = {"geometry_msgs/Point": Point, "geometry_msgs/Vector3": Vector3}
CORNERS = {"search_box": "use_search_box", "box": "use_box"}
SWITCHES = {"center": "use_center", "base_z": "use_base", "tool_at": "use_tool_at"}
CHOICES = ("set", "aspect", "psi")


def line(start, end):
    """A straight piece of a path."""
    return ToolSegment(kind=ToolSegment.LINE, start=Point(*start), end=Point(*end))


def arc(start, via, end):
    """The arc of a circle through three points."""
    return ToolSegment(kind=ToolSegment.ARC_THROUGH, start=Point(*start), via=Point(*via), end=Point(*end))


def turn(start, center, axis, angle, lift=0.0):
    """The arc from start about the axis through the center by an angle; a helix where it climbs along the axis."""
    return ToolSegment(kind=ToolSegment.ARC, start=Point(*start), center=Point(*center), axis=Vector3(*axis), angle=angle,
                       lift=lift)


def zone(use, kind, name="", center=(0, 0, 0), orientation=(0, 0, 0, 1), **measures):
    """A zone to "keep_in" or "keep_out" of: kind "box" with sides, "cylinder" with radius and height, "sphere" with radius,
    or "half_space" with normal. Lengths in metres, in the frame of the request unless in_root=True."""
    numbers = {}
    for field, text in (("use", use), ("kind", kind)):
        numbers[field] = getattr(ToolZone, str(text).upper(), None)
        if numbers[field] is None:
            raise TypeError(f"{field} = '{text}' is none of the constants of ToolZone")
    message = ToolZone(name=name, pose=Pose(Point(*center), Quaternion(*orientation)), **numbers)
    for field, value in measures.items():
        if field not in ("sides", "radius", "height", "normal", "in_root"):
            raise TypeError(f"'{field}' is no measure of a zone")
        setattr(message, field, read_value(message, field, value))
    return message


def read_value(message, name, value):
    """The value as the field of a message has it."""
    slot = dict(zip(message.__slots__, message._slot_types))[name]
    if slot == "float64[]" and isinstance(value, (int, float)):
        return [value]
    kind = TRIPLES.get(slot)
    if kind and not isinstance(value, kind):
        return kind(*value)
    kind = TRIPLES.get(slot[:-2]) if slot.endswith("[]") else None
    if kind:
        return [each if isinstance(each, kind) else kind(*each) for each in value]
    if name == "zones":
        return list(value)
    if name == "tolerances":
        kinds = value.items() if isinstance(value, dict) else [(each.kind, each.values) for each in value]
        return [Tolerance(kind=kind, values=[numbers] if isinstance(numbers, (int, float)) else list(numbers))
                for kind, numbers in kinds]
    if name in ("joint_limits", "hinge_limits", "own_zones", "own_tolerances", "turned") and isinstance(value, bool):
        return CriterionRequest.ON if value else CriterionRequest.OFF
    if name in CHOICES and isinstance(value, str):
        choice = getattr(CriterionRequest, value.upper(), None)
        if choice is None:
            raise TypeError(f"{name} = '{value}' is none of the constants of CriterionRequest")
        return choice
    return value


def fill(message, criterion=None, frame="", **fields):
    """The message with these fields of its own and of its criterion."""
    own = [name for name in message.__slots__ if name != "criterion"]
    message.criterion = copy.copy(criterion) if criterion else CriterionRequest()
    if frame:
        message.header = Header(frame_id=frame)
    for name, value in fields.items():
        if CORNERS.get(name) in own:
            setattr(message, CORNERS[name], True)
            message.min_corner, message.max_corner = (Point(*corner) for corner in value)
        elif name == "ratio" and "ratio_min" in own:
            message.ratio_min, message.ratio_max = value
        elif name == "footprint" and "footprint_x" in own:
            message.footprint_x, message.footprint_y = value
        elif name in own:
            setattr(message, name, read_value(message, name, value))
            if SWITCHES.get(name) in own:
                setattr(message, SWITCHES[name], True)
        elif name in CriterionRequest.__slots__:
            setattr(message.criterion, name, read_value(message.criterion, name, value))
        else:
            raise TypeError(f"{name} is not a field of {type(message).__name__}; these are: "
                            + ", ".join([*own, *CriterionRequest.__slots__]))
    try:
        message._check_types()
    except genpy.SerializationError as error:
        raise TypeError(str(error)) from error
    return message


def process_of(node):
    """The process that the node runs in; None where there is none."""
    try:
        uri = rosgraph.Master(rospy.get_name()).lookupNode(node)
        return xmlrpc.client.ServerProxy(uri).getPid(rospy.get_name())[2]
    except (rosgraph.MasterException, OSError, xmlrpc.client.Error):
        return None


class Goal:
    """A goal that was sent. Unlike actionlib's SimpleActionClient it misses no goal that ends at once, and it ends, LOST,
    when its node does."""

    GLANCE = 0.5  # [s] between two looks at the node while waiting

    def __init__(self, client, goal, feedback, active, node=""):
        self.ended = threading.Event()
        self.active = active
        self.node = node
        self.process = process_of(node) if node else None
        self.lost = False
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
        deadline = time.monotonic() + seconds
        missed = 0  # glances in a row that did not find the node
        while not self.ended.wait(max(0.0, min(self.GLANCE, deadline - time.monotonic()))):
            missed = missed + 1 if self.node and process_of(self.node) != self.process else 0
            if missed == 2:
                self.lost = True
                self.ended.set()
            elif time.monotonic() >= deadline:
                return False
        return True

    def get_state(self):
        """A constant of actionlib_msgs/GoalStatus."""
        return GoalStatus.LOST if self.lost else self.handle.get_goal_status()

    def get_result(self):
        """What it has ended with; None of a goal that is lost."""
        return None if self.lost else self.handle.get_result()


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
        return self.call("compute_largest_region", ComputeLargestRegion, fill(RegionRequest(), **fields)).region

    def last_region(self):
        """The last region that was computed, at once."""
        return self.call("get_region", GetRegion).region

    def workspace(self, **fields):
        """The set of all good points by boxes for the fields of a PavingRequest, a Workspace."""
        return self.call("compute_workspace", ComputeWorkspace, fill(PavingRequest(), **fields)).workspace

    def find_region(self, feedback=None, active=None, **fields):
        """Begins to look for the largest region. Returns the Goal.

        active is called when the computation begins. Cancel no sooner than that: actionlib's Python client may lose a goal
        that it cancels before the node has heard of it.
        """
        return self.send("find_largest_region", FindLargestRegionAction,
                         FindLargestRegionGoal(fill(RegionRequest(), **fields)), feedback, active)

    def approximate_workspace(self, feedback=None, active=None, **fields):
        """Begins to pave, as above."""
        return self.send("approximate_workspace", ApproximateWorkspaceAction,
                         ApproximateWorkspaceGoal(fill(PavingRequest(), **fields)), feedback, active)

    def set_criterion(self, **fields):
        """Changes what the node asks for from now on, for the fields of a SetCriterion request. Returns the Hypotheses."""
        return self.call("set_criterion", SetCriterion, fill(SetCriterionRequest(), **fields)).hypotheses

    def check_box(self, center, sides, frame="", criterion=None, **fields):
        """Whether all of a box is good. Sides are along the axes of the frame."""
        return self.check_solid(center, SolidPrimitive(SolidPrimitive.BOX, list(sides)), frame, criterion, **fields)

    def check_polytope(self, center, vertices, frame="", criterion=None, **fields):
        """Whether all of the convex hull of points is good, as seen from its center."""
        return self.check_solid(center, SolidPrimitive(), frame, criterion, vertices=vertices, **fields)

    def check_solid(self, center, solid, frame="", criterion=None, **fields):
        """The same for any SolidPrimitive but a cone."""
        return self.call("check_region", CheckRegion,
                         fill(CheckRegionRequest(solid=solid), criterion, frame, center=center, **fields))

    def check_line(self, points, frame="", criterion=None, **fields):
        """Whether all of the way through these points is good."""
        return self.check_path([line(*ends) for ends in zip(points, points[1:])], frame, criterion, **fields)

    def check_path(self, segments, frame="", criterion=None, **fields):
        """The same for lines, arcs and helices: line(), arc(), turn(). Its keywords: tool_speed [m/s], joint_acceleration_max (one
        number or three [m/s^2]), joint_speeds_off, largest_feed."""
        return self.call("check_path", CheckPath,
                         fill(CheckPathRequest(segments=segments), criterion, frame, **fields))

    def check_gcode(self, gcode, frame="", criterion=None, **fields):
        """Whether all of a job in G-code is good, given by its text. Its keywords: origin, work_offsets (of G54, G55, ...),
        tool_at, rapid_feed [m/s], joint_acceleration_max, joint_speeds_off, most_listed and the others of CheckGcode."""
        return self.call("check_gcode", CheckGcode, fill(CheckGcodeRequest(gcode=gcode), criterion, frame, **fields))

    def export_limits(self, form, center, solid, criterion=None, **fields):
        """The limits of a region that is proved, in the words of a firmware: klipper, marlin, reprapfirmware or linuxcnc.
        Its keywords: origin (the controller's zero), top_by_slicer, max_boxes."""
        return self.call("export_limits", ExportLimits,
                         fill(ExportLimitsRequest(format=form, solid=solid), criterion, center=center, **fields))

    def place_path(self, segments, frame="", criterion=None, **fields):
        """Where to put a path, with the largest margin. Its keywords: box (two corners of the translations that may be
        chosen), tool_speed, joint_acceleration_max, joint_speeds_off as above, largest_scale, accuracy, time_limit."""
        return self.call("place_path", PlacePath,
                         fill(PlacePathRequest(segments=segments), criterion, frame, **fields))

    def evaluate(self, point, frame="", criterion=None, **fields):
        """How the machine stands at a point."""
        return self.call("evaluate_point", EvaluatePoint,
                         fill(EvaluatePointRequest(), criterion, frame, point=point, **fields))

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
        return Goal(client, goal, feedback, active, self.node)
