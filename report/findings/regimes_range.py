# SPDX-License-Identifier: MIT
"""Over u p~ an error does not know the size of the coordinates."""

from ..document import Finding
from ..wording import count, factor, general, large, listing, shortest
from .regimes import ALIKE, SUITE, spread, study
from .series import names


def find(bundle):
    """Holds where every method errs alike in units of u p~ over all ranges; where it overflows is said apart."""
    rows = study(bundle, "range")
    found = spread(rows, "coordinate_range")
    uneven = [m for m, (ratio, *_) in found.items() if ratio > ALIKE]
    worst = max(found, key=lambda m: found[m][0])
    ratio, low, high = found[worst]
    ranges = sorted({r["coordinate_range"] for r in rows})
    broken = [r for r in rows if r["non_finite"]]
    places = listing(dict.fromkeys(f"R = {shortest(r['coordinate_range'])}, degree {r['degree']:g}" for r in broken))
    gone = sum(r["non_finite"] for r in broken)
    return Finding(
        id="regimes_range", about="suite", suite=SUITE, claim="", holds=not uneven,
        headline=f"From R = {shortest(ranges[0])} to {shortest(ranges[-1])} the mean error over u p~ of every method varies by a factor of "
                 f"{factor(ratio)} at most" + (f", but {count(len({r['method'] for r in broken}), 'method overflows', 'methods overflow')} "
                                            f"at {places}." if broken else ".")
        if not uneven else f"The mean error over u p~ of {names(uneven)} depends on the range, by a factor of up to {factor(ratio)}.",
        detail=(f"The largest variation is that of `{worst}` at degree {high['degree']:g}: {general(low['mean_error_u'])} at R = "
                f"{shortest(low['coordinate_range'])}, {general(high['mean_error_u'])} at R = {shortest(high['coordinate_range'])}.",
                f"Not finite: {large(gone)} trials, of {names(dict.fromkeys(r['method'] for r in broken))}. These cells are not compared."
                if broken else "Every trial gave a finite value."),
        rows=(low, high, *broken))
