#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds that every sentence that begins with 'Proved' has a test: proved.py ROOT

Each string of src/ and include/ that says 'Proved' or 'proved:' is listed with what covers it: a claim of
test/cli/sentences.py, which the oracle checks, a test of the node ('file: test'), or HELP where a text tells what the
program does. A string that is not listed fails, and so does a test that is not there.
"""

import pathlib
import re
import sys

HELP = "help"
COVERED = {
    "Proved: every point of the box is ": "box inside",
    "Proved: no further than ": "singular point",
    "Proved: the bad point lies in the box and is not ": "bad point",
    "Proved: ": "largest",
    "Proved: the points of the box that are ": "volume",
    "Proved by interval analysis: none, or one within a box around the point that is told.": "singularities",
    "Proved: no machine of the range has a ": "study",
    "Proved: the machine with ": "study",
    "Proved: every point of the path is in the set.": "path inside",
    "Proved: the path ": "path leaves",
    "Neither is proved: ": "nothing",
    "box inside: proved for every point": "ros/box_marker_test.cpp: hasABoxWhoseVerdictColorsIt",
    "proved: every point of the region satisfies the criterion": "ros/planner_test.cpp: hasNoTolerance",
    "proved: the bad point violates the criterion; ": "ros/planner_test.cpp: hasNoTolerance",
    # told of what checkContainment answers, which pkm check is told too
    "proved: within rounding of the bad point two struts are one vector, det A is 0: a parallel singularity":
        "singular point",
    "proved: no point that counts is singular": "ros/singularities_test.cpp: provesThatTheLargestCubeHasNone",
    "Proved answers about machines with three rails, three struts and a platform that never turns (Orthoglide, ": HELP,
    "one (share 1). Proved are the region of the best machine found, an upper bound of the regions of all ": HELP,
}
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


def claims_in(root):
    for path in sorted([*(root / "src").rglob("*"), *(root / "include").rglob("*")]):
        if path.suffix in (".cpp", ".h"):
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                for text in [] if line.lstrip().startswith("//") else STRING.findall(line):
                    if re.search(r"Proved|proved(:| for)", text):
                        yield f"{path.relative_to(root)}:{number}", text


def is_there(root, cover, claims):
    file, _, test = cover.partition(": ")
    return cover == HELP or cover in claims or bool(test) and test in (root / "test" / file).read_text(encoding="utf-8")


def main():
    root = pathlib.Path(sys.argv[1])
    sys.path.insert(0, str(root / "test" / "cli"))
    from sentences import CLAIMS
    found = list(claims_in(root))
    problems = [f"{place}: no test is named for the sentence '{text}'" for place, text in found if text not in COVERED]
    problems += [f"the test of '{text}' is not there: {cover}" for text, cover in COVERED.items()
                 if not is_there(root, cover, CLAIMS)]
    print("\n".join(problems) or f"{len(found)} sentences have their tests")
    return 1 if problems or not found else 0


if __name__ == "__main__":
    sys.exit(main())
