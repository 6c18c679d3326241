# SPDX-License-Identifier: BSD-3-Clause
"""The report of one machine: regions, what its joints take, what binds, sections of the factors, volumes."""

import math
from xml.etree import ElementTree

import numpy as np

from pkm_workspace import core
from pkm_workspace.errors import PkmError
from pkm_workspace.report import plots
from pkm_workspace.report.body import outline_of, surface_of
from pkm_workspace.report.numbers import bracket, in_words, number, rounded_up
from pkm_workspace.report.page import Page

SHAPES = (("cube", {}), ("sphere", {}), ("cylinder", {"ratio": [0.5, 0.5]}), ("square", {}))
FINENESS = 61  # points along each side of a section
OF_SEARCHES = {"accuracy", "threads", "time_limit", "max_memory", "max_boxes", "multi_precision", "certificate",
               "progress", "json", "turned"}
PLACES = {"base_z", "center", "search_box"}


def machine(machine, path, *, shapes=SHAPES, **criterion):
    """Writes the report of a machine. criterion: the keywords of largest() that say what every point satisfies."""
    asked = {key: value for key, value in criterion.items() if key not in OF_SEARCHES}
    regions = regions_of(machine, shapes, criterion)
    first = next((region for _, region in regions if region.size), None)
    if first is None:
        raise PkmError(f"no region of {machine.name} is proved: {regions[0][1].message}")
    page = Page(f"Machine {machine.name}", f"geometry {first.geometry_hash}; {said(first, criterion)}")
    add_regions(page, regions, PLACES & set(criterion))
    add_joints(page, machine, first)
    add_binding(page, machine, first, asked)
    add_sections(page, machine, first, asked)
    add_volumes(page, machine, asked)
    page.save(path)


def regions_of(machine, shapes, criterion):
    """The answer for each shape; of those that cannot be asked for, the reason, unless that is so for all of them."""
    found, reasons = [], []
    for name, measures in shapes:
        try:
            found.append((name, core.largest(machine, shape=name, **{**measures, **criterion})))
        except PkmError as reason:
            reasons.append(reason)
            found.append((name, core.Result(size=None, message=str(reason))))
    if len(reasons) == len(found):
        raise reasons[0]
    return found


def said(region, asked):
    """What the numbers of an answer hold for: what they were asked with, too."""
    bounds = f"velocity transmission factors in [{region.psi_min:g}, {region.psi_max:g}]" \
        if region.get("psi_min") and region.get("psi_max") else f"{region['set']} points"
    more = in_words({key: value for key, value in asked.items() if key not in ("psi_min", "psi_max", "joint_limits")})
    return (f"{bounds}, {'within' if region.joint_limits else 'without'} the joint limits, aspect {region.aspect}"
            + (f"; asked with {more}" if more else ""))


def meaning(region):
    """What the size of a shape is, and its unit."""
    return {"cube": "edge", "square": "edge", "sphere": "radius", "cylinder": "height"}.get(region.shape, "size")


def add_regions(page, regions, places):
    page.section("The largest regions")
    page.text("Every point of each of these regions satisfies the conditions, proved; and no region of that shape"
              + (f" with the {' and '.join(sorted(places)).replace('_', ' ')} that was asked for" if places else "")
              + " is larger than the upper end of its bracket.")
    found = [(name, region) for name, region in regions if region.size]
    page.table(["shape", "size", "center [m]", "volume", "status"],
               [[name, f"{meaning(region)} {bracket(region.size, region.size_upper_bound, 'm')}",
                 ", ".join(number(x, digits=4) for x in region.center),
                 bracket(region.volume, region.volume_upper_bound, "m³") if region.get("volume") else "flat", region.status]
                if region.size else [name, "none", "", "", region.message] for name, region in regions])
    page.figure(plots.bars([f"{name}: {meaning(region)}" for name, region in found],
                           [region.size for _, region in found], [region.size_upper_bound for _, region in found],
                           "size [m]"), "Blue: proved to be free of bad points. Orange: up to where there may be a "
                                        "larger one.")


def limits_of(urdf):
    """Of each joint with limits, as the URDF says them."""
    found = {}
    for joint in ElementTree.fromstring(urdf).iter("joint"):
        limit = joint.find("limit")
        if limit is not None and joint.get("type") in ("prismatic", "revolute"):
            found[joint.get("name")] = float(limit.get("lower", 0)), float(limit.get("upper", 0))
    return found


