# SPDX-License-Identifier: BSD-3-Clause
"""All that a node is asked, for answers of every kind."""

import copy
import math
import random
import re
import threading

from answer_claims import brackets, xyz
from claims import Case, criterion_of
from geometry_msgs.msg import Point, Vector3
from node_claims import definition_of
from node_process import PATIENCE, wait_until
from node_questions import solid
from oracle import Machine, Region
from pkm_workspace.client import line
from pkm_workspace.msg import Bounds, CriterionRequest, ErrorCode, RegionRequest
from pkm_workspace.srv import (CheckRegion, CheckRegionRequest, CompareMachines, CompareMachinesRequest,
                               ComputeConditioning, ComputeConditioningRequest, ComputeGuarantees,
                               ComputeGuaranteesRequest, FindSingularities,
                               FindSingularitiesRequest, SetCriterion)
from reasons import Wrong

ON, OFF = CriterionRequest.ON, CriterionRequest.OFF
FREE = CriterionRequest(joint_limits=OFF)
REACHABLE = CriterionRequest(set=CriterionRequest.REACHABLE, aspect=CriterionRequest.BOTH)
ONE_ASPECT = CriterionRequest(set=CriterionRequest.REACHABLE, aspect=CriterionRequest.OWN, joint_limits=OFF)
NARROW = CriterionRequest(psi_min=0.9999, psi_max=1.0001)
WIDE = CriterionRequest(psi_min=0.7, psi_max=1.4)
LONG = CriterionRequest(psi_min=0.05, psi_max=20, joint_limits=OFF)
SEED = 20261127
STATUS = ("none", "there", "undecided")


def is_about(markers, hypotheses):
    return criterion_of(markers[0].text) == criterion_of(definition_of(hypotheses))


def shows(markers, region):
    """Whether they are of this very region, and not of the one before, whose shape and criterion may be the same."""
    labels = [marker.text for marker in markers if marker.ns == "region" and marker.text.startswith(region.shape)]
    sizes = [float(re.search(r"[0-9.e-]*[0-9]", label[len(region.shape):])[0]) for label in labels]
    is_its = any(math.isclose(size, side, rel_tol=2e-3) for size in sizes for side in region.solid.dimensions)
    return is_its and is_about(markers, region.hypotheses)


