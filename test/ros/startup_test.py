#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A bad parameter or a bad URDF ends the node, before it computes, with a FATAL line that says why."""

import re
import threading
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from pkm_workspace.msg import CriterionRequest
from node_process import NAME, PATIENCE, NodeProcess, urdf

NAN = float("nan")

BAD_PARAMETERS = [
    ({"shape": "blob"}, r"shape = 'blob' must be cube, square, box, sphere, disc or cylinder"),
    ({"shape": 3}, r"shape = 3 must be a text: cube, square, box, sphere, disc or cylinder"),
    ({"shape": "box", "proportions": [1, 2]}, r"proportions = \{1,2\} must be three numbers"),
    ({"shape": "box", "proportions": [1, 0, -1]}, r"proportions \(1, 0, -1\).* must be"),
    ({"proportions": [1, 2, 3]}, r"proportions = \(1, 2, 3\).*box only"),
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
    ({"joint_limits": 1}, r"joint_limits = 1 must be true or false"),
    ({"search_box": [0, 1, 0, 1, 0]}, r"search_box = \{0,1,0,1,0\} must be six numbers"),
    ({"search_box": [1, 0, 0, 1, 0, 1]}, r"search.box x = \[1, 0\] m"),
    ({"time_limit": 0}, r"time_limit = 0 s must be > 0 and at most 86400 s"),
    ({"time_limit": 1e6}, r"time_limit = 1000000 s must be > 0 and at most 86400 s"),
    ({"threads": 0}, r"threads = 0 .*1"),
    ({"threads": 1.5}, r"threads = 1.5 must be a whole number >= 1"),
    ({"paving_resolution": -1.0}, r"paving_resolution = -1 m must be >= 0"),
    ({"diagnostic_period": 0}, r"diagnostic_period = 0 must be a number from 0.01 to 3600 \[s\]"),
    ({"diagnostic_period": "often"}, r"diagnostic_period = often must be a number from"),
    ({"rails": "rail_x"}, r"rails = rail_x must be a list of three names"),
    ({"rails": ["rail_x", "rail_y", "elbow"]}, r"elbow"),
    ({"psi_mim": 0.4}, r"psi_mim = 0.4 is not a parameter of this node; these are: accuracy, "
     + "".join(rf"(?=.*\b{name}\b)" for name in CriterionRequest.__slots__)),
]

BAD_DESCRIPTIONS = [
    (None, r"robot_description is not there.*load the machine's URDF"),
    (42, r"/robot_description must be a text, the machine's URDF"),
    ("", r"/robot_description: .*refused:(.|\n)*no well-formed XML"),
    ("<robot", r"/robot_description: .*refused:(.|\n)*no well-formed XML"),
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

    def test_names_all_that_is_wrong_at_once(self):
        parameters = {"shape": "blob", "accuracy": -1.0, "typo": True}
        with NodeProcess(urdf("orthoglide"), parameters) as node:
            _, output = node.wait()
        for name in parameters:
            self.assertRegex(output, rf"FATAL .*{name} = ")


if __name__ == "__main__":
    rospy.init_node("startup_test")
    rostest.rosrun("pkm_workspace", "startup", StartupTest)
