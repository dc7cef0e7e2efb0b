# SPDX-License-Identifier: MIT
"""De Casteljau's error against degree and parameter, once it is held against the truth."""

from ..document import Finding
from ..wording import general, interval, scientific
from .printed import FLAT, series


def find(bundle):
    """Holds where the error against the exact value varies clearly with the degree or with t."""
    key = dict(study="truth-bezier", method="de_casteljau", baseline="exact", generator="continuous")
    grid = sorted((r for r in bundle.judged().some(scalar="double", dimension=2, **key) if r["mean_error_u"] is not None),
                  key=lambda r: r["degree"])
    by_t = bundle.judged().some(scalar="double", dimension=2, study="2.3.3-bezier", method="de_casteljau", baseline="exact",
                                generator="continuous")
    printed = series(bundle, "degree", table="2.3.1", curve="bezier", method="de_casteljau", statistic="mean_error")
    growth = grid[-1].number("mean_error_u") / grid[0].number("mean_error_u")
    least, most = (f(by_t, key=lambda r: r.number("mean_error")) for f in (min, max))
    ratio = most.number("mean_error") / least.number("mean_error")
    seen = printed[-1].number("published") / printed[0].number("published")
    holds = growth > FLAT or ratio > FLAT
    return Finding(
        id="de_casteljau_flat", about="correction",
        claim="The error of de Casteljau hardly depends on the degree or on t.", holds=holds,
        headline="Against the exact value de Casteljau's error does depend on the degree and on t."
        if growth > FLAT and ratio > FLAT else
        f"Against the exact value de Casteljau's error depends on {'the degree' if growth > FLAT else 't'}." if holds else
        "Against the exact value, too, de Casteljau's error hardly depends on the degree or on t.",
        detail=(f"From degree {grid[0]['degree']:g} to {grid[-1]['degree']:g} its mean goes from "
                f"{general(grid[0]['mean_error_u'])} to {general(grid[-1]['mean_error_u'])} times u p~, a factor of "
                f"{general(growth)}; the printed errors grow by {general(seen)} from degree {printed[0]['degree']:g} to "
                f"{printed[-1]['degree']:g}.",
                f"Between intervals of t the mean error goes from {scientific(least['mean_error'])} on "
                f"{interval(least['t_min'], least['t_max'])} to {scientific(most['mean_error'])} on "
                f"{interval(most['t_min'], most['t_max'])}, a factor of {general(ratio)}"
                + (": 1-t is exact from one half upwards and rounded below." if ratio > FLAT else ".")),
        rows=tuple(grid) + tuple(by_t))
