# SPDX-License-Identifier: MIT
"""Derivatives: error against order, for curves about the origin and far from it."""

from ..bundle import Missing
from ..wording import general
from .canvas import finish, panels, styled
from .method_lines import draw_methods, ends, error_axis, looks, series

ID = "derivative-against-order"
DEGREE = 20
PARTS = (("derivative-order", "continuous", "control points in [-R, R]"),
         ("derivative-distant", "distant", "control points in [R (1 - 2^-20), R]"))


@styled
def draw(bundle):
    """Mean error over u p~ against the order, methods for control points, degree 20."""
    table = bundle["derivative.csv"]
    parts = []
    for study, generator, words in PARTS:
        lines = series(table.select(study=study, generator=generator, degree=DEGREE), lambda r: r["order"], "mean_error_u")
        if lines:
            parts.append((words, lines))
    if not parts:
        raise Missing(f"`derivative.csv` has no row of degree {DEGREE} that a figure can show")
    canvas, axes = panels(len(parts), 1, height=2.7)
    look = looks(sorted({m for _, lines in parts for m in lines}))
    words = []
    for ax, (title, lines) in zip(axes[:, 0], parts):
        draw_methods(ax, lines, look)
        title = title[0].upper() + title[1:]
        ax.set_title(title, loc="left")
        ax.set_xticks(sorted({k for points in lines.values() for k, _ in points}))
        ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        error_axis(ax)
        ax.set_ylabel("mean error / (u p~)")
        best, worst, last = ends(lines)
        words.append(f"{title}: at the highest order {best} has {general(last[best])}, {worst} {general(last[worst])}")
    axes[-1][0].set_xlabel("order k")
    return finish(canvas, ID, f"Mean error of derivatives over u p~ against the order, degree {DEGREE}",
                  f"{DEGREE} 阶曲线导数的平均误差与导数阶数（以 u p~ 计）", "Logarithmic in the error. " + "; ".join(words) + ".",
                  bottom=0.1)
