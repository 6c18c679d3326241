# SPDX-License-Identifier: BSD-3-Clause
"""pkm report: a machine, machines side by side, or a study, as one page of HTML (docs/report.md)."""

import argparse
import sys

from pkm_workspace import core, report
from pkm_workspace.errors import PkmError
from pkm_workspace.words import Parser

LEFT_OUT = {"shape", "certificate", "progress", "json", "vertices", "ratio"}


def parser():
    made = Parser(prog="pkm report", formatter_class=argparse.ArgumentDefaultsHelpFormatter,
                  argument_default=argparse.SUPPRESS,
                  description="Writes one file of HTML that needs no network: the report of a machine (one URDF), of "
                  "machines side by side (several), or of a study (its table, .sqlite). Other options are the "
                  "conditions of pkm largest.")
    made.add_argument("files", metavar="FILE", nargs="+", help="URDFs, or the table of a study")
    made.add_argument("--output", metavar="FILE", required=True, help="the page; a file there is replaced")
    made.add_argument("--shape", help="what machines are compared by")
    for name, (values, *_) in sorted(core.keywords_of("largest").items()):
        if name not in LEFT_OUT:
            made.add_argument("--" + name.rstrip("_").replace("_", "-"), dest=name, nargs="+", metavar=values or "VALUE",
                              help="as of pkm largest")
    return made


def value_of(words):
    """Numbers as numbers; what is said several times as a list."""
    values = []
    for word in words:
        try:
            values.append(float(word))
        except ValueError:
            values.append(word)
    return values[0] if len(values) == 1 else values


def main():
    given = vars(parser().parse_args())
    files, output = given.pop("files"), given.pop("output")
    shape = given.pop("shape", None)
    criterion = {name: value_of(words) for name, words in given.items()}
    try:
        if len(files) == 1 and files[0].endswith(".sqlite"):
            if criterion or shape:
                raise PkmError("a study has its own conditions: leave out " + ", ".join(criterion or ["shape"]))
            report.study(files[0], output)
        elif len(files) == 1:
            report.machine(core.Machine(files[0]), output, **criterion)
        else:
            report.comparison([core.Machine(file) for file in files], output, shape=shape or "cube", **criterion)
    except (PkmError, OSError) as reason:
        print(*(f"pkm: {line}" for line in str(reason).splitlines()), sep="\n", file=sys.stderr)
        return 2 if isinstance(reason, PkmError) else 1
    print(f"report written: {output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
