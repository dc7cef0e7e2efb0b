# SPDX-License-Identifier: MIT
"""Foot points: which methods find the nearest point of a curve, and how well."""

from ..document import Cell, Group, Table, Text
from ..findings.curves import GOAL, rows_of
from ..wording import general, large, scientific, shortest
from .suite_parts import COMPANION_PEERS, of_studies, with_times

TITLE = "The nearest point of a curve"
SUITE = KIND = "projection"
QUANTITIES = (("missed", "missed", sum, large), ("largest error, units", "max_error_eps", max, general),
              ("largest error of t", "max_t_error", max, scientific),
              ("gave up", "non_converged", sum, large))


def study_tables(bundle, study):
    """One table, with the placements of the point across."""
    yield _table(study, bundle.judged("projection.csv").some(study=study, status="ok"))


@with_times("projection")
def blocks(bundle, findings):
    """Findings, the figure, one table per study with the placements of the point across, and what the words mean."""
    rows = rows_of(bundle, SUITE, COMPANION_PEERS)
    yield from of_studies(bundle, findings, SUITE, dict.fromkeys(r["study"] for r in rows), study_tables, "projection_missed")
    yield Text("Truth: the real roots of (C - P)·C' in [0, 1], isolated with integers. A foot point is missed where the distance "
               "exceeds the least one by more than 2^-20 times the largest coordinate of control points and point. Errors of the "
               f"distance are in units of 2^-52 times that coordinate; the goal is {GOAL}. The error of t is to the nearest of "
               "equally near foot points; where the distance is flat no method can know t well. Placements of the point: "
               "`uniform` as a control point, `on_curve`, `beside` it by a millionth, `centre` of curvature, in a `cusp`, "
               "on the axis of a `mirrored` curve, and as a control point of a curve that is a `line` at constant speed.")


def _table(study, rows):
    placements = list(dict.fromkeys(r["placement"] for r in rows))
    groups = []
    for method in dict.fromkeys(r["method"] for r in rows):
        lines = []
        for label, column, over, write in QUANTITIES:
            cells = []
            for placement in placements:
                values = [r[column] for r in rows if r["method"] == method and r["placement"] == placement
                          and r[column] is not None]
                cells.append(Cell(write(over(values)), repr(over(values))) if values else Cell())
            lines.append((label, cells))
        groups.append(Group(f"`{method}`", method, tuple(lines)))
    degrees = list(dict.fromkeys(shortest(r["degree"]) for r in rows))
    trials = sum(r["trials"] for r in rows if r["method"] == rows[0]["method"])
    return Table(id=study, caption=f"Foot points, {'degree' if len(degrees) == 1 else 'degrees'} {', '.join(degrees)} ({large(trials)} trials per method, by placement of the point)",
                 caption_zh="最近点", row_head="quantity", axis="placement", head=tuple(placements), groups=tuple(groups))
