# SPDX-License-Identifier: MIT
"""Small curves far from the origin: differences first, or the triangle first."""

from ..bundle import Missing
from ..document import Finding
from ..wording import general, scientific, shortest

SUITE = "derivative"
STUDY, FIRST, LAST = "derivative-distant", "differences_de_casteljau", "triangle_derivatives"
LOST = 1e3  # in u p~: ten of the twenty bits by which the coordinates exceed the differences


def find(bundle):
    """Holds where differences of the control points keep every digit that differences of the triangle's points lose."""
    table = bundle["derivative.csv"]

    def rows(method):
        return [r for r in table.select(study=STUDY, method=method) if 0 < r["order"] < r["degree"]]
    before, after = rows(FIRST), rows(LAST)
    if not before or not after:
        raise Missing(f"`derivative.csv` has no `{STUDY}` rows of `{FIRST}` and `{LAST}`")
    kept = max(before, key=lambda r: r.number("mean_error_u"))
    lost = min(after, key=lambda r: r.number("mean_error_u"))
    holds = kept["mean_error_u"] < 10 and lost["mean_error_u"] > LOST
    return Finding(
        id="derivative_distant", about="suite", suite=SUITE, claim="", holds=holds,
        headline="Far from the origin derivatives must be taken of the control points, not of the points of de Casteljau's triangle."
        if holds else "Far from the origin it does not matter whether control points or points of the triangle are differenced.",
        detail=(f"With control points in [R (1 - 2^-20), R], their first differences are exact and the mean error of `{FIRST}` is at most "
                f"{general(kept['mean_error_u'])} u p~; `{LAST}` differences rounded points and has at least "
                f"{scientific(lost['mean_error_u'])} u p~ (degree {shortest(lost['degree'])}, order {shortest(lost['order'])}).",),
        rows=(kept, lost))
