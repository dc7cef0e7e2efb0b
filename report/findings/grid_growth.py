# SPDX-License-Identifier: MIT
"""Which method on a grid loses against the best one as the grid has more points."""

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, large, shortest
from .series import names

SUITE = "grid"


def find(bundle):
    """Holds where, at every degree, the least accurate method on the largest grid has a larger mean error over that of the best method
    there than on the smallest grid."""
    table = bundle["grid.csv"].of_suite(SUITE)
    study = next((s for s in table.distinct("study") if len(table.distinct("points", study=s)) > 1), None)
    if study is None:
        raise Missing("`grid.csv` has no study of the suite `grid` that varies the number of points")
    points = sorted(table.distinct("points", study=study))
    ends = _ends(table, study, points)
    if not ends:
        raise Missing("`grid.csv` has no two methods with errors on the same grids")
    losers = names(dict.fromkeys(worst for worst, _, _ in ends.values()))
    holds = all(few < many for _, few, many in ends.values())
    rows = tuple(table.select(study=study, degree=n, points=points[-1], method=ends[n][0])[0] for n in ends)
    return Finding(
        id="grid_growth", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"The more points a grid has, the more digits {losers} loses against the best method." if holds else
        f"{losers} does not lose more digits against the best method where a grid has more points.",
        detail=("Mean error over u p~, over that of the best method on the same grid: "
                + "; ".join(f"{factor(few)} times at degree {shortest(n)} with {large(points[0])} points and {factor(many)} times with "
                            f"{large(points[-1])}" for n, (_, few, many) in ends.items()) + f" (study `{study}`).",),
        rows=rows)


def _ends(table, study, points):
    """{degree: (the least accurate method on the largest grid, its ratio on the smallest grid, on the largest)}"""
    ends = {}
    for n in table.distinct("degree", study=study):
        smallest, largest = ({r["method"]: r for r in table.select(study=study, degree=n, points=p) if r["mean_error_u"]}
                             for p in (points[0], points[-1]))
        if len(largest) < 2:
            continue
        worst = max(largest.values(), key=lambda r: r["mean_error_u"])["method"]
        if worst in smallest:
            ends[n] = worst, _over_best(smallest, worst), _over_best(largest, worst)
    return ends


def _over_best(grid, method):
    return grid[method]["mean_error_u"] / min(r["mean_error_u"] for r in grid.values())
