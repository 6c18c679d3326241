# SPDX-License-Identifier: BSD-3-Clause
"""Starts the node as a process of its own, so that tests see how it ends and what it says."""

import os
import pathlib
import queue
import signal
import subprocess
import threading
import time

import roslib.packages
import rospkg
import rospy

NAME = "/pkm_workspace_node"
PATIENCE = 60.0  # [s] until a test fails; nothing is expected to take anywhere near as long


def urdf(machine):
    return (pathlib.Path(rospkg.RosPack().get_path("pkm_workspace")) / "urdf" / f"{machine}.urdf").read_text()


def wait_until(condition):
    """Looks again and again until it holds."""
    deadline = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError("waited in vain")


def slants(markers):
    """How many triangles of the set that a region lies in are across no axis: boxes have none."""
    corners = [[(p.x, p.y, p.z) for p in marker.points] for marker in markers if marker.ns == "paving_inside"]
    triangles = [zip(*points[k:k + 3]) for points in corners for k in range(0, len(points), 3)]
    return sum(all(len(set(values)) > 1 for values in triangle) for triangle in triangles)


class NodeProcess:
    """A node with these private parameters, on the text of a URDF (None: without one)."""

    def __init__(self, description, parameters=None):
        for name in (NAME, "/robot_description"):
            if rospy.has_param(name):
                rospy.delete_param(name)
        if description is not None:
            rospy.set_param("/robot_description", description)
        for name, value in (parameters or {}).items():
            rospy.set_param(f"{NAME}/{name}", value)
        executable = roslib.packages.find_node("pkm_workspace", "pkm_workspace_node")[0]
        environment = {**os.environ, "ROSCONSOLE_FORMAT": "${severity} ${logger}: ${message}",
                       "ROSCONSOLE_STDOUT_LINE_BUFFERED": "1"}
        self.process = subprocess.Popen([executable], env=environment, text=True, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT)
        self.lines = queue.Queue()
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self):
        """Goes on reading, so that the node never waits for a full pipe."""
        for line in self.process.stdout:
            self.lines.put(line)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.wait()
        self.process.stdout.close()

    def interrupt(self):
        self.process.send_signal(signal.SIGINT)

    def wait_for_output(self, text):
        """Waits until the node has said so."""
        while text not in self.lines.get(timeout=PATIENCE):
            pass

    def wait(self):
        """Waits for the node's end. Returns the exit code and all that it said since the last waiting."""
        code = self.process.wait(PATIENCE)
        self.reader.join(PATIENCE)
        return code, "".join(self.lines.get() for _ in range(self.lines.qsize()))
