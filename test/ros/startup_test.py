#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A bad parameter or a bad URDF ends the node, before it computes, with a FATAL line that says why."""

import pathlib
import re
import threading
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Point
from pkm_workspace.msg import CriterionRequest, RegionRequest
from pkm_workspace.srv import CompareMachines, ComputeLargestRegion
from node_process import NAME, PATIENCE, NodeProcess, slants, urdf, wait_until
from visualization_msgs.msg import MarkerArray

NAN = float("nan")
DATA = pathlib.Path(__file__).resolve().parents[1] / "data"

BAD_PARAMETERS = [
    ({"shape": "blob"}, r"shape = 'blob' must be cube, square, box, sphere, disc, cylinder or polytope"),
    ({"shape": 3}, r"shape = 3 must be a text: cube, square, box, sphere, disc, cylinder or polytope"),
    ({"shape": "box", "proportions": [1, 2]}, r"proportions = \{1,2\} must be three numbers"),
    ({"shape": "box", "proportions": [1, 0, -1]}, r"proportions \(1, 0, -1\).* must be"),
    ({"proportions": [1, 0, -1]}, r"proportions \(1, 0, -1\).* must be"),
    ({"ratio": [2, 1]}, r"ratio = \[2, 1\] must have the least one first"),
    ({"radius": "wide"}, r"radius = wide must be a number > 0 \[m\]"),
    ({"radius": 0.1, "height": 0.1}, r"a cylinder takes one of ratio, radius and height"),
    ({"height": -1.0}, r"height = -1 m must be positive"),
    ({"footprint": [1]}, r"footprint = \{1\} must be two numbers"),
    ({"vertices": [[0, 0, 0], [1, 0, 0], [0, 1]]}, r"vertices = .* must be a list of three numbers \[x, y, z\] each"),
    ({"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]}, r"vertices lie in one plane"),
    ({"turned": True, "shape": "disc"}, r"turned is for a square, cube, box or polytope: a disc turned"),
    ({"turned": 1}, r"turned = 1 must be true or false"),
    ({"base_z": 0, "center": [0, 0, 0]}, r"a center and base_z exclude each other"),
    ({"base_z": 0, "shape": "sphere"}, r"base_z is for regions with a lowest face, and a sphere has none"),
    ({"psi": "best"}, r"psi = best must be a text: given or auto"),
    ({"psi": "auto", "psi_min": 0.3}, r"psi = auto chooses the bounds of a dextrous set: leave out psi_min"),
    ({"psi": "auto", "set": "reachable"}, r"psi = auto chooses the bounds of a dextrous set"),
    ({"tool_link": "drill"}, r"tool_link names 'drill', which is not a link; the links are: "),
    ({"tool": [0, 0, 0.1], "tool_link": "drill"}, r"tool = \(0, 0, 0.1\) m and tool_link = 'drill' both tell"),
    ({"tool": 0.1}, r"tool = 0.1 must be three numbers \[x, y, z\] \[m\]"),
    ({"psi_min": "small"}, r"psi_min = small must be a number > 0"),
    ({"psi_min": 0}, r"psi_min = 0 .*must be positive"),
    ({"psi_max": 0.25}, r"psi_max = 0.25 must be at least psi_min = 0.5 \(the default\) "),
    ({"psi_min": 3, "psi_max": 2.5}, r"psi_max = 2.5 must be at least psi_min = 3 \(transmission"),
    ({"psi_max": NAN}, r"psi_max = nan .*must be positive"),
    ({"accuracy": -0.1}, r"accuracy = -0.1\S* m must be positive and finite, or 0 for a thousandth"),
    ({"set": "nice"}, r"set = nice must be a text: dextrous or reachable"),
    ({"aspect": "any"}, r"aspect = any must be a text: own, other or both"),
    ({"aspect": "both"}, r"a region with bounded factors lies in one aspect"),
    ({"force_min": -1.0}, r"force_min = -1 .*must be"),
    ({"force_max": "much"}, r"force_max = much must be a number >= force_min, or 0"),
    ({"kappa_max": 0.5}, r"kappa_max = 0.5 .*must be"),
    ({"tool_speed_min": -1}, r"tool_speed_min = -1 .*must be positive"),
    ({"strut_angle_max": 3.0}, r"strut_angle_max = 3 .*must be positive and at most 1.5707963"),
    ({"stiffness_min": 1e5}, r"stiffness_min needs the stiffness of its drive .* of joint .rail_x.: give joint_stiff"),
    ({"joint_speed_max": [1, 2]}, r"joint_speed_max = .* must be a number > 0, or a list of three .m/s."),
    ({"joint_error_max": -1.0}, r"joint_error_max = -1 .*must be positive"),
    ({"ball_axes": [[0, 0, 0]]}, r"ball_axes: .*not a direction"),
    ({"ball_axes": [[1, 0, 0], [0, 1, 0]]}, r"ball_axes: 2 axes, expected one for all legs or one for each"),
    ({"hinge_limits": 1}, r"hinge_limits = 1 must be true or false"),
    ({"joint_limits": 1}, r"joint_limits = 1 must be true or false"),
    ({"search_box": [0, 1, 0, 1, 0]}, r"search_box = \{0,1,0,1,0\} must be six numbers"),
    ({"search_box": [1, 0, 0, 1, 0, 1]}, r"search.box x = \[1, 0\] m"),
    ({"time_limit": 0}, r"time_limit = 0 s must be > 0 and at most 86400 s"),
    ({"time_limit": 1e6}, r"time_limit = 1000000 s must be > 0 and at most 86400 s"),
    ({"threads": 0}, r"threads = 0 .*1"),
    ({"threads": 1.5}, r"threads = 1.5 must be a whole number >= 1"),
    ({"joint_acceleration_max": [1, 2]}, r"joint_acceleration_max = .* must be a number > 0, or three \[m/s\^2\]"),
    ({"joint_acceleration_max": -1.0}, r"joint_acceleration_max = -1.* must be a number > 0, or three \[m/s\^2\]"),
    ({"set_style": "cloud"}, r"set_style = cloud must be a text: surface or boxes"),
    ({"set_colors": 1}, r"set_colors = 1 must be a text: condition or verdict"),
    ({"paving_resolution": -1.0}, r"paving_resolution = -1 m must be >= 0"),
    ({"diagnostic_period": 0}, r"diagnostic_period = 0 must be a number from 0.01 to 3600 \[s\]"),
    ({"diagnostic_period": "often"}, r"diagnostic_period = often must be a number from"),
    ({"rails": "rail_x"}, r"rails = rail_x must be a list of three names"),
    ({"rails": ["rail_x", "rail_y", "elbow"]}, r"elbow"),
    ({"psi_mim": 0.4}, r"psi_mim = 0.4 is not a parameter of this node; these are: accuracy, "
     + "".join(rf"(?=.*\b{name}\b)" for name in CriterionRequest.__slots__
              if not name.endswith(("zones", "tolerances")))),
]

BAD_DESCRIPTIONS = [
    (None, r"robot_description is not there.*load the machine's URDF"),
    (42, r"/robot_description must be a text, the machine's URDF"),
    ("", r"/robot_description: .*refused:(.|\n)*not well-formed XML"),
    ("<robot", r"/robot_description: .*refused:(.|\n)*not well-formed XML"),
    ("<robot name='stool'><link name='seat'/></robot>", r"/robot_description: .*refused:(.|\n)*0 prismatic joints"),
]


def refusal_defects(description, parameters, reason):
    """What is wrong with how the node ends: nothing, or one text."""
    with NodeProcess(description, parameters) as node:
        code, output = node.wait()
    fatal = "\n".join(line for line in output.splitlines() if "FATAL" in line)
    if code == 1 and re.search(reason, fatal) and "computing" not in output:
        return []
    return [f"{parameters}: exit code {code}, expected '{reason}', got:\n{output}"]


class StartupTest(unittest.TestCase):
    def expect_refusals(self, table):
        defects = [defect for row in table for defect in refusal_defects(*row)]
        if defects:
            self.fail("\n\n".join(defects))

    def test_refuses_bad_parameters(self):
        self.expect_refusals([(urdf("orthoglide"), *row) for row in BAD_PARAMETERS])

    def test_refuses_bad_descriptions(self):
        self.expect_refusals([(description, {}, reason) for description, reason in BAD_DESCRIPTIONS])

    def test_refuses_what_has_no_bounded_answer(self):
        # a segment along parallel rails can be as long as one likes
        self.expect_refusals([(urdf("uranesx"), {"joint_limits": False, "shape": "box", "proportions": [0, 0, 1]},
                               r"along the rails can be as long as one likes: ask for joint_limits, or for another")])

    def test_says_what_the_tool_point_is_and_that_default_bounds_do_not_suit(self):
        delta = (pathlib.Path(__file__).resolve().parents[1] / "data" / "equal_homes.urdf").read_text()
        with NodeProcess(delta, {"time_limit": 1}) as node:
            node.wait_for_output("the default bounds of psi, [0.5, 2], suit the paper's machines; the middle of this")
            node.wait_for_output("the tool point is where the links 'tcp1', 'tcp2', 'tcp3' coincide at joint values 0, "
                                 "the deepest that do; the legs are drawn up to 0.000324 m apart at joint values 0 "
                                 "(allowed: 0.00269 m)")

    def test_bounds_that_fit_and_shapes_that_wait(self):
        delta = (pathlib.Path(__file__).resolve().parents[1] / "data" / "equal_homes.urdf").read_text()
        with NodeProcess(delta, {"psi": "auto", "ratio": [1, 1], "proportions": [2, 1, 1], "time_limit": 1}):
            ask = rospy.ServiceProxy(f"{NAME}/compute_largest_region", ComputeLargestRegion, persistent=True)
            ask.wait_for_service(PATIENCE)
            cylinder = ask(query=RegionRequest(shape="cylinder", accuracy=0.05))
            self.assertEqual(cylinder.message, cylinder.region.message)
            self.assertEqual((cylinder.region.hypotheses.psi_min, cylinder.region.hypotheses.psi_max), (0.25, 3.9))
            height, radius = cylinder.region.solid.dimensions
            self.assertAlmostEqual(height, radius, places=12)
            box = ask(query=RegionRequest(shape="box", accuracy=0.05)).region.proportions
            self.assertEqual((box.x, box.y, box.z), (2, 1, 1))
            request = RegionRequest(shape="disc", accuracy=0.05)
            request.criterion.psi = CriterionRequest.AUTO
            disc = ask(query=request).region
            self.assertEqual((disc.hypotheses.psi_min, disc.hypotheses.psi_max), (0.25, 3.9))
            request.criterion.psi_min = 0.3
            self.assertIn("psi = AUTO chooses the bounds of a DEXTROUS set", ask(query=request).message)
            request.criterion.psi = 7
            self.assertIn("psi = 7 must be DEFAULT = 0 or AUTO = 1", ask(query=request).message)

    def test_measures_and_places_that_wait(self):
        own = {"shape": "cylinder", "radius": 0.2, "footprint": [0.1, 0.2], "base_z": -0.25, "accuracy": 0.02,
               "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}
        with NodeProcess(urdf("orthoglide"), own):
            ask = rospy.ServiceProxy(f"{NAME}/compute_largest_region", ComputeLargestRegion, persistent=True)
            ask.wait_for_service(PATIENCE)
            region = ask(query=RegionRequest()).region
            self.assertEqual((region.shape, region.use_base, region.base_z), ("cylinder", True, -0.25))
            self.assertEqual(region.solid.dimensions[1], 0.2)
            self.assertAlmostEqual(region.center.z, -0.25 + region.size / 2, places=12)
            box = ask(query=RegionRequest(shape="box")).region
            self.assertEqual((list(box.solid.dimensions[:2]), box.use_base), ([0.1, 0.2], True))
            self.assertFalse(ask(query=RegionRequest(shape="sphere")).region.use_base)
            self.assertEqual(len(ask(query=RegionRequest(shape="polytope")).region.vertices), 4)
            free = ask(query=RegionRequest(use_search_box=True, min_corner=Point(-1, -1, -1),
                                           max_corner=Point(1, 1, 1))).region
            self.assertEqual((free.use_base, free.use_search_box), (False, True))
            self.assertGreater(free.size, region.size_upper_bound)

    def test_a_node_may_turn_its_regions(self):
        with NodeProcess(urdf("orthoglide"), {"shape": "box", "proportions": [2, 1, 0.5], "turned": True,
                                              "accuracy": 0.01}):
            ask = rospy.ServiceProxy(f"{NAME}/compute_largest_region", ComputeLargestRegion, persistent=True)
            ask.wait_for_service(PATIENCE)
            turned = ask(query=RegionRequest()).region
            self.assertTrue(turned.turned and turned.angle != 0)
            straight = ask(query=RegionRequest(turned=RegionRequest.OFF)).region
            self.assertEqual((straight.turned, straight.angle, straight.orientation.w), (False, 0, 1))
            self.assertLess(straight.size_upper_bound, turned.size)
            self.assertFalse(ask(query=RegionRequest(shape="disc")).region.turned)
            compare = rospy.ServiceProxy(f"{NAME}/compare_machines", CompareMachines, persistent=True)
            query = RegionRequest(shape="square", turned=RegionRequest.ON)
            self.assertIn("machines are compared by regions that are not turned", compare(query=query).message)
            both = compare(query=RegionRequest(shape="square", accuracy=0.01), urdfs=[urdf("orthoglide")])
            self.assertEqual(len(both.machines), 2, both.message)

    def test_shows_the_surface_of_the_set_or_its_boxes_and_why(self):
        delta = (DATA / "delta_cnc.urdf").read_text()
        for machine, parameters, said, least, most in (
                (delta, {"psi": "auto"}, "surface of the set at resolution ", 1000, 1e6),
                (delta, {"psi": "auto", "shape": "disc"}, "set at resolution ", 0, 0),
                (delta, {"psi": "auto", "joint_limits": False, "shape": "cylinder", "height": 0.1},
                 "set at resolution ", 0, 0),
                (urdf("orthoglide"), {}, "surface of the set at resolution ", 1000, 1e6),
                (urdf("orthoglide"), {"set_style": "boxes"}, "set at resolution 0.05 m: ", 0, 0),
                (urdf("orthoglide"), {"paving_resolution": 20.0},
                 "the set is shown by boxes, without its surface: nothing is left of it at a resolution of 20", 0, 0)):
            with NodeProcess(machine, parameters) as node:
                node.wait_for_output(said)
                shown = []
                wait_until(lambda: shown.append(rospy.wait_for_message(f"{NAME}/markers", MarkerArray, PATIENCE))
                           or slants(shown[-1].markers) >= least)
                self.assertLessEqual(slants(shown[-1].markers), most)

    def test_diagnostics_come_as_often_as_asked(self):
        stamps = []
        enough = threading.Event()

        def note(message):
            stamps.append(message.header.stamp.to_sec())
            if len(stamps) >= 60:
                enough.set()

        with NodeProcess(urdf("orthoglide"), {"diagnostic_period": 0.02}):
            subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, note)
            self.assertTrue(enough.wait(PATIENCE))
            subscriber.unregister()
        gaps = sorted(after - before for before, after in zip(stamps, stamps[1:]))
        self.assertLess(gaps[len(gaps) // 2], 0.5, gaps)  # the median: by itself it is 1 s

    def status(self, name, text):
        """Waits until /diagnostics say so."""
        found = threading.Event()
        subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, lambda message: [
            found.set() for row in message.status if row.name.endswith(name) and text in row.message])
        self.addCleanup(subscriber.unregister)
        self.assertTrue(found.wait(PATIENCE), text)

    def test_says_that_robot_description_has_changed(self):
        with NodeProcess(urdf("orthoglide"), {"diagnostic_period": 0.05}) as node:
            node.wait_for_output("Proved")
            rospy.set_param("/robot_description", urdf("uranesx"))
            node.wait_for_output("robot_description is no longer the one that was read")
            self.status("geometry", "robot_description is no longer the one that was read")
            rospy.set_param("/robot_description", urdf("orthoglide"))
            self.status("geometry", "machine loaded")

    def test_says_that_no_clock_arrives(self):
        rospy.set_param("/use_sim_time", True)
        try:
            with NodeProcess(urdf("orthoglide")) as node:
                node.wait_for_output("no /clock arrives")
                self.status("clock", "no /clock arrives")
        finally:
            rospy.delete_param("/use_sim_time")

    def test_takes_infinity_for_no_bound_as_requests_do(self):
        with NodeProcess(urdf("orthoglide"), {"kappa_max": float("inf"), "force_max": float("inf")}) as node:
            node.wait_for_output("computing: largest cube, dextrous with psi in [0.5, 2], own aspect")
        self.expect_refusals([(urdf("orthoglide"), {"psi_max": float("inf")}, r"psi_max = inf"),
                              (urdf("orthoglide"), {"accuracy": 1e300}, r"accuracy = 1e\+300 "),
                              (urdf("orthoglide"), {"accuracy": 1e-300}, r"accuracy = 1e-300 ")])

    def test_names_all_that_is_wrong_at_once(self):
        parameters = {"shape": "blob", "accuracy": -1.0, "typo": True}
        with NodeProcess(urdf("orthoglide"), parameters) as node:
            _, output = node.wait()
        for name in parameters:
            self.assertRegex(output, rf"FATAL .*{name} = ")


if __name__ == "__main__":
    rospy.init_node("startup_test")
    rostest.rosrun("pkm_workspace", "startup", StartupTest)
