# SPDX-License-Identifier: BSD-3-Clause
"""What makes a true sentence a wrong one."""

import re


def times(prefix, factor):
    """Multiplies the number after what the expression matches."""
    pattern = re.compile(f"({prefix})(-?\\d+(?:\\.\\d+)?(?:e[-+]?\\d+)?)")
    return lambda text: pattern.sub(lambda found: found[1] + format(float(found[2]) * factor, ".9g"), text, count=1)


def instead(old, new):
    return lambda text: re.sub(old, new, text, count=1)
