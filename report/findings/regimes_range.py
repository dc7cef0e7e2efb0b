# SPDX-License-Identifier: MIT
"""Errors over u p~ against the size of the coordinates."""

from ..document import Finding
from ..wording import count, factor, general, large, listing, shortest
from .regimes import ALIKE, SUITE, in_words, spreads, study
from .series import names


def find(bundle):
    """Holds where no method's mean error over u p~ depends on the range. Overflow is reported separately."""
    rows = study(bundle, "range")
    found = spreads(rows, "coordinate_range")
    uneven = [m for m, s in found.items() if s.apart]
    widest = max(found.values(), key=lambda s: (s.apart, s.ratio))
    ranges = sorted({r["coordinate_range"] for r in rows})
    broken = [r for r in rows if r["non_finite"]]
    places = listing(dict.fromkeys(f"R = {shortest(r['coordinate_range'])}, degree {r['degree']:g}" for r in broken))
    return Finding(
        id="regimes_range", about="suite", suite=SUITE, claim="", holds=not uneven,
        headline=f"From R = {shortest(ranges[0])} to {shortest(ranges[-1])} the mean error over u p~ of no method changes "
                 f"by more than a factor of {ALIKE}" + (f", but {count(len({r['method'] for r in broken}), 'method overflows', 'methods overflow')} at {places}."
                                     if broken else ".") if not uneven else
        f"The mean error over u p~ of {names(uneven)} depends on the range, by a factor of up to {factor(widest.ratio)}.",
        detail=(f"{in_words(found)}; the largest variation is that of `{widest.high['method']}` at degree "
                f"{widest.high['degree']:g}: "
                f"{general(widest.low['mean_error_u'])} at R = {shortest(widest.low['coordinate_range'])}, "
                f"{general(widest.high['mean_error_u'])} at R = {shortest(widest.high['coordinate_range'])}.",
                f"Not finite: {large(sum(r['non_finite'] for r in broken))} trials, of "
                f"{names(dict.fromkeys(r['method'] for r in broken))}. These cells are not compared." if broken else
                "Every trial gave a finite value."),
        rows=(widest.low, widest.high, *broken))
