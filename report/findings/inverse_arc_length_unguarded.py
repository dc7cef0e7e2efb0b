# SPDX-License-Identifier: MIT
"""The source document's iteration for inverse arc length, which has no safeguard."""

from ..document import Finding
from ..wording import general, large, percent, shortest

SUITE = "inverse_arc_length"
PRINTED, GUARDED = "seed_000_newton", "bracketed_newton"


def find(bundle):
    """Holds where the document's iteration fails on curves on which a bracket does not."""
    table = bundle["inverse_arc_length.csv"].of_suite("inverse_arc_length")
    pairs = []
    for row in table.some(method=PRINTED):
        key = {c: row[c] for c in ("study", "dimension", "degree", "coordinate_range", "t_min", "t_max", "generator", "tolerance")}
        pairs.append((row, table.one(method=GUARDED, **key)))
    pairs = [(row, other) for row, other in pairs if not other["non_converged"]]
    failed = sum(row.number("non_converged") for row, _ in pairs)
    trials = sum(row.number("trials") for row, _ in pairs)
    worst, beside = max(pairs, key=lambda p: p[0].number("non_converged") / p[0].number("trials"))
    return Finding(
        id="inverse_arc_length_unguarded", about="suite", suite=SUITE, claim="", holds=failed > 0,
        headline=f"The source document's iteration for the parameter at a length fails in {percent(failed / trials)} of the trials in "
        "which a bracket does not." if failed else
        "The source document's iteration for the parameter at a length fails nowhere that a bracket does not.",
        detail=(f"{large(failed)} of {large(trials)}; most in {general(worst['non_converged'])} of {general(worst['trials'])} trials "
                f"of degree {shortest(worst['degree'])}, `{worst['generator']}`, at a tolerance of {shortest(worst['tolerance'])}. Its mean number of "
                f"iterations there is {general(worst['mean_iterations'])}, that of `{GUARDED}` "
                f"{general(beside['mean_iterations'])}.",) if failed else
        (f"{large(trials)} trials.",),
        rows=(worst, beside))
