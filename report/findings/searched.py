# SPDX-License-Identifier: MIT
"""Results of the search for worst cases, for findings and tables."""

import math

from ..bundle import Missing

GAIN = 1.5  # the gain over the sample that the search aims at; search.csv says `reached` where it got it


def rows_of(bundle, *suites):
    """Rows whose maxima are numbers."""
    rows = [r for r in bundle["search.csv"].of_suite(*suites).rows
            if all(isinstance(r[c], float) and math.isfinite(r[c]) for c in ("sampled_error_u", "searched_error_u"))]
    if not rows:
        raise Missing(f"`search.csv` has no finite maximum of the suite `{'` or `'.join(suites)}`")
    return rows


def gain(row):
    """The searched maximum over the sampled one; infinite where the sample has no error."""
    return row["searched_error_u"] / row["sampled_error_u"] if row["sampled_error_u"] else math.inf


def exceeding(rows):
    """Rows whose searched maximum exceeds the proved bound."""
    return [r for r in rows if r["bound_u"] is not None and not r["searched_error_u"] <= r["bound_u"]]
