# SPDX-License-Identifier: MIT
"""Searched maxima against proved bounds."""

from ..bundle import Missing
from ..document import Finding
from ..wording import count, general, shortest
from .searched import exceeding, rows_of
from .series import names

SUITE = "worst"


def find(bundle):
    """Holds where no searched maximum exceeds its proved bound."""
    rows = rows_of(bundle, "worst")
    bounded = [r for r in rows if r["bound_u"]]
    if not bounded:
        raise Missing("`search.csv` has no `worst-` row with a bound")
    broken = exceeding(rows)
    closest = max(bounded, key=lambda r: r["searched_error_u"] / r["bound_u"])
    unbounded = list(dict.fromkeys(r["method"] for r in rows if r["bound_u"] is None))
    return Finding(
        id="worst_bounds", about="suite", suite=SUITE, claim="", holds=not broken,
        headline=f"No searched worst case exceeds a proved bound, in {count(len(bounded), 'cell')} of "
                 f"{count(len({r['method'] for r in bounded}), 'method')}." if not broken else
        f"A searched worst case exceeds the proved bound of {names(dict.fromkeys(r['method'] for r in broken))}: a bound or "
        "its condition "
        "is wrong.",
        detail=(f"The closest comes to {general(closest['searched_error_u'] / closest['bound_u'], 2)} of its bound "
                f"(`{closest['method']}`, "
                f"degree {shortest(closest['degree'])}, `{closest['search_id']}`)."
                + (f" No bound is proved for {names(unbounded)}." if unbounded else ""),), rows=tuple(broken or [closest]))
