# SPDX-License-Identifier: MIT
"""Equal steps of t against equal steps of the length."""

from ..bundle import Missing
from ..document import Finding
from ..wording import general

SUITE = "inverse_arc_length"
EVEN = 1e-9  # relative difference from the mean up to which gaps are called even


def find(bundle):
    """Holds where points at true parameters are even on every curve, and points at equal steps of t on none."""
    table = bundle["spacing.csv"].of_suite("inverse_arc_length")
    gaps = {spacing: [r for r in table.select(spacing=spacing) if r["gap"] is not None] for spacing in ("parameter", "arc_length")}
    if not all(gaps.values()):
        raise Missing("`spacing.csv` has no gaps of both spacings")
    uneven = [r for r in gaps["arc_length"] if abs(r.number("gap") - 1) > EVEN]
    studies = {r["study"] for r in gaps["parameter"]}
    bunched = {r["study"] for r in gaps["parameter"] if abs(r.number("gap") - 1) > EVEN}
    least = min(gaps["parameter"], key=lambda r: r.number("gap"))
    most = max(gaps["parameter"], key=lambda r: r.number("gap"))
    holds = not uneven and bunched == studies
    return Finding(
        id="inverse_arc_length_spacing", about="suite", suite=SUITE, claim="", holds=holds,
        headline="Points at equal steps of t are not evenly spaced, points at equal steps of the length are." if holds else
        "Points are not spaced as expected: even at equal steps of the length, and only there.",
        detail=(f"On {len(studies)} drawn curves, equal steps of t cover {general(least['gap'])} to {general(most['gap'])} times the "
                "mean step of the length.",),
        rows=(least, most, *uneven))
