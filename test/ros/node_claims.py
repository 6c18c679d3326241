# SPDX-License-Identifier: BSD-3-Clause
"""What the node says, each kind of sentence from each place that it comes from, and what the oracle holds of it."""

import math
import re

import answer_claims as answers
import marker_claims as markers
import piece_claims as pieces
import sentences
from claims import criterion_of
from reasons import N, hold

QUESTION = (r"(?P<question>(?:largest|paving of all points that are|singularities of|global conditioning index of|"
            r"comparison by the largest|placement of a path whose points are) .*)")
REMARK = r"(?: (?P<remark>Joint limits are off: .*))?"
SIDES = r"(?P<x>\S+) x (?P<y>\S+) x (?P<z>\S+) m\n"
BINDS = r"(?P<kind>reach|joint_lower|joint_upper|aspect|psi_min|psi_max)(?: of (?P<joint>\w+))?"
EFFORT = r" \d+ boxes, \S+ s"
BY_COMMAND = ("inside", "remark", "bad point", "singular point", "nothing", "good point", "no good point",
              "path inside", "path leaves", "path too fast", "placement", "singularities")

LINES = r"(?: \d+ lines offend: \d+ outside, \d+ undecided\.)?"  # of a job in G-code

# name: pattern, and the function that holds a match against the oracle; None where nothing is claimed
CLAIMS = {
    **{name: sentences.CLAIMS[name] for name in BY_COMMAND},
    **{"job" + name[4:]: (sentences.CLAIMS[name][0] + LINES, sentences.CLAIMS[name][1])
       for name in ("path inside", "path leaves", "path too fast")},
    "region": (r"(?P<proven>Proved to the accuracy asked for)\." + REMARK, answers.region),
    "no region": (r"(?P<none>No (?:region|cylinder) .*, proved)\.", answers.region),
    "wide": (r"(?:.* ended the search: the bracket holds, but is wide|The accuracy is below what .*?)\." + REMARK,
             answers.region),
    "mean": (sentences.MEAN, answers.mean),
    "no mean": (sentences.NO_MEAN, answers.no_mean),
    "guarantee": sentences.CLAIMS["guarantee"],
    "no guarantee": sentences.CLAIMS["no guarantee"],
    "guarantees": (r"\d+ quantities are told\.(?: \S+ s)?", None),
    "set": (sentences.VOLUME, answers.paving),
    "components": (sentences.CLAIMS["components"][0], pieces.components),
    "connected": (sentences.CLAIMS["connected"][0], pieces.connected),
    "apart": (sentences.CLAIMS["apart"][0], pieces.apart),
    "comparison": (r"(?P<count>\d+) machines were compared\.", answers.comparison),
    "asked": ("Computing: " + QUESTION + r"\.", None),
    # log lines and /diagnostics: the answer to the question before it
    "region told": (r"(?:(?P<found>\w+) at \((?P<center>.*?)\) m of frame '\w+', "
                    r"(?:turned by (?P<angle>\S+) rad, )?.*? "
                    r"(?P<size_told>\S+), dimensions (?P<dimensions>[^m]*) m"
                    r"(?:, volume (?P<volume_told>\S+) m\^3)?\. )?"
                    rf"(?P<proof>{sentences.CLAIMS['largest'][0]}){EFFORT}", answers.region_told),
    "set told": (sentences.VOLUME + EFFORT, answers.set_told),
    "singularities told": (r"(?P<sentence>.*\.)(?: \S+ s)?", answers.singularities_told),
    "mean told": (rf"(?P<sentence>{sentences.MEAN})(?: \S+ s)?", answers.mean_told),
    "placement told": (re.sub(r"[?]P<[a-z_]+>", "?:", sentences.CLAIMS["placement"][0]) + r"(?: \S+ s)?", None),
    "comparison told": (r"\d+ machines were compared\.", None),
    "wide told": (r"the bounds are wider than asked: .*", None),
    "other": (r"(?!.*prove).*", None),  # of the URDF, and of the boxes in a picture
    # markers
    "label": (rf"(?P<shape>\w+) (?:{N} m high, radius {N} m|of radius {N} m|{N}(?: x {N}(?: x {N})?)? m)"
              r"(?:\nturned by (?P<turn>\S+) degrees)?", markers.label),
    "stroke": (rf"(?P<joint>\w+)\n{N} m", markers.stroke),
    "caption": (r"(?:(?P<sentence>.*)\n)?\w+, geometry \w{8}, pkm_workspace \S+\n(?:dextrous|reachable).*",
                markers.caption),
    "box inside": (rf"{SIDES}box inside: proved for every point\nnearest limit: {BINDS}", markers.box_inside),
    "box outside": (rf"{SIDES}box outside: a bad point is near\nwhich breaks {BINDS}", markers.box_outside),
    "box undecided": (rf"{SIDES}box undecided: the border of the set is too near\nnearest limit: {BINDS}", None),
    "kind": (r"serial singularity: (?P<joint>\w+)|parallel singularity", markers.singularity),
    "tool within": (rf"nearest limit: (?:psi (?P<psi>{N}), at (?P<side>least|most) {N} asked|(?P<reason>.*))",
                    markers.tool_within),
    "tool": (r"(?P<reason>(?:the|joint|det) .*?)", markers.tool),
    "tool elsewhere": (r"tool point \(.*\) m: .*|at or beyond a parallel singularity.*|"
                       r".*\(serial singularity\)", None),
}
REGION = ("region", "no region", "wide")
RARE = {"singular point", "box undecided", "wide told", "tool elsewhere"}  # may be met with no seed
SOURCES = {
    "check_region": ("inside", "remark", "bad point", "singular point", "nothing"),
    "check_path": ("path inside", "path leaves", "path too fast", "nothing"),
    "check_gcode": ("job inside", "job leaves", "job too fast"),
    "export_limits": ("inside", "remark"),
    "place_path": ("placement", ),
    "evaluate_point": ("good point", "no good point", "nothing"),
    "compute_largest_region": REGION,
    "find_largest_region": REGION,
    "get_region": REGION,
    "compute_conditioning": ("mean", "no mean"),
    "guarantee": ("guarantee", "no guarantee", "guarantees"),
    "compute_workspace": ("set", "components", "connected", "apart"),
    "approximate_workspace": ("set", ),
    "find_singularities": ("singularities", ),
    "compare_machines": ("comparison", ),
    "set_criterion": ("asked", ),
    "answer": ("region told", "set told", "mean told", "comparison told", "placement told",
               "singularities told", "guarantees"),
    "log": ("wide told", "other"),
    "markers": ("label", "stroke", "caption"),
    "workspace_markers": ("caption", ),
    "singularity_markers": ("kind", "caption"),
    "box_markers": ("box inside", "box outside", "box undecided", "caption"),
    "tool_markers": ("tool within", "tool", "tool elsewhere", "caption"),
}
INSIDE, OUTSIDE, UNDECIDED = 1, 2, 3
VERDICTS = {"inside": INSIDE, "remark": INSIDE, "bad point": OUTSIDE, "singular point": OUTSIDE, "nothing": UNDECIDED,
            "path inside": INSIDE, "path too fast": OUTSIDE, "job inside": INSIDE, "job leaves": OUTSIDE,
            "job too fast": OUTSIDE, "good point": INSIDE, "no good point": OUTSIDE}


