# SPDX-License-Identifier: MIT
"""Whether the halves of a split curve share their junction and keep the ends bit for bit, and whether their points are
on the curve."""

from ..bundle import Missing
from ..document import Finding
from ..wording import count, large
from .series import names

SUITE = "subdivision"
COUNTS = ("junctions_apart", "ends_moved", "points_off")


def find(bundle):
    """Holds where every method shares the junction, keeps the ends and puts points of halves within the bounds."""
    rows = [r for r in bundle["subdivision.csv"].of_suite(SUITE).rows if any(r[c] is not None for c in COUNTS)]
    if not rows:
        raise Missing("`subdivision.csv` has no row of the suite `subdivision` that says whether halves fit together")
    broken = [r for r in rows if any(r[c] for c in COUNTS)]
    trials = large(sum(r.number("trials") for r in rows))
    asked = [r for r in rows if r["points_off"] is not None]
    return Finding(
        id="subdivision_halves", about="suite", suite=SUITE, claim="", holds=not broken,
        headline=f"In {trials} splits the halves share their junction and keep the ends of the curve to the last bit." if not broken
        else f"Halves do not fit together: {names(dict.fromkeys(r['method'] for r in broken))}.",
        detail=(f"{count(len({r['method'] for r in rows}), 'method')} split {large(len(rows))} cells. In {large(len(asked))} of them "
                f"a point of each half is held to the true point within the bounds of the control points: "
                f"{large(sum(r['points_off'] for r in asked))} of {large(sum(r.number('trials') for r in asked))} are off.",),
        rows=tuple(broken or rows[:1]))
