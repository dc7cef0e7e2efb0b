# SPDX-License-Identifier: MIT
"""The source report: verdicts of its printed cells, its tables in its own layout and as curves, its methods against the truth."""

from collections import Counter

from ..bundle import Missing
from ..document import Cell, Definitions, Group, Table, Text
from ..error_tables import error_tables
from ..findings.printed_tables import worked
from ..findings.printed_times import CLOSE, TICK, VERDICTS, ratios, words
from ..methods import CHINESE, FORM, STATISTIC, form, name
from ..rows import distinct, grouped
from ..tables import AXIS, axis_label, listed
from ..wording import as_printed, general, interval, listing, scientific, shortest
from .parts import chapter, study_figure

MARK = {"inside": "✓ inside", "edge": "± edge", "explained": "≈ explained", "untestable": "– untestable", "outside": "✗ outside"}
FILES = ("scorecard.csv", "scorecard_timing.csv")
DISTANCE = "count_within_"


def counts(bundle):
    """{table: Counter of verdicts}, of errors and counts by cell and of times by the ratio of two."""
    tables = {}
    for row in bundle.tables["scorecard.csv"].rows if "scorecard.csv" in bundle else ():
        tables.setdefault(row["table"], Counter())[row["verdict"]] += 1
    if "scorecard_timing.csv" in bundle and "timing.csv" in bundle:
        tables["2.4"] = Counter(VERDICTS[ratio.verdict][1] for ratio in ratios(bundle))
    if not tables:
        raise Missing("the bundle has no `scorecard.csv`")
    return dict(sorted(tables.items()))


@chapter("Scorecard", suite="report")
def scorecard(bundle, _findings):
    """Verdicts counted by table, and every cell that is not inside."""
    yield Text("The band is the middle 90 % of independent repetitions of the report's experiment, with its generator and its yardstick. The "
               "ends of the band come from our repetitions and have an error of their own (99 % limits), and the printed value is rounded. "
               "**inside**: the printed value lies in the band, whatever these errors. **outside**: it lies beyond. **edge**: the errors decide. "
               "**explained**: it is outside for a stated cause. The times of table 2.4 are of another machine; what is compared is the ratio of two "
               "of them: **inside** where it agrees with ours within the steps of the clock, **explained** where the order is kept or both are within a "
               f"factor of {CLOSE}, **outside** where they are further apart and the order is open, or where the order is reversed, **untestable** where "
               "the clock shows neither.")
    rows = []
    for number, verdicts in counts(bundle).items():
        rows.append((f"Table {number}", *(Cell(str(verdicts[v]), str(verdicts[v]), v if verdicts[v] else "") for v in MARK), str(sum(verdicts.values()))))
    yield listed("scorecard-counts", "Printed cells, and ratios of printed times, by table and verdict", ("table", *MARK.values(), "cells"), rows, "各表的判定")
    if "scorecard.csv" in bundle:
        yield Text("The last range of table 2.3.2 repeats the last degree of table 2.3.1, and two methods can agree to the printed digits, so a "
                   "value can occur several times below.")
        yield listed("not-inside", "Errors and counts that are not inside the band",
                     ("table", "cell", "published", "ours, median", "ours, 5–95 %", "verdict", "note"),
                     map(_not_inside, bundle["scorecard.csv"].select(verdict=("edge", "outside", "explained"))), "不在区间之内的单元格")


def _place(row):
    if row["statistic"].startswith(DISTANCE):
        return f"within {row['statistic'].removeprefix(DISTANCE)}"
    if row["table"] == "2.3.3":
        return f"t in {interval(*row['interval'])}"
    return f"R = {shortest(row['coordinate_range'])}" if row["table"] == "2.3.2" else f"n = {row.text('degree')}"


def _not_inside(row):
    write = scientific if row["statistic"] in STATISTIC else general
    return (row["table"], f"{form(row['form'])[0]}, {name(row['method'])}, {STATISTIC.get(row['statistic'], ('count',))[0]}, {_place(row)}",
            Cell((as_printed if write is scientific else shortest)(row["published"]), row.text("published")),
            Cell(write(row["ours_median"]), row.text("ours_median")), _band(row, write), Cell(MARK[row["verdict"]], row["verdict"], row["verdict"]),
            row["note"] or "")


