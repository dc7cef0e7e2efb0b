# SPDX-License-Identifier: MIT
"""De Casteljau's error by degree and parameter, against the truth."""

from ..bundle import Missing
from ..document import Finding
from ..wording import general, interval, scientific, shortest
from .printed import FLAT, against_exact, series


def _against_truth(bundle, printed):
    """The rows at the printed degrees, in the same order."""
    rows = [against_exact(bundle, "de_casteljau", row["degree"]) for row in printed]
    sizes = {row["coordinate_range"] for row in (*rows, *printed)}
    if len(sizes) > 1:
        raise Missing("`accuracy.csv` has the degrees that are printed for another coordinate range")
    return rows


def find(bundle):
    """Holds where the error against the exact value, in coordinate units, clearly varies with the degree or with t,
    over the degrees and the range that are printed."""
    printed = series(bundle, "degree", table="2.3.1", curve="bezier", method="de_casteljau", statistic="mean_error")
    truth = _against_truth(bundle, printed)
    by_t = bundle.judged().some(scalar="double", dimension=2, study="2.3.3-bezier", method="de_casteljau", baseline="exact",
                                generator="continuous")
    errors = [r.number("mean_error") for r in truth]
    growth = max(errors) / min(errors)
    least, most = (f(by_t, key=lambda r: r.number("mean_error")) for f in (min, max))
    ratio = most.number("mean_error") / least.number("mean_error")
    seen = [r.number("published") for r in printed]
    first, last = (shortest(r["degree"]) for r in (truth[0], truth[-1]))
    holds = growth > FLAT or ratio > FLAT
    return Finding(
        id="de_casteljau_flat", about="correction",
        claim="The error of de Casteljau hardly changes with the degree and has little to do with t.",
        place="sections 2.3.1 and 2.3.3, after the first table of each", holds=holds,
        headline="Against the exact value de Casteljau's error does depend on the degree and on t."
        if growth > FLAT and ratio > FLAT else
        f"Against the exact value de Casteljau's error depends on {'the degree' if growth > FLAT else 't'}." if holds else
        "Against the exact value, too, de Casteljau's error hardly depends on the degree or on t.",
        detail=(f"From degree {first} to {last} its mean error goes from {scientific(errors[0])} to {scientific(errors[-1])} against the "
                f"exact value, and its extremes are a factor of {general(growth)} apart; the printed ones go from {scientific(seen[0])} to "
                f"{scientific(seen[-1])}, extremes a factor of {general(max(seen) / min(seen))} apart.",
                f"Between intervals of t the mean error goes from {scientific(least['mean_error'])} on "
                f"{interval(least['t_min'], least['t_max'])} to {scientific(most['mean_error'])} on "
                f"{interval(most['t_min'], most['t_max'])}, a factor of {general(ratio)}."),
        rows=(*truth, *by_t, *printed))
