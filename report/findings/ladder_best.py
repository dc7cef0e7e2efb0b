# SPDX-License-Identifier: MIT
"""Which method is the most accurate, degree by degree."""

from ..document import Finding
from ..methods import FORM
from ..wording import count, general, listing
from .series import best, by_degree, degrees, names

SUITE = "ladder"
GENERATOR = "continuous"


def find(bundle):
    """Holds where in each form some method has the least mean error at every degree."""
    table = bundle.exact("ladder")
    always, lines, used = {}, [], []
    for curve in table.distinct("curve", generator=GENERATOR):
        methods = by_degree(table.select(curve=curve, generator=GENERATOR, scalar="double", dimension=2))
        winners = best(methods)
        always[curve] = [m for m in methods if all(m in some for some in winners.values())]
        top = max(winners)
        used += [methods[m][n] for n, some in winners.items() for m in some]
        groups = {}
        for n, some in winners.items():
            groups.setdefault(some, []).append(n)
        rows = [methods[m][top] for m in winners[top]]
        lines.append(f"{FORM[curve][0][0].upper()}{FORM[curve][0][1:]}: the least mean error at degree {top:g} is "
                     f"{general(rows[0]['mean_error_u'])} u p~. First at " + "; ".join(f"{degrees(at)}: {names(some)}"
                                                                                    for some, at in groups.items()) + ".")
    holds = all(always.values())
    return Finding(
        id="ladder_best", about="suite", suite=SUITE, claim="", holds=holds,
        headline="At every degree of the ladder the most accurate on average are "
                 + listing(f"{names(some)} for {FORM[curve][0]}" for curve, some in always.items()) + "." if holds else
        "No method is the most accurate on average at every degree: "
        + listing(f"{count(len(some), 'method is', 'methods are')} so for {FORM[curve][0]}" for curve, some in always.items()) + ".",
        detail=tuple(lines), rows=tuple(used))
