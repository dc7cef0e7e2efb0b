# SPDX-License-Identifier: MIT
"""Rational curves: every method by degree, a panel for each generator of weights."""

from ..bundle import Missing
from ..wording import general
from .canvas import finish, panels, styled
from .method_lines import degree_axis, draw_methods, ends, error_axis, looks, series

ID = "rational-against-degree"


@styled
def draw(bundle):
    """Mean error over u p~ against degree in double, of the first study that varies the degree."""
    table = bundle.exact("rational")
    ladders = [s for s in table.distinct("study", scalar="double") if len(table.distinct("degree", study=s)) > 1]
    if not ladders:
        raise Missing("`accuracy.csv` has no `rational-` study in double that varies the degree")
    generators = table.distinct("generator", study=ladders[0], scalar="double")
    canvas, axes = panels(len(generators), 1, height=2.7, sharex=True, sharey=True)
    words = []
    look = looks(table.distinct("method", study=ladders[0], scalar="double"))
    for ax, generator in zip(axes[:, 0], generators):
        lines = series(table.select(study=ladders[0], scalar="double", generator=generator), lambda r: r["degree"], "mean_error_u")
        draw_methods(ax, lines, look)
        ax.set_title(f"{generator} inputs", loc="left")
        error_axis(ax)
        degree_axis(ax, {x for points in lines.values() for x, _ in points})
        ax.set_ylabel("mean error / (u p~)")
        best, worst, last = ends(lines)
        words.append(f"{generator}: at the highest degree {best} has {general(last[best])}, {worst} {general(last[worst])}")
    axes[-1][0].set_xlabel("degree n")
    return finish(canvas, ID, "Rational curves: mean error over u p~ against degree", "有理曲线：平均误差与阶数（以 u p~ 计）",
                  "Doubly logarithmic. " + "; ".join(words) + ".", bottom=0.1)
