# SPDX-License-Identifier: MIT
"""Selections of printed cells for the findings."""

from ..bundle import Missing

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
