#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve split` by the definition in rational arithmetic, on random and difficult curves.

Point i of the left half is the value at t of the Bernstein form with the control points c_0 to c_i; for the right half
these are c_i to c_n. For a rational curve the points (w c, w) are split and then divided.

check_split.py PROGRAM [--seed S]    exits 1 with the first mismatches
"""
import csv
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import check_eval  # noqa: E402
import exact  # noqa: E402

COLUMNS = "method,half,index,axis,value,exact,error,error_u,bound_u".split(",")
METHODS = ("de_casteljau_split", "lerp_split", "two_sided_split", "blossom_split", "matrix_split")
HALVES = ("left", "right")


def part(coefficients, half, i):
    """The control points that determine point i of the half."""
    return coefficients[:i + 1] if half == "left" else coefficients[i:]


def truths(case, t):
    """{(half, index, axis): (value, p~)} for every control point; its weight has the axis w."""
    found = {}
    for half in HALVES:
        for i in range(case.degree + 1):
            terms = exact.bernstein_terms(len(part(case.axes[0], half, i)) - 1, t)
            weights = case.weights and part(case.weights, half, i)
            for axis, coefficients in zip(check_eval.AXES, case.axes):
                points = check_eval.Case("", case.form, [part(coefficients, half, i)], [t], weights)
                found[half, i, axis] = check_eval.truth_of(points, terms, points.axes[0])
            if weights:
                found[half, i, "w"] = exact.value(terms, weights), exact.p_tilde(terms, weights)
    return found


def can_be_split(case, t):
    """Whether no control point of a half has the weight zero."""
    parts = [part(case.weights, half, i) for half in HALVES for i in range(case.degree + 1)] if case.weights else []
    return all(exact.value(exact.bernstein_terms(len(w) - 1, t), w)[0] for w in parts)


def cases(seed):
    draw = random.Random(seed)
    for index, (kind, coefficients) in enumerate(check_eval.KINDS.items()):
        for degree in (index % 4, draw.randint(4, 9), draw.randint(10, 24)):
            axes = [coefficients(draw, degree) for _ in range(1 + (index + degree) % 3)]
            yield check_eval.Case(f"{kind} {degree}", "bernstein", axes, draw.sample(check_eval.ORDINARY_T, 3) + [draw.random()])
    for index, (of_weights, weights_of) in enumerate(check_eval.WEIGHTS.items()):
        for kind in ("uniform", "integer", "mixed"):
            degree = draw.randint(0, 12)
            axes = [check_eval.KINDS[kind](draw, degree) for _ in range(1 + (index + degree) % 3)]
            yield check_eval.Case(f"{kind}, weights {of_weights} {degree}", "rational", axes,
                                  draw.sample(check_eval.ORDINARY_T, 2) + [draw.random()], weights_of(draw, degree))


class Judge(check_eval.Judge):
    """Judges rows of `curve split`: most columns of `curve eval`, and the number of the control point."""

    def judge_split(self, number, case):
        self.file = self.folder / f"curve_{number:03}.csv"
        case.write(self.file)
        axes = check_eval.AXES[:len(case.axes)] + (("w",) if case.weights else ())
        wanted = [(method, half, str(i), axis) for method in METHODS for half in HALVES for i in range(case.degree + 1)
                  for axis in axes]
        for t in case.parameters:
            if not can_be_split(case, t):
                continue
            output = self.call(case, "split", "--t", t.hex())
            rows = list(csv.DictReader((output or "").splitlines()))
            fine = [tuple(row[key] for key in COLUMNS[:4]) for row in rows] == wanted and all(list(row) == COLUMNS for row in rows)
            self.compare(fine, "rows", lambda t=t, n=len(rows): f"{case.form} {case.name}, t = {t}: {n} rows")
            right = {key: (truth, exact.to_double(truth), p_tilde) for key, (truth, p_tilde) in truths(case, t).items()}
            for row in rows if fine else []:
                self.judge_row(case, {**row, "t": t}, *right[row["half"], int(row["index"]), row["axis"]])


def judge_all(judge, seed):
    for number, case in enumerate(cases(seed)):
        judge.judge_split(number, case)


if __name__ == "__main__":
    sys.exit(check_eval.main(__doc__, Judge, judge_all))
