# SPDX-License-Identifier: MIT
"""The difference loop of the source document on derivatives, as printed."""

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, scientific, shortest

SUITE = "derivative"
STUDY, PRINTED, MENDED = "derivative-order", "seed_000", "differences_de_casteljau"
WRONG = 1e6  # an error larger than the corrected loop's by this factor is not a rounding error


def find(bundle):
    """Holds where the printed loop is as accurate as the corrected one for the first derivative and wrong for every
    higher one."""
    table = bundle["derivative.csv"]
    pairs = []
    for row in table.select(study=STUDY, method=PRINTED, generator="continuous"):
        if 0 < row["order"] <= row["degree"]:
            other = table.one(study=STUDY, method=MENDED, generator="continuous", degree=row["degree"], order=row["order"])
            pairs.append((row, other, row.number("mean_error") / other.number("mean_error")))
    first = [p for p in pairs if p[0]["order"] == 1]
    higher = [p for p in pairs if p[0]["order"] > 1]
    if not first or not higher:
        raise Missing(f"`derivative.csv` has no `{STUDY}` rows of `{PRINTED}` for the first and higher orders")
    holds = all(ratio < 2 for *_, ratio in first) and all(ratio > WRONG for *_, ratio in higher)
    mildest = min(higher, key=lambda p: p[2])
    return Finding(
        id="derivative_as_printed", about="suite", suite=SUITE, claim="", holds=holds,
        headline="The difference loop of Document 000 is right for the first derivative and wrong for every higher one."
        if holds else "The difference loop of Document 000 is not told from the mended one order by order.",
        detail=(f"For the first derivative its mean error is at most {factor(max(r for *_, r in first))} times that of the loop "
                f"with pass m ending at n-m; from the second on it is at least {factor(mildest[2])} times that (degree "
                f"{shortest(mildest[0]['degree'])}, order {shortest(mildest[0]['order'])}: "
                f"{scientific(mildest[0]['mean_error'])} against {scientific(mildest[1]['mean_error'])}).",),
        rows=tuple(r for pair in (max(first, key=lambda p: p[2]), mildest) for r in pair[:2]))
