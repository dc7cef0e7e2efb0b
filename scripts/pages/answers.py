# SPDX-License-Identifier: MIT
"""Which method for which need: the table at the top of README.md, decided by the rows of results/answers.

A method is a candidate for a need where the bundle has its errors and its times at every degree of DEGREES. What the need demands
is a predicate over its rows; of the candidates that meet it at every degree, the winner has the smallest product of times.
"""
import math
import textwrap
from dataclasses import dataclass
from typing import Callable

from report.wording import general, interval, large, listing, scientific, shortest
from scripts.pages.markdown import WIDTH, table

DEGREES = (3, 12, 30)
SMALL = 5  # roundings per degree: above the proved bounds of all methods in one pass over the control points
NOISY = "~"
MICROSECOND = 1000  # in nanoseconds


@dataclass(frozen=True)
class Need:
    """What somebody needs, in words, and the rows that decide it."""

    name: str
    demand: str  # with the names of columns in braces, or {interval}: what the rows of the errors say
    table: str  # of the errors
    studies: tuple  # of the errors; those that are shown first
    times: str  # the study of the times
    meets: Callable  # whether a row of the errors meets the demand
    error: Callable  # the text of the largest error, from the rows of one degree
    mode: str = "point"


def number(row, column):
    """A number, or infinity where the field is empty."""
    value = row[column]
    return value if isinstance(value, float) and not math.isnan(value) else math.inf


def done(row):
    return row["status"] == "ok" and not row["non_finite"] and row["baseline"] in (None, "exact")


def bounded(row):
    return done(row) and number(row, "bound_u") <= SMALL * row["degree"] and not row["bound_violations"]


def bounded_twice(row):
    """In the numerator and in the denominator."""
    return done(row) and number(row, "bound_u") <= 2 * SMALL * row["degree"] and not row["bound_violations"]


def in_u(rows):
    return f"{general(max(number(row, 'max_error_u') for row in rows), 2)} u"


def in_ulp(rows):
    return f"{general(max(number(row, 'max_error_ulp') for row in rows), 2)} ulp"


PROVED = f"bound proved, at most {SMALL}n u p~"
NEEDS = (
    Need("Fast and safe, t in [0, 1]", PROVED, "accuracy.csv", ("answers-bezier",), "answers-bezier-time", bounded, in_u),
    Need("Proved, and not growing with n", "at most 2 u p~", "accuracy.csv", ("answers-bezier",),
         "answers-bezier-time", lambda row: bounded(row) and number(row, "bound_u") <= 2, in_u),
    Need("Always correctly rounded", "no error above 1/2 ulp, even beside a multiple root", "accuracy.csv", ("answers-root",),
         "answers-bezier-time", lambda row: done(row) and number(row, "max_error_ulp") <= 0.5, in_ulp),
    Need("Many t on one curve", "as the first, in batches", "accuracy.csv", ("answers-bezier",), "answers-bezier-time", bounded, in_u,
         mode="batch"),
    Need("Far outside [0, 1]", "as the first, for t in {interval}", "accuracy.csv", ("answers-outside",), "answers-outside-time",
         bounded, in_u),
    Need("Rational curve", f"bound proved, at most {2 * SMALL}n u p~", "accuracy.csv", ("answers-rational",),
         "answers-rational-time", bounded_twice, in_u),
    Need("Data in power form", "as the first", "accuracy.csv", ("answers-power",), "answers-power-time", bounded, in_u),
    Need("Arc length", "the tolerance of {tolerance} kept in every trial", "arc_length.csv", ("answers-length",), "answers-length-time",
         lambda row: done(row) and not row["non_converged"] and not row["broken_promises"]
         and number(row, "max_relative") <= row["tolerance"],
         lambda rows: f"{scientific(max(number(row, 'max_relative') for row in rows), 2)} of it", mode="one_shot"),
    Need("Nearest point", "no nearer one missed", "projection.csv", ("answers-nearest",), "answers-nearest-time",
         lambda row: done(row) and row["missed"] == 0 and not row["non_converged"],
         lambda rows: f"{general(max(number(row, 'max_error_eps') for row in rows), 2)} eps", mode="one_shot"),
)


def errors_of(bundle, need):
    """{method: {degree: rows of its errors}}, of methods that are judged in every study of the need at every degree."""
    judged = bundle.judged(need.table) if need.table != "projection.csv" else bundle[need.table]
    rows = judged.select(study=need.studies, scalar="double")
    found = {}
    for row in rows:
        found.setdefault(row["method"], {}).setdefault(row["degree"], []).append(row)
    return {method: by_degree for method, by_degree in found.items()
            if all({row["study"] for row in by_degree.get(degree, ())} == set(need.studies) for degree in DEGREES)}


def times_of(bundle, need):
    """{method: {degree: row of its time}}"""
    found = {}
    for row in bundle["timing.csv"].select(study=need.times, mode=need.mode, scalar="double", degree=DEGREES):
        found.setdefault(row["method"], {})[row["degree"]] = row
    return {method: rows for method, rows in found.items() if len(rows) == len(DEGREES)}


def winner(bundle, need):
    """(method, its errors by degree, its times by degree); None where no method meets the demand."""
    errors, times = errors_of(bundle, need), times_of(bundle, need)
    meeting = [method for method in errors if method in times
               and all(need.meets(row) for degree in DEGREES for row in errors[method][degree])]
    if not meeting:
        return None
    best = min(meeting, key=lambda method: math.prod(number(times[method][degree], "median_ns") for degree in DEGREES))
    return best, errors[best], times[best]


def time_text(row):
    nanoseconds = number(row, "median_ns")
    text = f"{general(nanoseconds, 2)} ns" if nanoseconds < MICROSECOND else f"{general(nanoseconds / MICROSECOND, 2)} µs"
    return text if row["quality"] == "ok" else f"{text} {NOISY}"


def asked(bundle, need):
    """The rows of the errors of a need at the degrees of the table."""
    return bundle[need.table].select(study=need.studies, degree=DEGREES, scalar="double")


def demand(bundle, need):
    """What a need demands, with the numbers of its rows."""
    said = {}
    for row in asked(bundle, need):
        said.setdefault("{interval}", set()).add(interval(row["t_min"], row["t_max"]))
        said.setdefault("{tolerance}", set()).add(shortest(row["tolerance"]))
    text = need.demand
    for name, values in said.items():
        text = text.replace(name, listing(sorted(values)))
    return text


def trials(bundle):
    """A sentence: how many curves the errors of each need are the largest of."""
    least = {need.name: min((row["trials"] for row in asked(bundle, need)), default=0) for need in NEEDS}
    usual = max(least.values())
    fewer = ", ".join(f"{name.lower()} {large(number)}" for name, number in least.items() if number < usual)
    return f"Errors are the largest of {large(usual)} random curves{f' ({fewer})' if fewer else ''} for each cell, against the **exact** value."


def line(bundle, need):
    found = winner(bundle, need)
    what = f"**{need.name}**: {demand(bundle, need)}"
    if found is None:
        return [what, "none", *("" for _ in DEGREES)]
    method, errors, times = found
    shown = {degree: [row for row in errors[degree] if row["study"] == need.studies[0]] for degree in DEGREES}
    return [what, f"`{method}`", *(f"{need.error(shown[degree])}, {time_text(times[degree])}" for degree in DEGREES)]


def answers(bundle):
    """The table, and a sentence below it."""
    head = ["need", "method", *(f"n = {shortest(float(degree))}" for degree in DEGREES)]
    return f"{table(head, [line(bundle, need) for need in NEEDS])}\n\n{textwrap.fill(trials(bundle), WIDTH)}"
