# SPDX-License-Identifier: MIT
"""float errs in its own unit roundoff as double does in its own."""

from ..document import Finding
from ..wording import factor, general, scientific
from .regimes import ALIKE, SUITE, spread, study
from .series import names


def find(bundle):
    """Holds where the mean errors of every method, in the unit of its scalar, agree between float and double."""
    found = spread(study(bundle, "float"), "scalar")
    apart = {m: w for m, w in found.items() if w[0] > ALIKE}
    worst = max(found, key=lambda m: found[m][0])
    ratio, low, high = found[worst]
    alike = [w[0] for m, w in found.items() if m not in apart]
    return Finding(
        id="regimes_float", about="suite", suite=SUITE, claim="", holds=not apart,
        headline=f"In units of its own u p~ float errs as double does: the mean errors of all {len(found)} methods agree within a factor of "
                 f"{factor(ratio)}." if not apart else
        f"In units of its own u p~ float errs as double does for {len(alike)} of {len(found)} methods, but not for {names(apart)}.",
        detail=(f"The largest difference is that of `{worst}` at degree {high['degree']:g}: {scientific(low['mean_error_u'])} in "
                f"{low['scalar']} and {scientific(high['mean_error_u'])} in {high['scalar']}."
                + (f" The others agree within a factor of {general(max(alike), 2)}." if apart and alike else ""),),
        rows=tuple(r for w in (apart or found).values() for r in w[1:]))
