# SPDX-License-Identifier: MIT
"""Whether guarded methods for inverse arc length always converge, and whether promises are kept."""

from ..bundle import Missing
from ..document import Finding
from ..wording import general, large, shortest
from .series import names

SUITE = "inverse_arc_length"
GUARDED = ("bracketed_newton", "halley")
STRICTEST = 1e-12  # below this, rounding errors decide


def find(bundle):
    """Holds where the guarded methods always converge and no method breaks a promise."""
    table = bundle["inverse_arc_length.csv"].of_suite("inverse_arc_length")
    guarded = [r for r in table.select(method=GUARDED) if r["tolerance"] >= STRICTEST]
    if not guarded:
        raise Missing(f"`inverse_arc_length.csv` has no row of {names(GUARDED)} at {STRICTEST:g} or above")
    broken = [r for r in table.rows if r["broken_promises"]]
    failed = [r for r in guarded if r["non_converged"]]
    longest = max(guarded, key=lambda r: r.number("max_iterations"))
    trials = sum(r.number("trials") for r in guarded)
    wrong = broken or failed
    return Finding(
        id="inverse_arc_length_brackets", about="suite", suite=SUITE, claim="", holds=not wrong,
        headline=f"Newton's and Halley's method in a bracket reach every length, at tolerances of {shortest(STRICTEST)} and above, "
        f"{large(trials)} times." if not wrong else
        f"A length is not reached as promised by {names(dict.fromkeys(r['method'] for r in wrong))}.",
        detail=(f"At most {general(longest['max_iterations'])} iterations (`{longest['method']}`, degree {shortest(longest['degree'])}, "
                f"`{longest['generator']}`, tolerance {shortest(longest['tolerance'])}). "
                + ("No method says that it kept a tolerance that it did not keep." if not broken else
                   f"{large(sum(r.number('broken_promises') for r in broken))} promises are broken."),),
        rows=tuple(wrong or [longest]))
