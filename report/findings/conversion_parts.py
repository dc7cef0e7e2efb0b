# SPDX-License-Identifier: MIT
"""The part of a converted path that causes a large error."""

from ..bundle import Missing
from ..document import Finding
from ..wording import general, interval, listing, percent, scientific
from .conversion import SOURCES, SUITE, sources

BAD = 10  # times the error of the best method that converts nothing, in the same cell


def find(bundle):
    """Holds where in every bad cell the conversion is the largest part of the error."""
    rows = sources(bundle)
    given = {}
    for row in rows:
        if ":" not in row["method"]:
            key = tuple(row[c] for c in ("study", "degree", "t_min", "t_max"))
            given[key] = min(given.get(key, row.number("mean_error")), row.number("mean_error"))
    bad = [r for r in rows if ":" in r["method"]
           and r.number("mean_error") > BAD * given.get(tuple(r[c] for c in ("study", "degree", "t_min", "t_max")), float("inf"))]
    if not bad:
        raise Missing(f"no path of a `conversion-` study errs {BAD} times as much as a method that converts nothing")
    largest = {r: max(SOURCES, key=lambda source: r[source[0]])[1] for r in bad}
    of_conversion = sum(part == "conversion" for part in largest.values())
    worst = max(bad, key=lambda r: r["mean_error"])
    others = sorted({part for part in largest.values() if part != "conversion"})
    parts = listing(f"{scientific(worst[column])} from {name}" for column, name in SOURCES)
    return Finding(
        id="conversion_parts", about="suite", suite=SUITE, claim="", holds=of_conversion == len(bad),
        headline=f"Wherever a path errs more than {BAD} times as much as the best method for the given form, the conversion "
                 "is the largest "
                 f"part of its error: in all {len(bad)} cells." if of_conversion == len(bad) else
        f"Where a path errs more than {BAD} times as much as the best method for the given form, the conversion is the "
        "largest part of its "
        f"error in {of_conversion} of {len(bad)} cells ({percent(of_conversion / len(bad))}), {listing(others)} in the others.",
        detail=(f"The worst is `{worst['method']}` at degree {worst['degree']:g}, t in "
                f"{interval(worst['t_min'], worst['t_max'])}: of a mean "
                f"error of {scientific(worst['mean_error'])}, {parts}. The parts are averages over the trials whose error "
                "was taken apart "
                f"and need not add up; {general(len(rows))} cells have them.",),
        rows=tuple(bad))
