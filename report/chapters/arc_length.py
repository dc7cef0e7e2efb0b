# SPDX-License-Identifier: MIT
"""Arc lengths: what is promised, what is kept, and for how many evaluations."""

from ..document import Cell, Text
from ..tables import by_axis
from ..wording import general, scientific, shortest
from .suite_parts import figure, of_suite

TITLE = "Arc lengths"
PREFIX = "arc_length-"
LINES = (("mean relative error", "mean_relative", scientific), ("largest relative error", "max_relative", scientific),
         ("evaluations, mean", "mean_evaluations", general), ("not converged", "non_converged", general),
         ("promises broken", "broken_promises", general))
CELL = ("degree", "coordinate_range", "generator")  # what sets a table of a study apart


def blocks(bundle, findings):
    """Findings, the figure, then a table for each kind of curves."""
    table = bundle["arc_length.csv"].starting(PREFIX)
    yield from of_suite(findings, "arc_length")
    yield from figure("arc_length_evaluations", bundle)
    for study in table.distinct("study"):
        cells = {}
        for row in table.select(study=study):
            cells.setdefault(tuple(row[c] for c in CELL), []).append(row)
        for number, (cell, rows) in enumerate(cells.items(), 1):
            degree, size, generator = cell
            where = f"degree {shortest(degree)}, R = {shortest(size)}, {generator} inputs, {shortest(rows[0]['trials'])} curves"
            yield by_axis(rows, "tolerance", f"{study}-{number}", f"Arc lengths against tolerance ({where})", "弧长误差与容差",
                          [_line(*line) for line in LINES], row_head="quantity")
    yield Text("The tolerance is relative to the length. A method that cannot keep it says that it did not converge; a promise "
               "is broken where it said that it did and the error is larger. `gauss_legendre_24` knows no error of its own and "
               "never promises. Evaluations are those of the speed, of chord sums those of the curve. The truth is integrated "
               "in 70 digits.")


def _line(label, column, write):
    def cell(row):
        mark = "outside" if column == "broken_promises" and row[column] else ""
        return Cell(write(row[column]), row.text(column), mark)
    return (label, cell, lambda r: True)
