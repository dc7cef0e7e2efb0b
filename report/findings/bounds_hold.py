# SPDX-License-Identifier: MIT
"""Proved bounds against observed errors."""

from ..bundle import Missing
from ..document import Finding
from ..wording import count, general, large, listing

SUITE = ""  # of any bundle


def in_part(row):
    """Whether the bounds cover only a part of the trials: the largest error exceeds all bounds, but no trial violates
    its own."""
    return bool(row["bound_u"]) and not row["bound_violations"] and (row["max_error_u"] or 0) > row["bound_u"]


def find(bundle):
    """Holds where no trial of any method exceeds its proved bound."""
    rows = [r for r in bundle.judged().some(baseline="exact") if r["bound_u"] and r["status"] == "ok"]
    if not rows:
        raise Missing("`accuracy.csv` has no row with a bound")
    broken = [r for r in rows if r["bound_violations"]]
    trials = sum(r.number("trials") for r in rows)
    partly = [r for r in rows if in_part(r)]
    closest = max((r for r in rows if not in_part(r)), key=lambda r: (r["max_error_u"] or 0) / r["bound_u"], default=None)
    if closest is None:
        raise Missing("`accuracy.csv` has no row whose bound covers its largest error")
    used = (closest["max_error_u"] or 0) / closest["bound_u"]
    studies = dict.fromkeys(f"`{r['study']}`" for r in partly)
    methods = listing(dict.fromkeys(f"`{r['method']}`" for r in broken))
    return Finding(
        id="bounds_hold", about="reproduction" if bundle.has_suite("report") else "note", claim="", holds=not broken,
        headline=f"No proved error bound is exceeded in {large(trials)} judged evaluations." if not broken else
        f"A proved error bound is exceeded by {methods}: a bound or its condition is wrong.",
        detail=(f"{count(len(rows), 'cell')} of {count(len({r['method'] for r in rows}), 'method')} carry a bound. The closest "
                f"that an observed error comes to its bound is {general(used, 2)} of it (`{closest['method']}`, degree "
                f"{closest['degree']:g}).",
                f"In {count(len(partly), 'cell')} of {listing(studies)} some trials lie outside what is proved, and the "
                "largest error is one of theirs." if partly else ""),
        rows=tuple(broken or [closest, *partly]))
