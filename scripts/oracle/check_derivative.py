#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve derivative` by the definition in rational arithmetic, on random and difficult curves.

check_derivative.py PROGRAM [--seed S]    exits 1 with the first mismatches
"""
import csv
import math
import random
import sys
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import check_eval  # noqa: E402
import exact  # noqa: E402

COLUMNS = "method,t,order,axis,value,exact,error,error_ulp,error_u,bound_u".split(",")
METHODS = {"bernstein": ["differences_de_casteljau", "differences_horner", "compensated_differences", "triangle_derivatives",
                         "wozny_chudy_derivatives", "all_orders_differences_horner", "all_orders_triangle_derivatives",
                         "all_orders_wozny_chudy_derivatives", "seed_000"],
           "power": ["power_derivative", "compensated_power_derivative"]}
AS_PRINTED = "seed_000"


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


def worked():
    """Points of [Document 000], section 2.2, with the derivatives that it prints or that follow from them."""
    points = check_eval.Case("worked example", "bernstein", [[1.0, 3.0, 4.0, 6.0], [1.0, 1.0, 2.0, 3.0]], [0.0, 0.5])
    return points, {(1, 0.5): (4.5, 2.25), (2, 0.0): (-6, 6), (2, 0.5): (0, 3), (3, 0.5): (12, -6), (4, 0.5): (0, 0)}


def cases(seed):
    draw = random.Random(seed)
    for form in METHODS:
        for index, (kind, coefficients) in enumerate(check_eval.KINDS.items()):
            for degree in (index % 4, draw.randint(4, 12), draw.randint(13, 30)):
                axes = [coefficients(draw, degree) for _ in range(1 + (index + degree) % 3)]
                parameters = draw.sample(check_eval.ORDINARY_T, 4) + [draw.random()]
                if degree <= 4:
                    parameters += draw.sample(check_eval.EXTREME_T, 2)
                yield check_eval.Case(f"{kind} {degree}", form, axes, parameters), draw.sample(range(degree + 2), 2)


class Judge(check_eval.Judge):
    """Judges rows of `curve derivative`: the columns of `curve eval`, and the order."""

    def judge_orders(self, number, case, orders):
        self.file = self.folder / f"curve_{number:03}.csv"
        case.write(self.file)
        for order in orders:
            rows = self.rows_of(case, order)
            truths = self.truths_of(case, order)
            for row in rows:
                if row["method"] != AS_PRINTED or order <= 1:
                    self.judge_row(case, row, *truths[check_eval.float_of(row["t"]), row["axis"]])

    def rows_of(self, case, order):
        options = [word for t in case.parameters for word in ("--t", t.hex())]
        output = self.call(case, "derivative", "--order", str(order), *options)
        rows = list(csv.DictReader((output or "").splitlines()))
        keys = [(row["method"], check_eval.float_of(row["t"]), row["order"], row["axis"]) for row in rows]
        wanted = [(method, t, str(order), axis) for method in METHODS[case.form] for t in case.parameters
                  for axis in check_eval.AXES[:len(case.axes)]]
        fine = keys == wanted and all(list(row) == COLUMNS for row in rows)
        self.compare(fine, "rows", lambda: f"{case.form} {case.name}, order {order}: {len(rows)} rows")
        return rows if fine else []

    @staticmethod
    def truths_of(case, order):
        truths = {}
        for axis, coefficients in zip(check_eval.AXES, case.axes):
            c = derivative(case.form, coefficients, order)
            for t in case.parameters:
                terms = exact.basis_terms(case.form, len(c) - 1, t)
                truth = exact.value(terms, c)
                truths[t, axis] = truth, exact.to_double(truth), exact.p_tilde(terms, c)
        return truths

    def judge_worked(self):
        case, values = worked()
        self.file = self.folder / "worked.csv"
        case.write(self.file)
        for (order, t), value in values.items():
            printed = [[float(row["exact"]) for row in self.rows_of(case, order)
                        if float(row["t"]) == t and row["method"] == method] for method in METHODS["bernstein"]]
            self.compare(printed == [list(value)] * len(printed), "worked", lambda p=printed, k=order: f"order {k}: {p}")


def judge_all(judge, seed):
    judge.judge_worked()
    for number, (case, orders) in enumerate(cases(seed)):
        judge.judge_orders(number, case, orders)


if __name__ == "__main__":
    sys.exit(check_eval.main(__doc__, Judge, judge_all))
