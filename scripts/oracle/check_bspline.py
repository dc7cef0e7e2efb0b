#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve bspline` by the definition in rational arithmetic, over knots of many kinds.

Basis functions come from the recurrence of de Boor and Cox over all knots of the curve, with 0/0 = 0. The Bernstein form of a
span is what has the same values at n + 1 places of it: a system of linear equations. Every third curve has weights w_i: basis
function N_i becomes w_i N_i over the sum of these.

check_bspline.py PROGRAM [--seed S]    exits 1 with the first mismatches
"""
import functools
import math
import random
import sys
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import exact  # noqa: E402
import judging  # noqa: E402
from check_eval import KINDS, Case  # noqa: E402

COLUMNS = "method,t,index,axis,value,exact,error,error_ulp,error_u,bound_u".split(",")
METHODS = {"de_boor": False, "de_boor_cox_basis": False, "knot_insertion_span": True, "chudy_wozny_span": True}


def distances(kind, draw, count):
    """Of neighbouring knots."""
    return {"uniform": lambda: [1.0] * count, "random": lambda: [draw.uniform(0.01, 1) for _ in range(count)],
            "multiple": lambda: [draw.choice([0.0, 0.0, 0.25, draw.random()]) for _ in range(count)],
            "uneven": lambda: [2.0 ** -draw.randint(0, 40) for _ in range(count)]}[kind]()


def knots_of(kind, draw, degree, points):
    """Ascending, degree + 1 more than points; the first ones equal where `kind` is clamped."""
    count = points + degree + 1
    if kind == "clamped":
        inner = sorted(float(draw.randint(1, 9)) for _ in range(points - degree - 1))
        return [0.0] * (degree + 1) + inner + [10.0] * (degree + 1)
    knots = [draw.choice([0.0, -3.0, draw.random(), 1e6])]
    for step in distances(kind, draw, count - 1):
        knots.append(knots[-1] + step)
    return knots


def basis(knots, degree, span, t):
    """Those of degree n at t of a span, as they continue beyond it: {number of the control point: value}."""
    u, t = list(map(Fraction, knots)), Fraction(t)

    @functools.cache
    def value(i, r):
        if r == 0:
            return Fraction(i == span)
        rising, falling = u[i + r] - u[i], u[i + r + 1] - u[i + 1]
        return ((t - u[i]) / rising * value(i, r - 1) if rising else 0) + \
               ((u[i + r + 1] - t) / falling * value(i + 1, r - 1) if falling else 0)

    return {i: value(i, degree) for i in range(span - degree, span + 1)}


def bernstein_of_basis(knots, degree, span):
    """For each control point of the span, its weights of the control points of the B-spline curve."""
    a, c = Fraction(knots[span]), Fraction(knots[span + 1])
    equations = []
    for j in range(degree + 1):
        s = Fraction(j, degree)
        values = basis(knots, degree, span, a + s * (c - a))
        equations.append([math.comb(degree, k) * s**k * (1 - s)**(degree - k) for k in range(degree + 1)]
                         + [values[i] for i in sorted(values)])
    return exact.solved(equations)


def span_of(knots, degree, points, t):
    """The one that t lies in; the last that is not empty where the curve ends."""
    full = [k for k in range(degree, points) if knots[k] < knots[k + 1]]
    return max(k for k in full if knots[k] <= t) if t < knots[points] else full[-1]


def weighted(weights, coefficients):
    """(value, p~) as pairs of integers."""
    return tuple(exact.ratio(sum((w * Fraction(c) for w, c in zip(weights, made)), Fraction(0)))
                 for made in (coefficients, list(map(abs, coefficients))))


def rational(basis_weights, weights):
    """The basis functions of a rational curve."""
    products = [w * Fraction(own) for w, own in zip(basis_weights, weights)]
    return [product / sum(products) for product in products]


def judge(program, case, knots, own):
    """`own`: the weights of the curve, of which there are none in a polynomial one."""
    degree = len(knots) - len(case.axes[0]) - 1
    rows, _ = program.ask("bspline", "--points", list(zip(*case.axes)), "--knots", ",".join(u.hex() for u in knots),
                          *(f"--t={t.hex()}" for t in case.parameters), *(["--weights", ",".join(w.hex() for w in own)] if own else ()))
    wanted = [(method, float(t), index, axis) for method, makes_bernstein in METHODS.items() for t in case.parameters
              for numbers in [list(map(str, range(degree + 1))) if makes_bernstein else []]
              for index, axis in [*((index, axis) for index in ("", *numbers) for axis in case.names), *((index, "w") for index in numbers if own)]]
    right = {}
    for t in case.parameters:
        span = span_of(knots, degree, len(case.axes[0]), t)
        at_t = basis(knots, degree, span, t)
        weights = {"": [at_t[i] for i in sorted(at_t)],
                   **{str(k): made for k, made in enumerate(bernstein_of_basis(knots, degree, span))}}
        part = slice(span - degree, span + 1)
        for index, of_points in weights.items():
            for axis, coefficients in zip(case.names, case.axes):
                right[t, index, axis] = weighted(rational(of_points, own[part]) if own else of_points, coefficients[part])
            right[t, index, "w"] = weighted(of_points, own[part])
    for row in judging.rows_with_keys([{**row, "t": float(row["t"])} for row in rows], COLUMNS, wanted):
        yield from judging.judge_row(row, *right[row["t"], row["index"], row["axis"]])


def questions(program, seed):
    draw = random.Random(seed)
    for number, kind in enumerate(("uniform", "clamped", "random", "multiple", "uneven") * 8):
        degree = draw.randint(1, 6)
        points = degree + draw.randint(1, 4)
        knots = knots_of(kind, draw, degree, points)
        if not knots[degree] < knots[points]:
            continue
        of_points = draw.choice(("uniform", "integer", "positive", "cancelling", "graded", "subnormal", "mixed"))
        axes = [KINDS[of_points](draw, points - 1) for _ in range(1 + number % 3)]
        inside = [min(max(draw.uniform(knots[degree], knots[points]), knots[degree]), knots[points]) for _ in range(2)]
        parameters = list(dict.fromkeys([knots[degree], *inside, draw.choice(knots[degree:points + 1]), knots[points]]))
        case = Case(f"{of_points} points, {kind} knots, degree {degree}", "bernstein", axes, parameters)
        own = [draw.uniform(0.5, 2) * 2.0 ** draw.choice((0, draw.randint(-20, 20))) for _ in range(points)] if number % 3 == 0 else []
        yield f"{case.name}, {len(own)} weights", judge(program, case, knots, own)


if __name__ == "__main__":
    sys.exit(judging.main(__doc__, "curves", 35, questions))
