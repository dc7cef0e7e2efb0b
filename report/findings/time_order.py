# SPDX-License-Identifier: MIT
"""Which of the report's orders of speed hold on this machine."""

from ..document import Finding
from ..methods import FORM, name
from ..wording import listing

# fastest first, as the report concludes
ORDERS = {
    "bezier": ("direct", "de_casteljau", "factorial:power_sum"),
    "polynomial": ("power_sum", "forward_substitution:direct", "forward_substitution:de_casteljau"),
}


def _times(rows, column, order):
    """{degree: {method: time}} for the degrees at which every method of the order has a time."""
    times = {}
    for row in rows:
        if row["method"] in order and row[column] is not None:
            times.setdefault(row.number("degree"), {})[row["method"]] = row.number(column)
    return {n: times[n] for n in sorted(times) if len(times[n]) == len(order)}


def _kept(rows, column, order):
    """(degrees at which the order holds, degrees at which it can be judged)."""
    times = _times(rows, column, order)
    kept = [n for n, t in times.items() if all(t[a] < t[b] for a, b in zip(order, order[1:]))]
    return kept, list(times)


def _at_limits(bundle, curve, order, mode):
    """As _kept(), for the least times that the processor could take in the studies that reproduce the table."""
    rows = bundle["timing.csv"].rows if "timing.csv" in bundle else []
    return _kept([r for r in rows if (r["study"] or "").startswith("2.4") and r["curve"] == curve and r["mode"] == mode
                  and r["scalar"] == "double" and r["degree"] is not None], "limit_ns", order)


def find(bundle):
    """Holds where, as the report times them, both orders hold at every degree."""
    used, lines, all_kept = [], [], True
    for curve, order in ORDERS.items():
        written = " < ".join(name(m) for m in order)
        rows = bundle["scorecard_timing.csv"].some(table="2.4", curve=curve)
        kept, judged = _kept(rows, "ours_median", order)
        once, judged_once = _kept(rows, "prepared_median", order)
        used += rows
        all_kept = all_kept and bool(judged) and kept == judged
        failing = [f"{n:g}" for n in judged if n not in kept]
        fastest = [min(times, key=times.get) for times in _times(rows, "prepared_median", order).values()]
        limits = [_at_limits(bundle, curve, order, mode) for mode in ("one_shot", "point")]
        lines.append(f"{FORM[curve][0].capitalize()}: {written} in time holds at {len(kept)} of {len(judged)} degrees as "
                     "the report times it"
                     + (f" (not at degree {listing(failing)})" if failing else "")
                     + (f", and at {len(once)} of {len(judged_once)} when prepared once, where {name(order[0])} is fastest at "
                        f"{fastest.count(order[0])} and {name(order[-1])} at {fastest.count(order[-1])}." if judged_once
                        else ".")
                     + (" At the limits of this processor it would hold at "
                        + " and ".join(f"{len(k)} of {len(j)}{when}" for (k, j), when in zip(limits, ("", " when prepared once")) if j)
                        + "." if any(j for _, j in limits) else ""))
    return Finding(
        id="time_order", about="note",
        claim="In speed, for Bézier curves, direct evaluation comes before de Casteljau and that before conversion to power form; for "
              "polynomial curves direct evaluation comes before conversion followed by direct evaluation, and that before conversion "
              "followed by de Casteljau.",
        place="section 2.4, after each table", holds=all_kept,
        headline="The report's orders of speed hold on this machine and build when the conversion is charged to every curve." if all_kept
        else "The report's orders of speed do not all hold on this machine and build.",
        detail=(*lines, "What the report describes, compiled with and without optimisation, is timed by `scripts/check printed_times`."),
        rows=tuple(used))
