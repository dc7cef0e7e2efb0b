# SPDX-License-Identifier: MIT
"""The printed rows that the figures of one table draw, and words about them for people who cannot see them."""

from ..methods import FORM, STATISTIC, name
from ..wording import scientific
from .canvas import COLOURS

METHODS = {
    "bezier": ("de_casteljau", "factorial:power_sum"),
    "polynomial": ("forward_substitution:de_casteljau", "forward_substitution:direct"),
}
UNDER = "forward_substitution:de_casteljau"  # nearly everywhere on the same line as its sibling
COLOUR = {m: c for m, c in zip((m for methods in METHODS.values() for m in methods), COLOURS)}
LEGEND = [(name(m), c) for m, c in COLOUR.items()]


def rows_of(bundle, table, curve, method, statistic, order):
    """Rows of one printed row, ascending in `order`; Missing where there are none."""
    return sorted(bundle["scorecard.csv"].some(table=table, curve=curve, method=method, statistic=statistic), key=order)


def describe(rows, axis):
    """`via power form, mean error: 2.8e-10 at degree 4 to 1.2e-3 at degree 20`, from our medians."""
    first, last = rows[0], rows[-1]
    return (f"{name(first['method'])}, {STATISTIC[first['statistic']][0]}, {FORM[first['curve']][0]}: "
            f"{scientific(first['ours_median'])} at {axis(first)} to {scientific(last['ours_median'])} at {axis(last)}")
