# SPDX-License-Identifier: MIT
"""Tables of rows: methods down and one axis across, or the rows one by one."""

from dataclasses import replace

from .document import Cell, Group, Table
from .rows import fits, grouped
from .wording import general, interval, shortest

AXIS = {"degree": "degree n", "order": "order k", "coordinate_range": "R of the range [-R, R]", "interval": "interval of t", "curves": "set of curves"}


def axis_label(value, axis):
    return interval(*value) if axis == "interval" else shortest(value) if isinstance(value, float) else value


def one(column, write=general, mark=""):
    """A function of rows to the Cell of the last of them: its number, or its status where it has no result; `mark` where it is not 0."""
    def cell(rows):
        row = rows[-1]
        if row["status"] not in (None, "ok"):
            return Cell(row["status"], row["status"])
        return Cell(write(row[column]), row.text(column), mark if row[column] else "")
    return cell


def over(column, combine, write=general, mark=""):
    """A function of rows to the Cell of their combined values (`max`, `sum`), empty where none has one."""
    def cell(rows):
        values = [row[column] for row in rows if row[column] is not None]
        return Cell(write(combine(values)), repr(combine(values)).removesuffix(".0"), mark if combine(values) else "") if values else Cell()
    return cell


def by_axis(rows, axis, table_id, caption, lines, method="method", values=None, **more):
    """Methods down, the values of an axis across. `lines` are (label, function of the rows of a cell to a Cell, {column: value} that these
    rows have)."""
    values = values or sorted({row[axis] for row in rows})
    groups = []
    for name, own in grouped(rows, method).items():
        drawn = []
        for label, cell, key in lines:
            at = grouped([row for row in own if fits(row, key)], axis)
            cells = [cell(at[value]) if value in at else Cell() for value in values]
            if any(c.text for c in cells):
                drawn.append((label, cells))
        if drawn:
            groups.append(Group(f"`{name}`", name, tuple(drawn)))
    labels = {label for group in groups for label, _ in group.rows}
    every = labels.pop() if len(labels) == 1 and all(len(group.rows) == 1 for group in groups) else ""
    if every:
        groups = [Group(group.label, group.key, (("", cells),)) for group in groups for _, cells in group.rows]
    return Table(id=table_id, caption=caption, groups=tuple(groups), axis=AXIS.get(axis, axis), every=every,
                 head=tuple(axis_label(value, axis) for value in values), group_head=method, **more)


def listed(table_id, caption, head, rows, caption_zh="", whole=True):
    """One line for each row, of texts or Cells; the first is its label. Where it is not `whole`, what is the same in all of several rows stands
    above them."""
    def bare(text):
        return text.strip("`") if text.count("`") == 2 else text
    groups = [Group(label, bare(label), (("", [c if isinstance(c, Cell) else Cell(c, bare(c)) for c in cells]),)) for label, *cells in rows]
    columns = list(zip(*(group.rows[0][1] for group in groups)))
    same = [not whole and len(column) > 1 and len({cell.text for cell in column}) == 1 for column in columns]
    table = Table(id=table_id, caption=caption, caption_zh=caption_zh, groups=tuple(groups), group_head=head[0], head=tuple(head[1:]))
    if not any(same):
        return table
    csv_head, csv_rows = table.csv()
    return replace(table, csv_head=tuple(csv_head), csv_rows=tuple(csv_rows), head=tuple(h for h, one in zip(table.head, same) if not one),
                   every=", ".join(f"{h} {column[0].text}" for h, column, one in zip(table.head, columns, same) if one and column[0].text),
                   groups=tuple(Group(g.label, g.key, (("", [c for c, one in zip(g.rows[0][1], same) if not one]),)) for g in groups))
