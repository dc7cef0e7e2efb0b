# SPDX-License-Identifier: MIT
"""Which method for subdivision has the least error, by degree."""

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, general
from .series import best, by_degree, degrees, names

SUITE = "subdivision"


def find(bundle):
    """Holds where the same method has the least mean error over u p~ at every degree."""
    table = bundle["subdivision.csv"].of_suite(SUITE)
    study = next((s for s in table.distinct("study") if len(table.distinct("degree", study=s)) > 1), None)
    if study is None:
        raise Missing("`subdivision.csv` has no study of the suite `subdivision` that varies the degree")
    size = min(table.distinct("coordinate_range", study=study), key=lambda value: abs(value - 1))
    methods = by_degree(table.select(study=study, coordinate_range=size))
    groups = {}
    for n, winners in best(methods).items():
        groups.setdefault(winners, []).append(n)
    top = max(n for rows in methods.values() for n in rows)
    last = sorted((rows[top]["mean_error_u"], m) for m, rows in methods.items() if top in rows)
    (least, winner), (most, loser) = last[0], last[-1]
    first = next(iter(groups))
    return Finding(
        id="subdivision_best", about="suite", suite=SUITE, claim="", holds=len(groups) == 1,
        headline=f"{names(first)} splits with the least mean error over u p~ at every degree." if len(groups) == 1 else
        "Which method splits with the least mean error over u p~ changes with the degree.",
        detail=("The least mean error has " + "; ".join(f"{names(w)} at {degrees(at)}" for w, at in groups.items())
                + f". At degree {top:g} `{winner}` has {general(least)} u p~ and `{loser}` {general(most)}, "
                  f"{factor(most / least)} times as much.",),
        rows=(methods[winner][top], methods[loser][top]))
