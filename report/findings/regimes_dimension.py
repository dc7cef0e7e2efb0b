# SPDX-License-Identifier: MIT
"""The number of axes does not matter."""

from ..document import Finding
from ..wording import factor, general, shortest
from .regimes import ALIKE, SUITE, spread, study
from .series import names


def find(bundle):
    """Holds where the mean error over u p~ of every method that evaluates the given form is alike on all numbers of axes."""
    rows = study(bundle, "dimension")
    found = {m: w for m, w in spread(rows, "dimension").items() if ":" not in m}
    apart = [m for m, w in found.items() if w[0] > ALIKE]
    worst = max(found, key=lambda m: found[m][0])
    ratio, low, high = found[worst]
    axes = sorted({r["dimension"] for r in rows})
    return Finding(
        id="regimes_dimension", about="suite", suite=SUITE, claim="", holds=not apart,
        headline=f"From {shortest(axes[0])} to {shortest(axes[-1])} axes the mean error over u p~ of every method that evaluates the given "
                 f"form varies by a factor of {factor(ratio)} at most." if not apart else
        f"The mean error over u p~ of {names(apart)} depends on the number of axes, by a factor of up to {factor(ratio)}.",
        detail=(f"The largest variation is that of `{worst}` at degree {high['degree']:g}: {general(low['mean_error_u'])} on "
                f"{shortest(low['dimension'])} and {general(high['mean_error_u'])} on {shortest(high['dimension'])}.",),
        rows=(low, high))
