# SPDX-License-Identifier: MIT
"""Points on grids: largest error against the number of points."""

from ..bundle import Missing
from .canvas import finish, styled
from .method_lines import series
from .stacked import stacked

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
            parts.append((f"degree {degree:g}", lines))
    if not parts:
        raise Missing("`grid.csv` has no row that a figure can show")
    canvas, lowest, words = stacked(parts, lambda ax, lines: ax.set_xscale("log"), "largest error / (u p~)", "on the finest grid",
                                    sharex=True)
    lowest.set_xlabel("points of the grid")
    return finish(canvas, ID, "Largest error of the points of a grid over u p~ against their number",
                  "网格点的最大误差与点数（以 u p~ 计）", "Doubly logarithmic. " + words + ".", bottom=0.1)
