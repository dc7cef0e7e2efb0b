# SPDX-License-Identifier: MIT
"""The printed cells that no repetition of the experiment gives."""

from ..bundle import Missing
from ..document import Finding
from ..wording import as_printed, count, factor, general, listing, scientific, shortest, span
from .printed import accuracy_cells

DECADE = 10  # the factor of an exponent that is off by one


def find(bundle):
    """Holds where an explained cell lies above the band and a tenth of it lies inside: a slip of the exponent."""
    explained = [r for r in accuracy_cells(bundle) if r["verdict"] == "explained"]
    if not explained:
        raise Missing("`scorecard.csv` has no explained accuracy cell")
    slips = [r for r in explained if r.number("published") > r.number("ours_p95")
             and r.number("ours_p05") <= r.number("published") / DECADE <= r.number("ours_p95")]
    holds = len(slips) == len(explained)
    values = listing(dict.fromkeys(as_printed(r["published"]) for r in explained))
    ratios = [r.number("published") / r.number("ours_median") for r in explained]
    places = listing(dict.fromkeys(f"table {r['table']}, R = {shortest(r['coordinate_range'])}" for r in explained))
    others = [r.number("published") / r.number("ours_median") for e in explained
              for r in bundle["scorecard.csv"].select(**{c: e[c] for c in ("table", "curve", "method", "statistic")})
              if r["verdict"] != "explained"]
    if holds:
        headline = (f"{count(len(explained), 'cell')} reading {values} ({places}) "
                    f"{'is' if len(explained) == 1 else 'are'} a slip in the exponent.")
        detail = (f"Repetitions give {scientific(explained[0]['ours_median'])} there, {span(min(ratios), max(ratios), factor)} "
                  f"times less than printed, and a tenth of the printed value lies inside our band. In the other cells of "
                  f"{'its row' if len(explained) == 1 else 'these rows'} the printed value is "
                  f"{span(min(others), max(others), general)} times our median." if others else "",)
    else:
        headline = (f"{count(len(explained), 'cell')} reading {values} ({places}) cannot be called a slip in the exponent.")
        detail = (f"A tenth of the printed value lies inside our band in {len(slips)} of {len(explained)}; printed over our "
                  f"median is {span(min(ratios), max(ratios), general)}.",)
    return Finding(id="printed_slip", about="correction", claim=f"The largest error at {places} is {values}.",
                   holds=holds, headline=headline, detail=detail, rows=tuple(explained))
