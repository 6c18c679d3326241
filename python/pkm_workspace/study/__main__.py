# SPDX-License-Identifier: BSD-3-Clause
"""pkm study FILE: a table of many designs, from a file of YAML (docs/study.md)."""

import collections
import sys
import time

from pkm_workspace import study
from pkm_workspace.errors import PkmError
from pkm_workspace.study.file import read_study
from pkm_workspace.words import Parser

OFTEN = 1.0  # between two lines of progress [s]


def arguments(words):
    parser = Parser(prog="pkm study", description="Evaluates many designs, from a file of YAML: one "
                                     "row for each in a table of SQLite, which the same command goes on with.")
    parser.add_argument("file", metavar="FILE", help="the study: family, designs, question (docs/study.md)")
    parser.add_argument("--table", metavar="FILE", help="of SQLite; without it, what the study says, or its name with "
                        ".sqlite")
    parser.add_argument("--workers", metavar="COUNT", type=int, help="processes; without it, one for each processor")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of Dask's scheduler, whose workers compute")
    parser.add_argument("--export", metavar="FILE", action="append", default=[],
                        help="writes the table, too: .csv, .h5, .parquet; may be given several times")
    parser.add_argument("--quiet", action="store_true", help="tells no progress")
    return parser.parse_args(words)


class Progress:
    def __init__(self):
        self.next = 0.0

    def __call__(self, done, of, seconds):
        if time.monotonic() >= self.next:
            self.next = time.monotonic() + OFTEN
            print(f"{seconds:.0f} s: {done} of {of} designs", file=sys.stderr, flush=True)


def main():
    given = arguments(sys.argv[1:])
    try:
        wanted = read_study(given.file)
        if given.table:
            wanted["table"] = given.table
        begin = time.monotonic()
        written = study.run(**wanted, workers=given.workers, scheduler=given.scheduler,
                            progress=None if given.quiet else Progress())
        print(f"{written} of {len(wanted['designs'])} designs evaluated in {time.monotonic() - begin:.1f} s, the "
              f"others were there: {wanted['table']}")
        names, rows = study.read(wanted["table"])
        counts = collections.Counter(row[names.index("status")] for row in rows)
        print(", ".join(f"{status} {count}" for status, count in sorted(counts.items())))
        for file in given.export:
            print(f"{study.export(wanted['table'], file)} rows in {file}")
    except PkmError as reason:
        print(*(f"pkm: {line}" for line in str(reason).splitlines()), sep="\n", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("pkm: stopped; the same command goes on from here", file=sys.stderr)
        return 130
    except OSError as reason:
        print(f"pkm: {reason}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
