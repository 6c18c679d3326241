# SPDX-License-Identifier: BSD-3-Clause
"""Numbers as people read them, rounded outward."""

import decimal
import math

DIGITS = 3  # of a bracket's width that are printed
MOST = 7  # of a number


def rounded(value, step, rounding):
    exact = decimal.Decimal(value)
    return format(exact.quantize(decimal.Decimal(1).scaleb(step), rounding=rounding), "f")


def step_of(lower, upper):
    """The power of ten of the last digit: of those that say something, and not more than MOST."""
    largest = max(abs(lower), abs(upper))
    coarse = math.floor(math.log10(largest)) - MOST + 1 if largest > 0 else 0
    return max(coarse, math.floor(math.log10(upper - lower)) - DIGITS + 1) if upper > lower else coarse


def bracket(lower, upper, unit=""):
    """"0.6439 to 0.6450 m": the lower end rounded down, the upper end up."""
    if lower is None or upper is None or not (math.isfinite(lower) and math.isfinite(upper)):
        return "not known" if lower is None or upper is None else f"{lower} to {upper} {unit}".strip()
    step = step_of(lower, upper)
    low, high = rounded(lower, step, decimal.ROUND_FLOOR), rounded(upper, step, decimal.ROUND_CEILING)
    return (low if low == high else f"{low} to {high}") + (f" {unit}" if unit else "")


def number(value, unit="", digits=5):
    """To so many digits: for what proves nothing, centers and times."""
    if value is None:
        return ""
    text = f"{value:.{digits}g}" if isinstance(value, float) else str(value)
    return f"{text} {unit}".strip()


def rounded_up(value):
    return rounded(value, step_of(value, value), decimal.ROUND_CEILING)


def rounded_down(value):
    return rounded(value, step_of(value, value), decimal.ROUND_FLOOR)


def in_words(told):
    """"uranesx, shape square, accuracy 1e-3": what is not None."""
    if isinstance(told, (list, tuple)):
        return " ".join(map(in_words, told))
    if not isinstance(told, dict):
        return f"{told:g}" if isinstance(told, float) else str(told)
    return ", ".join(f"{name.replace('_', ' ')} {in_words(value)}" for name, value in told.items() if value is not None)