class Questions:
    """For a test that holds the answers, with held(), answered(), computed(), shown() and texts()."""

    def ask(self, node):
        for questions in (self.points, self.regions, self.paths, self.jobs, self.limits, self.largest, self.goals,
                          self.pavings, self.pieces, self.singularities, self.means, self.guarantees, self.placements,
                          self.tools, self.criteria):
            questions(node)

    def points(self, node):
        for width in [0.1, 0.3, 0.6, 1.0] * 3:
            for criterion in (CriterionRequest(), FREE, REACHABLE):
                point = node.near(self.rng, width)
                self.answered(node, "evaluate_point", node.client.evaluate(point, criterion=criterion), point=point)

    def region(self, node, shape, dimensions, center, **fields):
        request = CheckRegionRequest(solid=solid(shape, dimensions), center=Point(*center), **fields)
        answer = node.client.call("check_region", CheckRegion, request)
        self.answered(node, "check_region", answer, region=Region(shape, dimensions, center),
                      bad_point=xyz(answer.bad_point))

    def regions(self, node):
        for share in (0.1, 0.25, 0.4, 0.7, 2):
            sides = [self.rng.uniform(0.8, 1.2) * share * node.span for _ in range(3)]
            for criterion in (CriterionRequest(), FREE, REACHABLE, WIDE):
                self.region(node, "box", sides, node.near(self.rng, 0.05), criterion=criterion)
        for shape, shares in (("sphere", [0.1]), ("sphere", [0.5]), ("disc", [0, 0.1]), ("disc", [0, 0.6]),
                              ("cylinder", [0.1, 0.2]), ("cylinder", [0.5, 0.5])):
            self.region(node, shape, [share * node.span for share in shares], node.near(self.rng, 0.05))
        for share in (0.2, 0.3, 0.4):
            self.region(node, "box", [share * node.span] * 3, node.center, max_boxes=1)
        at = [x + 0.55 * node.span for x in node.center]
        self.region(node, "box", [0.3 * node.span] * 3, at, criterion=ONE_ASPECT)

    def paths(self, node):
        for width in (0.05, 0.1, 0.5, 0.8, 0.8, 3):
            points = [node.center] + [node.near(self.rng, width) for _ in range(3)]
            for criterion, way in ((CriterionRequest(), points), (FREE, points), (FREE, points[::-1])):
                answer = node.client.check_line(way, criterion=criterion)
                segments = [(f"segment {k}", *ends) for k, ends in enumerate(zip(way, way[1:]))]
                self.answered(node, "check_path", answer, segments=segments)
        for width, speed in ((0.05, 0.4), (0.1, 0.5), (0.3, 0.4), (0.3, 0.8), (0.1, 3)):
            way = [node.center] + [node.near(self.rng, width) for _ in range(3)]
            segments = [(f"segment {k}", *ends) for k, ends in enumerate(zip(way, way[1:]))]
            for most in (math.inf, 0.5 / node.span):
                fields = {} if most == math.inf else {"joint_acceleration_max": most}
                answer = node.client.check_line(way, criterion=FREE, tool_speed=speed, **fields)
                self.answered(node, "check_path", answer, segments=segments, tool_speed=speed,
                              joint_acceleration_max=most)

    def jobs(self, node):
        """Lines in G-code, the last of which may lead away, or too fast."""
        for width, speed in ((0.05, 0.4), (1.5, 0.4), (0.05, 5)):
            ends = [[round(x, 9) for x in point] for point in (node.near(self.rng, 0.05), node.near(self.rng, width))]
            words = [" ".join(f"{axis}{1000 * x:.6f}" for axis, x in zip("XYZ", end)) for end in ends]
            answer = node.client.check_gcode(f"G90 G94 G21\nG1 F{60000 * speed} {words[0]}\n{words[1]}\n",
                                             tool_at=node.center, criterion=FREE)
            ways = zip((2, 3), [node.center, ends[0]], ends)
            self.answered(node, "check_gcode", answer, segments=[(f"segment {k}", *way) for k, *way in ways],
                          tool_speed=speed)

    def limits(self, node):
        sides, form = [0.1 * node.span] * 3, "linuxcnc"
        answer = node.client.export_limits(form, node.center, solid("box", sides), criterion=FREE)
        self.answered(node, "export_limits", answer, region=Region("box", sides, node.center))

    def found(self, node, **fields):
        region = node.client.largest_region(accuracy=0.02 * node.span, **fields)
        self.answered(node, "compute_largest_region", region)
        self.computed(node)
        self.answered(node, "get_region", node.client.last_region())
        if region.size > 0:
            self.shown(node, "markers", lambda markers: shows(markers, region), region.hypotheses, answer=region)

    def largest(self, node):
        for shape, criterion in (("cube", WIDE), ("square", FREE), ("sphere", FREE), ("disc", CriterionRequest())):
            self.found(node, shape=shape, criterion=criterion)
        self.found(node, shape="box", proportions=Vector3(2, 1, 1))
        self.found(node, shape="box", proportions=Vector3(2, 1, 1), turned=True)
        self.found(node, shape="cylinder", ratio_min=0.5, ratio_max=0.5)
        self.found(node, shape="cylinder", ratio_min=0.4, ratio_max=0.6)
        self.found(node, shape="cube", criterion=NARROW)
        self.found(node, shape="cube", use_search_box=True, min_corner=Point(*node.center),
                   max_corner=Point(*(x + 0.3 * node.span for x in node.center)))

    def goals(self, node):
        """One that would go on for ever, until it is cancelled."""
        told, enough = [], threading.Event()

        def note(feedback):
            told.append(feedback)
            if feedback.size > 0 and len(told) > 1:
                enough.set()

        goal = node.client.find_region(note, shape="sphere", accuracy=1e-14 * node.span, criterion=LONG)
        wait_until(lambda: enough.is_set() or goal.ended.is_set())
        goal.cancel_goal()
        self.assertTrue(goal.wait_for_result(PATIENCE))
        region = goal.get_result().region
        self.answered(node, "find_largest_region", region)
        self.computed(node)
        case = Case(machine=node.machine, rng=random.Random(SEED), answer=region,
                    criterion=criterion_of(definition_of(region.hypotheses)))
        brackets(case, told, region)
        wider = copy.deepcopy(told[0])
        wider.size_upper_bound *= 1.1
        self.assertRaises(Wrong, brackets, case, [told[0], wider], region)

    def pavings(self, node):
        resolution = 0.1 * node.span
        goal = node.client.approximate_workspace(resolution=2 * resolution, max_listed=500)
        self.assertTrue(goal.wait_for_result(PATIENCE))
        result = goal.get_result()
        self.assertEqual((ErrorCode.SUCCESS, result.message), (result.error_code, result.workspace.message))
        for source, answer in (("approximate_workspace", result.workspace),
                               ("compute_workspace", node.client.workspace(resolution=resolution, max_listed=2000))):
            ends = xyz(answer.min_corner) + xyz(answer.max_corner)
            self.answered(node, source, answer, ends=ends)
        node.computations += 1
        self.computed(node, ends=ends)
        self.shown(node, "workspace_markers", lambda markers: True, answer.hypotheses)
        node.pavings.append((criterion_of(definition_of(answer.hypotheses)), ends))

    def pieces(self, node):
        """How sets hang together."""
        others = [node.near(self.rng, 0.1)] + [[0.65 * node.span] * 3] * (node.name == "orthoglide")
        for ends in ([node.center, other] for other in others):
            answer = node.client.workspace(resolution=0.05 * node.span, components=True, connect=ends, psi_min=0.2,
                                           psi_max=5, joint_limits=False)
            node.computations += 1
            box = xyz(answer.min_corner) + xyz(answer.max_corner)
            node.pavings.append((criterion_of(definition_of(answer.hypotheses)), box))
            for text in (answer.components_message, answer.connection_message):
                self.held(node, "compute_workspace", text, answer=answer, connect=ends,
                          definition=definition_of(answer.hypotheses))

    def singular(self, node, machine=None, region=None, **fields):
        answer = node.client.call("find_singularities", FindSingularities, FindSingularitiesRequest(**fields))
        legs = [("serial", leg.name) for leg in node.machine.legs[float]] + [("parallel", "")]
        rows = [(*leg, STATUS[finding.status], [(a + b) / 2 for a, b in zip(xyz(finding.min_corner),
                                                                          xyz(finding.max_corner))],
                 (finding.least.lower, finding.least.upper)) for leg, finding in zip(legs, [*answer.serial,
                                                                                         answer.parallel])]
        more = {"machine": machine or node.machine}
        self.answered(node, "find_singularities", answer, findings=rows, region=region, **more)
        self.computed(node)
        caption = answer.message + "\n"
        self.shown(node, "singularity_markers", lambda markers: markers[0].text.startswith(caption) and is_about(
            markers, answer.hypotheses), answer.hypotheses, **more)

    def singularities(self, node):
        kind = FindSingularitiesRequest
        self.singular(node)
        self.singular(node, aspect=kind.OWN)
        self.singular(node, time_limit=1e-9)
        if node.name != "uranesx":  # whose rails have no end then
            self.singular(node, over=kind.REACHABLE)
        sides = [0.2 * node.span] * 3
        self.singular(node, over=kind.REGION, solid=solid("box", sides), center=Point(*node.center),
                      region=Region("box", sides, node.center))
        ends = [(-0.3 * node.span, (0.2 + 0.1 * k) * node.span) for k in range(3)]
        self.singular(node, machine=node.machine.limited(ends), over=kind.JOINT_RANGES,
                      ranges=[Bounds(*pair) for pair in ends])

    def means(self, node):
        sides = [0.3 * node.span, 0.2 * node.span, 0.25 * node.span]
        cases = [(Region("box", sides, node.center), 0), (None, 1e-9)] + [(None, 0)] * (node.name != "uranesx")
        for region, limit in cases:
            fields = {"over": 1, "solid": solid("box", sides), "center": Point(*node.center)} if region else {}
            request = ComputeConditioningRequest(accuracy=0.05, time_limit=limit, **fields)
            answer = node.client.call("compute_conditioning", ComputeConditioning, request)
            self.answered(node, "compute_conditioning", answer, region=region, accuracy=0.05)
            self.computed(node)

    def guarantees(self, node):
        known = CriterionRequest(joint_speed_max=[1], joint_effort_max=[1000], joint_stiffness=[1e6],
                                 joint_error_max=[1e-5])
        for share in (0.2, 4):
            sides = [share * node.span] * 3
            request = ComputeGuaranteesRequest(solid=solid("box", sides), center=Point(*node.center), criterion=known)
            answer = node.client.call("guarantee", ComputeGuarantees, request)
            self.assertEqual(len(answer.guarantees), 10)
            region = Region("box", sides, node.center)
            for found in answer.guarantees:
                self.held(node, "guarantee", found.message, answer=answer, region=region,
                          definition=definition_of(answer.hypotheses))
            self.answered(node, "guarantee", answer)
            self.computed(node)

    def placements(self, node):
        for width in (0.1, 1.5):
            points = [[self.rng.uniform(-width, width) * node.span for _ in range(3)] for _ in range(4)]
            ends = list(zip(points, points[1:]))
            for more in ({"largest_scale": True}, {"tool_speed": 0.4, "criterion": FREE}):
                within = [[side * node.span] * 3 for side in (-2, 2)]
                answer = node.client.place_path([line(*each) for each in ends], time_limit=3, box=within,
                                                accuracy=0.002 * node.span, **more)
                segments = [(f"segment {k}", *each) for k, each in enumerate(ends)]
                self.answered(node, "place_path", answer, segments=segments, place=xyz(answer.translation),
                              tool_speed=more.get("tool_speed"))
                self.computed(node)

    def tools(self, node):
        for share in (0, 0.1, 0.3):
            for _ in range(3):
                place = node.near(self.rng, share)
                self.texts(node, "box_markers", node.box_at(place), node.region.hypotheses)
        for share in (0.1, *[1.5] * 6):
            markers = node.tool_to(node.near(self.rng, share))
            self.texts(node, "tool_markers", markers, node.region.hypotheses)

    def criteria(self, node):
        answer = node.client.call("set_criterion", SetCriterion, CriterionRequest(psi_min=0.6, psi_max=1.7), 0)
        self.answered(node, "set_criterion", answer)
        self.computed(node)
        region = node.client.last_region()
        self.assertEqual(0.6, region.hypotheses.psi_min)
        self.answered(node, "get_region", region)

    def compare(self, node, urdfs):
        answer = node.client.call("compare_machines", CompareMachines, CompareMachinesRequest(
            urdfs, RegionRequest(accuracy=0.02 * node.span)))
        machines = [node.machine, *map(Machine, urdfs)]
        self.answered(node, "compare_machines", answer, hypotheses=answer.machines[0].region.hypotheses,
                      machines=machines)
        self.computed(node)
