#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""exact.py against cases computed by hand, and against slower computations of the same numbers."""
import math
import random
import sys
import unittest
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import exact  # noqa: E402

TINY = 5e-324  # 2^-1074
LARGEST = sys.float_info.max  # 2^1024 - 2^971

PARAMETERS = [0.0, 1.0, 0.5, 1 / 3, math.nextafter(1, 0), TINY, -1e-300, -2.5, 3.7, 1e300]


def as_fraction(x):
    return Fraction(*x)


def horner(coefficients, t):
    total = Fraction(0)
    for c in reversed(coefficients):
        total = total * Fraction(t) + Fraction(c)
    return total


def some_curves(count=30):
    draw = random.Random(1)
    for _ in range(count):
        degree = draw.randint(0, 12)
        yield [draw.uniform(-1, 1) * 2.0 ** draw.randint(-1060, 1000) for _ in range(degree + 1)]


class Rounding(unittest.TestCase):
    def test_to_nearest_ties_to_even(self):
        u, tiny, largest = Fraction(1, 2**53), Fraction(TINY), Fraction(LARGEST)
        for x, expected in ((1 + u, 1.0), (1 + 3 * u, 1 + 2.0**-51), (1 + u + u**3, 1 + 2.0**-52), (tiny / 2, 0.0), (tiny / 2 + tiny / 2**60, TINY),
                            (tiny * (2**52 - Fraction(1, 2)), 2.0**-1022), (tiny * (2**52 - Fraction(2, 3)), 2.0**-1022 - TINY),
                            (largest + 2**970 - 1, LARGEST), (largest + 2**970, math.inf), (Fraction(10) ** 400, math.inf)):
            for sign in (1, -1):
                found = exact.to_double((sign * x).as_integer_ratio())
                self.assertEqual((found, math.copysign(1, found)), (sign * expected, sign), x)


class Ulp(unittest.TestCase):
    def test_definition(self):
        for x, k in [
            (Fraction(1), -52),
            (Fraction(3, 2), -52),
            (Fraction(2), -51),
            (1 - Fraction(1, 2**200), -53),  # the exact value counts, not the 1.0 to which it rounds
            (Fraction(2) ** -1022, -1074),
            (Fraction(2) ** -1021, -1073),
            (Fraction(2) ** -1080, -1074),
            (Fraction(0), -1074),
            (Fraction(2) ** 1030, 978),
        ]:
            self.assertEqual(exact.ulp_exponent(x.as_integer_ratio()), k, x)
            self.assertEqual(exact.ulp_exponent((-x).as_integer_ratio()), k, x)


class Curves(unittest.TestCase):
    def test_by_hand(self):
        terms = exact.basis_terms("bernstein", 2, 0.25)
        self.assertEqual([Fraction(k, terms[1]) for k in terms[0]], [Fraction(9, 16), Fraction(6, 16), Fraction(1, 16)])
        self.assertEqual(as_fraction(exact.value(terms, [1.0, -1.0, 4.0])), Fraction(7, 16))
        self.assertEqual(as_fraction(exact.p_tilde(terms, [1.0, -1.0, 4.0])), Fraction(19, 16))
        terms = exact.basis_terms("power", 2, -0.5)
        self.assertEqual(as_fraction(exact.value(terms, [1.0, 3.0, -2.0])), -1)
        self.assertEqual(as_fraction(exact.p_tilde(terms, [1.0, 3.0, -2.0])), 3)

    def test_outside_the_interval_p_tilde_takes_absolute_values_of_the_basis(self):
        terms = exact.basis_terms("bernstein", 1, 3.0)  # basis -2, 3
        self.assertEqual(as_fraction(exact.value(terms, [1.0, 1.0])), 1)
        self.assertEqual(as_fraction(exact.p_tilde(terms, [1.0, 1.0])), 5)

    def test_against_recurrences(self):
        for c in some_curves():
            for t in PARAMETERS:
                n = len(c) - 1
                b = exact.value(exact.basis_terms("bernstein", n, t), c)
                self.assertEqual(as_fraction(b), *exact.point_at([[Fraction(p)] for p in c], Fraction(t)))
                self.assertEqual(as_fraction(exact.value(exact.basis_terms("power", n, t), c)), horner(c, t))

    def test_p_tilde_against_the_sum_as_written(self):
        for b in some_curves(10):
            n, x = len(b) - 1, Fraction(1 / 3)
            terms = [math.comb(n, i) * x**i * (1 - x) ** (n - i) * Fraction(b[i]) for i in range(n + 1)]
            self.assertEqual(as_fraction(exact.p_tilde(exact.basis_terms("bernstein", n, 1 / 3), b)), sum(map(abs, terms)))


class RationalCurves(unittest.TestCase):
    def test_quarter_circle(self):
        # ((1-t^2)/(1+t^2), 2t/(1+t^2)), Farin, Curves and Surfaces for CAGD, conics
        for t in (0.0, 0.25, 0.5, 1 / 3, 1.0, -2.5, 1e300):
            terms = exact.basis_terms("rational", 2, t)
            x = as_fraction(exact.value(terms, [1.0, 1.0, 0.0], [1.0, 1.0, 2.0]))
            y = as_fraction(exact.value(terms, [0.0, 1.0, 1.0], [1.0, 1.0, 2.0]))
            self.assertEqual((x, y), ((1 - Fraction(t) ** 2) / (1 + Fraction(t) ** 2), 2 * Fraction(t) / (1 + Fraction(t) ** 2)))

    def test_weights_of_both_signs(self):
        # 1 - 4t below; at 1/2 the points 1 and 2 give (1/2 - 3) / -1, and magnitudes (1/2 + 3) / 1
        terms = exact.basis_terms("rational", 1, 0.5)
        self.assertEqual(as_fraction(exact.value(terms, [1.0, 2.0], [1.0, -3.0])), Fraction(5, 2))
        self.assertEqual(as_fraction(exact.p_tilde(terms, [1.0, 2.0], [1.0, -3.0])), Fraction(7, 2))
        self.assertIsNone(exact.value(exact.basis_terms("rational", 1, 0.25), [1.0, 2.0], [1.0, -3.0]))


class Conversions(unittest.TestCase):

    def test_by_hand(self):
        # t^2 at degree 3 has control points 0, 0, 1/3, 1
        self.assertEqual(exact.to_bernstein([0, 0, 1, 0]), [0, 0, Fraction(1, 3), 1])
        self.assertEqual(exact.to_power([1, 0, 0, 0]), [1, -3, 3, -1])

    def test_round_trip(self):
        for b in some_curves():
            self.assertEqual(exact.to_bernstein(exact.to_power(b)), [Fraction(x) for x in b])
            self.assertEqual(exact.to_power(exact.to_bernstein(b)), [Fraction(x) for x in b])


if __name__ == "__main__":
    unittest.main()
