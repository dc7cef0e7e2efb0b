# SPDX-License-Identifier: MIT
"""The source report's tables in its own layout, and the tables of the other chapters.

Rows are methods and statistics, columns are what the source varies: degree, range, interval or threshold.
"""

from .document import Cell, Group, Table
from .methods import CHINESE, STATISTIC, form, name
from .wording import as_printed, general, interval, scientific, shortest

# number in the source: (column of the bundle that varies, English caption, Chinese caption)
LAYOUT = {
    "2.2": ("statistic", "Round trip Bernstein form, power form, Bernstein form, power form: curves within a distance",
            "两种形式往返转换：偏差不超过给定距离的曲线条数"),
    "2.3.1": ("degree", "Error against degree", "误差与阶数"),
    "2.3.2": ("coordinate_range", "Error against coordinate range", "误差与坐标范围"),
    "2.3.3": ("interval", "Error against parameter interval", "误差与参数区间"),
    "2.4": ("degree", "Time in ms per 1000 curves (µs per curve)", "求值用时（毫秒 / 千条曲线）"),
}
AXIS = {"degree": "degree n", "order": "order k", "tolerance": "tolerance", "points": "points", "coordinate_range": "R of the range [-R, R]", "interval": "interval of t",
        "statistic": "distance at most"}
MARK = {"inside": "✓ inside", "edge": "± edge", "outside": "✗ outside", "explained": "≈ explained", "untestable": "– untestable"}


def axis_value(row, axis):
    return (row["t_min"], row["t_max"]) if axis == "interval" else row[axis]


def axis_label(value, axis):
    if axis == "interval":
        return interval(*value)
    if axis == "statistic":
        return value.removeprefix("count_within_")
    return shortest(value)


def scorecard_tables(bundle, file):
    """One Table per printed table and form of curve, in the order of the file."""
    scorecard = bundle[file]
    tables = []
    for number in scorecard.distinct("table"):
        for curve in scorecard.distinct("form", table=number):
            tables.append(_scorecard_table(number, curve, scorecard.select(table=number, form=curve)))
    return tables


def _scorecard_table(number, curve, rows):
    axis, english, chinese = LAYOUT.get(number, ("degree", "Printed cells", "原表"))
    values = list(dict.fromkeys(axis_value(r, axis) for r in rows))
    keys = list(dict.fromkeys((r["method"], None if axis == "statistic" else r["statistic"]) for r in rows))
    groups, csv_rows = [], []
    for method, statistic in keys:
        cells = {axis_value(r, axis): r for r in rows
                 if r["method"] == method and (statistic is None or r["statistic"] == statistic)}
        in_order = [cells.get(v) for v in values]
        write = general if statistic in (None, "total_time") else scientific
        en, zh = STATISTIC.get(statistic, ("count", "条数"))
        label = f"{name(method)}, {en} ({CHINESE.get(method, method)}，{zh})"
        groups.append(Group(label, f"{method} {statistic or 'count'}", tuple(_quantities(in_order, write))))
        for quantity in ("published", "ours_median", "ours_p05", "ours_p95", "continuous_median", "against_exact",
                         "prepared_median", "verdict"):
            texts = [r.text(quantity) if r else "" for r in in_order]
            if any(texts):
                csv_rows.append((method, statistic or "count", quantity, *texts))
    head = tuple(axis_label(v, axis) for v in values)
    form_en, form_zh = form(curve)
    return Table(id=f"table-{number}-{curve}", caption=f"Table {number}. {english}, {form_en}",
                 caption_zh=f"表 {number}　{chinese}（{form_zh}）", head=head, groups=tuple(groups), axis=AXIS[axis],
                 row_head="quantity", csv_head=("method", "statistic", "quantity", *head), csv_rows=tuple(csv_rows))


def _quantities(rows, write):
    """The lines under one printed row: what was printed, what we get, what the truth is, and the verdict."""
    def numbers(column, show=write):
        return [Cell(show(r[column]), r.text(column), r["verdict"] or "") if r else Cell() for r in rows]

    def band(r):
        if r is None or r["ours_p05"] is None or r["ours_p95"] is None:
            return Cell()
        return Cell(f"{write(r['ours_p05'])} – {write(r['ours_p95'])}", f"{r.text('ours_p05')} {r.text('ours_p95')}")

    lines = [("published", numbers("published", as_printed if write is scientific else shortest)),
             ("ours, median", [Cell(c.text, c.raw) for c in numbers("ours_median")]),
             ("ours, 5–95 %", [band(r) for r in rows]),
             ("continuous inputs", [Cell(c.text, c.raw) for c in numbers("continuous_median")]),
             ("against exact", [Cell(c.text, c.raw) for c in numbers("against_exact")]),
             ("prepared once", [Cell(c.text, c.raw) for c in numbers("prepared_median")]),
             ("verdict", [Cell(MARK.get(r["verdict"], r["verdict"] or ""), r.text("verdict"), r["verdict"] or "")
                          if r else Cell() for r in rows])]
    return [(label, cells) for label, cells in lines if any(c.text for c in cells)]


def by_axis(rows, axis, table_id, caption, caption_zh, lines, **more):
    """Methods against one axis. `lines` are (label, function of a row to a Cell, optional predicate on rows)."""
    values = sorted({axis_value(r, axis) for r in rows})
    groups = []
    for method in dict.fromkeys(r["method"] for r in rows):
        drawn = []
        for label, cell, belongs in lines:
            found = {axis_value(r, axis): r for r in rows if r["method"] == method and belongs(r)}
            cells = [cell(found[v]) if v in found else Cell() for v in values]
            if any(c.text for c in cells):
                drawn.append((label, cells))
        if drawn:
            groups.append(Group(f"`{method}`", method, tuple(drawn)))
    return Table(id=table_id, caption=caption, caption_zh=caption_zh, groups=tuple(groups), axis=AXIS[axis],
                 head=tuple(axis_label(v, axis) for v in values), **more)


def flat(table_id, caption, caption_zh, rows, columns, **more):
    """Rows of a file as they are. `columns` are (heading, column, function of a value to its text)."""
    first, *rest = columns
    groups = [Group(first[2](r[first[1]]), r.text(first[1]),
                    (("", [Cell(write(r[c]), r.text(c)) for _, c, write in rest]),)) for r in rows]
    return Table(id=table_id, caption=caption, caption_zh=caption_zh, groups=tuple(groups), group_head=first[0],
                 head=tuple(h for h, _, _ in rest), **more)
