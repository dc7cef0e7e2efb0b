# SPDX-License-Identifier: MIT
"""From which degree on factorials overflow in double."""

import math
import sys
from itertools import count as natural

from ..document import Finding
from ..wording import count, listing
from .printed import degrees


def find(bundle):
    """Holds where every method with factorials reaches the last degree whose factorial is a double and no further, and is finite at the
    degrees of the bundle up to there."""
    printed = degrees(bundle)[-1]
    methods = bundle["methods.csv"]
    used = [m for m in bundle.judged().distinct("method", study="truth-bezier")
            if m == "direct" or m.startswith("factorial:")]
    limits = [r for r in methods.some(id=[*used, "factorial"]) if r["max_degree"] is not None]
    overflow = next(n for n in natural(1) if math.factorial(n) > sys.float_info.max)
    rows = [r for r in bundle.judged().some(study="truth-bezier", method=used) if printed < r["degree"] < overflow]
    past = sorted({r["degree"] for r in rows})
    good = [r for r in rows if r["status"] == "ok" and r["non_finite"] == 0
            and r["mean_error"] is not None and math.isfinite(r["mean_error"])]
    reach = {r.number("max_degree") for r in limits}
    holds = bool(rows) and len(good) == len(rows) and reach == {overflow - 1}
    tried = f"at degree {listing(f'{n:g}' for n in past)}" if past else "past the printed degrees"
    finite = f"{len(good)} of {count(len(rows), 'cell')} with factorials {tried} are finite"
    limited = [f"`{r['id']}`" for r in limits]
    stated = (f"the methods that form factorials ({listing(limited)}) are stated to reach degree "
              f"{listing(f'{n:g}' for n in sorted(reach))}")
    return Finding(
        id="factorial_overflow", about="conclusion",
        claim="As the degree rises further, factorials overflow in floating point, and the conversion fails.",
        place="section 2.2, paragraph 3; section 3.2, paragraph 3", holds=holds,
        headline=f"Factorials overflow in double from degree {overflow} on; up to there the conversion does not fail: {finite}." if holds
        else f"Factorials overflow in double from degree {overflow} on, but {finite}, and {stated}.",
        detail=(f"{overflow}! is the first factorial that no double holds; {stated}." if holds else "",),
        rows=tuple(rows) + tuple(limits))
