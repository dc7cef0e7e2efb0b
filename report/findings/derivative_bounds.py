# SPDX-License-Identifier: MIT
"""Proved bounds of derivatives against observed errors."""

from ..bundle import Missing
from ..document import Finding
from ..wording import count, general, large, shortest
from .series import names

SUITE = "derivative"


def find(bundle):
    """Holds where no derivative of any trial exceeds its proved bound."""
    rows = [r for r in bundle["derivative.csv"].of_suite("derivative").rows if r["bound_u"]]
    if not rows:
        raise Missing("`derivative.csv` has no `derivative-` row with a bound")
    broken = [r for r in rows if r["bound_violations"]]
    closest = max(rows, key=lambda r: (r["max_error_u"] or 0) / r["bound_u"])
    return Finding(
        id="derivative_bounds", about="suite", suite=SUITE, claim="", holds=not broken,
        headline=f"No proved bound of a derivative is exceeded in {large(sum(r.number('trials') for r in rows))} judged evaluations."
        if not broken else
        f"A proved bound of a derivative is exceeded by {names(dict.fromkeys(r['method'] for r in broken))}: a bound or its "
        "condition is wrong.",
        detail=(f"{count(len(rows), 'cell')} of {count(len({r['method'] for r in rows}), 'method')} carry a bound. The closest comes "
                f"to {general((closest['max_error_u'] or 0) / closest['bound_u'], 2)} of it (`{closest['method']}`, degree "
                f"{shortest(closest['degree'])}, order {shortest(closest['order'])}).",),
        rows=tuple(broken or [closest]))
