#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds what the repository refers to: references.py ROOT

Fails, naming each place, where a text names a file of docs/ that is not there or cites a page that is not part of the
repository, and where a file that tools make is tracked.
"""

import pathlib
import re
import subprocess
import sys

TEXTS = (".action", ".cpp", ".h", ".launch", ".md", ".msg", ".py", ".rst", ".srv", ".test", ".txt", ".xml")
DOCUMENT = re.compile(r"(?<![\w/])docs/[\w./-]*\w")
FOREIGN = re.compile(r"\bdesign(\.md|( page)?,? section)|(?<!docs/)\bvalues\.md")
MADE_BY_TOOLS = re.compile(r"\.egg-info(/|$)|(^|/)__pycache__/|\.pyc$|^(build|devel|install)/")


def problems_of(root, name):
    if MADE_BY_TOOLS.search(name):
        yield f"{name}: made by a tool, not to be tracked"
    if not name.endswith(TEXTS):
        return
    for number, line in enumerate((root / name).read_text(encoding="utf-8").splitlines(), 1):
        for document in DOCUMENT.findall(line):
            if not list(root.glob(document.rstrip(".") + "*")):
                yield f"{name}:{number}: {document} is not there"
        if FOREIGN.search(line):
            yield f"{name}:{number}: cites a page that is not in the repository: {line.strip()}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    git = subprocess.run(["git", "-C", str(root), "ls-files"], capture_output=True, text=True, check=True)
    names = [name for name in git.stdout.splitlines() if (root / name).exists() and name != "test/lint/references.py"]
    problems = [problem for name in names for problem in problems_of(root, name)]
    if not names:
        sys.exit(f"{root}: no file found")
    print("\n".join(problems) or f"{len(names)} files refer to what is there")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
