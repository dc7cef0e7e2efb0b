# SPDX-License-Identifier: MIT
"""Which goals of the batch kernels are reached."""

from ..bundle import Missing
from ..document import Finding
from ..wording import count, general, listing, percent

SUITE = "roofline"


def find(bundle):
    """Holds where every row that has a goal meets it; the sentences name the worst row of each method."""
    rows = [r for r in bundle["roofline.csv"].rows if r["goal_met"] in ("yes", "no")]
    if not rows:
        raise Missing("no row of `roofline.csv` has a goal")
    missed = [r for r in rows if r["goal_met"] == "no"]
    nearest = {}
    for row in rows:
        key = (row["method"], row["target"])
        if key not in nearest or _margin(row) < _margin(nearest[key]):
            nearest[key] = row
    return Finding(
        id="roofline", about="suite", suite=SUITE, claim="", holds=not missed,
        headline=f"The batch kernels reach every goal of this run, {len(rows)} in all." if not missed else
        f"The batch kernels reach {len(rows) - len(missed)} of {count(len(rows), 'goal')} of this run; not all of "
        f"{listing(f'`{m}`' for m in dict.fromkeys(r['method'] for r in missed))} do.",
        detail=tuple(_sentence(row) for row in nearest.values()), rows=tuple(missed or nearest.values()))


def _margin(row):
    """The factor by which a row is better than its goal; 1 just reaches it."""
    if row["goal_share"] is not None:
        return row.number("share_of_peak") / row.number("goal_share")
    return row.number("goal_ns") / row.number("median_ns")


def _sentence(row):
    where = f"`{row['method']}` on {row['target']}, at its worst (degree {row.number('degree'):g}, {row['scalar']})"
    if row["goal_share"] is not None:
        return f"{where}: {percent(row['share_of_peak'])} of the peak, asked for {percent(row['goal_share'])}."
    return f"{where}: {general(row['median_ns'])} ns, asked for at most {general(row['goal_ns'])} ns."
