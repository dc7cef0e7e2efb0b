# SPDX-License-Identifier: MIT
"""Whether splines take time in proportion to their points."""

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, general, large, listing

SUITE = "companion_speed"
STUDY = "companion_speed-interpolation"
METHOD, PLAIN = "c2_natural", "c2_natural_handles"
CLAIM = 1


def find(bundle):
    """Holds where the exponent of the number of points, with its interval, is that of linear time for every method."""
    rows = [r for r in bundle["complexity.csv"].select(study=STUDY) if r["first_points"] is not None]
    if not rows:
        raise Missing(f"`complexity.csv` has no `{STUDY}` row of at least three numbers of points")
    holds = all(r.number("claimed") == CLAIM and r["verdict"] == "within" for r in rows)
    words = listing(f"N^{general(r.number('exponent'))} ({general(r.number('exponent_low'))} to {general(r.number('exponent_high'))}) "
                    f"for `{r['method']}`" for r in rows)
    span = f"From {large(rows[0].number('first_points'))} to {large(rows[0].number('last_points'))} points"
    times = bundle["timing.csv"].select(study=STUDY, method=PLAIN, relative_to=METHOD)
    ratios = [1 / r.number("ratio") for r in times]
    return Finding(
        id="interpolation_time", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"{span}, splines take linear time." if holds else
        f"{span}, it is not certain that splines take linear time.",
        detail=(f"The time of a spline through N points grows like {words}, with the 99 % interval of the exponent.",
                f"To refine slopes and add them before they are rounded costs {factor(min(ratios))} to {factor(max(ratios))} times the "
                "time of elimination for the handles alone." if ratios else ""),
        rows=(*rows, *times))
