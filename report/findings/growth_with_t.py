# SPDX-License-Identifier: MIT
"""The error of the power form against the parameter."""

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, interval, listing, scientific


def _middle(row):
    return (row.number("t_min") + row.number("t_max")) / 2


def find(bundle):
    """Holds where, over intervals of one width, the mean error grows more than in proportion to their middle, on every path."""
    scorecard = bundle["scorecard.csv"]
    rows = [r for r in scorecard.some(table="2.3.3", statistic="mean_error") if r["method"] != "de_casteljau"]
    width = min(r.number("t_max") - r.number("t_min") for r in rows)
    narrow = [r for r in rows if r["t_max"] - r["t_min"] < 1.001 * width]
    paths = {}
    for row in sorted(narrow, key=lambda r: r["t_min"]):
        paths.setdefault((row["curve"], row["method"]), []).append(row)
    if not paths or min(map(len, paths.values())) < 2:
        raise Missing("`scorecard.csv` has fewer than two intervals of one width in table 2.3.3")
    grows = [all(b.number(c) / a.number(c) > _middle(b) / _middle(a) for a, b in zip(p, p[1:]) for c in ("ours_median", "against_exact"))
             for p in paths.values()]
    holds = all(grows)
    first, last = paths[next(iter(paths))][0], paths[next(iter(paths))][-1]
    places = listing(interval(r["t_min"], r["t_max"]) for r in paths[next(iter(paths))])
    return Finding(
        id="growth_with_t", about="conclusion",
        claim="On converted curves the mean error grows with the mean of t, more than linearly.",
        place="section 2.3.3, after each table", holds=holds,
        headline=f"On converted curves the error grows more than in proportion to t on {sum(grows)} of {len(grows)} paths" + (
            ", as the report says." if holds else ": the report's conclusion does not hold on all."),
        detail=(f"Over {places}, the mean error of `{first['method']}` goes from {scientific(first.number('against_exact'))} to "
                f"{scientific(last.number('against_exact'))} against the exact value, a factor of "
                f"{factor(last['against_exact'] / first['against_exact'])}; printed: {scientific(first['published'])} to "
                f"{scientific(last['published'])}.",),
        rows=tuple(narrow))