def _band(row, write):
    if row["ours_p05"] is None or row["ours_p95"] is None:
        return Cell()
    return Cell(f"{write(row['ours_p05'])} – {write(row['ours_p95'])}", f"{row.text('ours_p05')} {row.text('ours_p95')}")


# number in the source: (column of the bundle that varies, English caption, Chinese caption)
LAYOUT = {
    "2.2": ("statistic", "Round trip Bernstein form, power form, Bernstein form, power form: curves within a distance",
            "两种形式往返转换：偏差不超过给定距离的曲线条数"),
    "2.3.1": ("degree", "Error against degree", "误差与阶数"),
    "2.3.2": ("coordinate_range", "Error against coordinate range", "误差与坐标范围"),
    "2.3.3": ("interval", "Error against parameter interval", "误差与参数区间"),
    "2.4": ("degree", "Time in ms per 1000 curves (µs per curve)", "求值用时（毫秒 / 千条曲线）"),
}


@chapter("The report's tables, with ours and the truth beside them", suite="report")
def tables(bundle, _findings):
    """One table per printed table and form of curve."""
    rows = [row for file in FILES if file in bundle for row in bundle[file].rows]
    if not rows:
        raise Missing("the bundle has no `scorecard.csv`")
    yield Definitions((
        ("published", "as the source report prints it, coloured by its verdict"),
        ("ours, median; 5–95 %", "the report's statistic over independent repetitions of its experiment, with its generator and its yardstick"),
        ("continuous inputs", "the median of the same with inputs that use every bit, not the report's grid"),
        ("against exact", "the median of the same statistic, measured against the exact value"),
        ("prepared once", "time per point where conversion and preparation are done once per curve"),
    ))
    for (number, curve), own in sorted(grouped(rows, "table", "form").items(), key=lambda item: item[0][0]):
        yield _printed_table(number, curve, own)
    yield _worked()
    if "scorecard_timing.csv" in bundle and "timing.csv" in bundle:
        yield from _ratios(bundle)


def _worked():
    """Section 2.2: control points and coefficients axis by axis, with those that are exact."""
    def text(numbers):
        return " ".join(map(str, numbers))
    return listed("worked-conversions", "Section 2.2. Worked conversions, axis by axis", ("example", "axis", "control points", "printed coefficients",
                  "exact coefficients", "printed “correct?”", "verdict"),
                  [(f"{row['example']}, degree {row['degree']}", row["axis"], row["control_points"], text(printed), text(exact), row["correct"],
                    Cell("✓ exact", "exact", "inside") if printed == exact else Cell("✗ wrong", "wrong", "outside")) for row, _, printed, exact in worked()], "五组转换算例")


def _ratios(bundle):
    """Table 2.4 as ratios: for each two methods, degrees across."""
    for curve, found in grouped(ratios(bundle), "form").items():
        degrees = sorted({ratio["degree"] for ratio in found})

        def line(own, cell):
            at = {ratio["degree"]: ratio for ratio in own}
            return [cell(at[n]) if n in at else Cell() for n in degrees]
        groups = [Group(label, label, (
            ("published", line(own, lambda one: Cell(words(*one.printed), " ".join(map(repr, one.printed))))),
            ("ours", line(own, lambda one: Cell(f"{general(one.ours[1])} [{general(one.ours[0])} – {general(one.ours[2])}]", repr(one.ours[1])))),
            ("verdict", line(own, _judged)))) for label, own in grouped(found, "label").items()]
        yield Table(id=f"ratios-2.4-{curve}", caption=f"Table 2.4 as ratios of times, {FORM[curve][0]}: what a clock of {TICK} ms may have shown, and ours with its interval",
                    caption_zh=f"表 2.4　用时之比（{FORM[curve][1]}）", head=tuple(map(shortest, degrees)), groups=tuple(groups), axis=AXIS["degree"],
                    group_head="methods", row_head="ratio")


def _judged(ratio):
    text, mark = VERDICTS[ratio.verdict]
    return Cell(f"{MARK[mark].split()[0]} {text}", ratio.verdict, mark)


