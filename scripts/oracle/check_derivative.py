#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve derivative` by the definition in rational arithmetic, on random and difficult curves.

check_derivative.py PROGRAM [--seed S]    exits 1 with the first mismatches
"""
import math
import random
import sys
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import exact  # noqa: E402
import judging  # noqa: E402
from check_eval import EXTREME_T, KINDS, ORDINARY_T, Case, rational_cases  # noqa: E402

COLUMNS = "method,t,order,axis,value,exact,error,error_ulp,error_u,bound_u".split(",")
METHODS = {"bernstein": ["differences_de_casteljau", "differences_horner", "compensated_differences", "triangle_derivatives",
                         "wozny_chudy_derivatives", "all_orders_differences_horner", "all_orders_triangle_derivatives",
                         "all_orders_wozny_chudy_derivatives", "seed_000"],
           "power": ["power_derivative", "compensated_power_derivative"],
           "rational": ["differences_horner", "triangle_derivatives", "wozny_chudy_derivatives", "local:differences_horner",
                        "local:triangle_derivatives"]}
AS_PRINTED = "seed_000"
# Points of [Document 000], section 2.2, with the derivatives that it prints or that follow from them, by order and t.
WORKED = [[1.0, 3.0, 4.0, 6.0], [1.0, 1.0, 2.0, 3.0]]
PRINTED = {(1, 0.5): (4.5, 2.25), (2, 0.0): (-6, 6), (2, 0.5): (0, 3), (3, 0.5): (12, -6), (4, 0.5): (0, 0)}


def derivative_of_powers(coefficients, order):
    """d^k/dt^k sum q_j t^j, ascending, as Fractions."""
    q = [math.perm(j, order) * Fraction(c) for j, c in enumerate(coefficients)]
    return q[order:] or [Fraction(0)]


def derivative(form, coefficients, order):
    """The coefficients of the derivative in the form of the curve. A curve in Bernstein form is converted to powers and
    back."""
    if form == "power":
        return derivative_of_powers(coefficients, order)
    return exact.to_bernstein(derivative_of_powers(exact.to_power(coefficients), order))


def cases(seed):
    draw = random.Random(seed)
    for form in ("bernstein", "power"):
        for index, (kind, coefficients) in enumerate(KINDS.items()):
            for degree in (index % 4, draw.randint(4, 12), draw.randint(13, 30)):
                axes = [coefficients(draw, degree) for _ in range(1 + (index + degree) % 3)]
                parameters = draw.sample(ORDINARY_T, 4) + [draw.random()]
                if degree <= 4:
                    parameters += draw.sample(EXTREME_T, 2)
                yield Case(f"{kind} {degree}", form, axes, parameters), draw.sample(range(degree + 2), 2)


def rows_of(program, case, order):
    rows = case.ask(program, "derivative", "--order", str(order), *(f"--t={t.hex()}" for t in case.parameters))
    wanted = [(method, t, str(order), axis) for method in METHODS[case.form] for t in case.parameters for axis in case.names]
    return judging.rows_with_keys([{**row, "t": judging.float_of(row["t"])} for row in rows], COLUMNS, wanted)


def of_quotient(order, numerator, denominator):
    """The derivative of A / W from the Taylor coefficients of both: those of the quotient, by division of the series."""
    quotient = []
    for k in range(order + 1):
        quotient.append((numerator[k] - sum(denominator[i] * quotient[k - i] for i in range(1, k + 1))) / denominator[0])
    return math.factorial(order) * quotient[order]


def taylor(control_points, order, t):
    """The coefficients of the powers of h in the curve at t + h, up to the order."""
    powers = exact.to_power(control_points)
    return [sum((math.comb(j, k) * Fraction(t) ** (j - k) * powers[j] for j in range(k, len(powers))), Fraction(0)) for k in range(order + 1)]


def sizes(control_points, order, t):
    """By order k the sum (n)_k sum_i (sum_j C(k,j) |b_(i+j)|) |B_i,n-k(t)|, over k!."""
    n, found = len(control_points) - 1, []
    for k in range(order + 1):
        sums = [sum(math.comb(k, j) * abs(Fraction(control_points[i + j])) for j in range(k + 1)) for i in range(n + 1 - k)]
        found.append(math.comb(n, k) * Fraction(*exact.p_tilde(exact.basis_terms("bernstein", n - k, t), sums)) if sums else Fraction(0))
    return found


def quotient_truth(case, coefficients, order, t):
    """The derivative of a rational curve, and S_k of core/bound/derivative_bound.hpp."""
    products = [Fraction(w) * Fraction(c) for w, c in zip(case.weights, coefficients)]
    weights = taylor(case.weights, order, t)
    magnitudes = [abs(weights[0]), *(-size for size in sizes(case.weights, order, t)[1:])]
    found = of_quotient(order, taylor(products, order, t), weights), of_quotient(order, sizes(products, order, t), magnitudes)
    return tuple(value.as_integer_ratio() for value in found)


def judge(program, case, order):
    truths = {}
    if case.weights:
        for axis, coefficients in zip(case.names, case.axes):
            for t in case.parameters:
                truths[t, axis] = quotient_truth(case, coefficients, order, t)
        for row in rows_of(program, case, order):
            yield from judging.judge_row(row, *truths[row["t"], row["axis"]])
        return
    for axis, coefficients in zip(case.names, case.axes):
        c = derivative(case.form, coefficients, order)
        for t in case.parameters:
            terms = exact.basis_terms(case.form, len(c) - 1, t)
            truths[t, axis] = exact.value(terms, c), exact.p_tilde(terms, c)
    for row in rows_of(program, case, order):
        if row["method"] != AS_PRINTED or order <= 1:
            yield from judging.judge_row(row, *truths[row["t"], row["axis"]])


def judge_worked(program, order, t, value):
    for method in METHODS["bernstein"]:
        rows = rows_of(program, Case("worked example", "bernstein", WORKED, [t]), order)
        found = [float(row["exact"]) for row in rows if row["method"] == method]
        if found != list(value):
            yield f"{method}: {found}"


def questions(program, seed):
    for (order, t), value in PRINTED.items():
        yield f"worked example, order {order}", judge_worked(program, order, t, value)
    for index, case in enumerate(rational_cases(random.Random(seed))):
        if 0 < case.degree <= 8 and case.parameters:
            order = 1 + index % 3
            yield f"rational {case.name}, order {order}", judge(program, case, order)
    for case, orders in cases(seed):
        for order in orders:
            yield f"{case.form} {case.name}, order {order}", judge(program, case, order)


if __name__ == "__main__":
    sys.exit(judging.main(__doc__, "derivatives", 173, questions))
