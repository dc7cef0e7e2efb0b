# SPDX-License-Identifier: MIT
"""How near kernels come to what the processor can do."""

from ..bundle import Missing
from ..document import Cell, Text
from ..limits import nearness, reading_limits, share_of_limit
from ..methods import form
from ..tables import by_axis
from ..wording import general, listing, percent, shortest, span
from .suite_parts import figure, of_suite, study_figure

TITLE = "Kernels against the peak and the limit of this machine"
KIND = SUITE = "roofline"
SIGN = {"yes": " ✓", "no": " ✗"}


def blocks(bundle, findings):
    """The finding, the figure, then a table for each study, scalar type and number of axes."""
    table = bundle["roofline.csv"]
    rows = [r for r in table.rows if r["share_of_peak"] is not None]
    if not rows:
        raise Missing("`roofline.csv` has no rows")
    yield from of_suite(findings, "roofline")
    yield from figure("share_of_peak", bundle)
    yield Text("One curve, many t, on one core. The peak is that of fused multiply-adds, measured in the same rounds as the methods: "
               + listing(_peaks(rows)) + ". A fused multiply-add counts as two operations. Every point has the bits of the scalar "
               "kernel's" + ("." if all(r["checked"] == "yes" for r in table.rows) else ", **but where a row says `checked` no**.")
               + " ✓ and ✗: a goal is asked of the row, and met or not. ~: the peak itself was more than 2 % below the best of the "
               "study in that race; others were at work.")
    if reading := reading_limits(table.rows):
        yield reading
    for study in table.distinct("study"):
        yield from study_figure(bundle, study)
        yield from study_tables(bundle, study)


def study_tables(bundle, study):
    """A table for each scalar type and number of axes."""
    kinds = {}
    for row in bundle["roofline.csv"].some(study=study):
        kinds.setdefault((row["scalar"], row["dimension"]), []).append(row)
    for (scalar, dimension), members in kinds.items():
        english, chinese = form(members[0]["form"])
        interval = "" if (members[0]["t_min"], members[0]["t_max"]) == (0, 1) else \
            f", t in [{shortest(members[0]['t_min'])}, {shortest(members[0]['t_max'])}]"
        yield by_axis(
            members, "degree", f"{study}-{scalar}-{shortest(dimension)}",
            f"Nanoseconds per point and share of the peak, {english} ({scalar}, {shortest(dimension)} axes{interval})",
            f"批量求值：每点用时（纳秒）与占峰值的比例，{chinese}",
            [(_line(target, mode), _cell, lambda r, key=(target, mode): (r["target"], r["mode"]) == key)
             for target, mode in dict.fromkeys((r["target"], r["mode"]) for r in members)], row_head="target")
        yield from nearness(members)


def _line(target, mode):
    return target if mode == "batch" else f"{target}, {mode}"


def _peaks(rows):
    """`AVX2 double 45.2 to 47.9 GFLOP/s, 50.3 to 52.1 with additions beside`, by target and scalar type, over the races."""
    peaks = {}
    for row in rows:
        peaks.setdefault((row["target"], row["scalar"]), []).append(row)

    def over(races, column):
        found = [row[column] for row in races if row[column] is not None]
        return span(min(found), max(found), general) if found else "unknown"
    return [f"{target} {scalar} {over(races, 'peak_gflops')} GFLOP/s, {over(races, 'mixed_peak_gflops')} with additions beside"
            for (target, scalar), races in peaks.items()]


def _cell(row):
    share = f", {percent(row['share_of_peak'])}" if row["share_of_peak"] is not None else ""
    if row["mode"] in ("point", "latency") and row["share_of_limit"] is not None:
        share = f", {share_of_limit(row['share_of_limit'])} of the limit"
    met = row["goal_met"] or ""
    noisy = " ~" if row["quality"] == "noisy" else ""
    return Cell(f"{general(row['median_ns'])}{share}{noisy}{SIGN.get(met, '')}", row.text("median_ns"),
                {"yes": "inside", "no": "outside"}.get(met, ""))
