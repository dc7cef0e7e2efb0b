# SPDX-License-Identifier: MIT
"""The error of paths through power form grows over t as (1+2t)^n, the norm of the power basis on Bernstein coefficients."""

from ..document import Finding
from ..wording import factor, scientific, shortest
from .conversion import SUITE, growth, middle, to_power
from .series import names

WITHIN = 10  # the norm, taken at the middles of intervals, bounds the growth up to a constant


def find(bundle):
    """Holds where no mean error grows from the first to the last interval more than a constant faster than (1+2t)^n."""
    cells = {}
    for row in to_power(bundle):
        if ":" in row["method"] and row["mean_error"]:
            cells.setdefault((row["method"], row["degree"]), []).append(row)
    grown = {}
    for key, rows in cells.items():
        rows = sorted(rows, key=middle)
        first, last = rows[0], rows[-1]
        grown[key] = (last.number("mean_error") / first.number("mean_error"), growth(middle(first), middle(last), key[1]), first, last)
    faster = [key for key, (ours, norm, *_) in grown.items() if ours > WITHIN * norm]
    top = max(degree for _, degree in grown)
    method, _ = max((key for key in grown if key[1] == top), key=lambda key: grown[key][0])
    ours, norm, first, last = grown[method, top]
    slow = [m for (m, degree), (a, b, *_) in grown.items() if degree == top and a < b / 100]
    return Finding(
        id="conversion_growth", about="suite", suite=SUITE, claim="", holds=not faster,
        headline="Over t the error of every path through power form grows at most as (1+2t)^n, up to a constant." if not faster else
        f"The error of {names(dict.fromkeys(m for m, _ in faster))} grows over t faster than (1+2t)^n.",
        detail=(f"At degree {shortest(top)} from the middle of the first interval, t = {shortest(middle(first))}, to that of "
                "the last, t = "
                f"{shortest(middle(last))}, (1+2t)^n grows by {factor(norm)}; the mean error of `{method}`, which grows "
                "most, by "
                f"{factor(ours)}, from {scientific(first['mean_error'])} to {scientific(last['mean_error'])}."
                + (f" Less than a hundredth of that growth have {names(slow)}." if slow else ""),),
        rows=tuple(r for _, _, *pair in grown.values() for r in pair))
