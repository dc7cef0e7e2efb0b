# SPDX-License-Identifier: MIT
"""Points on grids: largest error against the number of points."""

from ..bundle import Missing
from ..wording import general
from .canvas import finish, panels, styled
from .method_lines import draw_methods, ends, error_axis, looks, series

ID = "grid-against-points"
STUDY = "grid-points"


@styled
def draw(bundle):
    """Largest error over u p~ against the number of points, a panel for each degree."""
    rows = bundle["grid.csv"].select(study=STUDY)
    parts = []
    for degree in sorted({r["degree"] for r in rows}):
        lines = series([r for r in rows if r["degree"] == degree], lambda r: r["points"], "max_error_u")
        if lines:
            parts.append((f"degree {degree}", lines))
    if not parts:
        raise Missing("`grid.csv` has no row that a figure can show")
    canvas, axes = panels(len(parts), 1, height=2.4, sharex=True)
    look = looks(sorted({m for _, lines in parts for m in lines}))
    words = []
    for ax, (title, lines) in zip(axes[:, 0], parts):
        draw_methods(ax, lines, look)
        ax.set_title(title, loc="left")
        error_axis(ax)
        ax.set_xscale("log")
        ax.set_ylabel("largest error / (u p~)")
        best, worst, last = ends(lines)
        words.append(f"{title}: on the finest grid {best} has {general(last[best])}, {worst} {general(last[worst])}")
    axes[-1][0].set_xlabel("points of the grid")
    return finish(canvas, ID, "Largest error of the points of a grid over u p~ against their number",
                  "网格点的最大误差与点数（以 u p~ 计）", "Doubly logarithmic. " + "; ".join(words) + ".", bottom=0.1)
