# SPDX-License-Identifier: MIT
"""B-spline curves: largest error of points against the degree, by kind of knots."""

from ..bundle import Missing
from .canvas import finish, styled
from .method_lines import series
from .stacked import degrees_across, stacked

ID = "bspline-against-degree"
STUDIES = ("bspline-degree", "bspline-high_degree")


@styled
def draw(bundle):
    """Largest error over u p~ against the degree, a panel for each kind of knots."""
    rows = [r for study in STUDIES for r in bundle["bspline.csv"].select(study=study)]
    parts = []
    for knots in dict.fromkeys(r["knots"] for r in rows):
        lines = series([r for r in rows if r["knots"] == knots], lambda r: r["degree"], "max_error_u")
        if lines:
            parts.append((f"{knots} knots", lines))
    if not parts:
        raise Missing("`bspline.csv` has no row that a figure can show")
    canvas, lowest, words = stacked(parts, degrees_across, "largest error / (u p~)", "at the highest degree", sharex=True)
    lowest.set_xlabel("degree n")
    return finish(canvas, ID, "Largest error of points of B-spline curves over u p~ against degree",
                  "B 样条曲线点的最大误差与阶数（以 u p~ 计）", "Doubly logarithmic. " + words + ".", bottom=0.08)
