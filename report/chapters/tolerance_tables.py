# SPDX-License-Identifier: MIT
"""Tables of methods that are asked for a tolerance: one for each kind of curves, tolerances side by side."""

from ..document import Cell
from ..tables import by_axis
from ..wording import shortest

CELL = ("degree", "coordinate_range", "generator")  # what sets a table of a study apart


def tolerance_tables(study, rows, caption, caption_zh, lines):
    """Of the rows of a study. `lines` are (label, column, function of a value to its text); broken promises are marked."""
    cells = {}
    for row in rows:
        cells.setdefault(tuple(row[c] for c in CELL), []).append(row)
    for number, (cell, members) in enumerate(cells.items(), 1):
        degree, size, generator = cell
        where = f"degree {shortest(degree)}, R = {shortest(size)}, {generator} inputs, {shortest(members[0]['trials'])} curves"
        yield by_axis(members, "tolerance", f"{study}-{number}", f"{caption} ({where})", caption_zh,
                      [_line(*line) for line in lines], row_head="quantity")


def _line(label, column, write):
    def cell(row):
        mark = "outside" if column == "broken_promises" and row[column] else ""
        return Cell(write(row[column]), row.text(column), mark)
    return (label, cell, lambda r: True)
