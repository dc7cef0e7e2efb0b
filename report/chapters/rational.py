# SPDX-License-Identifier: MIT
"""Methods for rational curves, under mild and wild weights."""

from ..bundle import Missing
from ..document import Text
from ..error_tables import error_tables, swept
from ..search_tables import search_tables
from .suite_parts import figure, of_suite, replay

TITLE = "Rational curves"
SUITE = "rational"


def blocks(bundle, findings):
    """Findings, the figure, the tables of each study; the searched maxima where the bundle has them."""
    table = bundle.exact(SUITE)
    yield from of_suite(findings, "rational")
    yield from figure("rational_against_degree", bundle)
    for study in table.distinct("study"):
        rows = table.select(study=study)
        yield from error_tables(study, rows, swept(rows)[0])
    try:
        yield from search_tables(bundle, SUITE)
    except Missing:
        pass  # searches are a study of their own, which a bundle may do without
    yield Text("p~ of a rational curve is the sum of the absolute terms of its numerator over the absolute value of its "
               "denominator. Weights "
               "are positive: a bound holds under the conditions that stand with the method.")
    yield from replay(bundle, SUITE)
