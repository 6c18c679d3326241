#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The arguments of machine.launch reach the node: the machine of an integrator, from its file to a checked path."""

import os
import pathlib
import subprocess
import tempfile
import unittest

import rospy
import rostest
import yaml
from pkm_workspace.client import Client
from pkm_workspace.msg import Region
from sensor_msgs.msg import JointState

NODE = "/pkm_workspace_node"
PATIENCE = 60.0
DATA = pathlib.Path(__file__).resolve().parents[1] / "data"


def parameters(*arguments, **environment):
    """What machine.launch would set."""
    command = ["roslaunch", "--dump-params", "pkm_workspace", "machine.launch", "rviz:=false", *arguments]
    text = subprocess.run(command, env={**os.environ, **environment}, capture_output=True, text=True, check=True).stdout
    return yaml.safe_load(text)


class LaunchTest(unittest.TestCase):
    def test_region_is_that_of_the_arguments(self):
        region = rospy.wait_for_message(f"{NODE}/region", Region, PATIENCE)
        said = region.hypotheses
        self.assertEqual((said.machine, region.shape, said.joint_limits), ("linear_delta_cnc", Region.CYLINDER, False))
        self.assertEqual((said.psi_min, said.psi_max, said.accuracy), (0.25, 3.9, 0.02))
        self.assertEqual(region.header.frame_id, "world")
        height, radius = region.solid.dimensions
        self.assertAlmostEqual(height, radius, places=12)
        center = (region.center.x, region.center.y, region.center.z)
        aside = (region.center.x + 0.9 * radius, *center[1:])
        self.assertEqual(Client(NODE, PATIENCE).check_line([center, aside]).verdict, Client.INSIDE)

    def test_machine_follows_the_driver(self):
        driver = rospy.Publisher("/driver/joint_states", JointState, queue_size=1, latch=True)
        driver.publish(JointState(name=["rail3", "rail1", "rail2", "spindle"], position=[0.11, 0.1, 0.12, 7.0]))

        def follows(state):
            places = dict(zip(state.name, state.position))
            return all(abs(places[name] - q) < 1e-9 for name, q in (("rail1", 0.1), ("rail2", 0.12), ("rail3", 0.11)))

        for _ in range(200):  # ten seconds of states
            if follows(rospy.wait_for_message("/joint_states", JointState, PATIENCE)):
                return
        self.fail("the model does not stand where the driver says")

    def test_arguments_are_parameters(self):
        urdf = f"urdf:={DATA / 'equal_homes.urdf'}"
        self.assertEqual(parameters(urdf), {"/robot_description": (DATA / "equal_homes.urdf").read_text(),
                                            f"{NODE}/shape": "cube", f"{NODE}/joint_limits": True})
        given = parameters(urdf, "psi_min:=0.3", "psi_max:=3", "tool:=spindle", "shape:=box", "proportions:=[2, 1, 1]",
                           "search_box:=[0, 1, 0, 1, 0, 1]", "tip:=[0, 0, -0.1]", "limits:=false")
        self.assertEqual({name.split("/")[-1]: value for name, value in given.items() if name.startswith(NODE)},
                         {"psi_min": 0.3, "psi_max": 3.0, "tool_link": "spindle", "tool": [0, 0, -0.1], "shape": "box",
                          "joint_limits": False, "proportions": [2, 1, 1], "search_box": [0, 1, 0, 1, 0, 1]})

    def test_a_file_of_parameters_is_beneath_the_arguments(self):
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            file.write("{shape: sphere, keep_in: [], psi_min: 0.4}")
            file.flush()
            config = (f"urdf:={DATA / 'equal_homes.urdf'}", f"config:={file.name}")
            own = parameters(*config)
            self.assertEqual((own[f"{NODE}/shape"], own[f"{NODE}/psi_min"]), ("cube", 0.4))
            self.assertEqual(parameters(*config, "psi_min:=0.3")[f"{NODE}/psi_min"], 0.3)

    def test_xacro_is_run_where_asked_for(self):
        with tempfile.TemporaryDirectory() as folder:
            stand_in = pathlib.Path(folder) / "xacro"  # Debian has none: it says what it was called with
            stand_in.write_text('#!/bin/sh\necho "<robot name=\\"$1\\"/>"\n')
            stand_in.chmod(0o755)
            made = parameters("urdf:=my machine.xacro", "xacro:=true", PATH=f"{folder}:{os.environ['PATH']}")
        self.assertEqual(made["/robot_description"].strip(), '<robot name="my machine.xacro"/>')


if __name__ == "__main__":
    rospy.init_node("launch_test")
    rostest.rosrun("pkm_workspace", "launch", LaunchTest)
