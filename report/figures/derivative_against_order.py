# SPDX-License-Identifier: MIT
"""Derivatives: error against order, for curves about the origin and far from it."""

from ..bundle import Missing
from .canvas import finish, styled
from .method_lines import series
from .stacked import stacked

ID = "derivative-against-order"
DEGREE = 20
PARTS = (("derivative-order", "continuous", "Control points in [-R, R]"),
         ("derivative-distant", "distant", "Control points in [R (1 - 2^-20), R]"))


def _orders(ax, lines):
    ax.set_xticks(sorted({k for points in lines.values() for k, _ in points}))
    ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")


@styled
def draw(bundle):
    """Mean error over u p~ against the order, methods for control points, degree 20."""
    table = bundle["derivative.csv"]
    parts = []
    for study, generator, title in PARTS:
        lines = series(table.select(study=study, generator=generator, degree=DEGREE), lambda r: r["order"], "mean_error_u")
        if lines:
            parts.append((title, lines))
    if not parts:
        raise Missing(f"`derivative.csv` has no row of degree {DEGREE} that a figure can show")
    canvas, lowest, words = stacked(parts, _orders, "mean error / (u p~)", "at the highest order", height=2.7)
    lowest.set_xlabel("order k")
    return finish(canvas, ID, f"Mean error of derivatives over u p~ against the order, degree {DEGREE}",
                  f"{DEGREE} 阶曲线导数的平均误差与导数阶数（以 u p~ 计）", "Logarithmic in the error. " + words + ".",
                  bottom=0.1)
