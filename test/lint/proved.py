#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds that every sentence that says 'proved' has a test: proved.py ROOT

Each string of src/ and include/ that says so is listed with the claims that cover it, which the oracle checks: of
test/cli/sentences.py for what the command tells, of test/ros/node_claims.py for what the node tells, of both for what
both tell. HELP stands where a text tells what the program does. A string that is not listed fails, and so does a claim
that is not there. Of the command's strings those are looked at that begin a sentence.
"""

import pathlib
import re
import sys

COMMAND, NODE, HELP = "test/cli/sentences.py", "test/ros/node_claims.py", "help"
COVERED = {
    "Proved: ": {COMMAND: ("inside", "bad point", "singular point", "largest", "remark"),
                 NODE: ("inside", "bad point", "singular point", "region told", "remark")},
    "Proved: every point of the ": {COMMAND: ("inside", ), NODE: ("inside", )},
    "Proved: every point of the path is in the set.": {COMMAND: ("path inside", ), NODE: ("path inside", )},
    "Proved: the point is ": {COMMAND: ("good point", ), NODE: ("good point", )},
    "Proved: the point is not ": {COMMAND: ("no good point", ), NODE: ("no good point", )},
    "Proved: the path ": {COMMAND: ("path leaves", ), NODE: ("path leaves", )},
    "Proved: at ": {COMMAND: ("path too fast", ), NODE: ("path too fast", )},
    " the joints are proved to keep within their limits.": {COMMAND: ("path inside", ), NODE: ("path inside", )},
    "The largest feed is proved to be ": {COMMAND: ("path inside", "path too fast"),
                                          NODE: ("path inside", "path too fast")},
    "Proved: with this translation, and moved from there by up to ": {COMMAND: ("placement", ), NODE: ("placement", )},
    "Proved: there is no translation that may be chosen with which ": {COMMAND: ("placement", ), NODE: ("placement", )},
    "Proved: no translation that may be chosen has a margin above ": {COMMAND: ("placement", ), NODE: ("placement", )},
    " Proved: no translation is such that ": {COMMAND: ("placement", ), NODE: ("placement", )},
    " Proved: scaled about ": {COMMAND: ("placement", ), NODE: ("placement", )},
    "Neither is proved: ": {COMMAND: ("nothing", ), NODE: ("nothing", )},
    "Neither is proved: the border of the set is within rounding of the point, where ": {COMMAND: ("nothing", ),
                                                                                         NODE: ("nothing", )},
    ". Nothing that was looked at is proved to be outside.": {COMMAND: ("nothing", ), NODE: ("nothing", )},
    "Proved: no point that counts is singular.": {COMMAND: ("singularities", ), NODE: ("singularities", )},
    "Proved: there are ": {COMMAND: ("singularities", ), NODE: ("singularities", )},
    "proved to the accuracy asked for": {COMMAND: ("status", "comparison"), NODE: ("region", )},
    "no region of any size exists where the center may lie, proved": {COMMAND: ("status", ), NODE: ("no region", )},
    "no cylinder of the volume that the accuracy asks for exists, proved": {COMMAND: ("status", ),
                                                                            NODE: ("no region", )},
    "no region as large as the accuracy exists where the center may lie, proved": {COMMAND: ("status", ),
                                                                                   NODE: ("no region", )},
    " stay within their limits is not proved": {COMMAND: ("nothing", ), NODE: ("remark", )},
    "Proved: the global conditioning index is from ": {COMMAND: ("mean", ), NODE: ("mean", )},
    "Nothing is proved of the global conditioning index: ": {COMMAND: ("no mean", ), NODE: ("no mean", )},
    "Proved for every point: ": {COMMAND: ("guarantee", ), NODE: ("guarantee", )},
    "Nothing is proved of ": {COMMAND: ("no guarantee", ), NODE: ("no guarantee", )},
    "hinge_limits cannot be proved: ": HELP,
    "the certificate cannot be written: the region is not proved once more": HELP,
    "a point that is not proved to be bad": HELP,
    "the set has no proved volume.": {COMMAND: ("no mean", ), NODE: ("no mean", )},
    "Proved: the points of the box that are ": {COMMAND: ("volume", ), NODE: ("set", )},
    "Proved: the boxes inside form ": {COMMAND: ("components", ), NODE: ("components", )},
    "Proved: the points are connected, and every point of the path of ": {COMMAND: ("connected", ),
                                                                          NODE: ("connected", )},
    "Proved: the points are apart. Both are ": {COMMAND: ("apart", ), NODE: ("apart", )},
    "Proved: no machine of the range has a ": {COMMAND: ("study", )},
    "Proved: the machine with ": {COMMAND: ("study", )},
    "box inside: proved for every point": {NODE: ("box inside", )},
    "no box of these proportions is proved at this center": HELP,
    "nothing can be proved on this computer: ": HELP,
    "Proved answers about machines with three legs and a platform that never turns (Orthoglide, UraneSX, ": HELP,
    "one (share 1). Proved are the region of the best machine found, an upper bound of the regions of all ": HELP,
}
COMMAND_ONLY = "src/cli/"
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')
SAYS, BEGINS = r"\b[Pp]rove[dn]?\b", r"Proved|proved:|Neither"


def claims_in(root):
    for path in sorted([*(root / "src").rglob("*"), *(root / "include").rglob("*")]):
        if path.suffix in (".cpp", ".h"):
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                for text in [] if line.lstrip().startswith("//") else STRING.findall(line):
                    if re.search(BEGINS if "cli" in path.parts else SAYS, text):
                        yield f"{path.relative_to(root)}:{number}", text


def teller(place):
    """The table that has to cover it: the node tells all that is not COMMAND_ONLY."""
    return COMMAND if place.startswith(COMMAND_ONLY) else NODE


def missing(cover, claims):
    """Claims that are named and not there."""
    if cover != HELP:
        yield from ((table, name) for table, names in cover.items() for name in names if name not in claims[table])


def main():
    root = pathlib.Path(sys.argv[1])
    sys.path[:0] = [str(root / "test" / folder) for folder in ("cli", "ros")]
    import node_claims
    import sentences
    claims = {COMMAND: sentences.CLAIMS, NODE: node_claims.CLAIMS}
    found = list(claims_in(root))
    problems = [f"{place}: no test is named for the sentence '{text}'" for place, text in found
                if COVERED.get(text) != HELP and teller(place) not in COVERED.get(text, ())]
    problems += [f"{text}: {cover} is not there" for text in COVERED for cover in missing(COVERED[text], claims)]
    problems += [f"no source says: '{text}'" for text in set(COVERED) - {text for _, text in found}]
    problems += [f"{NODE}: nothing that the node says is a '{name}'" for name in set(node_claims.CLAIMS) -
                 {name for names in node_claims.SOURCES.values() for name in names}]
    print("\n".join(problems) or f"{len(found)} sentences have their tests")
    return 1 if problems or not found else 0


if __name__ == "__main__":
    sys.exit(main())
