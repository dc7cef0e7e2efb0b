# SPDX-License-Identifier: MIT
"""Relative error against the condition number, near multiple and clustered roots."""

from ..bundle import Missing
from ..document import Cell, Group, Table, Text
from ..methods import form
from ..wording import factor, scientific, shortest
from .suite_parts import figure, of_suite, replay

TITLE = "Near multiple roots: relative error against the condition number"
SUITE = "conditioning"
CSV = ("method", "t_min", "t_max", "p50_condition", "max_condition", "p50_relative", "max_relative")


def blocks(bundle, findings):
    """Findings, the figure, then a table for each study: the condition number rises from column to column."""
    table = bundle.exact(SUITE)
    if "p50_condition" not in table.columns:
        raise Missing("`accuracy.csv` has no column `p50_condition`")
    yield from of_suite(findings, "conditioning")
    yield from figure("error_against_condition", bundle)
    for study in table.distinct("study"):
        for degree in table.distinct("degree", study=study):
            yield _study(study, degree, table.select(study=study, degree=degree))
    yield Text("The coefficients are exact, so the error is that of the evaluation alone, and the condition number is that "
               "of the form in "
               "which the curve is given, converted paths included. Medians are of relative error and condition number each "
               "by itself. A "
               "relative error of exactly 1 is a computed 0.")
    yield from replay(bundle, SUITE)


def _study(study, degree, rows):
    """Columns by rising condition number; the first lines are those of the curves, the others those of the methods."""
    cells = sorted({(r["t_min"], r["t_max"]): r for r in rows}.values(), key=lambda r: r["p50_condition"] or 0)
    places = [(r["t_min"], r["t_max"]) for r in cells]

    def line(label, column, own):
        at = {(r["t_min"], r["t_max"]): r for r in own}
        return label, [Cell(scientific(at[p][column]), at[p].text(column)) if p in at else Cell() for p in places]
    groups = [Group("condition number", "condition", (line("median", "p50_condition", cells), line("largest", "max_condition", cells)))]
    for method in dict.fromkeys(r["method"] for r in rows):
        own = [r for r in rows if r["method"] == method]
        groups.append(Group(f"`{method}`", method, (line("median", "p50_relative", own), line("largest", "max_relative", own))))
    english, chinese = form(rows[0]["form"])
    return Table(id=f"{study}-{shortest(degree)}", caption=f"Condition number and relative error, degree {shortest(degree)}, "
                                                           f"{english} "
                 f"({rows[0]['generator']} inputs)", caption_zh=f"条件数与相对误差，{shortest(degree)} 阶，{chinese}", groups=tuple(groups),
                 axis="median condition number; the intervals of t stand in the CSV", row_head="over the trials",
                 head=tuple(factor(r.number("p50_condition")) for r in cells), csv_head=CSV,
                 csv_rows=tuple(tuple(r.text(c) for c in CSV) for r in rows))