def definition_of(hypotheses):
    """In the words of the node's questions."""
    hold(hypotheses.force_min == hypotheses.force_max == hypotheses.kappa_max == 0, "the oracle does not know these")
    dextrous = f"dextrous with psi in [{hypotheses.psi_min!r}, {hypotheses.psi_max!r}]"
    return ("", dextrous, "reachable")[hypotheses.set] + ", " + ("", "own", "other", "both")[hypotheses.aspect] + \
        " aspect, joint limits " + ("on" if hypotheses.joint_limits else "off")


def check(case):
    """Holds a sentence and what stands beside it against the oracle. @return the name of the claim"""
    if case.source == "check_gcode":
        case.text = re.sub(r"\bgcode:(\d+)", r"segment \1", case.text)
    is_free = not case.definition or case.definition == "global conditioning index of a region"
    case.criterion = None if is_free else criterion_of(case.definition)
    for name in SOURCES[case.source]:
        pattern, holds = CLAIMS[name]
        match = re.fullmatch(pattern, case.text)
        if not match:
            continue
        if holds:
            holds(case, match)
        if name in VERDICTS and case.source != "export_limits":  # which answers only what is inside
            hold(case.answer.verdict == VERDICTS[name], name, case.answer)
        if case.source == "check_path":
            answers.path(case)
        if case.source == "check_gcode":
            pieces.job(case)
        if case.source == "evaluate_point":
            answers.point(case)
        return name
    hold(False, "no pattern knows what", case.source, "says:", case.text)
    return math.nan
