# SPDX-License-Identifier: MIT
"""The bundle beside others: what `bezierbench compare` found, machine and build first."""

import math

from ..bundle import Missing
from ..document import Cell, Group, Table, Text
from ..methods import form
from ..tables import by_axis, flat
from ..wording import shortest

TITLE = "Compared with other bundles"
MOST_CELLS = 20  # of accuracy that are shown where values differ
VERDICT = {"slower": "outside", "faster": "inside", "same": "inside", "unresolved": ""}


def blocks(bundle, _findings):
    """Machines and builds, then accuracy, then times; with several bundles, how they rank."""
    found = bundle.comparison
    if found is None:
        raise Missing("no comparison was given: `bezierbench compare` writes one with `--out`, `--comparison` names it")
    for number, other in enumerate(found.rows.distinct("bundle"), 1):
        against = found.rows.some(bundle=other)[0]["against"]
        yield Text(f"**a** is `{against}`, **b** is `{other}`.")
        yield from _machines(found, other, f"comparison-{number}-machines")
        yield from _accuracy(found, other, f"comparison-{number}-accuracy")
        yield from _times(found, other, f"comparison-{number}-times")
    yield _standings(found)


def _machines(found, other, table_id):
    rows = found.facts.select(bundle=other)
    if not rows:
        yield Text("Machines and builds do not differ in anything that is recorded.")
        return
    groups = tuple(Group(f"`{r['fact']}`", r["fact"], (("", [Cell(r.text("a"), r.text("a")), Cell(r.text("b"), r.text("b"))]),))
                   for r in rows)
    yield Table(id=table_id, caption="Where machines and builds differ", caption_zh="机器与编译的差别",
                group_head="fact", head=("a", "b"), groups=groups)


def _accuracy(found, other, table_id):
    rows = found.rows.select(kind="accuracy", bundle=other)
    differing = [r for r in rows if r["verdict"] != "identical"]
    if not rows:
        yield Text("No row of accuracy is in both.")
    elif not differing:
        yield Text(f"Accuracy is identical, bit for bit, in all {len(rows)} common rows.")
    else:
        yield Text(f"Accuracy **differs** in {len(differing)} of {len(rows)} common rows"
                   + (f"; the first {MOST_CELLS} are:" if len(differing) > MOST_CELLS else ":"))
        yield flat(table_id, "Cells whose values differ", "数值不同的单元", differing[:MOST_CELLS],
                   [("study", "study", lambda v: v or ""), ("method", "method", lambda v: f"`{v}`"),
                    ("degree n", "degree", _any), ("file", "file", lambda v: f"`{v}`"),
                    ("column", "column", lambda v: f"`{v}`"), ("a", "a", _any), ("b", "b", _any)])


def _any(value):
    return value if isinstance(value, str) else repr(value) if isinstance(value, float) else ""


def _times(found, other, table_id):
    rows = [r for r in found.rows.select(kind="timing", bundle=other) if r["degree"] is not None]  # not the sentinel
    if not rows:
        yield Text("No time is in both.")
        return
    yield Text("Times of b over times of a, with the interval in brackets that holds the ratio in 99 of 100 cases, as far as "
               "times vary between the races of a run. `same` is within 1 %, `slower` and `faster` are beyond it, each with the whole "
               "interval; anything else is `unresolved`. Under it the same with every time in units of the sentinel, fixed "
               "work that runs beside the methods: between machines, that is what compares methods."
               + (" A ratio marked ~ comes from a race that was noisy on at least one side."
                  if any(r["quality"] != "ok" for r in rows) else ""))
    for study in dict.fromkeys(r["study"] for r in rows):
        kinds = {}
        for row in (r for r in rows if r["study"] == study):
            kinds.setdefault((row["scalar"], row["dimension"]), []).append(row)
        for number, ((scalar, dimension), kind) in enumerate(kinds.items(), 1):
            english, chinese = form(kind[0]["form"])
            lines = [(label, cell, lambda r, mode=mode: r["mode"] == mode)
                     for mode in dict.fromkeys(r["mode"] for r in kind)
                     for label, cell in ((mode, _ratio), (f"{mode}, in sentinels", _normalised))]
            yield by_axis(kind, "degree", f"{table_id}-{study}" + (f"-{number}" if len(kinds) > 1 else ""),
                          f"Time of b over time of a, {english}, study {study} ({scalar or 'double'}, "
                          f"{shortest(dimension) or 'any number of'} axes)",
                          f"用时之比，{chinese}", lines, row_head="mode")


def _ratio(row):
    return _cell(row, "ratio", "verdict")


def _normalised(row):
    return _cell(row, "normalised", "normalised_verdict") if row["normalised"] is not None else Cell()


def _cell(row, ratio, verdict):
    noisy = "" if row["quality"] == "ok" else " ~"
    low, high = _three(row[f"{ratio}_low"]), _three(row[f"{ratio}_high"])
    return Cell(f"{_three(row[ratio])} [{low} – {high}] {row[verdict]}{noisy}", row.text(ratio),
                "" if noisy else VERDICT.get(row[verdict], ""))


def _three(ratio):
    """With the three digits that a margin of 1 % needs."""
    return f"{ratio:.3f}"


def _mean(ratio):
    """Nothing for a bundle without times, or without a sentinel."""
    return "" if math.isnan(ratio) else _three(ratio)


def _standings(found):
    return flat("comparison-standings", "Geometric mean of time over a's, over all common timings", "各结果包的用时排名（几何平均）",
                found.standings.rows,
                [("bundle", "bundle", lambda v: f"`{v}`"), ("rank", "rank", shortest), ("processor", "cpu", str),
                 ("compiler", "compiler", str), ("machine", "machine", str), ("accuracy rows that differ", "accuracy_rows_differing", shortest),
                 ("timings", "timings", shortest), ("time", "mean_ratio", _mean),
                 ("in sentinels", "mean_normalised", _mean)])
