# SPDX-License-Identifier: MIT
"""Which method to choose: times and errors of the bundle, cell by cell, and the cell to show first."""

import math
from dataclasses import dataclass

from . import inputs
from .rows import grouped
from .wording import count

# A largest error above this share of p~, the sum of the absolute terms, leaves so few correct digits that the method is useless, whatever its time.
USELESS = 1e-3
ROUNDOFF = {"double": 2.0 ** -53, "float": 2.0 ** -24}
LOSING = 100  # a largest error in units of u p~ above which the page gives the number of lost digits
SMALL = 5  # roundings per degree: above the proved bounds of all methods in one pass over the control points
NO_TIME = "not timed"
TYPICAL = 10  # degree
MOST = 20_000  # candidates that the page's picker holds
FORMS = {"bernstein": "Bernstein form", "power": "power form", "rational": "rational curves"}


@dataclass(frozen=True)
class Cell:
    """A question: one value of every axis of the picker."""

    form: str
    degree: float
    mode: str
    scalar: str
    dimension: float
    where: str  # range and interval in words, or the set and its placement


@dataclass(frozen=True)
class Candidate:
    """A method in a cell: the row with its errors, the row with its time where it has one, and a trial to replay."""

    method: str
    errors: object
    timed: object = None
    replay: str = ""

    def number(self, timed_column, column):
        """A number of the row of pareto.csv, or of accuracy.csv where there was no time."""
        return self.errors[column] if self.timed is None else self.timed[timed_column]

    @property
    def error_u(self):
        return self.number("observed_max_u", "max_error_u")

    @property
    def bound_u(self):
        return self.number("bound_u", "bound_u")

    @property
    def ns(self):
        return None if self.timed is None else self.timed["ns"]

    @property
    def front(self):
        return "" if self.timed is None else self.timed["pareto"]


def useful(error_u, scalar):
    """Whether a largest error in units of u p~ leaves enough digits."""
    return isinstance(error_u, float) and error_u * ROUNDOFF.get(scalar, ROUNDOFF["double"]) <= USELESS


def small(degree, form):
    """The largest bound in units of u p~ that is called small; a rational curve has a numerator and a denominator."""
    return (2 if form == "rational" else 1) * SMALL * degree


def is_proved_small(bound_u, degree, form):
    """Whether a proved bound in units of u p~ is small: the requirement by default."""
    return isinstance(bound_u, float) and bound_u <= small(degree, form)


def lost(error_u):
    """The decimal digits that an error of so many u p~ loses, in words; empty up to LOSING."""
    if not isinstance(error_u, float) or not LOSING < error_u < math.inf:
        return ""
    return f"loses {count(round(math.log10(error_u)), 'digit')}"


def _cell(row, mode):
    where = inputs.words(row) if row["curves"] else inputs.words(row, "generator")
    return Cell(row["form"] or "", row["degree"], mode, row["scalar"] or "double", row["dimension"], where)


def _replays(bundle):
    """A function of (row, its study of accuracy) to the id of the kept trial of the largest error."""
    def key(row, study):
        return study, row["method"], _cell(row, NO_TIME)
    kept = {}
    for row in bundle.tables["worst.csv"].rows if "worst.csv" in bundle else ():
        kept.setdefault(key(row, row["study"]), []).append(row)
    return lambda row, study: max(kept.get(key(row, study), ()), key=lambda one: one["error_u"] or 0, default={"worst_id": ""})["worst_id"]


def candidates(bundle):
    """{Cell: [Candidate]}: timed cells from pareto.csv; where nothing was timed those of accuracy.csv, with the largest error over
    what generators draw."""
    replay = _replays(bundle)
    cells = {}
    for row in bundle.tables["pareto.csv"].rows if "pareto.csv" in bundle else ():
        cells.setdefault(_cell(row, row["mode"]), {})[row["method"]] = Candidate(row["method"], row, row, replay(row, row["accuracy_study"]))
    if not cells and ("accuracy.csv" in bundle or "unstable.csv" in bundle):
        rows = [r for r in bundle.judged().rows if r["baseline"] == "exact" and r["status"] == "ok" and r["max_error_u"] is not None]
        for row in rows[:MOST]:
            members = cells.setdefault(_cell(row, NO_TIME), {})
            held = members.get(row["method"])
            if held is None or row["max_error_u"] > held.error_u:
                members[row["method"]] = Candidate(row["method"], row, None, replay(row, row["study"]))
    return {cell: ranked(members.values(), cell) for cell, members in cells.items()}


def ranked(members, cell):
    """The useful ones before the others. Where there are times, those whose bound is proved to be small come first and those that lose digits
    last, then by time; else that with the smallest error."""
    def key(one):
        timed = cell.mode != NO_TIME
        later = timed and not is_proved_small(one.bound_u, cell.degree, cell.form)
        size = one.ns if one.ns is not None else one.error_u
        return not useful(one.error_u, cell.scalar), later, timed and lost(one.error_u) != "", size is None, size if size is not None else 0.0
    return sorted(members, key=key)


def default_cell(cells):
    """The cell that a page shows first: Bernstein form, double, in the plane, one point at a time, of the degree next to TYPICAL."""
    def best(values, *wanted):
        return next((w for w in wanted if w in values), values[0])
    left = list(cells)
    for axis, wanted in (("form", ("bernstein",)), ("scalar", ("double",)), ("mode", ("point",)), ("dimension", (2.0,))):
        chosen = best([getattr(c, axis) for c in left], *wanted)
        left = [c for c in left if getattr(c, axis) == chosen]
    return min(left, key=lambda c: abs(c.degree - TYPICAL))
