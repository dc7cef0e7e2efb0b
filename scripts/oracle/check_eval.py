#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve eval` and `curve convert` by the oracle in exact.py, on random and difficult curves.

check_eval.py PROGRAM [--seed S] [--keep DIR]    exits 1 with the first mismatches
"""
import argparse
import csv
import math
import random
import subprocess
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import exact  # noqa: E402

TINY = 5e-324
AXES = ("x", "y", "z")
EVAL_COLUMNS = "method,t,axis,value,exact,error,error_ulp,error_u,bound_u".split(",")
SHOWN = 12  # mismatches printed
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

    def write(self, place):
        with open(place, "w", encoding="ascii", newline="") as file:
            file.write(",".join(AXES[: len(self.axes)] + (("w",) if self.weights else ())) + "\n")
            for point in zip(*self.axes, *([self.weights] if self.weights else [])):
                file.write(",".join(c.hex() for c in point) + "\n")


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
    zeros = [0.0] * (degree + 1)
    return exact.rational_value(exact.basis_terms("rational", degree, t), zeros, weights) is not None


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


class Judge:
    def __init__(self, program, folder):
        self.program = program
        self.folder = folder
        self.comparisons = 0
        self.mismatches = []
        self.kinds = Counter()
        self.file = None

    def compare(self, fine, kind, line):
        """Counts one comparison and, unless `fine`, a mismatch with the text `line()`."""
        self.comparisons += 1
        if not fine:
            self.kinds[kind] += 1
            self.mismatches.append(f"{kind}: {line()} [{self.file.name}]")

    def call(self, case, *arguments, may_fail=(0,)):
        """The program's standard output for the file of `case`; None where its exit code is not 0."""
        form = "bernstein" if case.weights else case.form
        command = [self.program, "curve", arguments[0], "--curve", self.file, "--form", form, *arguments[1:]]
        result = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
        self.compare(
            result.returncode in may_fail,
            f"curve {arguments[0]} failed",
            lambda: f"{case.form} {case.name}: exit {result.returncode}: {result.stderr.strip()[:300]}",
        )
        return None if result.returncode != 0 else result.stdout

    def judge(self, number, case):
        self.file = self.folder / f"curve_{number:03}.csv"
        case.write(self.file)
        self.judge_eval(case)
        if not case.weights:
            self.judge_convert(case)

    # curve eval

    def judge_eval(self, case):
        options = [word for t in case.parameters for word in ("--t", t.hex())]
        output = self.call(case, "eval", *options)
        if output is None:
            return
        reader = csv.DictReader(output.splitlines())
        columns = reader.fieldnames or []
        self.compare(set(EVAL_COLUMNS) <= set(columns), "columns", lambda: f"{case.name}: {columns}")
        if not set(EVAL_COLUMNS) <= set(columns):
            return
        rows = list(reader)
        methods = list(dict.fromkeys(row["method"] for row in rows))
        self.judge_order(case, rows, methods)

        truths = {}
        for t in case.parameters:
            terms = exact.basis_terms(case.form, case.degree, t)
            for axis, coefficients in zip(AXES, case.axes):
                truth, amplification = truth_of(case, terms, coefficients)
                truths[t, axis] = truth, exact.to_double(truth), amplification
        for row in rows:
            key = float_of(row["t"]), row["axis"]
            if key in truths:
                self.judge_row(case, row, *truths[key])

    def judge_order(self, case, rows, methods):
        """Checks the order of the rows: by method, then by t as given, then by axis."""
        names = AXES[: len(case.axes)]
        wanted = [(m, t, axis) for m in methods for t in case.parameters for axis in names]
        got = [(row["method"], float_of(row["t"]), row["axis"]) for row in rows]
        self.compare(got == wanted, "rows", lambda: f"{case.form} {case.name}: {len(got)} rows, not {len(wanted)}")
        for method in EXPECTED[case.form] if case.degree <= 170 else []:
            self.compare(method in methods, "method left out", lambda m=method: f"{case.form} {case.name}: {m}")

    def judge_row(self, case, row, truth, rounded, amplification):
        def check(fine, field, expected):
            self.compare(
                fine,
                field,
                lambda: f"{case.form} {case.name}, {row['method']} at t = {row['t']}, {row['axis']}: "
                f"{row[field]}, expected {expected}; value {row['value']}, exact {row['exact']}",
            )

        numbers = {field: float_of(row[field]) for field in EVAL_COLUMNS[3:] if row.get(field, "") != ""}
        value = numbers.get("value", math.nan)
        check(rounds_to(numbers.get("exact", math.nan), rounded, truth[0] == 0), "exact", rounded)
        if not math.isfinite(value):
            for field in [field for field in ("error", "error_ulp", "error_u") if field in row]:
                check(numbers.get(field) == math.inf, field, "inf for a value that is not finite")
            return
        distance = exact.error(value, truth)
        error_u = exact.error_u(distance, amplification)
        expected = {
            "error": exact.to_double(distance),
            "error_ulp": exact.to_double(exact.error_ulp(distance, truth)),
            "error_u": math.inf if error_u is None else exact.to_double(error_u),
        }
        check(numbers.get("error") == expected["error"], "error", expected["error"])
        for field in [field for field in ("error_ulp", "error_u") if field in row]:
            check(close(numbers.get(field, math.nan), expected[field]), field, expected[field])
        if "bound_u" in numbers:
            check(expected["error_u"] <= numbers["bound_u"], "bound_u", f"at least {expected['error_u']}")

    # curve convert

    def judge_convert(self, case):
        if case.degree > 60:
            return
        inverse = case.form == "power"
        n = case.degree
        convert = exact.to_bernstein if inverse else exact.to_power
        truths = [convert(axis) for axis in case.axes]
        # the sums of absolute values, which rounding errors are proportional to
        sums = [absolute_sums(axis, inverse) for axis in case.axes]
        for method in CONVERSIONS[case.form]:
            lost = [self.may_overflow(method, truths[a], sums[a], n) for a in range(len(sums))]
            exits = {any(certainly for certainly, _ in lost): (INPUT_OUTPUT,), not any(may for _, may in lost): (0,)}
            output = self.call(case, "convert", "--method", method, may_fail=exits.get(True, (0, INPUT_OUTPUT)))
            if output is None:
                continue
            rows = list(csv.reader(output.splitlines()))
            names = list(AXES[: len(case.axes)])
            shape = bool(rows) and rows[0] == names and len(rows) == n + 2
            self.compare(shape, "shape of a conversion", lambda m=method: f"{case.form} {case.name}, {m}")
            if not shape:
                continue
            for i, row in enumerate(rows[1:]):
                for a, text in enumerate(row):
                    fine, expected = self.converted(method, float_of(text), truths[a][i], sums[a], i, n)
                    self.compare(
                        fine,
                        f"conversion {method}",
                        lambda m=method, x=text, e=expected, i=i, a=a: f"{case.form} {case.name}, {m}, "
                        f"coefficient {i} {AXES[a]}: {x}, expected {e}",
                    )

    @staticmethod
    def may_overflow(method, truths, sums, n):
        """(whether a coefficient certainly overflows, so that the conversion is refused; whether one may overflow)."""
        lost = any(math.isinf(exact.to_double(truth.as_integer_ratio())) for truth in truths)
        if method == "exact":
            return lost, lost
        return lost, lost or max(sums) * 4**n * math.factorial(n) >= 2**1000  # intermediate products may overflow

    @staticmethod
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


