# SPDX-License-Identifier: MIT
"""Whether a Bernstein form of a knot span that nothing is proved of keeps the bound that is proved of another."""

from ..bundle import Missing
from ..document import Finding
from ..wording import general, listing, shortest
from .series import names

SUITE = "bspline"


def find(bundle):
    """Holds where no largest error of control points exceeds the proved bound of another method in the same cell."""
    rows = [r for r in bundle["bspline.csv"].of_suite(SUITE).rows if r["max_control_error_u"] is not None]
    bounds, proved = {}, set()
    for r in rows:
        if r["control_bound_u"] is not None:
            key = _cell(r)
            bounds[key] = min(bounds.get(key, r["control_bound_u"]), r["control_bound_u"])
            proved.add(r["method"])
    judged = [r for r in rows if r["control_bound_u"] is None and bounds.get(_cell(r))]
    if not judged:
        raise Missing("`bspline.csv` has no Bernstein form without a proved bound beside one that has it")
    beyond = [r for r in judged if r["max_control_error_u"] > bounds[_cell(r)]]
    worst = max(judged, key=lambda r: r["max_control_error_u"])
    of_methods = names(dict.fromkeys(r["method"] for r in judged))
    return Finding(
        id="bspline_recurrence", about="suite", suite=SUITE, claim="", holds=not beyond,
        headline=f"{of_methods}, of which nothing is proved, stays below the bound that is proved of {names(sorted(proved))}."
        if not beyond else f"{of_methods} loses digits: over {listing(dict.fromkeys(r['knots'] for r in beyond))} knots its control "
        f"points have errors above the bound that is proved of {names(sorted(proved))}.",
        detail=(f"The largest error of a control point is {general(worst['max_control_error_u'])} u p~, at degree "
                f"{shortest(worst['degree'])} over {worst['knots']} knots, where {general(bounds[_cell(worst)])} is proved of "
                f"{names(sorted(proved))}."
                + (f" The lowest degree with an error above such a bound is {shortest(min(r['degree'] for r in beyond))}."
                   if beyond else ""),),
        rows=(worst,))


def _cell(row):
    return tuple(row[c] for c in ("dimension", "degree", "coordinate_range", "t_min", "t_max", "generator", "knots"))
