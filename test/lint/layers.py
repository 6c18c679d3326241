#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the layers apart: layers.py ROOT COMPILER FLAG...

Fails, naming each place, where a folder includes one that its layer does not know, where anything below ros/ and nodes/
includes ROS, or where a header of the core does not compile on its own or reaches a header of ROS.
"""

import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

# Each folder, with those of its own package that it may include besides itself; "" is what stands beside the folders.
COMMON = {"interval", "common"}
BELOW_DEXTERITY = COMMON | {"machine"}
CORE = BELOW_DEXTERITY | {"dexterity", "region", "paving", "report", "tasks", "study", "urdf_io", "import",
                          "certificate"}
LAYERS = {
    "": set(),
    "interval": set(),
    "common": {"interval"},
    "machine": COMMON,
    "dexterity": BELOW_DEXTERITY,
    "region": BELOW_DEXTERITY | {"dexterity"},
    "paving": BELOW_DEXTERITY | {"dexterity"},
    "report": BELOW_DEXTERITY | {"dexterity", "region", "paving"},
    "tasks": BELOW_DEXTERITY | {"dexterity", "region", "paving", "report", "import"},
    "study": BELOW_DEXTERITY | {"dexterity", "region", "paving"},
    "certificate": BELOW_DEXTERITY | {"dexterity", "region", "paving"},
    "urdf_io": BELOW_DEXTERITY,
    "import": BELOW_DEXTERITY,
    "cli": CORE,
    "python": CORE,
    "ros": CORE,
    "nodes": CORE | {"ros"},
}
KNOW_ROS = {"ros", "nodes"}
NEED_PYTHON = {"python"}  # its headers compile with those of an interpreter only
OWN_INCLUDE = re.compile(r'\s*#\s*include\s+"pkm_workspace/(\w+)/')
INCLUDE = re.compile(r'\s*#\s*include\s+[<"](.*)[>"]')
ROS_PACKAGES = r"/(ros|roscpp\w*|tf2\w*|actionlib\w*|diagnostic_\w+|interactive_markers|\w+_(msgs|srvs))/"
OWN_MESSAGES = r"/pkm_workspace/[A-Z]\w*\.h$"
ROS_HEADER = re.compile(ROS_PACKAGES + "|" + OWN_MESSAGES)


def files_of(root, folder):
    places = (root / "include/pkm_workspace" / folder, root / "src" / folder)
    pattern = "**/*" if folder else "*"
    return [path for place in places for path in sorted(place.glob(pattern)) if path.suffix in (".h", ".cpp")]


def wrong_includes(path, folder):
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        own = OWN_INCLUDE.match(line)
        if own and own.group(1) != folder and own.group(1) not in LAYERS[folder]:
            yield f"{path}:{number}: {folder}/ must not include {own.group(1)}/"
        other = INCLUDE.match(line)
        if other and folder not in KNOW_ROS and ROS_HEADER.search("/" + other.group(1)):
            yield f"{path}:{number}: {folder}/ must not include {other.group(1)}"


def wrong_headers(path, root, compiler):
    """Compiles a header and searches what it reached, itself and its package apart."""
    options = ["-fsyntax-only", "-MD", "-MF", "/dev/stdout", "-MT", "x", "-I", str(root / "include"), "-x", "c++", "-"]
    run = subprocess.run([*compiler, *options], input=f'#include "{path}"\n', capture_output=True, text=True)
    if run.returncode != 0:
        yield f"{path}: does not compile on its own without ROS:\n{run.stderr}"
    for header in run.stdout.replace("\\\n", " ").split():
        if not header.startswith(str(root)) and ROS_HEADER.search(header):
            yield f"{path}: reaches {header}"


def main():
    root, compiler = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    problems, checked = [], []
    for folder in LAYERS:
        files = files_of(root, folder)
        problems += [problem for path in files for problem in wrong_includes(path, folder)]
        checked += [path for path in files if path.suffix == ".h" and folder not in KNOW_ROS | NEED_PYTHON]
    if not checked:
        sys.exit(f"{root}: no header found")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for found in pool.map(lambda path: list(wrong_headers(path, root, compiler)), checked):
            problems += found
    print("\n".join(problems) or f"{len(checked)} headers of the core know no ROS; all folders keep to their layers")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
