# SPDX-License-Identifier: MIT
"""Each further working precision of a compensated scheme extends the condition numbers it can handle by a factor
1/u."""

import re

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, listing

SUITE = "conditioning"
UNIT = 2.0 ** -53
ACCURATE = 2 * UNIT  # one ulp at most: "accurate to u"
LOST = 1.0  # a relative error of 1: no digit is right
SLACK = 2  # the rule holds up to a constant, since the condition number is a bound on what rounding can do


def precision(method):
    """K for a method that works as if in K-fold precision; None where the id does not state K."""
    if ":" in method:
        return None
    fold = re.search(r"_k(\d+)$", method)
    return int(fold[1]) if fold else 2 if method.startswith("compensated_") else 1


def cells(bundle):
    """{(curve, method): rows by ascending condition number}, for rows with a median condition number and relative
    error."""
    found = {}
    for row in bundle.exact("conditioning").rows:
        if row["p50_condition"] is not None and row["p50_relative"] is not None:
            found.setdefault((row["curve"], row["method"]), []).append(row)
    if not found:
        raise Missing("`accuracy.csv` has no `conditioning-` row with `p50_condition` and `p50_relative`")
    return {key: sorted(rows, key=lambda r: r.number("p50_condition")) for key, rows in found.items()}


def first_above(rows, limit):
    """The row of least condition number whose median relative error exceeds `limit`; None where none does."""
    return next((r for r in rows if not r["p50_relative"] <= limit), None)


def find(bundle):
    """Holds where the median relative error of every K-fold scheme stays below about u + condition u^K."""
    by_method = cells(bundle)
    judged = [(r, precision(m)) for (_, m), rows in by_method.items() for r in rows if precision(m)]
    broken = [(r, k) for r, k in judged if not r["p50_relative"] <= SLACK * (UNIT + r["p50_condition"] * UNIT ** k)]
    top = max(k for _, k in judged)
    lines, used = [], [r for r, _ in broken]
    for (curve, method), rows in by_method.items():
        unsure, lost = first_above(rows, ACCURATE), first_above(rows, LOST)
        used += [r for r in (unsure, lost) if r]
        lines.append((precision(method) or top + 1, f"`{method}` ({'Bernstein' if curve == 'bezier' else 'power'} form) "
                      + (factor(unsure["p50_condition"]) if unsure else "in no cell") + " and "
                      + (factor(lost["p50_condition"]) if lost else "in no cell")))
    names = listing(dict.fromkeys(f"`{r['method']}`" for r, _ in broken))
    return Finding(
        id="conditioning_digits", about="suite", suite=SUITE, claim="", holds=not broken,
        headline=f"With K-fold precision the median relative error stays below about u + condition u^K, for K = 1 to {top} "
                 "in all "
                 f"{len(judged)} cells: accurate to u until the condition number nears 1/u^(K-1)." if not broken else
        f"The rule u + condition u^K does not describe {names}.",
        detail=("Condition number from which the median relative error exceeds 2u, and from which it exceeds 1: "
                + "; ".join(text for _, text in sorted(lines, key=lambda line: line[0])) + ".",),
        rows=tuple(used or [r for r, _ in judged]))
