#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The launch files open rviz on what they promise: looked at on a screen in memory, by colours and counts."""

import pathlib
import subprocess
import tempfile
import unittest

import rospy
import rostest
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion
from node_process import slants, wait_until
from pkm_workspace.client import Client
from rendering import Launch
from std_msgs.msg import Header
from visualization_msgs.msg import InteractiveMarkerFeedback, Marker, MarkerArray

NODE = "/pkm_workspace_node"
URDF = pathlib.Path(__file__).resolve().parents[2] / "urdf"
DATA = pathlib.Path(__file__).resolve().parents[1] / "data"
PKM = ["rosrun", "pkm_workspace", "pkm"]
OK, WARNING, ERROR = (40, 120, 197), (192, 128, 0), (192, 32, 32)  # names of displays in their list


def percent(name, least, most):
    return {f"{name} [% of the view]": (lambda picture: picture.percent(name), least, most)}


def count(name, number, least, cell):
    return {f"number of {name}": (lambda picture: picture.count(name, least, cell), number, number)}


def listed(text, color, least, most):
    return {f"pixels of displays with {text}": (lambda picture: picture.listed(color), least, most)}


def pose_at(*point):
    return Pose(Point(*point), Quaternion(0, 0, 0, 1))


# A whole machine that fills the view, and no complaint of rviz.
WELL = {
    **percent("rails", 0.1, 4),
    **percent("sliders", 0.01, 1),
    **percent("struts", 0.03, 2),
    "height of what is drawn [% of the view]": (lambda picture: picture.height(), 55, 99),
    "margin around it [% of the view's height]": (lambda picture: picture.margin(), 0.5, 45),
    **listed("status ok", OK, 300, 3000),
    **listed("a warning", WARNING, 0, 0),
    **listed("an error", ERROR, 0, 0),
}
LABELS = count("labels", 4, 30, 24)  # one of the region, one at each rail

HANDLES = percent("blue arrows", 0.05, 2)


