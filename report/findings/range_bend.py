# SPDX-License-Identifier: MIT
"""The cause of the bend of the error over the range: the report's random grid."""

from ..document import Finding
from ..wording import general, scientific, shortest, span
from .printed import FLAT, series

METHOD = "factorial:power_sum"


def _spread(values):
    return max(values) / min(values)


def find(bundle):
    """Holds where the error grows with the range, as printed and ours: in proportion with continuous inputs, with a bend on the report's
    grid."""
    rows = series(bundle, "coordinate_range", table="2.3.2", curve="bezier", method=METHOD, statistic="mean_error")
    over_range = {c: [r.number(c) / r.number("coordinate_range") for r in rows]
                  for c in ("published", "ours_median", "continuous_median")}
    in_u = {}
    used = []
    for generator in ("report", "continuous"):
        found = [bundle.accuracy(study="2.3.2-bezier", method=METHOD, baseline="direct", generator=generator, degree=r["degree"],
                                 coordinate_range=r["coordinate_range"]) for r in rows]
        used += found
        in_u[generator] = [r.number("mean_error_u") for r in found]
    spread = {c: _spread(v) for c, v in over_range.items()}
    grows = all(a.number(c) < b.number(c) for a, b in zip(rows, rows[1:]) for c in over_range)
    holds = grows and spread["continuous_median"] <= FLAT < spread["ours_median"]
    first, last = rows[0]["coordinate_range"], rows[-1]["coordinate_range"]
    ours, published, continuous = (over_range[c] for c in ("ours_median", "published", "continuous_median"))
    printed = (f"Via power form, mean error over range falls from {scientific(published[0])} at R = {shortest(first)} to "
               f"{scientific(published[-1])} at R = {shortest(last)} in print, and from {scientific(ours[0])} to "
               f"{scientific(ours[-1])} with the report's generator; with continuous inputs it stays at "
               f"{span(min(continuous), max(continuous), scientific)}.")
    units = (f"Over u p~ the mean error varies by a factor of {general(_spread(in_u['report']))} with the report's grid and "
             f"{general(_spread(in_u['continuous']))} with continuous inputs.")
    return Finding(
        id="range_bend", about="conclusion", claim="As the range of the coordinates grows, the error grows.",
        place="section 2.3.2, after each table", holds=holds,
        headline="The error grows with the range, with continuous inputs in proportion to it; the bend of the printed errors is the "
                 "random grid." if holds else
                 "The random grid does not explain the error over the range in this bundle: "
                 f"error over range varies by a factor of {general(spread['ours_median'])} with the grid and "
                 f"{general(spread['continuous_median'])} with continuous inputs.",
        detail=(printed, units, *_conversion(bundle, rows)), rows=tuple(rows + used))


def _conversion(bundle, rows):
    """Yields the conversion's part of the error on the grid at both ends of the range; nothing where no error was split
    into parts."""
    shares = []
    for row in (rows[0], rows[-1]):
        parts = bundle.judged().select(study="2.3.2-bezier", method=METHOD, baseline="exact", generator="report", scalar="double",
                                       dimension=2, degree=row["degree"], coordinate_range=row["coordinate_range"])
        if len(parts) != 1 or parts[0]["mean_conversion_error"] is None:
            return
        shares.append((row, parts[0].number("mean_conversion_error"), parts[0].number("mean_evaluation_error")))
    (first, *before), (last, *after) = shares
    yield (f"On the grid the conversion makes a mean error of {scientific(before[0])} and the evaluation one of {scientific(before[1])} at "
           f"R = {shortest(first['coordinate_range'])}; at R = {shortest(last['coordinate_range'])} they make {scientific(after[0])} and "
           f"{scientific(after[1])}.")
