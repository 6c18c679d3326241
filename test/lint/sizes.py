#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails, naming each place, where a line, a file, a function or a main is longer than the house allows."""

import pathlib
import re
import sys

COLUMNS = 120
FILE_LINES = 300
LONGER = {"check_certificate.py": 540, "certificate_extensions.py": 320}  # in one piece for who trusts no other
FUNCTION_LINES = 40
MAIN_LINES = 25
FOLDERS = ("include", "src", "test", "bench", "scripts", "examples")
SUFFIXES = {".h", ".cpp", ".py", ".sh", ""}
NO_FUNCTION = re.compile(r"\s*(if|else|for|while|do|switch|case|default|try|catch|namespace|class|struct|enum|union)\b")


def header_of(lines, brace):
    """The first line of the statement that the brace at line number `brace` belongs to."""
    first = brace - 1
    while first > 0 and re.search(r"[^;{}:\s]\s*$", lines[first - 1]) and not re.match(r"\s*(//|#)", lines[first - 1]):
        first -= 1
    return lines[first]


def functions(lines):
    """Yields line number, header and number of body lines of each function laid out by clang-format."""
    for number, line in enumerate(lines):
        lambda_head = re.match(r"(\s*).*\[.*\].*\{\s*$", line)
        brace = re.match(r"(\s*)\{\s*$", line)
        if not lambda_head and not brace:
            continue
        header = line if lambda_head else header_of(lines, number)
        if "(" not in header or (brace and NO_FUNCTION.match(header)):
            continue
        closing = (lambda_head or brace).group(1) + "}"
        end = next((n for n in range(number + 1, len(lines)) if lines[n].startswith(closing)), len(lines))
        yield number + 1, header.strip(), end - number - 1


def problems(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        if len(line) > COLUMNS:
            yield f"{path}:{number}: {len(line)} columns, at most {COLUMNS} allowed"
    most = LONGER.get(path.name, FILE_LINES)
    if len(lines) >= most:
        yield f"{path}: {len(lines)} lines, fewer than {most} allowed"
    if path.suffix not in (".h", ".cpp"):
        return
    for number, header, length in functions(lines):
        limit = MAIN_LINES if re.match(r"int main\(", header) else FUNCTION_LINES
        if length >= limit:
            yield f"{path}:{number}: {length} lines in '{header}', fewer than {limit} allowed"


def main():
    root = pathlib.Path(sys.argv[1])
    candidates = [path for folder in FOLDERS for path in sorted((root / folder).rglob("*"))]
    files = [path for path in candidates if path.is_file() and path.suffix in SUFFIXES]
    if not files:
        sys.exit(f"{root}: no source file found")
    found = [problem for path in files for problem in problems(path)]
    print("\n".join(found) if found else f"{len(files)} files are within the limits")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
