# SPDX-License-Identifier: MIT
"""On converted polynomial curves the evaluator hardly matters."""

from ..document import Finding
from ..wording import general, percent
from .printed import series

NEGLIGIBLE = 0.01


def find(bundle):
    """Holds where, at the highest degree, both evaluators have about the same error after the report's conversion."""
    rows = {m: series(bundle, "degree", table="2.3.1", curve="polynomial", method=f"forward_substitution:{m}",
                      statistic="mean_error") for m in ("de_casteljau", "direct")}
    apart = [abs(a.number("ours_median") / b.number("ours_median") - 1)
             for a, b in zip(rows["de_casteljau"], rows["direct"])]
    low, high = rows["direct"][0], rows["direct"][-1]
    holds = apart[-1] < NEGLIGIBLE
    lines = [f"The mean errors after `forward_substitution` differ by {percent(apart[0])} at degree {low['degree']:g} and by "
             f"{percent(apart[-1])} at degree {high['degree']:g}."]
    if "scorecard_timing.csv" in bundle:
        timed = bundle["scorecard_timing.csv"].select(table="2.4", curve="polynomial", method="forward_substitution:direct",
                                                      degree=high["degree"])
        if timed and timed[0]["prepared_median"]:
            share = 1 - timed[0].number("prepared_median") / timed[0].number("ours_median")
            lines.append(f"Of the time per curve at degree {high['degree']:g}, conversion and set-up take {percent(share)}.")
    return Finding(
        id="conversion_dominates", about="conclusion",
        claim="On polynomial curves the errors and the cost come mainly from the conversion to Bernstein form.",
        place="section 3.2, paragraph 2",
        holds=holds,
        headline="On polynomial curves, converted as the report does it, the error comes from the conversion: both evaluators "
                 "err alike." if holds else
                 f"On polynomial curves the evaluator still matters at degree {high['degree']:g}: the errors differ by "
                 f"a factor of {general(1 + apart[-1])}.",
        detail=tuple(lines), rows=tuple(r for pair in rows.values() for r in pair))
