#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every sentence of the node on seeded machines, from its services, actions, markers, diagnostics and log, against the
oracle, with the fields beside it; and that the oracle objects to wrong ones."""

import os
import pathlib
import random
import re
import sys
import unittest

import roslib.packages
import rospy
import rostest

os.environ["PKM"] = roslib.packages.find_node("pkm_workspace", "pkm")[0]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))

import node_claims
from claims import Case, criterion_of
from crooked import crooked
from node_claims import definition_of
from node_questions import Node
from oracle import Machine
from pkm import run
from questions import SEED, Questions
from reasons import Wrong
from visualization_msgs.msg import Marker
from wrong_answers import WRONG

CASES = int(os.environ.get("PKM_WORKSPACE_TEST_CASES", 1))
LINE = re.compile(r"(?:INFO|WARN) ros\.pkm_workspace\.(\w+): (.*)", re.S)


def texts_of(markers):
    """Lines of small letters are markers of their own, one after the other."""
    texts = []
    for before, marker in zip([None, *markers], markers):
        if before and before.type == marker.type == Marker.TEXT_VIEW_FACING and before.ns == marker.ns:
            texts[-1] += "\n" + marker.text
        elif marker.text:
            texts.append(marker.text)
    return set(texts)
DRIVES = ("--joint-speed-max", 1, "--joint-effort-max", 1000)


class SentencesTest(Questions, unittest.TestCase):
    seen, caught = set(), set()  # claims, and the wrong versions of them that were refuted: (claim, number)

    def setUp(self):
        self.rng = random.Random(SEED)
        self.told = set()  # sentences that were held

    def held(self, node, source, text, **more):
        case = Case(**{"machine": node.machine, "rng": random.Random(SEED), "source": source, "text": text,
                       "held_before": self.told, **more})
        with self.subTest(machine=node.name, source=source, text=text):
            claim = node_claims.check(Case(**vars(case)))
            self.told.add(text)
            self.seen.add(claim)
            for k, spoil in enumerate(WRONG.get(claim, ())):
                if (claim, k) not in self.caught:
                    self.refute(claim, k, spoil(case))

    def refute(self, claim, k, case):
        try:
            node_claims.check(case)
        except Wrong:
            self.caught.add((claim, k))

    def answered(self, node, source, answer, **more):
        """Holds the message of an answer with hypotheses."""
        hypotheses = more.pop("hypotheses", None) or answer.hypotheses
        self.held(node, source, answer.message, answer=answer, definition=definition_of(hypotheses), **more)

    def computed(self, node, **more):
        """Holds what /diagnostics tell of a computation."""
        question, answer = node.diagnosis()
        self.held(node, "answer", answer, definition=question, **more)
        node.computations += 1

    def shown(self, node, topic, fits, hypotheses, **more):
        """Holds the texts of the first markers that fit."""
        markers = node.topics[topic].wait(lambda array: fits(array.markers)).markers
        self.texts(node, topic, markers, hypotheses, **more)

    def texts(self, node, topic, markers, hypotheses, **more):
        for text in texts_of(markers):
            self.held(node, topic, text, markers=markers, hypotheses=hypotheses, definition=definition_of(hypotheses),
                      **more)

    def read_log(self, node):
        question = None
        for line in node.log():
            match = LINE.fullmatch(line)
            self.assertTrue(match, line)
            if match[2].startswith("computing: "):
                question = match[2][len("computing: "):]
            else:
                is_answer = match[1] == "server" and not match[2].startswith("the bounds")
                is_paving = is_answer and question and question.startswith("paving")
                ends = [ends for about, ends in node.pavings if is_paving and criterion_of(question) == about]
                self.held(node, "answer" if is_answer else "log", match[2], definition=is_answer and question,
                          ends=ends[0] if ends else None)

    def hold_all(self, name, urdf, others=()):
        with Node(name, urdf, {"show_boundary": True}) as node:
            self.answered(node, "get_region", node.region)
            self.computed(node)
            self.ask(node)
            if others:
                self.compare(node, others)
            self.read_log(node)

    def test_orthoglide(self):
        urdf = run("urdf", "--machine", "orthoglide", "--length", self.rng.uniform(0.2, 2), *DRIVES).stdout
        self.hold_all("orthoglide", urdf, [crooked(self.rng)])

    def test_uranesx(self):
        urdf = run("urdf", "--machine", "uranesx", "--lambda", self.rng.uniform(0, 0.1), *DRIVES).stdout
        self.hold_all("uranesx", urdf)

    def test_crooked_machines(self):
        for _ in range(CASES):
            self.hold_all("crooked", crooked(self.rng))

    @classmethod
    def tearDownClass(cls):
        """After all tests: every claim was met, and every kind of wrong one refuted."""
        print("seed", SEED)
        unseen = set(node_claims.CLAIMS) - cls.seen - node_claims.RARE
        missed = {(claim, k) for claim, spoils in WRONG.items() for k in range(len(spoils))} - cls.caught
        if unseen or missed or Machine.undecided:
            raise AssertionError(f"never met: {unseen}; never refuted: {missed}; undecided points: {Machine.undecided}")


if __name__ == "__main__":
    rospy.init_node("sentences_test")
    rostest.rosrun("pkm_workspace", "sentences", SentencesTest)
