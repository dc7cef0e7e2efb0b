# SPDX-License-Identifier: MIT
"""C2 natural splines: how far the conditions are missed, by the number of points."""

from ..document import Cell, Group, Table, Text
from ..findings.splines import GOAL
from ..wording import general, large, shortest
from .suite_parts import of_studies, with_times

TITLE = "Splines through points"
SUITE = KIND = "interpolation"
QUANTITIES = (("C1, largest", "max_c1_u"), ("C2, largest", "max_c2_u"), ("natural ends, largest", "max_natural_u"),
              ("control points, largest error", "max_error_u"))


def study_tables(bundle, study):
    """One table, with the numbers of points across."""
    yield _table(study, bundle["interpolation.csv"].some(study=study))


@with_times("interpolation")
def blocks(bundle, findings):
    """Findings, the figure, then a table for each study with the numbers of points across."""
    table = bundle["interpolation.csv"].of_suite(SUITE)
    yield from of_studies(bundle, findings, SUITE, table.distinct("study"), study_tables, "interpolation_residuals")
    yield Text("All in units of u times the largest coordinate of an axis, the largest over trials, knots and axes, and over the cells of "
               "a study. C1 is the jump of P1 - P0 over P3 - P2 of the segment before, C2 that of the second differences, natural ends "
               f"are the second differences there; points and joints are met bit for bit. The goal is {GOAL}. The truth is the exact "
               "spline in integers; of very many points only the conditions are judged, which are exact, too.")


def _table(study, rows):
    numbers = sorted({r["points"] for r in rows})
    groups = []
    for method in dict.fromkeys(r["method"] for r in rows):
        lines = []
        for label, column in QUANTITIES:
            cells = []
            for points in numbers:
                values = [r[column] for r in rows if r["method"] == method and r["points"] == points and r[column] is not None]
                cells.append(Cell(general(max(values)), repr(max(values))) if values else Cell())
            lines.append((label, cells))
        groups.append(Group(f"`{method}`", method, tuple(lines)))
    trials = sum(r["trials"] for r in rows if r["method"] == rows[0]["method"])
    generators = ", ".join(dict.fromkeys(r["generator"] for r in rows))
    return Table(id=study, caption=f"Residuals of splines by number of points, {generators} ({large(trials)} sets of points per method)",
                 caption_zh="样条的残差", row_head="quantity", axis="points", head=tuple(map(shortest, numbers)), groups=tuple(groups))
