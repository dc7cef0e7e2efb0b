# SPDX-License-Identifier: MIT
"""Whether splines are as smooth as rounding allows."""

from ..bundle import Missing
from ..document import Finding
from ..wording import general, large, shortest

SUITE = "interpolation"
METHOD, PLAIN = "c2_natural", "c2_natural_handles"
GOAL = 8  # units of u times the largest coordinate
RESIDUALS = ("max_data_u", "max_c0_u", "max_c1_u", "max_c2_u", "max_natural_u")


def largest_residual(row):
    """The largest residual of a row: of interpolation, C0, C1, C2 and natural ends."""
    return max(row.number(c) for c in RESIDUALS)


def find(bundle):
    """Holds where the refined spline keeps the goal in every cell and breaks no bound."""
    table = bundle["interpolation.csv"].of_suite(SUITE)
    ours, plain = table.select(method=METHOD), table.select(method=PLAIN)
    if not ours or not plain:
        raise Missing(f"a study of the suite `{SUITE}` needs `{METHOD}` and `{PLAIN}`")
    worst, other = max(ours, key=largest_residual), max(plain, key=largest_residual)
    holds = largest_residual(worst) <= GOAL and not any(r["bound_violations"] for r in ours)
    sets = large(sum(r.number("trials") for r in ours))
    unit = "u times the largest coordinate"
    errors = [r["max_error_u"] for r in ours if r["max_error_u"] is not None]
    return Finding(
        id="interpolation_residuals", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"C2 natural splines through {sets} sets of points miss no condition by more than {general(largest_residual(worst))} "
                 f"units of {unit}; the goal is {GOAL}." if holds else
        f"A C2 natural spline misses a condition by {general(largest_residual(worst))} units of {unit}, the goal is {GOAL}, or breaks "
        "its bound.",
        detail=(f"Slopes are refined once and added to the points before they are rounded, so that every control point is the exact "
                f"one rounded (largest error {general(max(errors, default=0))} units). By elimination for the handles alone, "
                f"`{PLAIN}`, {general(largest_residual(other))} units are missed ({shortest(other['points'])} points, "
                f"`{other['generator']}`).",),
        rows=(worst, other))
