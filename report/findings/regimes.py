# SPDX-License-Identifier: MIT
"""What the findings about regimes look at: one study, and by what the mean error of a method varies over its axis."""

import math

from ..bundle import Missing

SUITE = "regimes"
ALIKE = 2  # means of heavy-tailed errors over thousands of trials differ by less than this where nothing else does


def study(bundle, name):
    """Rows of one study against the exact value."""
    return bundle.exact(f"regimes-{name}").rows


def spread(rows, apart):
    """{method: (largest over least mean error in u p~, the two rows)}; cells compared differ in the column `apart` only.

    Cells with trials that are not finite are left out: the finite ones of a cell are its milder ones.
    """
    groups = {}
    for row in rows:
        if row["status"] == "ok" and not row["non_finite"] and isinstance(row["mean_error_u"], float) and 0 < row["mean_error_u"] < math.inf:
            rest = tuple(row[c] for c in ("scalar", "dimension", "degree", "coordinate_range", "t_min", "t_max") if c != apart)
            groups.setdefault((row["method"], rest), []).append(row)
    found = {}
    for (method, _), members in groups.items():
        low, high = (end(members, key=lambda r: r["mean_error_u"]) for end in (min, max))
        ratio = high["mean_error_u"] / low["mean_error_u"]
        if len(members) > 1 and ratio >= found.get(method, (0,))[0]:
            found[method] = (ratio, low, high)
    if not found:
        raise Missing(f"no two cells of the study differ in `{apart}` only")
    return found
