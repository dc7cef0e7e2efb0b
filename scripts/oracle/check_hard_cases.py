#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges a table of hard cases (hard_cases.csv) in rational arithmetic: every value, every rounding, every distance.

Shares nothing with the program. The numbers of a format are counted through from 0, so that rounding is a comparison with
the midpoint of two neighbours, and the distance from a rounding boundary one with the midpoints around.

check_hard_cases.py FILE    exits 1 with the first mismatches
"""
import csv
import decimal
import sys
from fractions import Fraction
from pathlib import Path

import exact

COLUMNS = ("study,family,search,drawn,form,scalar,degree,dimension,t,coefficients,exact,rounded,rounded_double,rounded_float,"
           "distance_ulp").split(",")
EXACT_DIGITS, DISTANCE_DIGITS = 40, 17
SHOWN = 12  # mismatches printed


class Format:
    """The numbers >= 0 of a binary format, in order: number(0) = 0, number(1) the smallest."""

    def __init__(self, precision, lowest_exponent, highest_exponent):
        self.precision, self.lowest = precision, lowest_exponent
        self.normal = 1 << (precision - 1)  # the place of the smallest normal number
        self.end = self.place(Fraction(2) ** highest_exponent)  # of the first that is infinite

    def place(self, x):
        """Of the largest number that is at most x >= 0, were exponents without an upper limit."""
        if x < self.normal * Fraction(2) ** self.lowest:
            return x // Fraction(2) ** self.lowest
        binade = exact.floor_log2((x.numerator, x.denominator)) - self.precision + 1
        return x // Fraction(2) ** binade + (binade - self.lowest) * self.normal

    def number(self, place):
        if place < self.normal:
            return place * Fraction(2) ** self.lowest
        binade, significand = divmod(place, self.normal)
        return (significand + self.normal) * Fraction(2) ** (self.lowest + binade - 1)

    def midpoint(self, place):
        """Between the number at this place and the next."""
        return (self.number(place) + self.number(place + 1)) / 2

    def nearest(self, x):
        """Ties go to the even place, whose significand is even."""
        place = min(self.place(abs(x)), self.end - 1)
        up = abs(x) - self.midpoint(place)
        place += up > 0 or (up == 0 and place % 2 == 1)
        magnitude = exact.INFINITY if place == self.end else float(self.number(place))
        return -magnitude if x < 0 else magnitude

    def distance(self, x):
        """From the nearest midpoint, in the spacing of numbers at x."""
        place = min(self.place(abs(x)), self.end - 1)
        around = [self.midpoint(k) for k in (place - 1, place, place + 1) if 0 <= k < self.end]
        spacing = self.number(place + 1) - self.number(place)
        return min(abs(abs(x) - midpoint) for midpoint in around) / spacing


FORMATS = {"double": Format(53, -1074, 1024), "float": Format(24, -149, 128)}


def digits(x, count):
    """x as a decimal number of so many significant digits, rounded once."""
    context = decimal.Context(prec=count, rounding=decimal.ROUND_HALF_EVEN, Emax=decimal.MAX_EMAX, Emin=decimal.MIN_EMIN)
    return context.divide(decimal.Decimal(x.numerator), decimal.Decimal(x.denominator))


def mismatches(case):
    """What is wrong with a row."""
    t, coefficients = float.fromhex(case["t"]), [float.fromhex(c) for c in case["coefficients"].split()]
    degree, scalar = len(coefficients) - 1, FORMATS[case["scalar"]]
    terms = exact.basis_terms(case["form"], degree, t)
    x, p_tilde = Fraction(*exact.value(terms, coefficients)), Fraction(*exact.p_tilde(terms, coefficients))
    distance = scalar.distance(x)
    claims = {
        "degree": int(case["degree"]) == degree,
        "dimension": case["dimension"] == "1",
        "t": 0 <= t <= 1,
        "inputs": all(scalar.nearest(Fraction(number)) == number for number in (t, *coefficients)),
        "exact": decimal.Decimal(case["exact"]) == digits(x, EXACT_DIGITS),
        "rounded": float.fromhex(case["rounded"]) == scalar.nearest(x),
        "rounded_double": float.fromhex(case["rounded_double"]) == FORMATS["double"].nearest(x),
        "rounded_float": float.fromhex(case["rounded_float"]) == FORMATS["float"].nearest(x),
        "distance_ulp": decimal.Decimal(case["distance_ulp"]) == digits(distance, DISTANCE_DIGITS),
        "search": {"tie": distance == 0, "nearest": distance > 0, "cancelled": x != 0, "zero": x == 0 < p_tilde}[case["search"]],
    }
    return [what for what, holds in claims.items() if not holds]


def judged(file):
    """(number of rows, mismatches)."""
    with open(file, encoding="utf-8", newline="") as lines:
        table = csv.DictReader(lines)
        if table.fieldnames != COLUMNS:
            return 0, [f"columns {table.fieldnames}"]
        cases = list(table)
    return len(cases), [f"row {number}: {what}" for number, case in enumerate(cases, 1) for what in mismatches(case)]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    count, wrong = judged(Path(sys.argv[1]))
    for line in wrong[:SHOWN]:
        print(line)
    print(f"{count} hard cases, {len(wrong)} mismatches")
    return 1 if wrong or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
