# SPDX-License-Identifier: BSD-3-Clause
"""What the core in Python raises and warns of."""


class PkmError(ValueError):
    """What was asked for is wrong; the text says what, with value, unit, range and remedy, one problem a line."""


class PkmFailure(RuntimeError):
    """A file could not be written, or a certificate does not hold. answer: the Result that was computed before."""

    def __init__(self, message, answer=None):
        super().__init__(message)
        self.answer = answer


class PkmWarning(UserWarning):
    """What is in the input and not used, or hardly meant."""
