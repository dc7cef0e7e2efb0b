# SPDX-License-Identifier: MIT
"""Derivatives of any order: by differences, from the triangle, in power form, and as the source document prints them."""

from ..document import Text
from ..error_tables import error_tables, swept_with
from .suite_parts import of_studies, with_times

TITLE = "Derivatives"
SUITE = KIND = "derivative"


def study_tables(bundle, study):
    """Mean and largest error, with orders across unless an interval or the degrees run there."""
    rows = bundle["derivative.csv"].some(study=study)
    yield from error_tables(study, rows, *swept_with("order", rows))


@with_times("derivative")
def blocks(bundle, findings):
    """Findings, the figure, then the tables of each study."""
    table = bundle["derivative.csv"].of_suite(SUITE)
    yield from of_studies(bundle, findings, SUITE, table.distinct("study"), study_tables, "derivative_against_order")
    yield Text("p~ is that of the derivative: its own control points D^k b_i, times n (n-1) ... (n-k+1), in magnitude, weighted "
               "with the Bernstein polynomials of degree n-k (in power form its own coefficients with the powers of t). The bound "
               "has a second part for the differences, which control points far from the origin make large. An order beyond the "
               "degree gives 0. `seed_000` has no bound: it is kept to be compared with.")
