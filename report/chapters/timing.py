# SPDX-License-Identifier: MIT
"""Nanoseconds per point of every timed method."""

from ..bundle import Missing
from ..document import Cell, Text
from ..methods import form
from ..tables import by_axis
from ..wording import general, shortest

TITLE = "Time per point on this machine"


def blocks(bundle, _findings):
    """One table per study: median with its interval, by mode."""
    table = bundle["timing.csv"]
    methods = [r for r in table.rows if r["degree"] is not None]  # not the sentinel, which has none
    if not methods:
        raise Missing("`timing.csv` has no rows")
    yield Text("`one_shot`: prepare a curve and evaluate one point. `point`: prepared, one point at a time. The interval in "
               "brackets, `low_ns` to `high_ns` of the file, covers how far the median varies from one race to another of the same "
               "methods, spread over the run. Every timed output was first checked against the judged one"
               + ("." if all(r["checked"] == "yes" for r in methods) else
                  "; **some outputs did not pass that check** and are marked ✗.")
               + (" A time marked ~ comes from a race in which fixed work beside it changed its speed by more than 2 %: "
                  "ratios within a race stand, times of different races compare badly."
                  if any(r["quality"] == "noisy" for r in methods) else ""))
    for study in dict.fromkeys(r["study"] for r in methods):
        kinds = {}
        for row in (r for r in methods if r["study"] == study):
            kinds.setdefault((row["scalar"], row["dimension"]), []).append(row)
        for number, ((scalar, dimension), rows) in enumerate(kinds.items(), 1):
            modes = list(dict.fromkeys(r["mode"] for r in rows))
            english, chinese = form(rows[0]["curve"])
            yield by_axis(
                rows, "degree", f"timing-{study}" + (f"-{number}" if len(kinds) > 1 else ""),
                f"Nanoseconds per point, {english} ({scalar or 'double'}, {shortest(dimension) or 'any number of'} axes)",
                f"每点用时（纳秒），{chinese}",
                [(mode, _cell, lambda r, mode=mode: r["mode"] == mode) for mode in modes], row_head="mode")


def _cell(row):
    failed = "" if row["checked"] == "yes" else " ✗"
    noisy = " ~" if row["quality"] == "noisy" else ""
    return Cell(f"{general(row['median_ns'])} [{general(row['low_ns'])} – {general(row['high_ns'])}]{noisy}{failed}",
                row.text("median_ns"), "outside" if failed else "")
