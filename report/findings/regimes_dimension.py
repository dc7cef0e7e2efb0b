# SPDX-License-Identifier: MIT
"""Errors over u p~ against the number of axes."""

from ..document import Finding
from ..wording import count, factor, general, shortest
from .regimes import ALIKE, SUITE, in_words, spreads, study
from .series import names


def find(bundle):
    """Holds where no method's mean error over u p~ depends on the number of axes."""
    rows = study(bundle, "dimension")
    found = spreads(rows, "dimension")
    apart = [m for m, s in found.items() if s.apart]
    widest = max(found.values(), key=lambda s: (s.apart, s.ratio))
    axes = sorted({r["dimension"] for r in rows})
    return Finding(
        id="regimes_dimension", about="suite", suite=SUITE, claim="", holds=not apart,
        headline=f"From {shortest(axes[0])} to {shortest(axes[-1])} axes the mean error over u p~ of no method changes "
                 f"by more than a factor of {ALIKE}." if not apart else
        f"The mean error over u p~ of {names(apart)} depends on the number of axes, by a factor of up to "
        f"{factor(widest.ratio)}.",
        detail=(f"{in_words(found)}; the largest variation is that of `{widest.high['method']}` at degree "
                f"{widest.high['degree']:g}: "
                f"{general(widest.low['mean_error_u'])} on {count(int(widest.low['dimension']), 'axis', 'axes')} and "
                f"{general(widest.high['mean_error_u'])} on {shortest(widest.high['dimension'])}.",),
        rows=(widest.low, widest.high))
