#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve length` and `curve at-length` in decimal arithmetic, on random and difficult curves.

It shares no code with the program. Lengths are integrals by the tanh-sinh rule (Takahasi and Mori 1974) in 45 digits,
over pieces that end at the extrema of |C'|^2 and so next to its roots. Two step sizes must agree. The lengths at
exact_t +- one ulp must lie on either side of the target. A promised tolerance must be kept.

check_length.py PROGRAM [--seed S]    exits 1 with the first mismatches
"""
import math
import random
import sys
from decimal import Decimal, getcontext
from fractions import Fraction

import numpy

import judging
from exact import to_power
from judging import collinear, constant, cusp, integers, straight, uniform

LENGTH = "method,length,error_estimate,evaluations,converged,exact,error".split(",")
AT_LENGTH = "method,t,iterations,converged,exact_t,error,error_estimate,length_error".split(",")
AXES = (["x"], ["x", "y"], ["x", "y", "z"])
SURE = {"bracketed_newton", "halley"}  # methods that must converge
TOLERANCE = "1e-9"

getcontext().prec = 45
AGREE = Decimal("1e-25")  # largest difference between two step sizes, relative to the length of the curve


def tanh_sinh_rule(per_unit):
    """(distance of the node from the nearer end of [0, 1], weight) for u = 0, h, 2h, ... with h = 1 / per_unit."""
    half_pi = Decimal("3.14159265358979323846264338327950288419716939937510582") / 2
    rule = []
    for k in range(5 * per_unit + 1):
        u = Decimal(k) / per_unit
        grown, shrunk = u.exp(), (-u).exp()
        angle = half_pi * (grown - shrunk)  # pi sinh u; x = 1 / (1 + exp(-+angle))
        small = 1 / (1 + angle.exp())
        weight = half_pi * (grown + shrunk) * small * (1 - small) / per_unit
        rule.append((small, weight))
    return rule


RULE = tanh_sinh_rule(64)


def times(p, q):
    product = [Fraction(0)] * max(len(p) + len(q) - 1, 0)
    for i, x in enumerate(p):
        for j, y in enumerate(q):
            product[i + j] += x * y
    return product


def hodograph(points, weights):
    """A' W - A W' of each axis and W as power coefficients, exactly, ascending; Fractions. W is 1 without weights."""
    denominator = to_power(weights) if weights else [Fraction(1)]
    axes = []
    for axis in range(len(points[0])):
        numerator = to_power([Fraction(p[axis]) * Fraction(w) for p, w in zip(points, weights or [1] * len(points))])
        left, right = times(derivative(numerator), denominator), times(numerator, derivative(denominator))
        size = max(len(left), len(right))
        axes.append([x - y for x, y in zip(*(side + [Fraction(0)] * (size - len(side)) for side in (left, right)))])
    return axes, denominator


def horner(coefficients, z):
    value = 0
    for c in reversed(coefficients):
        value = value * z + c
    return value


def derivative(coefficients):
    return [j * c for j, c in enumerate(coefficients)][1:]


def roots_of(coefficients):
    """All complex roots, in double precision."""
    largest = max(map(abs, coefficients), default=0) or 1
    scaled = [float(c / largest) for c in coefficients]
    while scaled and abs(scaled[-1]) < 1e-14:
        scaled.pop()
    return [complex(root) for root in numpy.roots(scaled[::-1])]


def cuts(square, denominator):
    """The ends of the pieces: 0, 1, the real parts of complex roots of |A'W - AW'|^2 and of W, and the extrema of the first. A root
    next to the real axis gives a minimum, which is refined in decimal: a cusp is a double root of it, but a simple root of its
    derivative."""
    slope = [decimal(c) for c in derivative(square)]
    bend = derivative(slope)
    found = {Decimal(0), Decimal(1)}
    found |= {Decimal(root.real) for root in roots_of(square) + roots_of(denominator) if 0 < root.real < 1 and abs(root.imag) > 1e-4}
    for root in roots_of(derivative(square)):
        if not (math.isfinite(root.real) and 0 < root.real < 1):
            continue
        t = Decimal(root.real)
        for _ in range(6 if abs(root.imag) < 1e-4 else 0):
            change = horner(bend, t)
            t -= horner(slope, t) / change if change else 0
        found.add(t if abs(t - Decimal(root.real)) < Decimal("1e-3") and 0 < t < 1 else Decimal(root.real))
    return sorted(found)


class Curve:
    """Lengths of one curve, in units of a power of two."""

    def __init__(self, points, weights=None):
        size = max((abs(x) for p in points for x in p), default=0) or 1.0
        self.unit = Fraction(2) ** math.frexp(size)[1]
        scaled = [[Fraction(x) / self.unit for x in p] for p in points]
        axes, denominator = hodograph(scaled, weights)
        squares = [times(axis, axis) for axis in axes]
        square = [sum(terms) for terms in zip(*squares)]
        self.still = not any(square)
        self.cuts = [] if self.still else cuts(square, denominator)
        self.axes, self.denominator = [[decimal(c) for c in axis] for axis in axes], [decimal(c) for c in denominator]
        self.whole = self.length(Decimal(0), Decimal(1))

    def speed(self, t):
        return sum((horner(axis, t) ** 2 for axis in self.axes), Decimal(0)).sqrt() / horner(self.denominator, t) ** 2

    def length(self, low, high):
        """The length of the part between two parameters in [0, 1]."""
        if self.still or high <= low:
            return Decimal(0)
        ends = [low, *(c for c in self.cuts if low < c < high), high]
        return sum((self.piece(a, b) for a, b in zip(ends, ends[1:])), Decimal(0))

    def piece(self, low, high):
        width = high - low
        fine, coarse = Decimal(0), Decimal(0)
        for k, (near, weight) in enumerate(RULE):
            both = self.speed(low + width * near) + (self.speed(high - width * near) if k else 0)
            fine += weight * both
            coarse += 2 * weight * both if k % 2 == 0 else 0
        if abs(fine - coarse) * width > AGREE * max(map(abs, (x for axis in self.axes for x in axis))):
            raise ArithmeticError(f"the oracle's own steps differ by {fine - coarse:.1e}")
        return width * fine


def decimal(x):
    return Decimal(x.numerator) / Decimal(x.denominator)


def close(value, expected, unit, digits):
    return abs(value - expected) <= unit * Decimal(10) ** -digits


def judge_length(rows, curve):
    if list(rows[0]) != LENGTH or len(rows) < 3:
        yield f"columns or methods: {rows[:1]}"
        return
    unit = decimal(curve.unit)
    for row in rows:
        exact, length = Decimal(row["exact"]) / unit, Decimal(float(row["length"])) / unit
        if not close(exact, curve.whole, curve.whole, 24):
            yield f"{row['method']}: exact {exact}, but {curve.whole} in units of {float(curve.unit)}"
        error = abs(length - curve.whole)
        if not close(Decimal(row["error"]) / unit, error, error + curve.whole * Decimal("1e-9"), 15):
            yield f"{row['method']}: error {row['error']}, not {error * unit}"
        if row["converged"] == "yes" and error > Decimal(TOLERANCE) * curve.whole:
            yield f"{row['method']}: promised {TOLERANCE}, but is {error / curve.whole:.2e} off"


def judge_at_length(rows, curve, target):
    """Yields what is wrong with rows of `curve at-length`; `target` is in units of the curve."""
    if list(rows[0])[:len(AT_LENGTH)] != AT_LENGTH or list(rows[0])[len(AT_LENGTH):] not in AXES or not SURE <= {row["method"] for row in rows}:
        yield f"columns or methods: {rows[:1]}"
        return
    exact = float(rows[0]["exact_t"])
    here = curve.length(Decimal(0), Decimal(exact))
    below, above = (Decimal(min(max(math.nextafter(exact, end), 0), 1)) for end in (-1.0, 2.0))
    slack = curve.whole * Decimal("1e-24")
    low = here - curve.length(below, Decimal(exact)) - slack
    high = here + curve.length(Decimal(exact), above) + slack
    if not low <= target <= high:
        yield f"exact_t {exact}: lengths about it {low} to {high}, target {target}"
    for row in rows:
        t = Decimal(float(row["t"]))
        if abs(abs(t - Decimal(exact)) - Decimal(row["error"])) > abs(above - below):
            yield f"{row['method']}: error {row['error']} of t = {row['t']}, but exact_t is {exact}"
        on_curve = min(max(t, Decimal(0)), Decimal(1))
        reached = here + curve.length(Decimal(exact), on_curve) - curve.length(on_curve, Decimal(exact))
        error = abs(reached - target)
        if not close(Decimal(row["length_error"]) / decimal(curve.unit), error, error + curve.whole * Decimal("1e-9"), 14):
            yield f"{row['method']}: length_error {row['length_error']}, not {error * decimal(curve.unit)}"
        if row["converged"] == "yes" and error > Decimal(TOLERANCE) * curve.whole:
            yield f"{row['method']}: promised {TOLERANCE}, but is {error / curve.whole:.2e} off"
        if row["method"] in SURE and row["converged"] != "yes":
            yield f"{row['method']} did not converge"


def mixed(draw, n, d):
    """Coordinates of different sizes, as far as this quadrature allows."""
    return [[draw.uniform(-1, 1) * 2.0 ** draw.randint(-8, 8) for _ in range(d)] for _ in range(n + 1)]


KINDS = (uniform, integers, mixed, straight, constant, collinear, cusp)


def positive(draw, n):
    return [draw.uniform(0.25, 4) for _ in range(n + 1)]


def of_both_signs(draw, n):
    """Weights whose sum has no root: those in between are so small that the ends outweigh them."""
    return [1.0, *(draw.uniform(-1, 2) / n for _ in range(n - 1)), draw.uniform(1, 4)][: n + 1]


def rational_cases(seed):
    """Yields (name, control points, weights)."""
    draw = random.Random(seed)
    yield "quarter circle", [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, 1.0, 2.0]
    for kind in (uniform, integers, cusp, collinear):
        for weights in (positive, of_both_signs):
            n = 3 if kind is cusp else draw.choice((1, 2, 3, 4))
            yield f"{kind.__name__}, weights {weights.__name__} {n}", kind(draw, n, 1 + draw.randrange(3)), weights(draw, n)


def cases(seed):
    """Yields (name, control points)."""
    draw = random.Random(seed)
    yield "sharp", [[0.0, 0.0], [1.0, 1.0], [0.1, 1.0], [1.0, 0.0]]
    yield "closed", [[0.0, 0.0], [3.0, 3.0], [-3.0, 3.0], [0.0, 0.0]]
    for kind in KINDS:
        for n in (1, 3, draw.choice((2, 4, 5))):
            points = kind(draw, n, 1 + draw.randrange(3))
            yield f"{kind.__name__} {n}", points
    yield "tiny", [[x * 2.0**-900 for x in p] for p in uniform(draw, 3, 2)]
    yield "huge", [[x * 2.0**900 for x in p] for p in uniform(draw, 3, 2)]


def judge(program, points, draw, weights=None):
    """Yields the mismatches for one curve."""
    names = [*judging.AXES[:len(points[0])], "w"]
    given = [[*p, w] for p, w in zip(points, weights)] if weights else points

    def rows(command, *options):
        return program.ask(command, "--curve", given, "--tolerance", TOLERANCE, *options, columns=names)[0]

    curve = Curve(points, weights)
    yield from judge_length(rows("length"), curve)
    share = draw.choice((0.0, 1.0, draw.random(), draw.random(), draw.random()))
    yield from judge_at_length(rows("at-length", f"--fraction={share!r}"), curve, Decimal(share) * curve.whole)
    length = float(Decimal(0.37) * curve.whole * decimal(curve.unit))
    yield from judge_at_length(rows("at-length", f"--length={length!r}"), curve, Decimal(length) / decimal(curve.unit))


def questions(program, seed):
    draw = random.Random(-seed)
    for name, points, weights in rational_cases(seed):
        yield f"{name} {points} {weights}", judge(program, points, draw, weights)
    for name, points in cases(seed):
        yield f"{name} {points}", judge(program, points, draw)


if __name__ == "__main__":
    sys.exit(judging.main(__doc__, "curves", 20, questions))
