# SPDX-License-Identifier: MIT
"""The rounding of 1-t: an error that the report's yardstick shares with the method that it judges."""

from ..document import Finding
from ..wording import scientific
from .printed import against_exact, degrees


def find(bundle):
    """Holds where both methods are farther from the truth than from each other, and gain where 1-t is exact."""
    n = degrees(bundle)[-1]
    pair = dict(study="2.3.1-bezier", generator="continuous", degree=n)
    apart = bundle.accuracy(method="de_casteljau", baseline="direct", **pair)
    truth = {m: against_exact(bundle, m, n) for m in ("direct", "de_casteljau")}
    dyadic = {m: bundle.accuracy(study="truth-bezier", method=m, degree=n, baseline="exact", generator="dyadic") for m in truth}
    gap = apart.number("mean_error")
    error = {m: row.number("mean_error") for m, row in truth.items()}
    after = {m: row.number("mean_error") for m, row in dyadic.items()}
    hidden = gap < min(error.values())
    gains = all(after[m] < error[m] for m in truth)
    numbers = (f"At degree {n:g}, de Casteljau and direct evaluation lie {scientific(gap)} apart on average; from the exact "
               f"value de Casteljau is {scientific(error['de_casteljau'])} away and direct {scientific(error['direct'])}.")
    shift = (f"Where t is a multiple of the unit roundoff, so that 1-t is exact, de Casteljau goes from "
             f"{scientific(error['de_casteljau'])} to {scientific(after['de_casteljau'])} and direct from "
             f"{scientific(error['direct'])} to {scientific(after['direct'])}")
    return Finding(
        id="common_rounding", about="correction", claim="Evaluation by the definition is taken to be completely accurate.",
        place="section 2.3, paragraph 2",
        holds=hidden and gains,
        headline="The report's yardstick hides an error that it shares with de Casteljau: the rounding of 1-t."
        if hidden and gains else "No error shared with the report's yardstick shows in this bundle.",
        detail=(numbers + (" What both have in common cancels in their distance." if hidden else
                           " Their distance does not understate the error."),
                shift + (": that rounding is a large part of the error of both." if gains else
                         ": the rounding of 1-t is not what both have in common.")),
        rows=(apart, *truth.values(), *dyadic.values()))
