# SPDX-License-Identifier: BSD-3-Clause
"""A study in a file of YAML (docs/study.md)."""

import pathlib

from pkm_workspace.core import keywords_of
from pkm_workspace.errors import PkmError
from pkm_workspace.study import designs as ways
from pkm_workspace.study.families import Catalogue, Files, Function, Mixture

KEYS = {"family", "designs", "question", "volumes", "guarantees", "table"}


def number(value):
    """YAML reads 1e-4 as a text."""
    try:
        return float(value) if isinstance(value, str) else value
    except ValueError:
        return value


def part(where, value, allowed, required=()):
    if not isinstance(value, dict):
        raise PkmError(f"{where}: names and values are expected, not {value!r}")
    for name in value:
        if allowed is not None and name not in allowed:
            raise PkmError(f"{where}: '{name}' is not known; allowed: {', '.join(sorted(allowed))}")
    for name in required:
        if name not in value:
            raise PkmError(f"{where}: '{name}' is missing")
    return value


def family_of(value, folder):
    known = part("family", value, None)
    if len(known) == 1 and "function" in known:
        place, _, name = str(known["function"]).rpartition(":")
        return Function(f"{folder / place if place.endswith('.py') else place}:{name}")
    if len(known) == 1 and "mix" in known:
        files = known["mix"]
        if not isinstance(files, list) or len(files) != 2:
            raise PkmError(f"family: mix: two URDFs are mixed, not {files!r}")
        return Mixture(*(folder / file for file in files))
    if known == {"files": True}:
        return Files()
    return Catalogue(**known)


def list_of(where, values):
    if isinstance(values, list):
        return [number(value) for value in values]
    known = part(where, values, {"from", "to", "count"}, ("from", "to", "count"))
    if not isinstance(known["count"], int):
        raise PkmError(f"{where}: count = {known['count']!r}: must be a whole number")
    return ways.numbers_between(*(number(known[name]) for name in ("from", "to", "count")))


def range_of(where, values):
    if not isinstance(values, list) or len(values) != 2:
        raise PkmError(f"{where}: the least and the largest are expected, not {values!r}")
    return tuple(number(value) for value in values)


def designs_of(value):
    if isinstance(value, list):
        return [{name: number(one) for name, one in part("designs", design, None).items()} for design in value]
    known = part("designs", value, {"grid", "sample"})
    if len(known) != 1:
        raise PkmError("designs: give a list, or one of grid and sample")
    if "grid" in known:
        return ways.grid(**{name: list_of(f"designs: grid: {name}", values)
                            for name, values in part("designs: grid", known["grid"], None).items()})
    wanted = dict(part("designs: sample", known["sample"], None, ("count",)))
    count, skip = wanted.pop("count"), wanted.pop("skip", 0)
    for name, value, least in (("count", count, 1), ("skip", skip, 0)):
        if not isinstance(value, int) or value < least:
            raise PkmError(f"designs: sample: {name} = {value!r}: must be a whole number from {least}")
    return ways.sample(count, skip, **{name: range_of(f"designs: sample: {name}", values) for name, values in wanted.items()})


def read_study(path):
    """The arguments of run() as a dictionary."""
    try:
        import yaml
    except ImportError:
        raise PkmError("a study in a file needs PyYAML (Debian: python3-yaml)") from None
    path = pathlib.Path(path)
    try:
        text = path.read_text(encoding="utf-8")
        told = part(path, yaml.safe_load(text), KEYS, ("family", "designs"))
        question = part("question", told.get("question") or {}, set(keywords_of("largest")))
        more = {name: part(name, told[name], None) for name in ("volumes", "guarantees") if told.get(name) is not None}
        return {"family": family_of(told["family"], path.resolve().parent), "designs": designs_of(told["designs"]),
                "table": str(told.get("table") or path.with_suffix(".sqlite")), **more, **question}
    except OSError as reason:
        raise PkmError(f"{path}: cannot be read: {reason.strerror}") from None
    except (yaml.YAMLError, UnicodeDecodeError) as reason:
        raise PkmError(f"{path}: is not YAML: {reason}") from None
    except PkmError as reason:
        raise PkmError(f"{path}: {str(reason).removeprefix(f'{path}: ')}") from None
