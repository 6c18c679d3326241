#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails where a C++ file is not as clang-format would write it. Mend with: clang-format -i FILE
set -euo pipefail
cd "$1"
command -v clang-format >/dev/null || { echo "clang-format is missing: run scripts/setup --tests" >&2; exit 1; }
find . \( -path ./build -o -path ./devel -o -path ./install \) -prune -o \( -name '*.h' -o -name '*.cpp' \) -print |
  sort | xargs clang-format --dry-run --Werror
