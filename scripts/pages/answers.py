# SPDX-License-Identifier: MIT
"""Which method for which need: the table at the top of README.md, decided by the rows of results/real and results/answers.

A method is a candidate for a need where its bundle has its errors and its times at every degree of the need. What the need demands
is a predicate over its rows; of the candidates that meet it at every degree, the fastest has the smallest product of times. Times are ratios to those of one method, taken side by
side. Those whose intervals overlap with its own at every degree are tied with it, and the winner is the one among them with the smallest
proved bound.
"""
import math
import statistics
import textwrap
from dataclasses import dataclass, field
from typing import Callable

from report.answer import ROUNDOFF, SMALL, is_proved_small
from report.findings import real_curves
from report.inputs import ONE_SET
from report.schema import faults
from report.rows import distinct, fits
from report.wording import general, interval, large, listing, scientific, shortest
from scripts.pages.markdown import WIDTH, table

DEGREES = (2, 3, 5, 12, 30)  # of those the bundle has rows of
MISROUNDED = 0.05  # a share of coordinates that a fast method may misround on real curves
AXES = 2  # of the curves of the table
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
    scalar: str = "double"
    rows: dict = field(default_factory=dict)  # values that the rows of the errors have


def number(row, column):
    """A number, or infinity where the field is empty."""
    value = row[column]
    return value if isinstance(value, float) and not math.isnan(value) else math.inf


def done(row):
    return row["status"] == "ok" and not row["non_finite"] and row["baseline"] in (None, "exact")


def bounded(row):
    return done(row) and is_proved_small(row["bound_u"], row["degree"], row["form"]) and not row["bound_violations"]


def faultless(row, kind):
    """Whether a row of a kind of study has none of the faults that its table declares."""
    return done(row) and not any(row[fault] for fault in faults(kind))


def in_u(rows):
    return f"{general(max(number(row, 'max_error_u') for row in rows), 2)} u"


def in_ulp(rows):
    return f"{general(max(number(row, 'max_error_ulp') for row in rows), 2)} ulp"


def in_share(rows):
    return f"{real_curves.share(max(number(row, 'misrounded') for row in rows))} misrounded"


def nearest_in(share):
    """Whether at most such a share of coordinates is misrounded, and no bound is broken."""
    return lambda row: done(row) and not row["bound_violations"] and number(row, "misrounded") <= share


def on_sets(name, text, share, scalar, mode="point"):
    """A need of real curves, outlines in the plane; every set and placement has to meet it."""
    return Need(name, text, "accuracy.csv", ("real-sets",), "real-time", nearest_in(share), in_share, mode, scalar,
                {"form": "bernstein", "dimension": AXES})


REAL = (
    on_sets("Real curves, float", f"at most {100 * MISROUNDED:g} % of the coordinates are not the nearest number, on every set", MISROUNDED, "float"),
    on_sets("Real curves, float, none misrounded", "on no set, in any trial", 0, "float"),
    on_sets("Many t on one real curve, float", "the same share, in batches", MISROUNDED, "float", "batch"),
    on_sets("Real curves, double", "the same share", MISROUNDED, "double"),
)
PROVED = f"bound proved, at most {SMALL}n u p~"
CHORDS = 1.2  # chords over the least number, in the mean
EXCESS = 1e-12  # of a box, in sizes of the curve
NEEDS = (
    Need("Fast and safe, t in [0, 1]", PROVED, "accuracy.csv", ("answers-bezier",), "answers-bezier-time", bounded, in_u),
    Need("Proved, and not growing with n", "at most 2 u p~", "accuracy.csv", ("answers-bezier",),
         "answers-bezier-time", lambda row: bounded(row) and number(row, "bound_u") <= 2, in_u),
    Need("Always correctly rounded", "no error above 1/2 ulp, even beside a multiple root", "accuracy.csv", ("answers-root",),
         "answers-bezier-time", lambda row: done(row) and number(row, "max_error_ulp") <= 0.5, in_ulp),
    Need("Many t on one curve", f"{PROVED}, in batches", "accuracy.csv", ("answers-bezier",), "answers-bezier-time", bounded, in_u,
         mode="batch"),
    Need("Far outside [0, 1]", PROVED + ", for t in {interval}", "accuracy.csv", ("answers-outside",), "answers-outside-time",
         bounded, in_u),
    Need("Rational curve", f"bound proved, at most {2 * SMALL}n u p~", "accuracy.csv", ("answers-rational",),
         "answers-rational-time", bounded, in_u),
    Need("Data in power form", PROVED, "accuracy.csv", ("answers-power",), "answers-power-time", bounded, in_u),
    Need("Arc length", "the tolerance of {tolerance} kept in every trial", "arc_length.csv", ("answers-length",), "answers-length-time",
         lambda row: done(row) and not row["non_converged"] and not row["broken_promises"]
         and number(row, "max_relative") <= row["tolerance"],
         lambda rows: f"{scientific(max(number(row, 'max_relative') for row in rows), 2)} of it", mode="one_shot"),
    Need("Nearest point", "no nearer one missed", "projection.csv", ("answers-nearest",), "answers-nearest-time",
         lambda row: done(row) and row["missed"] == 0 and not row["non_converged"],
         lambda rows: f"{general(max(number(row, 'max_error_eps') for row in rows), 2)} eps", mode="one_shot"),
    Need("Curve as chords", f"the tolerance of {{tolerance}} of its size proved for every chord, at most {CHORDS} times the least number of chords",
         "flattening.csv", ("answers-flattening",), "answers-flattening-time",
         lambda row: faultless(row, "flattening") and number(row, "mean_over_least") <= CHORDS,
         lambda rows: f"{general(max(number(row, 'mean_over_least') for row in rows), 3)} × the least number", mode="one_shot"),
    Need("Easing, y of an x", "monotone, the ends exact, within 1 ulp", "easing.csv", ("answers-easing",), "answers-easing-time",
         lambda row: faultless(row, "easing") and number(row, "max_error_ulp") <= 1, in_ulp, mode="one_shot"),
    Need("Box of a curve", f"never too small, at most {EXCESS:g} of its size too large", "bounds.csv", ("answers-boxes",), "answers-boxes-time",
         lambda row: faultless(row, "bounds") and number(row, "max_excess_size") <= EXCESS,
         lambda rows: f"{scientific(max(number(row, 'max_excess_size') for row in rows), 2)} of the size", mode="one_shot"),
)


