# SPDX-License-Identifier: MIT
"""Degrees at which Bernstein factors underflow."""

from ..document import Finding
from ..wording import count, general, large, listing, shortest
from .regimes import SUITE, study
from .series import by_degree, names


def find(bundle):
    """Holds where no method returns a value that is not finite."""
    rows = study(bundle, "degree")
    methods = by_degree(rows)
    broken = [r for r in rows if r["non_finite"]]
    refused = {}
    for r in rows:
        if r["status"] != "ok":
            refused.setdefault(r["method"], []).append(r["degree"])
    top = max(r["degree"] for r in rows)
    last = {m: at[top]["mean_error_u"] for m, at in methods.items() if top in at}
    best, worst = (end(last, key=last.get) for end in (min, max))
    return Finding(
        id="regimes_degree", about="suite", suite=SUITE, claim="", holds=not broken,
        headline=f"Up to degree {shortest(top)} no method returns a value that is not finite"
                 + (" (not for this degree: " + listing(f"`{m}` from {shortest(min(at))}" for m, at in refused.items()) + ")."
                    if refused else ".")
        if not broken else f"{names(dict.fromkeys(r['method'] for r in broken))} return values that are not finite, first at "
                           "degree "
        f"{shortest(min(r['degree'] for r in broken))}.",
        detail=(f"At degree {shortest(top)} the mean error is {general(last[best])} u p~ (`{best}`) to "
                f"{general(last[worst])} (`{worst}`) "
                f"among {count(len(last), 'method')}; {large(sum(r['non_finite'] or 0 for r in rows))} trials are not finite.",),
        rows=tuple(broken or [at[top] for at in methods.values() if top in at]))
