# SPDX-License-Identifier: MIT
"""Whether fits keep their tolerances and claimed errors."""

from ..document import Finding
from ..wording import count, general, large
from .series import names

SUITE = "fitting"


def find(bundle):
    """Holds where no data point was farther from a fitted curve than asked for or than claimed."""
    rows = bundle["fitting.csv"].of_suite("fitting").rows
    broken = [r for r in rows if r["broken_promises"] or r["understated"]]
    trials = sum(r.number("trials") for r in rows)
    closest = max((r for r in rows if r["max_error_over_tolerance"] is not None), key=lambda r: r["max_error_over_tolerance"])
    return Finding(
        id="fitting_promise", about="suite", suite=SUITE, claim="", holds=not broken,
        headline=f"No data point is farther from a fitted curve than asked for, in {large(trials)} fits." if not broken else
        f"Data lie farther from a curve than promised by {names(dict.fromkeys(r['method'] for r in broken))}.",
        detail=(f"{count(len({r['method'] for r in rows}), 'method')}, judged by exact distances to the whole curve; the largest is "
                f"{general(closest['max_error_over_tolerance'])} of the tolerance.",),
        rows=tuple(broken or [closest]))
