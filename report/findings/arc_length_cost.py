# SPDX-License-Identifier: MIT
"""The evaluations that arc lengths need for a tolerance: Simpson's rule against Gauss-Legendre rules."""

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, general, shortest

SUITE = "arc_length"
STUDY, SIMPSON, GAUSS = "arc_length-tolerance", "adaptive_simpson38", "gauss_legendre_adaptive"
STRICT = 1e-6


def find(bundle):
    """Holds where adaptive Gauss-Legendre rules take fewer evaluations than Simpson's at every strict tolerance."""
    table = bundle["arc_length.csv"]
    pairs = []
    for row in table.select(study=STUDY, method=SIMPSON):
        if row["tolerance"] <= STRICT and not row["non_converged"]:
            key = {c: row[c] for c in ("degree", "generator", "tolerance")}
            other = table.one(study=STUDY, method=GAUSS, **key)
            pairs.append((row.number("mean_evaluations") / other.number("mean_evaluations"), row, other))
    if not pairs:
        raise Missing(f"`arc_length.csv` has no converged `{STUDY}` rows of `{SIMPSON}` at {STRICT:g} or below")
    least = min(pairs, key=lambda p: p[0])
    most = max(pairs, key=lambda p: p[0])
    holds = least[0] > 1
    return Finding(
        id="arc_length_cost", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"At tolerances of {shortest(STRICT)} and below, adaptive Gauss-Legendre rules take fewer evaluations than "
        "Simpson's 3/8 rule." if holds else
        f"At tolerances of {shortest(STRICT)} and below, adaptive Gauss-Legendre rules do not always take fewer evaluations than "
        "Simpson's 3/8 rule.",
        detail=(f"Simpson's rule takes {factor(least[0])} to {factor(most[0])} times as many: at {shortest(most[1]['tolerance'])} "
                f"{general(most[1]['mean_evaluations'])} against {general(most[2]['mean_evaluations'])} (degree "
                f"{shortest(most[1]['degree'])}, `{most[1]['generator']}`).",),
        rows=(*least[1:], *most[1:]))