def _printed_table(number, curve, rows):
    axis, english, chinese = LAYOUT[number]
    values = distinct(rows, axis)
    groups, csv_rows = [], []
    for (method, statistic), own in grouped(rows, "method", *(["statistic"] if axis != "statistic" else ["form"])).items():
        statistic = statistic if axis != "statistic" else "count"
        at = {row[axis]: row for row in own}
        in_order = [at[value] for value in values]
        write = general if statistic in ("count", "total_time") else scientific
        en, zh = STATISTIC.get(statistic, ("count", "条数"))
        groups.append(Group(f"{name(method)}, {en} ({CHINESE.get(method, method)}，{zh})", f"{method} {statistic}", tuple(_quantities(in_order, write))))
        csv_rows += [(method, statistic, quantity, *texts) for quantity in ("published", "ours_median", "ours_p05", "ours_p95", "continuous_median",
                                                                            "against_exact", "prepared_median", "verdict")
                     if any(texts := [row.text(quantity) for row in in_order]) and (quantity, number) != ("verdict", "2.4")]
    head = tuple(value.removeprefix(DISTANCE) if axis == "statistic" else axis_label(value, axis) for value in values)
    form_en, form_zh = form(curve)
    return Table(id=f"table-{number}-{curve}", caption=f"Table {number}. {english}, {form_en}",
                 caption_zh=f"表 {number}　{chinese}（{form_zh}）", head=head, groups=tuple(groups), axis=AXIS.get(axis, "distance at most"),
                 row_head="quantity", csv_head=("method", "statistic", "quantity", *head), csv_rows=tuple(csv_rows))


def _quantities(rows, write):
    """The lines under one printed row: the printed values, ours, the truth, and the verdict."""
    def ours(column):
        return [Cell(write(r[column]), r.text(column)) for r in rows]
    printed = as_printed if write is scientific else shortest
    judged = rows[0]["table"] != "2.4"  # whose times are of another machine; their ratios are judged
    lines = [("published", [Cell(printed(r["published"]), r.text("published"), judged and r["verdict"] or "") for r in rows]),
             ("ours, median", ours("ours_median")), ("ours, 5–95 %", [_band(r, write) for r in rows]),
             ("continuous inputs", ours("continuous_median")), ("against exact", ours("against_exact")), ("prepared once", ours("prepared_median")),
             ("verdict", [Cell(MARK.get(r["verdict"], ""), r.text("verdict"), r["verdict"] or "") for r in rows if judged])]
    return [(label, cells) for label, cells in lines if any(c.text for c in cells)]


@chapter("Figures", suite="report")
def figures(bundle, _findings):
    """The source report's tables as curves: every figure that the bundle has the rows for."""
    from ..figures.printed import TABLES  # needs matplotlib, which --summary does without

    drawn = []
    for draw in TABLES:
        try:
            drawn.append(draw(bundle))
        except (Missing, ZeroDivisionError) as lack:
            drawn.append(Text(f"The figure {draw.__name__.replace('_', ' ')} is left out: {lack}."))
    if all(isinstance(block, Text) for block in drawn):
        raise Missing("the bundle has no `scorecard.csv` with the printed cells")
    yield Text("Lines are our medians, shaded bands hold 90 % of our repetitions, circles are the printed values. Dashed: the same with continuous "
               "inputs. Dotted: the same, measured against the exact value; where it cannot be seen it lies under the median.")
    yield from drawn


@chapter("Methods against the truth", suite="report")
def truth(bundle, _findings):
    """Per study: mean error; then the largest error beside its proved bound."""
    judged = bundle.exact("report")
    rows = [r for r in judged.rows if not bundle.studies[r["study"]].printed]
    if not rows:
        raise Missing("`accuracy.csv` has no study of the suite `report` except those that have printed values")
    yield Text("Errors are Euclidean distances to the exact value, in units of u p~ with u = 2^-53 and p~ the sum of the absolute terms of the "
               "curve at t in the form in which it is given.")
    unstable = distinct((r for r in bundle.judged().rows if r.file == "unstable.csv"), "method")
    if unstable:
        yield Text("Not part of the accuracy digest, because the machine's mathematics library decides their last bits: "
                   f"{listing(f'`{m}`' for m in unstable)}.")
    for study, own in grouped(rows, "study").items():
        yield from study_figure(bundle, study)
        yield from error_tables(study, own)
