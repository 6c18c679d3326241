# SPDX-License-Identifier: BSD-3-Clause
"""pkm report: a machine, machines side by side, or a study, as one page of HTML (docs/report.md)."""

import argparse
import pathlib
import sys

from pkm_workspace import core, report
from pkm_workspace.errors import PkmError
from pkm_workspace.words import Parser

KNOWN = core.keywords_of("largest")
LEFT_OUT = {"shape", "certificate", "progress", "json", "vertices"}


def parser():
    made = Parser(prog="pkm report", formatter_class=argparse.ArgumentDefaultsHelpFormatter,
                  argument_default=argparse.SUPPRESS,
                  description="Writes one file of HTML that needs no network: the report of a machine (one URDF), of "
                  "machines side by side (several), or of a study (its table, .sqlite). Other options are the "
                  "conditions of pkm largest.")
    made.add_argument("files", metavar="FILE", nargs="+", help="URDFs, or the table of a study")
    made.add_argument("--output", metavar="FILE", required=True, help="the page; a file there is replaced")
    made.add_argument("--shape", help="of the region; without it several, or a cube to compare by")
    for name, (values, *_) in sorted(KNOWN.items()):
        if name not in LEFT_OUT:
            made.add_argument("--" + name.rstrip("_").replace("_", "-"), dest=name, nargs="*", action="append",
                              metavar=values or "", help="as of pkm largest")
    return made


def value_of(name, given):
    """True for a word alone; numbers as numbers; of what may be given several times, a list of all."""
    _, is_repeatable, *_ = KNOWN[name]
    values = [[number_or_text(word) for word in words] for words in given]
    if is_repeatable:
        return values
    if len(values) > 1:
        raise PkmError(f"--{name.replace('_', '-')} is given more than once")
    return True if not values[0] else values[0][0] if len(values[0]) == 1 else values[0]


def number_or_text(word):
    try:
        return float(word)
    except ValueError:
        return word


def write(files, output, shape, criterion):
    if len(files) == 1 and is_table(files[0]):
        if criterion or shape:
            raise PkmError("a study has its own conditions: leave out " + ", ".join(criterion or ["shape"]))
        report.study(files[0], output)
    elif len(files) == 1:
        shapes = {"shapes": ((shape, {}), )} if shape else {}
        report.machine(core.Machine(files[0]), output, **shapes, **criterion)
    else:
        report.comparison([core.Machine(file) for file in files], output, shape=shape or "cube", **criterion)


def is_table(file):
    path = pathlib.Path(file)
    if file.endswith(".sqlite") or not path.is_file():
        return file.endswith(".sqlite")
    with path.open("rb") as content:
        return content.read(15) == b"SQLite format 3"


def main():
    given = vars(parser().parse_args())
    files, output, shape = given.pop("files"), given.pop("output"), given.pop("shape", None)
    try:
        write(files, output, shape, {name: value_of(name, words) for name, words in given.items()})
    except (PkmError, OSError) as reason:
        print(*(f"pkm: {line}" for line in str(reason).splitlines()), sep="\n", file=sys.stderr)
        return 2 if isinstance(reason, PkmError) else 1
    except KeyboardInterrupt:
        print("pkm: stopped; no report is written", file=sys.stderr)
        return 130
    print(f"report written: {output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
