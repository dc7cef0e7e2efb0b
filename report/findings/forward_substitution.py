# SPDX-License-Identifier: MIT
"""The cause of the exponential error of conversions from power form to Bernstein form."""

import math

from ..document import Finding
from ..wording import factor, general, scientific
from .printed import EXPONENTIAL, degrees, per_degree


def find(bundle):
    """Holds where the error grows exponentially with forward substitution and does not with the positive sum."""
    low, *_, high = degrees(bundle)
    rows = {c: [bundle.accuracy(study="truth-polynomial", method=f"{c}:de_casteljau", degree=n, baseline="exact",
                                generator="continuous") for n in (low, high)]
            for c in ("forward_substitution", "positive_sum")}
    error = {c: [r.number("mean_error") for r in pair] for c, pair in rows.items()}
    growth = {c: per_degree(*pair, low, high) for c, pair in error.items()}
    holds = growth["positive_sum"] < EXPONENTIAL <= growth["forward_substitution"]
    solve, positive = error["forward_substitution"], error["positive_sum"]
    ratio = solve[1] / positive[1]
    decades = math.log10(ratio)
    return Finding(
        id="forward_substitution", about="correction",
        claim="On polynomial curves the errors grow exponentially with the degree; where it is large, they come mainly from the "
              "conversion to Bernstein form.", place="section 2.3.1, after the second table",
        holds=holds,
        headline="The exponential error of power form to Bernstein form is the report's forward substitution, not the "
                 "conversion: with the positive sum it vanishes." if holds else
                 "Replacing forward substitution by the positive sum does not remove an exponential error in this bundle.",
        detail=(f"At degree {high:g} the mean error against the exact value is {scientific(solve[1])} with "
                f"`forward_substitution` and {scientific(positive[1])} with `positive_sum`, both followed by de Casteljau: "
                f"a ratio of {factor(ratio)}, {general(decades, 2)} decades.",
                f"From degree {low:g} to {high:g} the error is multiplied by {general(growth['forward_substitution'])} per "
                f"degree with the one and by {general(growth['positive_sum'])} with the other."),
        rows=tuple(r for pair in rows.values() for r in pair))
