#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The integer arithmetic of scripts/check_certificate.py: forms hold what their members become, in exact fractions."""

import math
import random
import unittest
from fractions import Fraction

from checkers import check_certificate

core = check_certificate
SEED = 20261128
CASES = 2000
BIG = 200  # bits: more than the checker's


class Numbers(unittest.TestCase):
    def setUp(self):
        self.rng = random.Random(SEED)

    def number(self, most):
        return self.rng.randrange(-most, most + 1)

    def drawn(self, swing, radius, center=core.ONE):
        slopes = tuple(self.number(swing) for _ in range(3))
        return core.Form(self.number(center), slopes, self.rng.randrange(radius + 1))

    def member(self, form, delta):
        """A number that the form may be there, in units."""
        off = Fraction(self.number(1000), 1000) if self.rng.random() < 0.7 else self.rng.choice((-1, 1))
        return form.c + sum(g * d for g, d in zip(form.g, delta)) + off * form.r

    def assert_holds(self, form, delta, value, case):
        linear = form.c + sum(g * d for g, d in zip(form.g, delta))
        self.assertLessEqual(abs(value - linear), form.r, "seed %d, case %d" % (SEED, case))

    def forms(self):
        for case in range(CASES):
            swing, radius = (1 << self.rng.randrange(core.P) for _ in range(2))
            delta = [Fraction(self.rng.choice((-64, 64, self.number(64))), 64) for _ in range(3)]
            yield case, swing, radius, delta

    def test_sums_and_products(self):
        for case, swing, radius, delta in self.forms():
            f, g = self.drawn(swing, radius), self.drawn(swing, radius * self.rng.randrange(2))
            a, b = self.member(f, delta), self.member(g, delta)
            self.assert_holds(f + g, delta, a + b, case)
            self.assert_holds(f - g, delta, a - b, case)
            self.assert_holds(f * g, delta, a * b / core.ONE, case)
            self.assertLessEqual(f.lower(), a)
            self.assertGreaterEqual(f.upper(), a)

    def test_roots(self):
        for case, swing, radius, delta in self.forms():
            f = self.drawn(swing, radius // 4)
            least = self.rng.randrange(core.ONE // 4)
            a = self.member(f, delta)
            if a < least:
                continue
            root = Fraction(math.isqrt(int(a * core.ONE) << (2 * BIG)), 1 << BIG)
            found = core.root(f, least)
            linear = found.c + sum(g * d for g, d in zip(found.g, delta))
            self.assertLessEqual(abs(root - linear), found.r + Fraction(1, 1 << 100), "seed %d, case %d" % (SEED, case))

    def test_inverses(self):
        inverse = core.extension("inverse")
        for case, swing, radius, delta in self.forms():
            f = self.drawn(swing // 4, radius // 4)
            if f.lower() > 0:
                self.assert_holds(inverse(f), delta, core.ONE * core.ONE / Fraction(self.member(f, delta)), case)

    def test_what_is_read(self):
        for case in range(CASES):
            x, y = sorted(math.ldexp(self.rng.uniform(-1, 1), self.rng.randrange(-80, 20)) for _ in range(2))
            for value in (x, y):
                for read in ([x, y], value):
                    form = core.form(read)
                    self.assertLessEqual(form.lower(), Fraction(value) * core.ONE, case)
                    self.assertGreaterEqual(form.upper(), Fraction(value) * core.ONE, case)
            side = core.side(x, y, 1)
            for t in (-1, self.number(16) / 16, 1):
                value = (Fraction(x) * (1 - Fraction(t)) + Fraction(y) * (1 + Fraction(t))) / 2 * core.ONE
                self.assert_holds(side, [0, Fraction(t), 0], value, case)

    def test_sines_and_cosines(self):
        cosine_and_sine = core.extension("cosine_and_sine")
        for _ in range(50):
            angle = self.rng.uniform(-8, 8)
            for form, value in zip(cosine_and_sine(angle), (math.cos(angle), math.sin(angle))):
                self.assertLessEqual(abs(form.c / core.ONE - value), 1e-15)


if __name__ == "__main__":
    unittest.main()
