# SPDX-License-Identifier: MIT
"""Subdivision: error of the control points against degree, polynomial and rational curves."""

from ..bundle import Missing
from ..wording import general
from .canvas import finish, panels, styled
from .method_lines import degree_axis, draw_methods, ends, error_axis, looks, series

ID = "subdivision-against-degree"
PARTS = (("subdivision-degree", "continuous", "Bezier curves"),
         ("subdivision-rational", "weights_mild", "rational curves, mild weights"),
         ("subdivision-rational", "weights_wild", "rational curves, wild weights"))


@styled
def draw(bundle):
    """Mean error over u p~ against the degree, a panel for each kind of curve."""
    table = bundle["subdivision.csv"]
    parts = []
    for study, generator, words in PARTS:
        rows = table.select(study=study, generator=generator)
        size = min((r["coordinate_range"] for r in rows), key=lambda value: abs(value - 1), default=None)
        lines = series([r for r in rows if r["coordinate_range"] == size], lambda r: r["degree"], "mean_error_u")
        if lines:
            parts.append((words, lines))
    if not parts:
        raise Missing("`subdivision.csv` has no row that a figure can show")
    canvas, axes = panels(len(parts), 1, height=2.4, sharex=True)
    look = looks(sorted({m for _, lines in parts for m in lines}))
    words = []
    for ax, (title, lines) in zip(axes[:, 0], parts):
        draw_methods(ax, lines, look)
        ax.set_title(title, loc="left")
        error_axis(ax)
        degree_axis(ax, {x for points in lines.values() for x, _ in points})
        ax.set_ylabel("mean error / (u p~)")
        best, worst, last = ends(lines)
        words.append(f"{title}: at the highest degree {best} has {general(last[best])}, {worst} {general(last[worst])}")
    axes[-1][0].set_xlabel("degree n")
    return finish(canvas, ID, "Mean error of the control points of both halves over u p~ against degree",
                  "分割曲线控制点的平均误差与阶数（以 u p~ 计）", "Doubly logarithmic. " + "; ".join(words) + ".", bottom=0.1)
