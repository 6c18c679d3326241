# SPDX-License-Identifier: BSD-3-Clause
"""The reasons that are told for a bad point, each against the state of the machine there."""

import math
import re

N = r"(-?[\d.]+(?:e[-+]?\d+)?)"
UNIT = r"(?: m(?:/s(?:\^2)?)?)?"


class Wrong(AssertionError):
    """A sentence that the oracle refutes, or that no pattern knows."""


def hold(condition, *what):
    if not condition:
        raise Wrong(" ".join(map(str, what)))


def number_or_near(text, bound, value, slack, where):
    """The end of a reason: a value on its side of the bound, or by how much at most it is there."""
    match = re.fullmatch(rf"(?:is|would be)(?: at)? {N}{UNIT}, (above|below) {bound}", text)
    if match:
        told, limit = float(match[1]), float(match[3])
        hold(abs(told - value) <= 1e-5 * max(1, abs(value)) + slack, where, told, "is told,", value, "is right")
        hold((told > limit) == (match[2] == "above"), where, text)
        return
    match = re.fullmatch(rf"(?:is|would be) (above|below) {bound}(?:, by at most {N}{UNIT})?", text)
    if match:
        limit, sign = float(match[2]), 1 if match[1] == "above" else -1
        hold(sign * (value - limit) >= -slack, where, text, "but it is", value)
        hold(match[3] is None or abs(value - limit) <= float(match[3]) + slack, where, text, "but it is", value)
        return
    match = re.fullmatch(rf"reaches {bound}(?:, to within {N}{UNIT}| exactly)", text)
    hold(match, "no pattern knows the reason:", where, text)
    hold(abs(value - float(match[1])) <= float(match[2] or 0) + slack, where, text, "but it is", value)


def strut(machine, name, text, state, slack):
    at = [leg.name for leg in machine.legs[float]].index(name)
    length = machine.legs[float][at].length
    across = math.sqrt(max(0, length**2 - state.radicands[at]))
    match = re.fullmatch(rf"is {N} m long(.*)", text)
    hold(match and abs(float(match[1]) - length) <= 1e-8 * length, name, text, "but it is", length)
    far = re.fullmatch(rf" and (would have to reach|reaches) {N} m across its rail", match[2])
    near = re.fullmatch(rf", too short to reach across its rail(?:, by at most {N} m)?", match[2])
    just = re.fullmatch(rf" and reaches as far across its rail(?: or less)?(?:, to within {N} m| exactly)?"
                        r"(?: \(serial singularity\))?", match[2])
    hold(far or near or just, "no pattern knows the reason:", text)
    is_kept = just or far and far[1] == "reaches"
    hold(is_kept or across >= length - slack, text, "but it reaches", across, "of", length)
    if far:
        hold(abs(float(far[2]) - across) <= 1e-5 * across + slack, text, "but", across)
        hold((far[1] == "reaches") == (float(far[2]) < length), text, "of", length)
    if near or just:
        by = 0 if text.endswith("exactly") else (near or just)[1]
        hold(by is None or abs(across - length) <= float(by) + slack, text, "but", across - length)


def reason(case, text, point, slack=1e-9):
    """@param slack how far values may be off because the point is not known better"""
    machine = case.machine
    state, sign = machine.state(point), machine.sign * (-1 if case.criterion.aspect == "other" else 1)
    match = re.fullmatch(r"the strut of '(.*)' (is .*)", text)
    if match:
        return strut(machine, match[1], match[2], state, slack)
    match = re.fullmatch(r"joint '(.*?)' (.*)", text)
    if match:
        at = [leg.name for leg in machine.legs[float]].index(match[1])
        end = 1 if "upper limit" in text else 0
        limit = re.search(rf"its (?:lower|upper) limit of {N} m", text)
        hold(limit and float(limit[1]) == machine.legs[float][at].limits[end], text)
        bound = rf"its (?:lower|upper) limit of {N} m"
        return number_or_near(match[2], bound, state.rhos[at], slack, match[1])
    match = re.fullmatch(r"the (least|largest) velocity transmission factor (.*)", text)
    if match:
        value = state.psi()[0 if match[1] == "least" else 2]
        return number_or_near(match[2], N, value, slack * (1 + value) + 1e-7, match[1] + " factor")
    if text == "det A has the wrong sign for this aspect, beyond a parallel singularity":
        return hold(state.in_reach and state.det * sign < slack, text, "but det A is", state.det)
    match = re.fullmatch("det A over the product of the struts' lengths, with the sign of the aspect, (.*)", text)
    hold(match, "no pattern knows the reason:", text)
    scale = math.prod(leg.length for leg in machine.legs[float])
    return number_or_near(match[1], "(0)", state.det * sign / scale, slack, "det A")
