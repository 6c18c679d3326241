#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Keeps wide instructions to themselves: wide_symbols.py NM SOURCE WIDTH OBJECT...

The object file of SOURCE is compiled for processors that not everybody has. Fails, naming each, where it defines a weak
function that is not about packs of its own WIDTH: another file may define the same one, and the linker would be free to
keep the wide copy for everybody.
"""

import pathlib
import re
import subprocess
import sys

def main():
    nm, source, width, candidates = sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:]
    own = re.compile(rf"\b(Pack|LaneMask)<{width}(, \d+u?l?)?>")
    objects = [path for path in candidates if pathlib.Path(path).name.startswith(source + ".o")]
    if len(objects) != 1:
        sys.exit(f"{source}: one object file expected, found {objects}")
    listing = subprocess.run([nm, "-C", objects[0]], stdout=subprocess.PIPE, text=True, check=True).stdout
    weak = re.findall(r"^[0-9a-f]+ W (.*)$", listing, re.MULTILINE)
    shared = sorted({name for name in weak if not own.search(name)})
    if not weak or shared:
        sys.exit("\n".join([f"{objects[0]}: {len(weak)} weak functions, of which others may have:", *shared]))
    print(f"{objects[0]}: all {len(weak)} weak functions are its own")


if __name__ == "__main__":
    main()
