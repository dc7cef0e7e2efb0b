# SPDX-License-Identifier: MIT
"""Piecewise fits: segments for a tolerance, and whether it is kept."""

from ..document import Cell, Group, Table, Text
from ..wording import general, large, scientific, shortest
from .suite_parts import of_studies, with_times

TITLE = "Curves near points"
SUITE = KIND = "fitting"


def study_tables(bundle, study):
    """One table, with the kinds of data across."""
    yield _table(study, bundle["fitting.csv"].some(study=study))


@with_times("fitting", "fitting_time")
def blocks(bundle, findings):
    """Findings, two figures, one table per study with the kinds of data across, and what the words mean."""
    table = bundle["fitting.csv"].of_suite(SUITE)
    yield from of_studies(bundle, findings, SUITE, table.distinct("study"), study_tables, "fitting_example", "fitting_segments")
    yield Text("The tolerance is a distance in coordinate units. The error is the largest distance of a data point from the whole curve, "
               "exact; a promise is broken where it exceeds the tolerance, or where the curve leaves the polyline of the data by more than "
               "the tolerance and the sampling allow. Segments are the mean over trials in the cell that needs "
               "most. Data: `samples` of a Bézier curve at equal steps of t, `uneven` at random ones, `noisy` with noise of 2^-10 R, "
               "along the control `polyline`, of a `closed` curve, and `drawn` as by a bad pen, with repetitions and steps backwards. "
               "Corners of the data are kept, and a tight bend is one to a loose tolerance, so that a curve can have more segments "
               "than it needs.")


def _table(study, rows):
    kinds = list(dict.fromkeys(r["data"] for r in rows))
    tolerances = sorted({r["tolerance"] for r in rows}, reverse=True)
    groups = []
    for method in dict.fromkeys(r["method"] for r in rows):
        mine = [r for r in rows if r["method"] == method]
        lines = [(f"segments at {scientific(e)}", _cells([r for r in mine if r["tolerance"] == e], kinds, "mean_segments", max, general))
                 for e in tolerances]
        lines.append(("largest error / tolerance", _cells(mine, kinds, "max_error_over_tolerance", max, general)))
        lines.append(("steps, most", _cells(mine, kinds, "max_iterations", max, large)))
        lines.append(("promises broken", _cells(mine, kinds, "broken_promises", sum, large)))
        groups.append(Group(f"`{method}`", method, tuple(lines)))
    trials = sum(r["trials"] for r in rows if r["method"] == rows[0]["method"])
    degrees = ", ".join(dict.fromkeys(shortest(r["degree"]) for r in rows))
    points = ", ".join(dict.fromkeys(shortest(r["points"]) for r in rows))
    return Table(id=study, caption=f"Fits to {points} points of curves of degree {degrees} ({large(trials)} fits per method)",
                 caption_zh="分段拟合", row_head="quantity", axis="data", head=tuple(kinds), groups=tuple(groups))


def _cells(rows, kinds, column, over, write):
    cells = []
    for kind in kinds:
        values = [r[column] for r in rows if r["data"] == kind and r[column] is not None]
        cells.append(Cell(write(over(values)), repr(over(values))) if values else Cell())
    return cells
