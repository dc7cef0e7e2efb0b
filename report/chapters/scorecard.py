# SPDX-License-Identifier: MIT
"""Verdicts counted by table, and every cell that is not inside."""

from collections import Counter

from ..bundle import Missing
from ..document import Cell, Group, Table, Text
from ..methods import STATISTIC, form, name
from ..tables import MARK, axis_label
from ..wording import as_printed, general, interval, scientific, shortest

TITLE = "Scorecard"
SUITE = "report"
VERDICTS = ("inside", "edge", "explained", "untestable", "outside")
FILES = ("scorecard.csv", "scorecard_timing.csv")


def counts(bundle):
    """{table: Counter of verdicts} over both scorecards, in the order of the files."""
    tables = {}  # by number
    for file in FILES:
        for row in bundle.tables[file].rows if file in bundle else ():
            tables.setdefault(row["table"], Counter())[row["verdict"] or "none"] += 1
    if not tables:
        raise Missing("the bundle has no `scorecard.csv`")
    return dict(sorted(tables.items()))


def blocks(bundle, _findings):
    """The count, and what lies outside or needs a reason."""
    tables = counts(bundle)
    yield Text("The band is what the middle 90 % of independent repetitions of the report's experiment give, with its generator "
               "and its yardstick. Its ends are known from our repetitions, with an error of their own (99 % limits), and the printed value is "
               "rounded. **inside**: the printed value lies in the band, whatever these errors. **outside**: it lies beyond. **edge**: the "
               "errors decide. **explained**: it is outside for a stated cause. **untestable**: the printed time is no more than one tick of its "
               "clock, which almost any time rounds to. Times are another machine's and need not match.")
    groups = []
    for number, verdicts in tables.items():
        total = sum(verdicts.values())
        cells = [Cell(str(verdicts[v]), str(verdicts[v]), v if verdicts[v] else "") for v in VERDICTS]
        groups.append(Group(f"Table {number}", number, (("", [*cells, Cell(str(total), str(total))]),)))
    yield Table(id="scorecard-counts", caption="Printed cells by table and verdict", caption_zh="各表的判定", group_head="table",
                head=(*(MARK[v] for v in VERDICTS), "cells"), groups=tuple(groups))
    if "scorecard.csv" in bundle:
        yield Text("The last range of table 2.3.2 repeats the last degree of table 2.3.1, and two methods can agree to the printed digits, so a "
                   "value can stand several times below.")
        yield _not_inside(bundle["scorecard.csv"].select(verdict=("edge", "outside", "explained")))


def _place(row):
    if row["statistic"].startswith("count_within_"):
        return f"within {axis_label(row['statistic'], 'statistic')}"
    if row["table"] == "2.3.3":
        return f"t in {interval(row['t_min'], row['t_max'])}"
    if row["table"] == "2.3.2":
        return f"R = {shortest(row['coordinate_range'])}"
    return f"n = {row.text('degree')}"


def _not_inside(rows):
    groups = []
    for row in rows:
        write = scientific if row["statistic"] in STATISTIC else general
        band = f"{write(row['ours_p05'])} – {write(row['ours_p95'])}"
        what = f"{form(row['form'])[0]}, {name(row['method'])}, {STATISTIC.get(row['statistic'], ('count',))[0]}, {_place(row)}"
        texts = [(what, what), ((as_printed if write is scientific else shortest)(row["published"]), row.text("published")),
                 (write(row["ours_median"]), row.text("ours_median")),
                 (band, f"{row.text('ours_p05')} {row.text('ours_p95')}"),
                 (MARK[row["verdict"]], row["verdict"]), (row["note"] or "", row["note"] or "")]
        cells = [Cell(text, raw, row["verdict"] if i == 4 else "") for i, (text, raw) in enumerate(texts)]
        groups.append(Group(row["table"], row["table"], (("", cells),)))
    return Table(id="not-inside", caption="Errors and counts that are not inside the band", caption_zh="不在区间之内的单元格",
                 group_head="table", head=("cell", "published", "ours, median", "ours, 5–95 %", "verdict", "note"),
                 groups=tuple(groups))
