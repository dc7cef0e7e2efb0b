# SPDX-License-Identifier: MIT
"""How many round trips stay close depends on where the coordinates may lie."""

from ..document import Finding
from ..wording import count, general, percent
from .printed import FLAT

DISTANCE = "1e-5"


def find(bundle):
    """Holds where continuous inputs stay close clearly less often than the report's grid."""
    table = bundle["conversion.csv"]
    rows = {g: table.some(study="2.2", generator=g) for g in ("report", "continuous", "integer")}
    column = f"within_{DISTANCE}"
    share = {g: sum(r.number(column) for r in found) / sum(r.number("trials") for r in found)
             for g, found in rows.items()}
    cell = bundle["scorecard.csv"].one(table="2.2", statistic=f"count_within_{DISTANCE}")
    curves = round(cell.number("ours_median") / share["report"]) if share["report"] else 0
    holds = share["continuous"] * FLAT < share["report"] <= share["integer"]
    numbers = (f"Within {DISTANCE} stay {percent(share['report'])} of the curves on the report's grid, "
               f"{percent(share['continuous'])} with continuous coordinates and {percent(share['integer'])} with whole "
               f"numbers. The report prints {count(int(cell.number('published')), 'curve')}; we get "
               f"{general(cell.number('ours_median'))} [{general(cell.number('ours_p05'))} to "
               f"{general(cell.number('ours_p95'))}]"
               + (f" of about {curves}" if curves else "") + " with its generator.")
    return Finding(
        id="round_trip_grid", about="correction",
        claim=f"95 % of the random curves come back from the round trip within {DISTANCE} and all within 1e-1, which is negligible for "
              "their range, so the conversions are correct.", place="section 3.1, paragraph 1",
        holds=holds,
        headline=f"How many round trips stay within {DISTANCE} is a property of the grid, not of the conversions." if holds
        else f"The grid does not decide how many round trips stay within {DISTANCE} in this bundle.",
        detail=(numbers,), rows=(cell, *(r for found in rows.values() for r in found)))