def rows_of(bundle, need):
    """The rows of the errors that a need is about, at degrees of DEGREES; of sets those of enough trials."""
    judged = real_curves.judged(bundle) if need in REAL else bundle[need.table].rows if need.table == "projection.csv" else bundle.judged(need.table).rows
    return [row for row in judged if fits(row, {"study": need.studies, "scalar": need.scalar, "degree": DEGREES, **need.rows})]


def degrees(bundle, need):
    """Those of DEGREES at which the bundle has errors and times of a need, ascending."""
    timed = {row["degree"] for row in bundle["timing.csv"].select(study=need.times, mode=need.mode, scalar=need.scalar)}
    return tuple(sorted(timed.intersection(distinct(rows_of(bundle, need), "degree"))))


def errors_of(bundle, need):
    """{method: {degree: rows of its errors}}, of methods that are judged in every study and on every set of the need at every degree."""
    def cell(row):
        return row["study"], *(row[column] for column in ONE_SET)
    found, cells = {}, {}
    for row in rows_of(bundle, need):
        found.setdefault(row["method"], {}).setdefault(row["degree"], []).append(row)
        cells.setdefault(row["degree"], set()).add(cell(row))
    at = degrees(bundle, need)
    return {method: by_degree for method, by_degree in found.items() if all(set(map(cell, by_degree.get(degree, ()))) == cells[degree] for degree in at)}


def times_of(bundle, need):
    """{method: {degree: row of its time}}"""
    found, wanted = {}, degrees(bundle, need)
    for row in bundle["timing.csv"].select(study=need.times, mode=need.mode, scalar=need.scalar, degree=wanted):
        found.setdefault(row["method"], {})[row["degree"]] = row
    return {method: rows for method, rows in found.items() if len(rows) == len(wanted)}


@dataclass(frozen=True)
class Found:
    """Who answers a need, with the rows that say so."""

    method: str
    errors: dict  # {degree: rows}
    times: dict  # {degree: row}
    counts: dict  # {degree: row of cost.csv}, where they were counted
    tied: tuple  # the other methods that are as fast, as far as the times tell


def product(rows, column):
    return math.prod(number(row, column) for row in rows)


def overlap(one, other):
    """Whether the intervals of two times have a value in common, as ratios to the same method where they have one."""
    low, high = ("ratio_low", "ratio_high") if one["ratio"] and one["relative_to"] == other["relative_to"] else ("low_ns", "high_ns")
    return number(one, low) <= number(other, high) and number(other, low) <= number(one, high)


def winner(bundle, need):
    """The Found of a need; None where no method meets the demand."""
    errors, times, at = errors_of(bundle, need), times_of(bundle, need), degrees(bundle, need)
    meeting = [method for method in errors if at and method in times and all(need.meets(row) for degree in at for row in errors[method][degree])]
    if not meeting:
        return None
    by_time = sorted(meeting, key=lambda method: product((times[method][degree] for degree in at), "ratio"))
    tied = [method for method in by_time if all(overlap(times[method][degree], times[by_time[0]][degree]) for degree in at)]
    best = min(tied, key=lambda method: product((row for degree in at for row in errors[method][degree]), "bound_u"))
    counted = bundle["cost.csv"].select(study=need.times, mode=need.mode, scalar=need.scalar, method=best) if "cost.csv" in bundle else ()
    return Found(best, errors[best], times[best], {row["degree"]: row for row in counted}, tuple(method for method in tied if method != best))


