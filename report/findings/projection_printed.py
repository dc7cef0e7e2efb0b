# SPDX-License-Identifier: MIT
"""Whether the quintic that a source document prints finds nearest points."""

from ..bundle import Missing
from ..document import Finding
from ..wording import large, percent
from .projection import by_method, of_rows

SUITE = "projection"
WRONG = 0.1  # share of missed foot points that no choice of inputs explains


def find(bundle):
    """Holds where the printed coefficients miss foot points that the right ones find."""
    methods = by_method(bundle)
    printed, right = methods.get("quintic_seed_002"), methods.get("quintic_companion")
    if printed is None or right is None:
        raise Missing("a `projection-` study needs `quintic_seed_002` beside `quintic_companion`")
    degrees = {r["degree"] for r in printed.rows}
    right = of_rows([r for r in right.rows if r["degree"] in degrees])  # the printed one is for cubics only
    holds = printed.share > WRONG and right.share < WRONG
    shares = f"{percent(printed.share)} of {large(printed.trials)}"
    return Finding(
        id="projection_printed", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"The quintic with the printed coefficients k2, k3 and k4 misses {shares} foot points, with the right ones and the "
                 f"same solver {percent(right.share)} of {large(right.trials)}." if holds else
        f"The quintic with the printed coefficients misses {shares} foot points, that with the right ones "
        f"{percent(right.share)}: these inputs do not tell them apart.",
        detail=("Printed: k2 = A·D + 6 B·C + 3 C·C, k3 = 3 B·D + 6 C·C + 3 C·D, k4 = 3 C·D + 3 D·D. Expanded: k2 = A·D + 9 B·C, "
                "k3 = 4 B·D + 6 C·C, k4 = 5 C·D.",),
        rows=(max(printed.rows, key=lambda r: r["missed"]), max(right.rows, key=lambda r: r["missed"])))
