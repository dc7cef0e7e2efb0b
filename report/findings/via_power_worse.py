# SPDX-License-Identifier: MIT
"""De Casteljau against the power form, for Bézier curves."""

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, span
from .printed import accuracy_cells


def find(bundle):
    """Holds where de Casteljau errs less in every printed cell, against the yardstick and against the exact value."""
    cells = {}
    for row in accuracy_cells(bundle):
        if row["curve"] == "bezier":
            key = tuple(row[c] for c in ("statistic", "degree", "coordinate_range", "t_min", "t_max"))
            cells.setdefault(key, {})[row["method"]] = row
    pairs = [(c["de_casteljau"], c["factorial:power_sum"]) for c in cells.values()
             if {"de_casteljau", "factorial:power_sum"} <= set(c)]
    if not pairs:
        raise Missing("`scorecard.csv` has no cell with both de Casteljau and the power form")
    wins = {c: sum(a.number(c) < b.number(c) for a, b in pairs)
            for c in ("published", "ours_median", "continuous_median", "against_exact")}
    ratios = [b.number("against_exact") / a.number("against_exact") for a, b in pairs]
    n = len(pairs)
    holds = all(w == n for w in wins.values())
    return Finding(
        id="via_power_worse", about="conclusion",
        claim="For Bézier curves de Casteljau is always more accurate than conversion to power form.",
        place="sections 2.3.2 and 2.3.3, after the first table of each", holds=holds,
        headline=f"De Casteljau is more accurate than the power form in all {n} pairs of cells, whatever it is held against."
        if holds else f"De Casteljau is not more accurate than the power form in all {n} pairs of cells.",
        detail=(f"It wins in {wins['published']} as printed, {wins['ours_median']} in our repetition, "
                f"{wins['continuous_median']} with continuous inputs and {wins['against_exact']} against the exact value, "
                f"where the power form's error is {span(min(ratios), max(ratios), factor)} times as large.",),
        rows=tuple(r for pair in pairs for r in pair))
