# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the core in Python share: the module as the build made it, and the command to compare with."""

import pathlib
import sys
import warnings

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1] / "cli"))

import pkm_workspace as core  # noqa: E402
from pkm import DATA, URDF, CommandTest, run  # noqa: E402,F401

NAMES = ("orthoglide", "orthoglide_prototype", "uranesx", "delta", "tripod", "mixed_legs")
FLAT = {"uranesx"}  # nothing changes along its rails: regions lie across them
TIMED = {"seconds", "boxes_per_second"}


def machine(name, **keywords):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", core.PkmWarning)
        return core.Machine(URDF / f"{name}.urdf", **keywords)


def untimed(value):
    """An answer without what a clock measured."""
    if isinstance(value, dict):
        return {key: untimed(member) for key, member in value.items() if key not in TIMED}
    if isinstance(value, list):
        return [untimed(member) for member in value]
    return untimed(value.reshape(len(value), 6).tolist()) if hasattr(value, "shape") else value


def words_of(keywords):
    """The words of a command line that mean the same as keywords. Numbers have all their digits."""
    words = []
    for key, value in keywords.items():
        if value is False and key not in ("joint_limits", "hinge_limits"):
            continue
        words.append("--" + key.rstrip("_").replace("_", "-"))
        if key in ("joint_limits", "hinge_limits"):
            words.append("on" if value else "off")
        elif isinstance(value, (list, tuple)):
            words += [repr(float(number)) for number in value]
        elif value is not True:
            words.append(str(value))
    return words
