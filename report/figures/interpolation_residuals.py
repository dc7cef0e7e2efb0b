# SPDX-License-Identifier: MIT
"""C2 natural splines: the jump of second differences against the number of points."""

from ..bundle import Missing
from ..findings.splines import GOAL
from ..wording import general
from .canvas import DOTTED, finish, panels, styled
from .method_lines import degree_axis, draw_methods, ends, error_axis, looks, series

ID = "interpolation-residuals"
STUDY = "interpolation-points"


@styled
def draw(bundle):
    """Largest residual of C2 over u max|K| against the number of points, a line per method, and the goal."""
    lines = series(bundle["interpolation.csv"].select(study=STUDY), lambda r: r["points"], "max_c2_u")
    if not lines:
        raise Missing(f"`interpolation.csv` has no `{STUDY}` row that a figure can show")
    canvas, axes = panels(1, 1, height=2.7)
    ax = axes[0][0]
    ax.axhline(GOAL, color="0.4", linestyle=DOTTED, linewidth=0.9, label=f"goal, {GOAL}")
    draw_methods(ax, lines, looks(sorted(lines)))
    error_axis(ax)
    degree_axis(ax, {points for line in lines.values() for points, _ in line})
    ax.set_xlabel("points")
    ax.set_ylabel("largest C2 residual / (u max |K|)")
    best, worst, last = ends(lines)
    return finish(canvas, ID, "Largest C2 residual of natural splines against the number of points, random points",
                  "自然样条的最大 C2 残差与点数",
                  f"Doubly logarithmic. At the largest number of points {best} has {general(last[best])}, {worst} "
                  f"{general(last[worst])}; the goal is {GOAL}.", bottom=0.1)
