# SPDX-License-Identifier: BSD-3-Clause
"""What the two checkers make of a certificate: sentences without counts, or nothing where it is refused."""

import json
import re
import subprocess
import sys

from pkm import PKM, URDF

sys.path.insert(0, str(URDF.parent / "scripts"))
import check_certificate  # noqa: E402


def _without_counts(sentences):
    return [re.sub(r" \(boxes: \d+\)", "", sentence) for sentence in sentences]


def by_python(data):
    try:
        return _without_counts(check_certificate.check(data))
    except (check_certificate.Refused, *check_certificate.NOT_UNDERSTOOD):
        return None


def by_pkm(text):
    process = subprocess.run([PKM, "verify", "/dev/stdin", "--json"], input=text, capture_output=True, text=True)
    if process.returncode == 2:  # NaN is no JSON
        return None
    answer = json.loads(process.stdout)
    assert process.returncode == (1 if answer["refused"] else 0), process
    return None if answer["refused"] else _without_counts(answer["verified"])
