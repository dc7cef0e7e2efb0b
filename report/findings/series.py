# SPDX-License-Identifier: MIT
"""Mean errors in u p~ by method and degree, for the findings of the suites."""

from ..bundle import Missing
from ..wording import listing, shortest


def by_degree(rows):
    """{method: {degree: row}} of the rows with a number."""
    methods = {}
    for row in rows:
        if row["status"] == "ok" and isinstance(row["mean_error_u"], float):
            methods.setdefault(row["method"], {})[row.number("degree")] = row
    if not methods:
        raise Missing("no row has a mean error over u p~")
    return methods


def best(methods):
    """{degree: the methods with the least mean error}; several where their errors are equal."""
    degrees = sorted({n for rows in methods.values() for n in rows})
    least = {n: min(rows[n]["mean_error_u"] for rows in methods.values() if n in rows) for n in degrees}
    return {n: tuple(m for m, rows in methods.items() if n in rows and rows[n]["mean_error_u"] == least[n]) for n in degrees}


def growth(rows):
    """The largest mean error of one method over that at the lowest degree."""
    first = rows[min(rows)]["mean_error_u"]
    return max(r["mean_error_u"] for r in rows.values()) / first


def names(methods, most=6):
    """The names as text: `a`, `b` and 3 more."""
    methods = [f"`{m}`" for m in methods]
    return listing(methods) if len(methods) <= most else f"{', '.join(methods[:most - 1])} and {len(methods) - most + 1} more"


def degrees(values):
    return f"degree {listing(shortest(n) for n in values)}"