class ViewsTest(unittest.TestCase):
    def publish(self, name, kind, *arguments, **fields):
        """Latched until the test is over: whoever comes late gets the message as well."""
        publisher = rospy.Publisher(f"{NODE}/{name}", kind, queue_size=1, latch=True)
        self.addCleanup(publisher.unregister)
        publisher.publish(*arguments, **fields)

    def by_verdict(self, machine, **arguments):
        """Whoever is launched next would find the parameter as well."""
        self.addCleanup(rospy.delete_param, f"{NODE}/set_colors")
        return Launch("machine", urdf=URDF / f"{machine}.urdf", config=DATA / "by_verdict.yaml", **arguments)

    def see(self, screen, expectations):
        return screen.wait_for(expectations, self.id().split(".")[-1])

    def test_the_largest_cube_of_the_orthoglide_and_what_ends_the_set(self):
        with Launch("orthoglide") as screen:
            wait_until(lambda: slants(rospy.wait_for_message(f"{NODE}/markers", MarkerArray).markers))
            # the boxes before the surface, 8 % of the view, do not count
            self.see(screen, {**WELL, **LABELS, **percent("region's faces", 4, 14),
                              **percent("joint ranges", 0.05, 0.5), **percent("end by psi_min", 10, 25),
                              **percent("end by psi_max", 2, 15)})

    def test_the_set_by_verdict(self):
        with self.by_verdict("orthoglide") as screen:
            region = {**percent("region's faces", 5, 14), **percent("region's edges", 0.08, 0.6),
                      **percent("joint ranges", 0.05, 0.5), **percent("set", 8, 25)}
            self.see(screen, {**WELL, **LABELS, **region, **percent("border of the set", 0, 1)})
            Client(NODE).workspace()
            self.see(screen, {**WELL, **region, **percent("border of the set", 2, 12)})
            flat = Marker(type=Marker.CUBE, pose=pose_at(0, 0, 0))
            flat.header.frame_id = "base_link"
            self.publish("singularity_markers", MarkerArray, [flat])
            self.see(screen, listed("a warning", WARNING, 50, 3000))  # which would have been seen above

    def test_a_machine_on_a_tilted_table(self):
        lean = {"lean of the joint ranges [degrees]": (lambda picture: picture.lean("joint ranges", 100), 4, 12)}
        with Launch("tilted_table") as screen:
            self.see(screen, {**WELL, **LABELS, **lean, **count("joint ranges", 3, 100, 12), **percent("table", 4, 15),
                              **percent("set", 0.2, 3), **percent("region's edges", 0.02, 0.07),
                              **percent("joint ranges", 0.1, 0.35)})
            Client(NODE).largest_region(shape="cube", header=Header(frame_id="world"))
            # the surface of the set around the cube, through which the table is seen
            self.see(screen, {**WELL, **lean, **percent("table", 0.1, 4), **percent("end by psi_max", 2, 10),
                              **percent("labels", 0.04, 1), **percent("region's edges", 0.05, 0.5),
                              **percent("joint ranges", 0.3, 1.5)})

    def test_machines_with_other_legs(self):
        """Cranks with their arcs, struts of variable length, one leg of each kind; all labels are in the picture."""
        for machine, faces, ranges in (("delta", 1, 0.3), ("tripod", 0.03, 0.04), ("mixed_legs", 3, 0.1)):
            with Launch(machine) as screen:
                self.see(screen, {**WELL, **percent("region's faces", faces, 14), **percent("labels", 0.1, 1.5),
                                  **percent("joint ranges", ranges, 2)})

    def test_tool_and_box_of_the_prototype(self):
        good = {**percent("green", 0.4, 2), **percent("red", 0, 0.4)}
        with Launch("prototype", view="interactive") as screen:
            self.see(screen, {**WELL, **HANDLES, **good, **percent("green box", 0.2, 1), **percent("red box", 0, 0.4),
                              **percent("labels", 0.02, 0.3)})
            self.publish("interactive_markers/feedback", InteractiveMarkerFeedback, marker_name="box",
                         event_type=InteractiveMarkerFeedback.POSE_UPDATE, pose=pose_at(0.2, 0.1, 0.15))
            self.see(screen, {**good, **percent("green box", 0, 0.1), **percent("red box", 0.4, 2)})
            self.publish("tool_pose", PoseStamped, pose=pose_at(0.12, 0.12, 0.15))
            self.see(screen, {**percent("green", 0, 0.35), **percent("red", 1.5, 6), **percent("labels", 0.1, 0.7)})

    def test_the_box_starts_within_the_region_and_the_set_leaves_it_to_the_mouse(self):
        grabbed = []
        feedback = rospy.Subscriber(f"{NODE}/interactive_markers/feedback", InteractiveMarkerFeedback,
                                    lambda event: grabbed.append((event.event_type, event.marker_name)))
        self.addCleanup(feedback.unregister)
        with self.by_verdict("orthoglide_prototype", view="interactive") as screen:
            seen = {**percent("green box", 0.2, 1), **percent("red box", 0, 0.4)}
            self.see(screen, {**WELL, **seen})
            Client(NODE).workspace(resolution=0.025)
            picture = self.see(screen, {**seen, **percent("border of the set", 0.5, 20)})
            row, column = picture.middle("green box")
            for down, right in ((0, 0), (-12, 0), (12, 5), (5, -12)):
                grabbed.clear()
                deadline = rospy.Time.now() + rospy.Duration(30.0)
                while (InteractiveMarkerFeedback.MOUSE_DOWN, "box") not in grabbed and rospy.Time.now() < deadline:
                    screen.click(row + down, column + right)
                self.assertIn((InteractiveMarkerFeedback.MOUSE_DOWN, "box"), grabbed, (down, right))

    def test_handles_of_the_uranesx(self):
        with Launch("uranesx", view="interactive") as screen:
            self.see(screen, {**WELL, **HANDLES})

    def test_a_machine_mounted_above_a_root_of_its_own(self):
        with Launch("machine", urdf=DATA / "delta_cnc.urdf") as screen:
            self.see(screen, WELL)

    def test_machines_of_any_size_whatever_their_root_is_called(self):
        """The same but for their scale: what is seen of them is the same."""
        height = {"height of what is drawn [% of the view]": (lambda picture: picture.height(), 68, 73)}
        for length in ("0.1", "10"):
            urdf = subprocess.run([*PKM, "urdf", "--machine", "uranesx", "--length", length], check=True, text=True,
                                  capture_output=True).stdout
            with tempfile.NamedTemporaryFile("w", suffix=".urdf") as file:
                file.write(urdf.replace("base_link", "foot"))
                file.flush()
                with Launch("machine", urdf=file.name, shape="square") as screen:
                    self.see(screen, {**WELL, **LABELS, **height})


if __name__ == "__main__":
    rospy.init_node("views_test")
    rostest.rosrun("pkm_workspace", "views", ViewsTest)
