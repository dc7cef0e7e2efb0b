# SPDX-License-Identifier: MIT
"""One data set of each kind with its fits, as they stand in the bundle."""

from matplotlib.lines import Line2D
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from ..bundle import Missing
from ..wording import scientific
from .canvas import COLOURS, INK, finish, panels, styled

ID = "fitting-example"
STUDY = "fitting-cubics"
COLUMNS = 3


@styled
def draw(bundle):
    """A panel for each kind of data: the points, each method's curve, and where its segments join."""
    rows = bundle["fitting_example.csv"].some(study=STUDY)
    kinds = list(dict.fromkeys(r["data"] for r in rows))
    methods = [m for m in dict.fromkeys(r["method"] for r in rows) if m]
    canvas, axes = panels(-(-len(kinds) // COLUMNS), COLUMNS, height=2.6)
    texts = []
    for ax, kind in zip(axes.flat, kinds):
        ax.set_title(kind, loc="left")
        counts = [f"{method} {_draw_fit(ax, [r for r in rows if r['data'] == kind and r['method'] == method], i)}"
                  for i, method in enumerate(methods)]
        data = [r for r in rows if r["data"] == kind and not r["method"]]
        ax.plot([r["x"] for r in data], [r["y"] for r in data], linestyle="none", marker=".", markersize=3.5, color=INK, zorder=3)
        ax.set_xlabel(", ".join(counts), fontsize=8)
        ax.tick_params(labelsize=7)
        texts.append(f"{kind}: {', '.join(counts)}")
    for ax in axes.flat[len(kinds):]:
        ax.set_axis_off()
    handles = [Line2D([], [], color=COLOURS[i], marker="o", markerfacecolor="none", label=m) for i, m in enumerate(methods)]
    canvas.legend(handles=[*handles, Line2D([], [], color=INK, linestyle="none", marker=".", label="data")], loc="lower center",
                  ncol=len(methods) + 1, fontsize=9)
    return finish(canvas, ID, f"Data of cubics and their fits, tolerance {scientific(rows[0]['tolerance'])}; circles are joints; below, "
                  "the numbers of segments", "数据与分段拟合", "Segments by kind of data and method. " + "; ".join(texts) + ".",
                  bottom=0.35)


def _draw_fit(ax, rows, i):
    """Draws the segments by their control points; returns how many there are."""
    if not rows:
        raise Missing(f"`fitting_example.csv` has data of `{STUDY}` without a fit")
    points = [(r["x"], r["y"]) for r in rows]
    codes = [Path.MOVETO, Path.CURVE4, Path.CURVE4, Path.CURVE4] * (len(points) // 4)
    ax.add_patch(PathPatch(Path(points, codes), fill=False, edgecolor=COLOURS[i], linewidth=2.6 - 1.2 * i, zorder=1 + i))
    joints = points[0::4] + points[-1:]
    ax.plot(*zip(*joints), linestyle="none", marker="o", markersize=7 - 2.5 * i, markerfacecolor="none",
            markeredgecolor=COLOURS[i], zorder=4)
    return len(points) // 4
