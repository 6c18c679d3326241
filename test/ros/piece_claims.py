# SPDX-License-Identifier: BSD-3-Clause
"""What the oracle holds against answers of the node on how sets hang together, and on jobs line by line."""

import math

import connection_claims
from answer_claims import NEAR, motion, xyz
from claims import on, verdicts
from oracle import BAD
from reasons import hold


def components(case, match):
    found = case.answer.components
    hold(len(found) == int(match["count"]), match[0], "but the answer has", len(found))
    hold((case.answer.zero_component + 1 or None) == (match["zero"] and int(match["zero"])), match[0], case.answer)
    connection_claims.pieces(case, match, [(piece.cluster, xyz(piece.point)) for piece in found], False)


def connected(case, match):
    hold(case.answer.connection == case.answer.CONNECTED, case.answer)
    connection_claims.way(case, match, [xyz(point) for point in case.answer.connection_path], *case.connect)


def apart(case, match):
    hold(case.answer.connection == case.answer.APART, case.answer)
    connection_claims.part(case, *case.connect)


def job(case):
    """The lines that offend are bad where that is said, the others nowhere."""
    answer = case.answer
    hold(len(answer.offences) == answer.outside + answer.undecided, answer)
    told = {f"segment {offence.line}": offence for offence in answer.offences}
    for segment in case.segments:
        offence = told.get(segment[0])
        if not offence:
            hold(BAD not in verdicts(case, segment, 0, 1, 100), segment, "is not inside")
        elif offence.verdict == answer.OUTSIDE:
            hold(math.dist(on(segment, offence.bad_at), xyz(offence.point)) < NEAR, offence)
            if offence.limit.kind < offence.limit.JOINT_SPEED:
                hold(case.machine.verdict(xyz(offence.point), case.criterion) == BAD, "good at", offence)
    if answer.verdict == answer.INSIDE:
        motion(case)
