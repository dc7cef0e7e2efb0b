# SPDX-License-Identifier: MIT
"""Factorials in double do not overflow just past the printed degrees."""

import math
from itertools import count as natural

from ..document import Finding
from ..wording import count, listing
from .printed import degrees

INT64_MAX = 2**63 - 1


def find(bundle):
    """Holds where every method with factorials has the status ok and finite errors beyond the printed degrees."""
    printed = degrees(bundle)[-1]
    methods = bundle["methods.csv"]
    used = [m for m in bundle.judged().distinct("method", study="truth-bezier")
            if m == "direct" or m.startswith("factorial:")]
    limit = {r["id"]: r for r in methods.some(id=[*used, "factorial"]) if r["max_degree"] is not None}
    reach = min(r.number("max_degree") for r in limit.values()) if limit else math.inf
    rows = [r for r in bundle.judged().some(study="truth-bezier", method=used) if printed < r["degree"] <= reach]
    past = sorted({r["degree"] for r in rows})
    good = [r for r in rows if r["status"] == "ok" and r["non_finite"] == 0
            and r["mean_error"] is not None and math.isfinite(r["mean_error"])]
    holds = bool(rows) and len(good) == len(rows)
    overflow = next(n for n in natural(1) if math.factorial(n) > INT64_MAX)
    tried = f"at degree {listing(f'{n:g}' for n in past)}" if past else "past the printed degrees"
    return Finding(
        id="factorial_overflow", about="correction",
        claim=f"Past degree {printed:g} factorials overflow and the conversion fails.", holds=holds,
        headline=f"In double, factorials do not overflow past degree {printed:g}: {len(good)} of {count(len(rows), 'cell')} "
                 f"{tried} are finite." if holds else
                 f"Past degree {printed:g} only {len(good)} of {count(len(rows), 'cell')} with factorials are finite "
                 f"{tried}.",
        detail=(f"The first factorial that a 64-bit integer cannot hold is {overflow}!; the methods that form factorials in "
                f"double ({listing(f'`{m}`' for m in limit)}) are stated to reach degree {reach:g}." if limit else "",),
        rows=tuple(rows) + tuple(limit.values()))
