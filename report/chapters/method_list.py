# SPDX-License-Identifier: MIT
"""The methods as the program lists them; README.md's table is made of the same columns by scripts/readme.py."""

from ..bundle import Missing
from ..document import Cell, Group, Table, Text
from ..wording import count

TITLE = "The methods"
# heading and what stands under it, from a row of methods.csv
COLUMNS = (
    ("id", lambda row: f"`{row.text('id')}`"),
    ("takes", lambda row: row.text("form")),
    ("degrees", lambda row: f"{row.text('min_degree')}–{row.text('max_degree')}"),
    ("flops per point", lambda row: row.text("flops")),
    ("error bound", lambda row: row.text("bound") or "none"),
    ("source", lambda row: row.text("citation")),
)


def listed(bundle):
    """The rows of the methods that are no composition, in the program's order."""
    rows = [row for row in bundle["methods.csv"].rows if ":" not in row["id"]]
    if not rows:
        raise Missing("`methods.csv` has no rows")
    return rows


def blocks(bundle, _findings):
    """One row per method and form that it takes; converted paths are counted."""
    rows = listed(bundle)
    paths = len(bundle["methods.csv"].rows) - len(rows)
    yield Text(f"What `bezierbench list methods` says: {count(len(rows), 'entry', 'entries')}, one per method and form of "
               "curve that "
               f"it takes. The {count(paths, 'path')} `conversion:evaluator` are compositions of these.")
    lines = [[write(row) for _, write in COLUMNS] for row in rows]
    groups = tuple(Group(line[0], row["id"], (("", [Cell(text, text) for text in line[1:]]),)) for row, line in zip(rows, lines))
    yield Table(id="methods", caption="Methods, with the form that they take, cost, proved bound and source", caption_zh="方法一览",
                group_head=COLUMNS[0][0], head=tuple(heading for heading, _ in COLUMNS[1:]), groups=groups)
