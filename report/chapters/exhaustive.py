# SPDX-License-Identifier: MIT
"""Every float: the largest error of each method on named curves, and how often its last bits break what a user relies on."""

from ..document import Cell, Group, Table, Text
from ..wording import general, large

COUNTS = ("misrounded", "non_monotone", "out_of_hull")


def _count(row, column):
    """A count; where the curve has nothing that could be counted, empty."""
    count = row[column]
    return Cell() if count is None else Cell(large(count), row.text(column))


def _cells(row):
    largest = row["max_error_ulp"]
    error = Cell("not finite", "", "outside") if largest is None else Cell(general(largest, 6), row.text("max_error_ulp"))
    return [error, Cell(f"{float.fromhex(row.text('worst_t')):.9g}", row.text("worst_t")),
            *(_count(row, column) for column in COUNTS)]


def _table(study, number, first, last, rows):
    """One interval of a study: curves, each with its methods."""
    curves = {}
    for row in rows:
        curves.setdefault(row["curve_id"], []).append(row)
    groups = tuple(Group(f"`{curve}`, degree {own[0]['degree']:g}", curve, tuple((f"`{r['method']}`", _cells(r)) for r in own))
                   for curve, own in curves.items())
    shown = f"[{float(first):.9g}, {float(last):.9g}]"
    return Table(id=f"{study}-{number}", caption=f"The largest error at the {large(rows[0]['points'])} floats t of {shown}, and how "
                 "many points are misrounded, steps not monotone, points outside the hull",
                 caption_zh=f"区间 {shown} 内全部单精度参数处的最大误差（ulp）及舍入错误、非单调、越界的次数", groups=groups,
                 head=("largest error, ulp", "at t", *(column.replace("_", " ") for column in COUNTS)), group_head="curve",
                 row_head="method")


def study_tables(bundle, study):
    """A table of each interval; what its numbers are."""
    intervals = {}
    for row in bundle["exhaustive.csv"].some(study=study):
        intervals.setdefault((row.text("t_min"), row.text("t_max")), []).append(row)
    for number, ((first, last), rows) in enumerate(intervals.items(), 1):
        yield _table(study, number, first, last, rows)
    yield Text("Every float t of the interval was evaluated in float, so that these are facts about all inputs, not estimates. An error "
               "is that of a coordinate, in the spacing of floats at its true value. A point is misrounded where a coordinate is not the "
               "float nearest to the true value; a step from a t to the next is not monotone where a coordinate goes against its "
               "control coordinates, where these never decrease or never increase.")
