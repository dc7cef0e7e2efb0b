# SPDX-License-Identifier: MIT
"""Points on uniform grids: forward differencing, whose error grows with the number of points, against one point at a time."""

from ..document import Text
from ..error_tables import error_tables, swept_with
from .suite_parts import of_studies, with_times

TITLE = "Points on a grid"
SUITE = KIND = "grid"


def study_tables(bundle, study):
    """Mean and largest error, with numbers of points across where there are more of them than degrees."""
    rows = bundle["grid.csv"].some(study=study)
    yield from error_tables(study, rows, *swept_with("points", rows))


@with_times("grid")
def blocks(bundle, findings):
    """Findings, the figure, then the tables of each study."""
    table = bundle["grid.csv"].of_suite(SUITE)
    yield from of_studies(bundle, findings, SUITE, table.distinct("study"), study_tables, "grid_against_points")
    yield Text("A grid has the parameters k/m for k = 0, 1, ..., m, where m is a power of two, and its errors are those of all its "
               "points. Forward differencing makes each point from the one before by n additions on each axis, so every step adds "
               "its roundings, and the bound grows with k; `pointwise_...` is an evaluator at one point after the other.")
