# SPDX-License-Identifier: MIT
"""The results of a method for projection over all cells of its studies."""

from dataclasses import dataclass

from ..bundle import Missing

SUITE = "projection"
FILE = "projection.csv"
GOAL = 4  # units of 2^-52 times the largest coordinate


@dataclass(frozen=True)
class Method:
    """One method over the cells that it supports."""

    rows: tuple
    trials: float
    missed: float
    largest: float  # error of a distance, in units of 2^-52 times the largest coordinate

    @property
    def share(self):
        return self.missed / self.trials


def rows_of(bundle, *suites):
    """The rows of all methods that have numbers; Missing where there are none."""
    return bundle.judged(FILE).of_suite(*suites or (SUITE,)).some(status="ok")


def of_rows(rows):
    """The Method of these rows. Raises Missing where there are none."""
    if not rows:
        raise Missing(f"`{FILE}` has no cells of the same degree for two methods that are compared")
    return Method(tuple(rows), sum(r.number("trials") for r in rows), sum(r.number("missed") for r in rows),
                  max(r.number("max_error_eps") for r in rows))


def by_method(bundle):
    """{method: Method}, ordered by missed foot points, then by error."""
    methods = {}
    for row in rows_of(bundle):
        methods.setdefault(row["method"], []).append(row)
    all_of = {m: of_rows(rows) for m, rows in methods.items()}
    return dict(sorted(all_of.items(), key=lambda item: (item[1].share, item[1].largest, item[0])))