def add_joints(page, machine, region):
    page.section(f"What the joints do in the {region.shape}")
    limits = limits_of(machine.urdf)
    page.table(["joint", "least", "largest", "stroke", "limits"],
               [[joint.joint, bracket(*joint.enclosures.lower, joint.unit), bracket(*joint.enclosures.upper, joint.unit),
                 f"{rounded_up(joint.stroke)} {joint.unit}", " to ".join(f"{x:g}" for x in limits.get(joint.joint, ()))]
                for joint in region.joint_ranges])
    for unit in dict.fromkeys(joint.unit for joint in region.joint_ranges):
        page.figure(plots.ranges([(joint.joint, (joint.lower, joint.upper), limits.get(joint.joint))
                                  for joint in region.joint_ranges if joint.unit == unit], f"joint value [{unit}]"),
                    "Blue: the certified range of each joint while the tool goes through the region. Grey: its limits.")


def add_binding(page, machine, region, criterion):
    page.section("What binds")
    points = surface_of(region)
    answers = core.evaluate(machine, points=points, **of_evaluate(criterion)).points
    page.text(f"The nearest limit at the center of the {region.shape} and at the corners of its surface. The margin is "
              "how far the value is from its bound, both in SI units where they have one.")
    page.table(["point [m]", "limit", "joint", "value", "bound", "margin"],
               [[", ".join(number(float(x), digits=4) for x in point), answer.binding.limit, answer.binding.joint or "",
                 number(answer.binding.value), number(answer.binding.bound), margin_of(answer)]
                for point, answer in zip(points, answers)])


def margin_of(answer):
    """Values are enclosed for each condition by itself: one may look worse than what is proved of all of them."""
    margin = answer.binding.margin
    return "not negative, proved" if answer.satisfies and margin is not None and margin < 0 else number(margin, digits=3)


def of_evaluate(criterion):
    known = core.keywords_of("evaluate")
    return {key: value for key, value in criterion.items() if key in known}


def add_sections(page, machine, region, criterion):
    page.section("Sections of the transmission factors")
    center = np.array(region.center)
    reach = 1.6 * max(max(region.dimensions), 1e-9)
    steps = np.linspace(-reach, reach, FINENESS)
    for name, pick, levels in (("least", min, [region.get("psi_min")]), ("largest", max, [region.get("psi_max")])):
        planes = [plane_of(machine, center, steps, axes, pick, region, criterion) for axes in ((0, 1), (0, 2), (1, 2))]
        page.figure(plots.sections(planes, [level for level in levels if level], f"{name} factor [1]"),
                    f"The {name} velocity transmission factor over the planes through the region's center, in floating "
                    "point; values above three times psi_max have its color. Orange: the bound. White: the region. Nothing is drawn where the machine does not reach.",
                    is_wide=True)


def plane_of(machine, center, steps, axes, pick, region, criterion):
    points = np.tile(center, (len(steps) ** 2, 1))
    points[:, axes[0]] += np.repeat(steps, len(steps))
    points[:, axes[1]] += np.tile(steps, len(steps))
    answers = core.evaluate(machine, points=points, **of_evaluate(criterion)).points
    if len(answers) < len(points):
        raise KeyboardInterrupt
    field = [pick(answer.psi) if answer.psi and answer.within_reach else math.nan for answer in answers]
    names = "xyz"
    field = np.clip(np.array(field).reshape(len(steps), -1), None, 3 * (region.get("psi_max") or 2))
    return (names[axes[0]], center[axes[0]] + steps, names[axes[1]], center[axes[1]] + steps, field,
            outline_of(region, center, axes))


def add_volumes(page, machine, criterion):
    page.section("The whole set")
    page.text("Of all points that satisfy the conditions, wherever they lie.")
    known = core.keywords_of("pave")
    keywords = {key: value for key, value in criterion.items() if key in known}
    try:
        paving = core.pave(machine, list_boxes=1, volume_to=1e-3, **keywords)
    except PkmError as reason:
        page.text(f"Its volume is not known: {reason}")
        return
    name, unit = {1: ("length", "m"), 2: ("area", "m²"), 3: ("volume", "m³")}[paving.dimension]
    page.table(["set", name], [[f"all {paving['set']} points, aspect {paving.aspect}",
                                bracket(paving[f"{name}_lower"], paving[f"{name}_upper"], unit)]])
    page.text(paving.message)
