# SPDX-License-Identifier: BSD-3-Clause
"""Which designs a study looks at: lists, grids and low-discrepancy samples of named parameters."""

import itertools
import math
import numbers

from pkm_workspace.errors import PkmError

PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29)


def is_number(value):
    return isinstance(value, numbers.Real) and not isinstance(value, bool)


def numbers_between(least, most, count):
    """Equally spaced, both ends included."""
    if not (is_number(least) and is_number(most) and isinstance(count, numbers.Integral) and count >= 1):
        raise PkmError(f"from {least!r} to {most!r}, {count!r} of them: two numbers and a count from 1 are expected")
    if count == 1:
        return [least]
    return [least + (most - least) * k / (count - 1) for k in range(count)]


def values_of(name, values):
    if isinstance(values, tuple) and len(values) == 3:
        return numbers_between(*values)
    if isinstance(values, (tuple, str)) or not hasattr(values, "__iter__"):
        raise PkmError(f"{name} = {values!r}: a list is expected, or (least, most, count)")
    return list(values)


def grid(**parameters):
    """Every combination; each parameter is a list, or (least, most, count)."""
    lists = {name: values_of(name, values) for name, values in parameters.items()}
    return [dict(zip(lists, values)) for values in itertools.product(*lists.values())]


def radical_inverse(index, base):
    """The digits of the index behind the point, in reverse order (van der Corput)."""
    value, scale = 0.0, 1.0 / base
    while index:
        index, digit = divmod(index, base)
        value, scale = value + digit * scale, scale / base
    return value


def sample(count, skip=0, /, **parameters):
    """So many designs of Halton's sequence, which fills the box of the parameters evenly; each is (least, most). The
    same designs every time, and the first of a larger sample. skip: so many are left out at the beginning."""
    if len(parameters) > len(PRIMES):
        raise PkmError(f"a sample of {len(parameters)} parameters: at most {len(PRIMES)} fill evenly; use a list of your own")
    if not (isinstance(count, numbers.Integral) and count >= 1 and isinstance(skip, numbers.Integral) and skip >= 0):
        raise PkmError(f"a sample of {count!r} designs after {skip!r}: whole numbers from 1 and from 0 are expected")
    for name, ends in parameters.items():
        if not (isinstance(ends, (tuple, list)) and len(ends) == 2 and all(map(is_number, ends))):
            raise PkmError(f"{name} = {ends!r}: (least, most) are expected, two numbers")
    return [{name: least + (most - least) * radical_inverse(k, base)
             for (name, (least, most)), base in zip(parameters.items(), PRIMES)} for k in range(skip + 1, skip + count + 1)]


def checked(designs):
    """As a list of dictionaries that have the same names, with numbers or texts as values."""
    designs = [dict(design) for design in designs]
    if not designs:
        raise PkmError("the study has no designs: give a list of dictionaries, study.grid(...) or study.sample(...)")
    names = list(designs[0])
    if not names:
        raise PkmError("the designs have no parameters: name at least one")
    for place, design in enumerate(designs):
        if list(design) != names:
            raise PkmError(f"design {place} has the parameters {', '.join(design)}; the first one has {', '.join(names)}")
        for name, value in design.items():
            if hasattr(value, "item"):
                design[name] = value = value.item()
            if isinstance(value, bool) or not isinstance(value, (int, float, str)):
                raise PkmError(f"design {place}: {name} = {value!r} is no number and no text")
            if isinstance(value, float) and not math.isfinite(value):
                raise PkmError(f"design {place}: {name} = {value!r} is not finite")
    return designs
