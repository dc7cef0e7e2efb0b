# SPDX-License-Identifier: MIT
"""The error of the power form against the degree."""

from ..document import Finding
from ..wording import general, scientific
from .printed import EXPONENTIAL, per_degree, series


def find(bundle):
    """Holds where the mean error against the exact value grows exponentially through the power form."""
    rows = series(bundle, "degree", table="2.3.1", curve="bezier", method="factorial:power_sum", statistic="mean_error")
    low, high = rows[0].number("degree"), rows[-1].number("degree")
    growth = {c: per_degree(rows[0].number(c), rows[-1].number(c), low, high)
              for c in ("published", "ours_median", "continuous_median", "against_exact")}
    holds = growth["against_exact"] >= EXPONENTIAL and growth["continuous_median"] >= EXPONENTIAL
    return Finding(
        id="growth_with_degree", about="conclusion",
        claim="With rising degree the error of conversion to power form rises exponentially.",
        place="section 2.3.1, after the first table", holds=holds,
        headline=f"Through the power form the error of a Bézier curve is multiplied by {general(growth['against_exact'])} "
                 "with every degree: it grows exponentially." if holds else
                 f"Through the power form the error is multiplied by only {general(growth['against_exact'])} with every "
                 "degree: it does not grow exponentially.",
        detail=(f"From degree {low:g} to {high:g} the mean error goes from {scientific(rows[0]['against_exact'])} to "
                f"{scientific(rows[-1]['against_exact'])} against the exact value. The factor per degree is "
                f"{general(growth['published'])} as printed, {general(growth['ours_median'])} in our repetition and "
                f"{general(growth['continuous_median'])} with continuous inputs.",),
        rows=tuple(rows))
