# SPDX-License-Identifier: MIT
"""Subdivision: error of the control points against degree, polynomial and rational curves."""

from ..bundle import Missing
from .canvas import finish, styled
from .method_lines import series
from .stacked import degrees_across, stacked

ID = "subdivision-against-degree"
PARTS = (("subdivision-degree", "continuous", "Bezier curves"),
         ("subdivision-rational", "weights_mild", "rational curves, mild weights"),
         ("subdivision-rational", "weights_wild", "rational curves, wild weights"))


@styled
def draw(bundle):
    """Mean error over u p~ against the degree, a panel for each kind of curve."""
    table = bundle["subdivision.csv"]
    parts = []
    for study, generator, title in PARTS:
        rows = table.select(study=study, generator=generator)
        size = min((r["coordinate_range"] for r in rows), key=lambda value: abs(value - 1), default=None)
        lines = series([r for r in rows if r["coordinate_range"] == size], lambda r: r["degree"], "mean_error_u")
        if lines:
            parts.append((title, lines))
    if not parts:
        raise Missing("`subdivision.csv` has no row that a figure can show")
    canvas, lowest, words = stacked(parts, degrees_across, "mean error / (u p~)", "at the highest degree", sharex=True)
    lowest.set_xlabel("degree n")
    return finish(canvas, ID, "Mean error of the control points of both halves over u p~ against degree",
                  "分割曲线控制点的平均误差与阶数（以 u p~ 计）", "Doubly logarithmic. " + words + ".", bottom=0.1)
