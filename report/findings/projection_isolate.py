# SPDX-License-Identifier: MIT
"""Whether isolated roots, refined from the control points, give every nearest point."""

from ..bundle import Missing
from ..document import Finding
from ..wording import general, large, percent
from .projection import GOAL, by_method

SUITE = "projection"


def find(bundle):
    """Holds where `quintic_isolate` misses no foot point and no distance is off by more than the goal."""
    methods = by_method(bundle)
    isolate = methods.get("quintic_isolate")
    if isolate is None:
        raise Missing("a `projection-` study needs `quintic_isolate`")
    holds = isolate.missed == 0 and isolate.largest <= GOAL
    worst = max(isolate.rows, key=lambda r: (r["missed"], r["max_error_eps"]))
    unit = "2^-52 times the largest coordinate"
    lines = [f"`{m}`: {large(one.missed)} of {large(one.trials)} missed ({percent(one.share)}), largest error of the distance "
             f"{general(one.largest)} units." for m, one in methods.items() if m != "quintic_isolate"]
    return Finding(
        id="projection_isolate", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"Isolating the roots of (C - P)·C' and polishing them misses none of {large(isolate.trials)} foot points; the "
                 f"distance is at most {general(isolate.largest)} units of {unit} off." if holds else
        f"Isolating the roots of (C - P)·C' misses {large(isolate.missed)} of {large(isolate.trials)} foot points; the largest error "
        f"of the distance is {general(isolate.largest)} units of {unit}, the goal {GOAL}.",
        detail=tuple(lines), rows=(worst,))
