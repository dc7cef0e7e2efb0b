#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve eval` and `curve convert` by the oracle in exact.py, on random and difficult curves.

check_eval.py PROGRAM [--seed S]    exits 1 with the first mismatches
"""
import math
import random
import sys
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import exact  # noqa: E402
import judging  # noqa: E402
from judging import AXES, TINY, float_of, rounds_to  # noqa: E402

EVAL_COLUMNS = "method,t,axis,value,exact,error,error_ulp,error_u,bound_u".split(",")
INPUT_OUTPUT = 4  # the exit code for data that cannot be written

# Methods that must answer in each form, whatever else the program offers.
EXPECTED = {
    "bernstein": ["direct", "de_casteljau"],
    "power": ["power_sum", "horner"],
    "rational": ["de_casteljau", "de_casteljau_farin", "horner_bernstein", "volk_schumaker", "wozny_chudy"],
}
CONVERSIONS = {
    "bernstein": ["exact", "factorial", "differences"],
    "power": ["exact", "forward_substitution", "positive_sum", "triangle"],
}

# Values of t for every curve. At 2^-53 and its neighbours 1 - t begins to round to 1.
ORDINARY_T = [0.0, 1.0, 0.5, 1 / 3, math.nextafter(1, 0), math.nextafter(1, 2), math.nextafter(0.5, 0)]
ORDINARY_T += [2.0**-53, math.nextafter(2.0**-53, 0), math.nextafter(2.0**-53, 1), 1 - 2.0**-52, -0.0, -2.5, 3.7]
# Values of t whose powers overflow or underflow.
EXTREME_T = [TINY, -TINY, 1e-300, -1e-300, 2.0**-1022, 1e300, -1e300, 1.5e154]


@dataclass
class Case:
    name: str
    form: str
    axes: list  # one list of coefficients per axis
    parameters: list
    weights: list = None  # of a rational curve

    @property
    def degree(self):
        return len(self.axes[0]) - 1

    @property
    def names(self):
        """Of the axes."""
        return AXES[:len(self.axes)]

    def ask(self, program, command, *options, **more):
        """The rows of `curve COMMAND` for this curve, at its parameters unless there are other options."""
        points = list(zip(*self.axes, *([self.weights] if self.weights else [])))
        form = "bernstein" if self.weights else self.form
        at = options or [f"--t={t.hex()}" for t in self.parameters]
        return program.ask(command, "--curve", points, "--form", form, *at, columns=self.names + "w", **more)[0]


# Coefficients of one axis, by kind.


def cancelling(draw, n):
    """Huge coefficients of alternating sign plus small ones: p~ / |p| is enormous."""
    return [(-1.0) ** i * draw.uniform(0.9, 1.1) * 1e15 + draw.random() for i in range(n + 1)]


def antisymmetric(draw, n):
    """b_(n-i) = -b_i, so that the curve is exactly zero at t = 1/2 in Bernstein form."""
    half = [draw.uniform(-1, 1) for _ in range((n + 1) // 2)]
    return half + [0.0] * ((n + 1) % 2) + [-b for b in reversed(half)]


def single(draw, n):
    b = [0.0] * (n + 1)
    b[draw.randint(0, n)] = draw.choice([1.0, -3.0, 1e308, TINY, 1e-310])
    return b


KINDS = {
    "uniform": lambda draw, n: [draw.uniform(-1e6, 1e6) for _ in range(n + 1)],
    "integer": lambda draw, n: [float(draw.randint(-9, 9)) for _ in range(n + 1)],
    "positive": lambda draw, n: [draw.uniform(1, 2) for _ in range(n + 1)],
    "constant": lambda draw, n: [draw.uniform(-1, 1)] * (n + 1),
    "cancelling": cancelling,
    "antisymmetric": antisymmetric,
    "single": single,
    "mixed": lambda draw, n: [draw.uniform(-1, 1) * 2.0 ** draw.randint(-1070, 1000) for _ in range(n + 1)],
    "graded": lambda draw, n: [draw.uniform(-1, 1) * 2.0 ** (-18 * i) for i in range(n + 1)],
    "subnormal": lambda draw, n: [draw.randint(-1000, 1000) * TINY for _ in range(n + 1)],
    "near_subnormal": lambda draw, n: [draw.uniform(-1, 1) * 2.0**-1018 for _ in range(n + 1)],
    "huge": lambda draw, n: [draw.choice([-1, 1]) * draw.uniform(0.5, 1.79) * 1e308 for _ in range(n + 1)],
    "zero": lambda draw, n: [0.0] * (n + 1),
    "negative_zero": lambda draw, n: [draw.choice([0.0, -0.0]) for _ in range(n + 1)],
}


# Weights, by kind.
WEIGHTS = {
    "mild": lambda draw, n: [draw.uniform(0.5, 2) for _ in range(n + 1)],
    "equal": lambda draw, n: [draw.uniform(0.5, 2)] * (n + 1),
    "wild": lambda draw, n: [draw.uniform(1, 2) * 2.0 ** draw.randint(-60, 60) for _ in range(n + 1)],
    "a zero": lambda draw, n: [0.0 if i == (n + 1) // 2 and n > 0 else draw.uniform(0.5, 2) for i in range(n + 1)],
    "ends zero": lambda draw, n: [1.0 if 0 < i < n or n < 2 else 0.0 for i in range(n + 1)],
    "negative": lambda draw, n: [-draw.uniform(0.5, 2) for _ in range(n + 1)],
    "both signs": lambda draw, n: [draw.uniform(-1, 1) for _ in range(n + 1)],
    "one negative": lambda draw, n: [-1e-3 if i == n // 2 and n > 0 else 1.0 for i in range(n + 1)],
    "tiny": lambda draw, n: [draw.randint(1, 1000) * TINY for _ in range(n + 1)],
    "huge": lambda draw, n: [draw.uniform(0.5, 1.79) * 1e308 for _ in range(n + 1)],
    "mixed": lambda draw, n: [draw.uniform(1, 2) * 2.0 ** draw.randint(-1070, 1000) for _ in range(n + 1)],
}


def has_point(degree, t, weights):
    return exact.value(exact.basis_terms("rational", degree, t), weights)[0] != 0


def some_parameters(draw, degree):
    """Values of t: all extreme ones at low degree, a few at high degree, where exact values have 10^5 bits."""
    chosen = ORDINARY_T + [draw.random() for _ in range(3)] + [draw.uniform(-1, 2)]
    if degree <= 6:
        return chosen + EXTREME_T
    if degree <= 60:
        return draw.sample(chosen, 8) + draw.sample(EXTREME_T[:5], 1)
    return draw.sample(chosen, 5)


def rational_cases(draw):
    for index, (of_weights, weights_of) in enumerate(WEIGHTS.items()):
        for kind, coefficients in KINDS.items():
            degree = draw.choice([index % 3, 3 + index % 3, draw.randint(6, 40)])
            axes = [coefficients(draw, degree) for _ in range(1 + (index + degree) % 3)]
            weights = weights_of(draw, degree)
            parameters = [t for t in some_parameters(draw, degree) if has_point(degree, t, weights)]
            yield Case(f"{kind}, weights {of_weights} {degree}", "rational", axes, parameters, weights)
    circle = [[1.0, 1.0, 0.0], [0.0, 1.0, 1.0]]
    yield Case("quarter circle 2", "rational", circle, some_parameters(draw, 2), [1.0, 1.0, 2.0])


def cases(seed):
    draw = random.Random(seed)
    yield from rational_cases(random.Random(seed))
    degrees = [0, 1, 2, 3, 4, 5, 6, 9, 13, 20, 21, 33]
    for form in ("bernstein", "power"):
        for index, (kind, coefficients) in enumerate(KINDS.items()):
            # every kind at three low degrees and one higher one
            for degree in [index % 3, 3 + index % 3, draw.choice(degrees[6:]), draw.randint(7, 60)]:
                dimension = 1 + (index + degree) % 3
                axes = [coefficients(draw, degree) for _ in range(dimension)]
                yield Case(f"{kind} {degree}", form, axes, some_parameters(draw, degree))
        for kind, degree in [("uniform", 170), ("huge", 170), ("uniform", 171)]:
            yield Case(f"{kind} {degree}", form, [KINDS[kind](draw, degree)], some_parameters(draw, degree))
        # the smallest subnormal times t > 1/2 rounds to itself, and so does p~ in double: the true p~ is far smaller
        yield Case("sticking 20", form, [[0.0] * 20 + [TINY]], [0.51, 0.6261567791606476, 0.6877561493712671, 0.9])
        # axes of different scales
        axes = [KINDS[kind](draw, 5) for kind in ("huge", "subnormal", "zero")]
        yield Case("scales 5", form, axes, some_parameters(draw, 5))


def judge_eval(program, case):
    """The order of the rows, by method, then by t as given, then by axis; then each row."""
    rows = case.ask(program, "eval")
    if not rows or not set(EVAL_COLUMNS) <= set(rows[0]):
        yield f"columns: {rows[:1]}"
        return
    methods = list(dict.fromkeys(row["method"] for row in rows))
    if [(row["method"], float_of(row["t"]), row["axis"]) for row in rows] != [(m, t, axis) for m in methods for t in case.parameters for axis in case.names]:
        yield f"{len(rows)} rows in another order"
        return
    yield from (f"method left out: {method}" for method in EXPECTED[case.form] if case.degree <= 170 and method not in methods)
    truths = {}
    for t in case.parameters:
        terms = exact.basis_terms(case.form, case.degree, t)
        for axis, c in zip(case.names, case.axes):
            truths[t, axis] = exact.value(terms, c, case.weights), exact.p_tilde(terms, c, case.weights)
    for row in rows:
        yield from judging.judge_row(row, *truths[float_of(row["t"]), row["axis"]])


def judge_convert(program, case, method):
    n, inverse = case.degree, case.form == "power"
    convert = exact.to_bernstein if inverse else exact.to_power
    truths = [convert(axis) for axis in case.axes]
    # the sums of absolute values, which rounding errors are proportional to
    sums = [absolute_sums(axis, inverse) for axis in case.axes]
    lost = [may_overflow(method, truth, s, n) for truth, s in zip(truths, sums)]
    certainly, maybe = (any(one) for one in zip(*lost))
    rows = case.ask(program, "convert", "--method", method, may_fail=(INPUT_OUTPUT,) if maybe else ())
    if certainly:
        if rows:
            yield "a coefficient that is too large is written"
        return
    if not maybe or rows:
        if len(rows) != n + 1 or list(rows[0]) != list(case.names):
            yield "the shape of the conversion"
            return
        for i, row in enumerate(rows):
            for axis, truth, s in zip(case.names, truths, sums):
                fine, expected = converted(method, float_of(row[axis]), truth[i], s, i, n)
                if not fine:
                    yield f"coefficient {i} {axis}: {row[axis]}, expected {expected}"


def may_overflow(method, truths, sums, n):
    """(whether a coefficient certainly overflows, so that the conversion is refused; whether one may overflow)."""
    lost = any(math.isinf(exact.to_double(truth.as_integer_ratio())) for truth in truths)
    if method == "exact":
        return lost, lost
    return lost, lost or max(sums) * 4**n * math.factorial(n) >= 2**1000  # intermediate products may overflow


def converted(method, computed, truth, sums, i, n):
    rounded = exact.to_double(truth.as_integer_ratio())
    if method == "exact":
        return rounds_to(computed, rounded, truth == 0), rounded
    # Intermediate products may overflow where the result does not. Underflow costs 2^-1074 per product.
    if max(sums) * 4**n >= 2**1000 or not math.isfinite(computed):
        return max(sums) * 4**n * math.factorial(n) >= 2**1000, rounded
    amplification = 3**n * max(sums) if method == "forward_substitution" else sums[i]
    underflow = Fraction(TINY) * 4 ** (n + 2) * (n + 2)
    tolerance = (8 * n + 16) * exact.UNIT_ROUNDOFF * amplification + underflow
    return abs(Fraction(computed) - truth) <= tolerance, f"{rounded} within {float(tolerance):.3g}"


def absolute_sums(coefficients, inverse):
    """sum |matrix entry| |coefficient| of the conversion, per row."""
    c = [abs(Fraction(x)) for x in coefficients]
    n = len(c) - 1
    if inverse:
        return exact.to_bernstein(c)
    return [math.comb(n, j) * sum(math.comb(j, i) * c[i] for i in range(j + 1)) for j in range(n + 1)]


def questions(program, seed):
    for case in cases(seed):
        yield f"{case.form} {case.name}", judge_eval(program, case)
        if not case.weights and case.degree <= 60:
            for method in CONVERSIONS[case.form]:
                yield f"{case.form} {case.name}, {method}", judge_convert(program, case, method)


if __name__ == "__main__":
    sys.exit(judging.main(__doc__, "answers", 600, questions))
