# SPDX-License-Identifier: MIT
"""Methods against the exact value, in units of u p~."""

from ..bundle import Missing
from ..document import Text
from ..error_tables import error_tables
from ..wording import listing
from .suite_parts import figure

TITLE = "Methods against the truth"
SUITE = "report"


def blocks(bundle, _findings):
    """Per study: mean error; then the largest error beside its proved bound."""
    judged = bundle.exact(SUITE)
    table = judged.with_rows([r for r in judged.rows if not bundle.studies[r["study"]].printed])
    if not table.rows:
        raise Missing("`accuracy.csv` has no study of the suite `report` beside those that have printed values")
    yield Text("Errors are Euclidean distances to the exact value, in units of u p~ with u = 2^-53 and p~ the sum of the "
               "absolute terms of the curve at t in the form in which it is given.")
    unstable = list(dict.fromkeys(r["method"] for r in bundle.judged().rows if r.file == "unstable.csv"))
    if unstable:
        yield Text(f"Not part of the accuracy digest, because the machine's mathematics library decides their last bits: "
                   f"{listing(f'`{m}`' for m in unstable)}.")
    for study in table.distinct("study"):
        yield from error_tables(study, table.select(study=study))
    yield from figure("truth_against_degree", bundle)