def time_text(row, counted):
    """`0.34 to 0.36; 46 instructions, about 2.9 ns`: the interval of the ratio first."""
    low, high = (general(number(row, column), 2) for column in ("ratio_low", "ratio_high"))
    nanoseconds = number(row, "median_ns")
    about = f"{general(nanoseconds, 2)} ns" if nanoseconds < MICROSECOND else f"{general(nanoseconds / MICROSECOND, 2)} µs"
    ratio = "1" if row["relative_to"] == row["method"] else high if float(low) == float(high) else f"{low} to {high}"
    return f"{ratio} ×<br>" + (f"{large(round(number(counted, 'instructions')))} instructions, " if counted else "") + f"about {about}"


def demand(bundle, need):
    """What a need demands, with the numbers of its rows."""
    said = {}
    for row in rows_of(bundle, need):
        said.setdefault("{interval}", set()).add(interval(row["t_min"], row["t_max"]))
        said.setdefault("{tolerance}", set()).add(shortest(row["tolerance"]))
    text = need.demand
    for name, values in said.items():
        text = text.replace(name, listing(sorted(values)))
    return text


def trials(bundle):
    """A sentence: how many curves the errors of each need are the largest of."""
    least = {need.name: min((row["trials"] for row in rows_of(bundle, need)), default=0) for need in NEEDS}
    usual = statistics.mode(least.values())
    others = ", ".join(f"{name.lower()} {large(number)}" for name, number in least.items() if number != usual)
    return f"Errors are the largest of {large(usual)} random curves{f' ({others})' if others else ''} for each cell, against the **exact** value."


def units():
    """Sentences: what u p~ is, and what an error of so many of them is in units of coordinates."""
    return (f"u = 2^-53; p~ = sum |b_i| |B_i(t)|, with the Euclidean norm |b_i|. For t in [0, 1] p~ is at most √d times the largest "
            f"coordinate in d dimensions, √{AXES} times in the plane: \"{SMALL} u\" is an error of at most "
            f"{scientific(SMALL * math.sqrt(AXES) * ROUNDOFF['double'], 2)} times that coordinate. ulp: last digits of the exact value. "
            "Lengths: relative; nearest points: eps is 2^-52 times the largest coordinate. "
            "×: the time over that of the third column's method, side by side, as its 99 % interval; instructions: counted by Valgrind, the same on "
            "every run; ns: about, on the bundle's machine. All are per prepared point or, of the other problems, per answer from the "
            "control points. Methods in parentheses are as fast, as far as the intervals tell.")


def trials_on_sets(real):
    """A sentence: which sets a share is the largest of."""
    sets = {}
    for row in (row for need in REAL for row in rows_of(real, need)):
        sets.setdefault(row["curves"], {})[row["degree"], row["generator"]] = row["trials"]
    points = sum(sum(trials.values()) for trials in sets.values())
    timed = (row for need in REAL for row in real["timing.csv"].select(study=need.times) if row["degree"] is not None)  # not the sentinel
    distances = distinct(timed, "coordinate_range")
    return (f"Real curves ([results/real](results/real)): the largest share on one of the sets {listing(sets)} ({large(points)} points), as stored and "
            f"translated on a page; times are of curves {listing(map(shortest, distances))} times their size from the origin.")


def line(bundle, need, columns):
    found, at = winner(bundle, need), degrees(bundle, need)
    what = f"**{need.name}**: {demand(bundle, need)}"
    if found is None:
        return [what, "none", "", *("" for _ in columns)]
    shown = {degree: [row for row in found.errors[degree] if row["study"] == need.studies[0]] for degree in at}
    tied = f" ({listing(f'`{method}`' for method in found.tied)})" if found.tied else ""
    relative = listing(f"`{method}`" for method in dict.fromkeys(row["relative_to"] for row in found.times.values()))
    return [what, f"`{found.method}`{tied}", relative,
            *(f"{need.error(shown[degree])}<br>{time_text(found.times[degree], found.counts.get(degree))}" if degree in at else ""
              for degree in columns)]


def answers(bundle, real=None):
    """The table, and what its numbers are: real curves first, where there is a bundle of them."""
    asked = [(real, need) for need in REAL if real] + [(bundle, need) for need in NEEDS]
    columns = sorted({degree for one, need in asked for degree in degrees(one, need)})
    head = ["need", "method", "× of", *(f"n = {shortest(degree)}" for degree in columns)]
    said = [*([trials_on_sets(real)] if real else []), trials(bundle), units()]
    return "\n\n".join([table(head, [line(one, need, columns) for one, need in asked]), *(textwrap.fill(text, WIDTH) for text in said)])
