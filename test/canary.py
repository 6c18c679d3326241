#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Succeeds only if unsound rounding is noticed: canary.py GTEST-BINARY SUITE...

The binary is built with rounding errors left out. It must run to its end and fail a test of every suite named.
"""

import re
import subprocess
import sys


def main():
    binary, suites = sys.argv[1], sys.argv[2:]
    run = subprocess.run([binary, "--gtest_color=no"], stdout=subprocess.PIPE, text=True)
    failed = set(re.findall(r"^\[  FAILED  \] (?:\w+/)?(\w+?)(?:/\d+)?\.\w", run.stdout, re.MULTILINE))
    unnoticed = [suite for suite in suites if suite not in failed]
    print("suites that failed, as they should:", ", ".join(sorted(failed)) or "none")
    if not suites or run.returncode != 1 or unnoticed:
        sys.exit(f"the canary lives: exit code {run.returncode}, 1 expected; not noticed by {unnoticed}")


if __name__ == "__main__":
    main()
