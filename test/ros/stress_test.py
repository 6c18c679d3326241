#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Eight clients at once, while goals are set and cancelled: no wrong answer, no lost reply, memory that stays."""

import collections
import pathlib
import random
import threading
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from pkm_workspace.client import Client, Refused
from pkm_workspace.msg import Region

NODE = "/pkm_workspace_node"
SEED = 20261122
ENDED = (GoalStatus.SUCCEEDED, GoalStatus.PREEMPTED, GoalStatus.RECALLED)
PATIENCE = 60.0
EDGE = 0.643950551  # of the largest cube [m]
VOLUME = 1.632  # of the dextrous set [m^3]
MORE = 16 << 20  # what memory may grow by once it has settled [bytes]


def resident():
    """Memory of the node [bytes]."""
    node = rosgraph.Master(rospy.get_name()).lookupNode(NODE)
    pid = xmlrpc.client.ServerProxy(node).getPid(rospy.get_name())[2]
    return int(pathlib.Path(f"/proc/{pid}/statm").read_text().split()[1]) * 4096


def evaluates(machine, chance):
    x = chance.uniform(-0.2, 0.2)
    answer = machine.evaluate((x, 0.0, 0.0))
    return answer.verdict == machine.INSIDE and answer.psi[0].lower <= 1.0 <= answer.psi[2].upper


def checks_regions(machine, chance):
    inside = chance.random() < 0.5
    edge = EDGE - 1e-6 if inside else EDGE + 1e-6
    answer = machine.check_box((0.086273015,) * 3, (edge,) * 3)
    return answer.verdict == (machine.INSIDE if inside else machine.OUTSIDE)


def checks_paths(machine, chance):
    far = chance.choice((0.2, 0.9))
    answer = machine.check_line([(0, 0, 0), (0.1, 0, 0), (far, far, 0)])
    return answer.verdict == (machine.INSIDE if far == 0.2 else machine.OUTSIDE)


def computes(machine, chance):
    region = machine.largest_region(accuracy=chance.choice((1e-2, 1e-3)))
    return region.status == Region.PROVEN and region.size <= EDGE + 1e-9 and EDGE - 1e-9 <= region.size_upper_bound


def paves(machine, chance):
    workspace = machine.workspace(resolution=chance.choice((0.2, 0.1)))
    return workspace.volume_lower_bound <= VOLUME + 1e-3 and VOLUME - 1e-3 <= workspace.volume_upper_bound


def is_refused(machine, _):
    try:
        machine.largest_region(accuracy=-1.0)
    except Refused as refused:
        return "accuracy = -1" in str(refused)
    return False


def sets_and_cancels_goals(machine, chance):
    """A goal that another client preempts ends as well as one that is cancelled."""
    active = threading.Event()
    goal = machine.find_region(active=active.set, shape=chance.choice(("cube", "sphere")), accuracy=1e-6)
    while not (active.wait(0.01) or goal.get_state() in ENDED):  # one that is preempted early never becomes active
        pass
    if chance.random() < 0.7:
        goal.cancel_goal()
    if not goal.wait_for_result(PATIENCE):
        return False
    if goal.get_state() == GoalStatus.RECALLED:
        return True
    region = goal.get_result().region
    return goal.get_state() in ENDED and region.size <= region.size_upper_bound


SERVICES = (evaluates, checks_regions, checks_paths, computes, paves, is_refused)
CLIENTS = [SERVICES] * 6 + [(sets_and_cancels_goals,)] * 2


class StressTest(unittest.TestCase):
    def work(self, number, end):
        """One client, until time is up."""
        machine, chance = Client(NODE, PATIENCE), random.Random(SEED + number)
        while time.monotonic() < end:
            task = chance.choice(CLIENTS[number])
            self.begun[number] += 1
            try:
                if not task(machine, chance):
                    self.wrong.append(f"client {number} of seed {SEED}: {task.__name__}")
            except Exception as error:  # a reply that was lost
                self.wrong.append(f"client {number}: {task.__name__}: {error!r}")
            self.done[number] += 1
            self.counts[task.__name__] += 1

    def run_for(self, seconds):
        end = time.monotonic() + seconds
        threads = [threading.Thread(target=self.work, args=(number, end)) for number in range(len(CLIENTS))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(seconds + 2 * PATIENCE)
        return not any(thread.is_alive() for thread in threads)

    def test_eight_clients_at_once(self):
        self.wrong, self.counts = [], collections.Counter()
        self.begun, self.done = [0] * len(CLIENTS), [0] * len(CLIENTS)
        seconds = rospy.get_param("~seconds")
        Client(NODE, PATIENCE).largest_region()
        self.assertTrue(self.run_for(0.3 * seconds), "a client waits for ever")
        settled = resident()
        self.assertTrue(self.run_for(0.7 * seconds), "a client waits for ever")
        grown = resident() - settled
        rospy.loginfo("%s; memory %d MiB, grown by %d kiB", dict(self.counts), settled >> 20, grown >> 10)
        self.assertEqual([], self.wrong[:10])
        self.assertEqual(self.begun, self.done)
        self.assertEqual({task.__name__ for tasks in CLIENTS for task in tasks}, set(self.counts))
        self.assertLess(grown, MORE)


if __name__ == "__main__":
    rospy.init_node("stress_test")
    rostest.rosrun("pkm_workspace", "stress", StressTest)
