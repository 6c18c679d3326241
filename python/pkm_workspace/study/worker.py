# SPDX-License-Identifier: BSD-3-Clause
"""A worker of a study on this machine: reads batches of designs on standard input, writes their rows."""

import os
import pickle
import sys

from pkm_workspace.study.evaluate import rows_of


def messages(stream):
    while len(head := stream.read(8)) == 8:
        yield pickle.loads(stream.read(int.from_bytes(head, "little")))


def main():
    out = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a family prints is not mixed with rows
    batches = messages(sys.stdin.buffer)
    family, question = next(batches)
    for batch in batches:
        try:
            out.write(pickle.dumps(rows_of(family, question, batch)))
            out.flush()
        except BrokenPipeError:
            os._exit(0)  # nobody waits for them any more


if __name__ == "__main__":
    main()
