# SPDX-License-Identifier: MIT
"""Selections of printed cells for the findings."""

import math
from dataclasses import dataclass

from ..bundle import Missing

BAND = 0.95 - 0.05
RARE = 0.05  # a probability below which chance is no explanation
ACCURACY_TABLES = ("2.3.1", "2.3.2", "2.3.3")


def accuracy_cells(bundle):
    """The distinct printed accuracy cells: the last range of 2.3.2 repeats the last degree of 2.3.1."""
    cells = {}
    for row in bundle["scorecard.csv"].some(table=ACCURACY_TABLES):
        key = tuple(row[c] for c in ("curve", "method", "statistic", "degree", "coordinate_range", "t_min", "t_max"))
        cells.setdefault(key, row)
    return list(cells.values())


def experiments(cells):
    """The cells grouped by their random curves. The methods and statistics of one experiment share its trials, so that
    their deviations are correlated."""
    found = {}
    for row in cells:
        found.setdefault(tuple(row[c] for c in ("curve", "degree", "coordinate_range", "t_min", "t_max")), []).append(row)
    return list(found.values())


@dataclass(frozen=True)
class Event:
    """A printed error or count with all cells that repeat it, since a table repeats a run of another or two methods err alike."""

    rows: tuple

    @property
    def verdict(self):
        """That of its cells; where they differ, the error of the band decides."""
        found = {row["verdict"] for row in self.rows}
        return found.pop() if len(found) == 1 else "edge"

    @property
    def chance(self):
        """The probability that a repetition of the report's experiment is called outside."""
        stated = self.rows[0]["chance_outside"]
        return 1 - BAND if stated is None else stated  # older bundles know no edge


def events(bundle):
    """The distinct errors and counts that the report prints, as Events."""
    found = {}
    for row in bundle["scorecard.csv"].rows:
        key = tuple(row[c] for c in ("curve", "statistic", "degree", "coordinate_range", "t_min", "t_max", "published"))
        found.setdefault(key, []).append(row)
    return [Event(tuple(rows)) for rows in found.values()]


def outside_by_chance(found):
    """(how many of these events chance leaves outside on average, the probability that it leaves as many outside as there are, if the
    events were independent)."""
    expected = sum(event.chance for event in found)
    share, n = expected / len(found), len(found)
    outside = sum(event.verdict == "outside" for event in found)
    return expected, math.fsum(math.comb(n, k) * share ** k * (1 - share) ** (n - k) for k in range(outside, n + 1))


def against_exact(bundle, method, degree):
    """The row of most trials with the errors of a method for Bézier curves, inputs continuous, on the cells of table 2.3.1."""
    return bundle.accuracy(study="2.3.1-bezier", method=method, degree=degree, baseline="exact", generator="continuous")


def degrees(bundle):
    """The degrees that the source report prints, ascending."""
    rows = bundle["scorecard.csv"].some(table="2.3.1")
    return sorted({row.number("degree") for row in rows})


def series(bundle, axis, **key):
    """The cells of one printed row, ascending along an axis."""
    rows = bundle["scorecard.csv"].some(**key)
    return sorted(rows, key=lambda row: row.number(axis))


def per_degree(first, last, low, high):
    """The factor per degree by which an error grows from `first` at degree `low` to `last` at degree `high`."""
    if first * last < 0:
        raise Missing("an error is negative")
    return (last / first) ** (1 / (high - low))


# An error that grows by at least this factor per degree is called exponential.
EXPONENTIAL = 1.5
# Values that differ by less than this factor are called flat.
FLAT = 1.25
