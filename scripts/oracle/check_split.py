#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve split` by the definition in rational arithmetic, on random and difficult curves.

Point i of the left half is the value at t of the Bernstein form with the control points c_0 to c_i; for the right half
these are c_i to c_n. For a rational curve the points (w c, w) are split and then divided.

check_split.py PROGRAM [--seed S]    exits 1 with the first mismatches
"""
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import exact  # noqa: E402
import judging  # noqa: E402
from check_eval import KINDS, ORDINARY_T, WEIGHTS, Case  # noqa: E402

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
            weights = case.weights and part(case.weights, half, i)
            terms = exact.bernstein_terms(len(part(case.axes[0], half, i)) - 1, t)
            for axis, coefficients in zip(case.names, case.axes):
                c = part(coefficients, half, i)
                found[half, str(i), axis] = exact.value(terms, c, weights), exact.p_tilde(terms, c, weights)
            if weights:
                found[half, str(i), "w"] = exact.value(terms, weights), exact.p_tilde(terms, weights)
    return found


def can_be_split(case, t):
    """Whether no control point of a half has the weight zero."""
    parts = [part(case.weights, half, i) for half in HALVES for i in range(case.degree + 1)] if case.weights else []
    return all(exact.value(exact.bernstein_terms(len(w) - 1, t), w)[0] for w in parts)


def cases(seed):
    draw = random.Random(seed)
    for index, (kind, coefficients) in enumerate(KINDS.items()):
        for degree in (index % 4, draw.randint(4, 9), draw.randint(10, 24)):
            axes = [coefficients(draw, degree) for _ in range(1 + (index + degree) % 3)]
            yield Case(f"{kind} {degree}", "bernstein", axes, draw.sample(ORDINARY_T, 3) + [draw.random()])
    for index, (of_weights, weights_of) in enumerate(WEIGHTS.items()):
        for kind in ("uniform", "integer", "mixed"):
            degree = draw.randint(0, 12)
            axes = [KINDS[kind](draw, degree) for _ in range(1 + (index + degree) % 3)]
            yield Case(f"{kind}, weights {of_weights} {degree}", "rational", axes, draw.sample(ORDINARY_T, 2) + [draw.random()],
                       weights_of(draw, degree))


def judge(program, case, t):
    right = truths(case, t)
    wanted = [(method, half, str(i), axis) for method in METHODS for half in HALVES for i in range(case.degree + 1)
              for axis in case.names + ("w" if case.weights else "")]
    for row in judging.rows_with_keys(case.ask(program, "split", "--t", t.hex()), COLUMNS, wanted):
        yield from judging.judge_row(row, *right[row["half"], row["index"], row["axis"]])


def questions(program, seed):
    for case in cases(seed):
        for t in case.parameters:
            if can_be_split(case, t):
                yield f"{case.form} {case.name}, t = {t}", judge(program, case, t)


if __name__ == "__main__":
    sys.exit(judging.main(__doc__, "splits", 200, questions))
