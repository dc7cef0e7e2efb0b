# SPDX-License-Identifier: MIT
"""Errors in float against errors in double, each in its own unit roundoff."""

from ..document import Finding
from ..wording import count, general
from .regimes import ALIKE, SUITE, in_words, spreads, study
from .series import names


def find(bundle):
    """Holds where the mean errors of every method, in the unit of its scalar, agree between float and double."""
    found = spreads(study(bundle, "float"), "scalar")
    apart = {m: s for m, s in found.items() if s.apart}
    widest = max(found.values(), key=lambda s: (s.apart, s.ratio))
    return Finding(
        id="regimes_float", about="suite", suite=SUITE, claim="", holds=not apart,
        headline=f"In units of its own u p~ float errs as double does: the mean errors of {count(len(found), 'method')} "
                 f"agree within a factor of {ALIKE}." if not apart else
        f"In units of its own u p~ float errs as double does for {len(found) - len(apart)} of {count(len(found), 'method')}, "
        "but not for "
        f"{names(apart)}.",
        detail=(f"{in_words(found)}; the largest difference is that of `{widest.high['method']}` at degree "
                f"{widest.high['degree']:g}: "
                f"{general(widest.low['mean_error_u'])} in {widest.low['scalar']} and {general(widest.high['mean_error_u'])} "
                "in "
                f"{widest.high['scalar']}.",),
        rows=tuple(r for s in (apart or found).values() for r in (s.low, s.high)))
