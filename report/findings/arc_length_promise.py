# SPDX-License-Identifier: MIT
"""Whether methods for arc lengths keep the tolerances that they report as kept."""

from ..document import Finding
from ..wording import count, large, percent
from .series import names

SUITE = "arc_length"


def find(bundle):
    """Holds where no method said that it kept a tolerance that it did not keep."""
    rows = bundle["arc_length.csv"].of_suite("arc_length").rows
    broken = [r for r in rows if r["broken_promises"]]
    trials = sum(r.number("trials") for r in rows)
    refused = sum(r.number("non_converged") for r in rows)
    silent = sorted({r["method"] for r in rows} - {r["method"] for r in rows if r["non_converged"] < r["trials"]})
    return Finding(
        id="arc_length_promise", about="suite", suite=SUITE, claim="", holds=not broken,
        headline=f"Every promised tolerance of an arc length is kept, in {large(trials - refused)} promises." if not broken else
        f"A promised tolerance of an arc length is broken by {names(dict.fromkeys(r['method'] for r in broken))}.",
        detail=(f"{count(len({r['method'] for r in rows}), 'method')} were asked {large(trials)} times and said "
                f"{percent(refused / trials)} of the time that they could not keep the tolerance."
                + (f" Never to promise anything is all that {names(silent)} can do." if silent else ""),),
        rows=tuple(broken or rows[:1]))
