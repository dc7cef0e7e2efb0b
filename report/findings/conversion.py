# SPDX-License-Identifier: MIT
"""Selections of rows for the findings and figures about conversions."""

import math

from ..bundle import Missing

SUITE = "conversion"
UNIT = 2.0 ** -53
# By kind of curve: the name of the conversion, and its norm (from the largest coefficient to the largest coefficient).
NORMS = {
    "bezier": ("Bernstein to power form", "max_j C(n,j) 2^j", lambda n: max(math.comb(n, j) * 2 ** j for j in range(n + 1))),
    "polynomial": ("Power to Bernstein form", "(n+1)", lambda n: n + 1),
}
SOURCES = (("mean_conversion_error", "conversion"), ("mean_one_minus_t_error", "rounding of 1-t"),
           ("mean_evaluation_error", "evaluation"))


def scale(row):
    """The largest distance of a control point from the origin, with R in every coordinate."""
    return row.number("coordinate_range") * math.sqrt(row["dimension"] or 1)


def sources(bundle):
    """Accuracy rows whose error was taken apart."""
    rows = [r for r in bundle.exact("conversion").rows if all(r[c] is not None for c, _ in SOURCES)]
    if not rows:
        raise Missing("`accuracy.csv` has no row of the suite `conversion` with its error taken apart")
    return rows


def to_power(bundle):
    """Rows of Bernstein curves that are evaluated in several intervals of t."""
    rows = [r for r in bundle.exact("conversion").rows if r["curve"] == "bezier"]
    if len({(r["t_min"], r["t_max"]) for r in rows}) < 2:
        raise Missing("`accuracy.csv` has no study of the suite `conversion` of Bézier curves with several intervals of t")
    return rows


def middle(row):
    """The middle of a row's interval of t."""
    return (row.number("t_min") + row.number("t_max")) / 2


def growth(start, t, degree):
    """The factor by which (1+2t)^n grows from `start` to `t`."""
    return ((1 + 2 * t) / (1 + 2 * start)) ** degree