def truth_of(case, terms, coefficients):
    """(p(t), p~(t)) on one axis."""
    if case.weights:
        return (exact.rational_value(terms, coefficients, case.weights),
                exact.rational_p_tilde(terms, coefficients, case.weights))
    return exact.value(terms, coefficients), exact.p_tilde(terms, coefficients)


def absolute_sums(coefficients, inverse):
    """sum |matrix entry| |coefficient| of the conversion, per row."""
    c = [abs(Fraction(x)) for x in coefficients]
    n = len(c) - 1
    if inverse:
        return exact.to_bernstein(c)
    return [math.comb(n, j) * sum(math.comb(j, i) * c[i] for i in range(j + 1)) for j in range(n + 1)]


def float_of(text):
    return float.fromhex(text) if "0x" in text else float(text)


def rounds_to(a, rounded, truth_is_zero):
    """Whether `a` has the bits of `rounded`. The sign of a zero counts only where it is the result of an underflow."""
    return a == rounded and (truth_is_zero or math.copysign(1, a) == math.copysign(1, rounded))


def close(a, b):
    return a == b or abs(a - b) <= 1e-9 * abs(b) or abs(a - b) <= 4 * TINY


def judge_all(judge, seed):
    for number, case in enumerate(cases(seed)):
        judge.judge(number, case)


def main(description, judge_class, judge_all_of):
    """Has judge_all_of(judge, seed) judge the program of the command line: 1, to exit with, where anything does not match."""
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("program", type=Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=Path, help="leave the curve files in this folder")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        judge = judge_class(options.program.resolve(), folder)
        judge_all_of(judge, options.seed)
    for line in judge.mismatches[:SHOWN]:
        print(line)
    for kind, count in judge.kinds.most_common():
        print(f"{count} mismatches: {kind}")
    print(f"oracle: {judge.comparisons} comparisons, {len(judge.mismatches)} mismatches")
    return 1 if judge.mismatches else 0


if __name__ == "__main__":
    sys.exit(main(__doc__, Judge, judge_all))
