# SPDX-License-Identifier: MIT
"""The printed times are steps of the clock."""

import math

from ..document import Finding
from ..wording import count, general, span
from .printed import FLAT


def find(bundle):
    """Holds where every printed time is a whole number of ticks (milliseconds) and some are no more than one."""
    rows = bundle["scorecard_timing.csv"].some(table="2.4")
    printed = [r.number("published") for r in rows]
    tick = math.gcd(*map(int, printed)) if all(p == int(p) for p in printed) else 0
    small = [r for r in rows if r["published"] <= tick]
    holds = bool(tick and small)
    ours = [r.number("ours_median") for r in small] or [r.number("ours_median") for r in rows]
    prepared = [r for r in rows if r["prepared_median"] and ":" in r["method"]]
    gain = [r.number("ours_median") / r.number("prepared_median") for r in prepared]
    lines = [f"{len(small)} of the {count(len(rows), 'printed time')} are no more than one tick of {tick} ms. Where it prints "
             f"those, we measure {span(min(ours), max(ours), general)} µs per curve, a spread of "
             f"{general(max(ours) / min(ours), 2)}." if small else
             f"The {count(len(rows), 'printed time')} have no tick in common that any of them is as small as."]
    if gain:
        lines.append(f"The report charges the conversion to every point. Prepared once, a point on a converted curve costs "
                     f"{span(min(gain), max(gain), lambda v: general(v, 2))} times less"
                     + ("." if min(gain) > FLAT else ", so the conversion is not the larger part everywhere."))
    return Finding(
        id="timings_quantised", about="note", claim="", holds=holds,
        headline=f"The printed times are steps of a clock of {tick} ms: {len(small)} of {len(rows)} are 0 or {tick}." if holds else
        "The printed times are not whole steps of a clock in this bundle.",
        detail=tuple(lines), rows=tuple(rows))
