#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve interpolate` in rational arithmetic, on random and difficult points.

It shares no code with the program. The conditions of a C2 natural spline are written as one system for all control
points, with P0, P1, P2 and P3 of every segment unknown, and solved by Gaussian elimination with fractions.

check_interpolate.py PROGRAM [--seed S]    exits 1 with the first mismatches
"""
import math
import random
import sys
from fractions import Fraction

import judging
from exact import solved
from judging import integers, uniform

# The largest accepted error of a control point, in u max|K|: sqrt(3) is proved; the other method has no bound.
METHODS = {"c2_natural": 1.74, "c2_natural_handles": 12}
RESIDUALS = 8  # largest accepted residual of c2_natural, in u max|K|
SMALLEST = Fraction(1, 2**1074)


def conditions(n):
    """Yields (kind, number of the data point, left-hand side) of every condition; unknown 4i + j is P_j of segment
    i."""
    one = Fraction(1)
    for i in range(n):
        yield "data", i, {4 * i: one}
        yield "data", i + 1, {4 * i + 3: one}
        if i:
            yield "C1", None, {4 * i + 1: one, 4 * i: -one, 4 * i - 1: -one, 4 * i - 2: one}
            yield "C2", None, {4 * i: one, 4 * i + 1: -2 * one, 4 * i + 2: one,
                               4 * i - 3: -one, 4 * i - 2: 2 * one, 4 * i - 1: -one}
    yield "natural", None, {0: one, 1: -2 * one, 2: one}
    yield "natural", None, {4 * n - 3: one, 4 * n - 2: -2 * one, 4 * n - 1: one}


def truth(points):
    """The control points of every segment, one after the other."""
    n = len(points) - 1
    return solved([[left.get(j, Fraction(0)) for j in range(4 * n)] + [Fraction(0 if k is None else x) for x in points[k or 0]]
                   for _, k, left in conditions(n)])


def judge(points, exact, found, method):
    """Yields what is wrong with the values of one axis, one line each."""
    points, found = [Fraction(x) for x in points], [Fraction(x) for x in found]
    size = max(map(abs, points))
    unit = size / 2**53
    for at, (right, value) in enumerate(zip(exact, found, strict=True)):
        limit = METHODS[method] * unit + SMALLEST if at % 4 in (1, 2) else 0
        if abs(value - right) > limit:
            yield f"P{at % 4} of segment {at // 4} is {float(value)}, not {float(right)}"
    if method != "c2_natural":
        return
    for kind, k, left in conditions(len(points) - 1):
        residual = abs(sum(a * found[j] for j, a in left.items()) - (0 if k is None else points[k]))
        if residual > RESIDUALS * unit + 6 * SMALLEST:
            yield f"a residual of {kind} is {float(residual / unit) if unit else math.inf} units"


def signs(draw, n, d):
    size = draw.uniform(0.5, 1)
    return [[draw.choice((-size, size)) for _ in range(d)] for _ in range(n + 1)]


def graded(draw, n, d):
    return [[draw.uniform(-1, 1) * 2.0 ** draw.randint(-60, 60) for _ in range(d)] for _ in range(n + 1)]


def distant(draw, n, d):
    return [[1e9 + draw.uniform(-1, 1) for _ in range(d)] for _ in range(n + 1)]


def huge(draw, n, d):
    return [[draw.uniform(-1, 1) * 1e308 for _ in range(d)] for _ in range(n + 1)]


def tiny(draw, n, d):
    return [[draw.randint(-9999, 9999) * 5e-324 for _ in range(d)] for _ in range(n + 1)]


def repeated(draw, n, d):
    points = uniform(draw, n, d)
    for i in range(1, n + 1):
        if draw.random() < 0.5:
            points[i] = points[i - 1]
    return points


KINDS = (uniform, integers, signs, graded, distant, huge, tiny, repeated)


def cases(seed):
    """Yields (name, points)."""
    draw = random.Random(seed)
    yield "the example of [Document 003]", [[0.0], [1.0], [0.0], [1.0]]
    for kind in KINDS:
        for n in (1, 2, 3, draw.randint(4, 9), draw.randint(10, 30)):
            yield f"{kind.__name__} {n}", kind(draw, n, 1 + draw.randrange(3))


def judge_spline(program, points, exact, method):
    rows, _ = program.ask("interpolate", "--points", points, "--method", method)
    if [(row["segment"], row["index"]) for row in rows] != [(str(i), str(j)) for i in range(len(points) - 1) for j in range(4)]:
        yield "rows of other segments than asked for"
        return
    for axis, coordinates, right in zip("xyz", zip(*points), zip(*exact)):
        for line in judge(coordinates, right, [float(row[axis]) for row in rows], method):
            yield f"axis {axis}: {line}"


def questions(program, seed):
    for name, points in cases(seed):
        exact = truth(points)
        for method in METHODS:
            yield f"{method}, {name}", judge_spline(program, points, exact, method)


if __name__ == "__main__":
    sys.exit(judging.main(__doc__, "splines", 80, questions))
