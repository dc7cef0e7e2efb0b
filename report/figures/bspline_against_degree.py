# SPDX-License-Identifier: MIT
"""B-spline curves: largest error of points against the degree, by kind of knots."""

from ..bundle import Missing
from ..wording import general
from .canvas import finish, panels, styled
from .method_lines import degree_axis, draw_methods, ends, error_axis, looks, series

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
    canvas, axes = panels(len(parts), 1, height=2.4, sharex=True)
    look = looks(sorted({m for _, lines in parts for m in lines}))
    words = []
    for ax, (title, lines) in zip(axes[:, 0], parts):
        draw_methods(ax, lines, look)
        ax.set_title(title, loc="left")
        error_axis(ax)
        degree_axis(ax, {x for points in lines.values() for x, _ in points})
        ax.set_ylabel("largest error / (u p~)")
        best, worst, last = ends(lines)
        words.append(f"{title}: at the highest degree {best} has {general(last[best])}, {worst} {general(last[worst])}")
    axes[-1][0].set_xlabel("degree n")
    return finish(canvas, ID, "Largest error of points of B-spline curves over u p~ against degree",
                  "B 样条曲线点的最大误差与阶数（以 u p~ 计）", "Doubly logarithmic. " + "; ".join(words) + ".", bottom=0.08)
