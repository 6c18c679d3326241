# SPDX-License-Identifier: BSD-3-Clause
"""A node on one machine, and what is heard of it."""

import math
import re
import threading

import rospy
from answer_claims import xyz
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Point, PoseStamped
from node_process import NAME, PATIENCE, NodeProcess, wait_until
from oracle import Machine
from pkm_workspace.client import Client
from pkm_workspace.msg import Region
from shape_msgs.msg import SolidPrimitive
from visualization_msgs.msg import InteractiveMarkerFeedback, MarkerArray

TOPICS = ("markers", "workspace_markers", "singularity_markers", "box_markers", "tool_markers")


class Heard:
    """What came on a topic."""

    def __init__(self, topic, kind):
        self.changed = threading.Condition()
        self.last = None
        self.subscriber = rospy.Subscriber(topic, kind, self.take)

    def take(self, message):
        with self.changed:
            self.last = message
            self.changed.notify_all()

    def wait(self, fits):
        """The first message from now on, or the last one, that fits."""
        with self.changed:
            if not self.changed.wait_for(lambda: self.last is not None and fits(self.last), PATIENCE):
                raise AssertionError(f"in vain on {self.subscriber.name}, at last there was:\n{self.last}")
            return self.last


class Node:
    """Runs until the end of a with statement. A machine is told from others by its name."""

    def __init__(self, name, urdf, parameters):
        self.name, self.machine = name, Machine(urdf)
        self.span = self.machine.span
        leg = self.machine.legs[float][0]
        self.center = [x + y for x, y in zip(leg.c, leg.zero)]  # of the zero configuration
        self.process = NodeProcess(urdf, {"diagnostic_period": 0.02, **parameters})
        self.client = Client(NAME, PATIENCE)
        self.topics = {topic: Heard(f"{NAME}/{topic}", MarkerArray) for topic in TOPICS}
        self.topics["diagnostics"] = Heard("/diagnostics", DiagnosticArray)
        self.pose = rospy.Publisher(f"{NAME}/tool_pose", PoseStamped, queue_size=1)
        self.drag = rospy.Publisher(f"{NAME}/interactive_markers/feedback", InteractiveMarkerFeedback, queue_size=1)
        self.pavings = []  # what each was about, and the corners of its box
        self.computations = 1  # its own region is the first
        self.region = rospy.wait_for_message(f"{NAME}/region", Region, PATIENCE)
        self.frame = self.region.header.frame_id
        wait_until(lambda: self.pose.get_num_connections() > 0 and self.drag.get_num_connections() > 0)

    def __enter__(self):
        self.process.__enter__()
        return self

    def __exit__(self, *reason):
        for heard in self.topics.values():
            heard.subscriber.unregister()
        self.process.__exit__(*reason)

    def near(self, rng, share):
        """A point about the center, at most this share of a strut away in each axis."""
        return [x + rng.uniform(-share, share) * self.span for x in self.center]

    def diagnosis(self):
        """Question and answer of the last computation, once it is the last that was asked for."""
        values = {}

        def fits(message):
            for status in message.status:
                if status.name.endswith("computation"):
                    values.update({value.key: value.value for value in status.values})
            return values.get("computations") == str(self.computations)

        self.topics["diagnostics"].wait(fits)
        return values["question"], values["answer"]

    def box_at(self, place):
        """Drags the box in rviz. @return its markers there"""
        feedback = InteractiveMarkerFeedback(client_id="test", marker_name="box",
                                             event_type=InteractiveMarkerFeedback.POSE_UPDATE)
        feedback.header.frame_id, feedback.pose.position = self.frame, Point(*place)
        feedback.pose.orientation.w = 1
        self.drag.publish(feedback)
        return self.topics["box_markers"].wait(lambda array: is_at(array, "box", place)).markers

    def tool_to(self, place):
        """Leads the tool from the center towards a place. @return the markers where it ends"""
        for target, is_center in ((self.center, True), (place, False)):
            pose = PoseStamped()
            pose.header.frame_id, pose.pose.position, pose.pose.orientation.w = self.frame, Point(*target), 1
            self.pose.publish(pose)
            markers = self.topics["tool_markers"].wait(
                lambda array, is_center=is_center: is_at(array, "ellipsoid", self.center) == is_center).markers
        return markers

    def log(self):
        """All that it said, line by line, once it has ended."""
        self.process.interrupt()
        code, output = self.process.wait()
        if code != 0:
            raise AssertionError(f"it ended with {code}: {output}")
        lines = re.sub(r"\x1b\[\d*m", "", output).splitlines()  # without its colors
        return [line.strip() for line in lines if line.strip()]


def is_at(array, kind, place):
    """Whether such a marker is there."""
    return any(marker.ns == kind and math.dist(place, xyz(marker.pose.position)) < 1e-9 for marker in array.markers)


def solid(shape, dimensions):
    kind = {"box": SolidPrimitive.BOX, "sphere": SolidPrimitive.SPHERE}.get(shape, SolidPrimitive.CYLINDER)
    return SolidPrimitive(kind, list(dimensions))
