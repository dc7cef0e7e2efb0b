# SPDX-License-Identifier: MIT
"""Curves in the plane as a bundle has them."""

from matplotlib.lines import Line2D
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from ..bundle import Missing
from ..wording import general, scientific, span
from .canvas import COLOURS, FAINT, INK, belongs, figure, finish, panels
from .colours import looks

STUDY = "fitting-cubics"
COLUMNS = 3
SPACED = {"inverse_arc_length-tolerance": "random curve", "inverse_arc_length-cusp": "curve that stops inside"}
SPACINGS = {"parameter": "equal steps of t", "arc_length": "equal steps of the length"}


@figure
def fitting_example(bundle):
    """A panel for each kind of data: the points, each method's curve, and where its segments join."""
    rows = bundle["fitting_example.csv"].some(study=STUDY)
    kinds = list(dict.fromkeys(r["data"] for r in rows))
    methods = [m for m in dict.fromkeys(r["method"] for r in rows) if m]
    canvas, axes, look = *panels(-(-len(kinds) // COLUMNS), COLUMNS, height=2.6), looks(bundle, methods)
    texts = []
    for ax, kind in zip(axes.flat, kinds):
        ax.set_title(kind, loc="left")
        counts = [f"{method} {_draw_fit(ax, [r for r in rows if r['data'] == kind and r['method'] == method], i, look[method]['color'])}"
                  for i, method in enumerate(methods)]
        data = [r for r in rows if r["data"] == kind and not r["method"]]
        ax.plot([r["x"] for r in data], [r["y"] for r in data], linestyle="none", marker=".", markersize=3.5, color=INK, zorder=3)
        ax.set_xlabel(", ".join(counts), fontsize=8)
        ax.tick_params(labelsize=7)
        texts.append(f"{kind}: {', '.join(counts)}")
    for ax in axes.flat[len(kinds):]:
        ax.set_axis_off()
    handles = [Line2D([], [], color=look[m]["color"], marker="o", markerfacecolor="none", label=m) for m in methods]
    canvas.legend(handles=[*handles, Line2D([], [], color=INK, linestyle="none", marker=".", label="data")], loc="lower center",
                  ncol=len(methods) + 1, fontsize=9)
    return finish(canvas, "fitting-example", f"Data of cubics and their fits, tolerance {scientific(rows[0]['tolerance'])}; circles are joints; below, "
                  "the numbers of segments", "Segments by kind of data and method. " + "; ".join(texts) + ".",
                  bottom=0.35)


def _draw_fit(ax, rows, i, colour):
    """Draws the segments by their control points; returns how many there are."""
    if not rows:
        raise Missing(f"`fitting_example.csv` has data of `{STUDY}` without a fit")
    points = [(r["x"], r["y"]) for r in rows]
    codes = [Path.MOVETO, Path.CURVE4, Path.CURVE4, Path.CURVE4] * (len(points) // 4)
    joints = points[0::4] + points[-1:]
    line, = ax.plot(*zip(*joints), linestyle="none", marker="o", markersize=7 - 2.5 * i, markerfacecolor="none", markeredgecolor=colour, zorder=4)
    line.series_name, line.reads = rows[0]["method"], [f"joint {k} of {len(joints) - 1} segments" for k in range(len(joints))]
    belongs(rows[0]["method"], ax.add_patch(PathPatch(Path(points, codes), fill=False, edgecolor=colour, linewidth=2.6 - 1.2 * i, zorder=1 + i)))
    return len(points) // 4


@figure
def spacing(bundle):
    """A row for each curve: its outline, with points of the one and of the other spacing."""
    table = bundle["spacing.csv"]
    studies = [s for s in SPACED if table.select(study=s, dimension=2)]
    if not studies:
        raise Missing("`spacing.csv` has no planar curve of the studies that a figure shows")
    canvas, axes = panels(len(studies), len(SPACINGS), height=2.9)
    texts = []
    for row, study in zip(axes, studies):
        outline = table.select(study=study, spacing="outline")
        for ax, (spacing, words), colour in zip(row, SPACINGS.items(), COLOURS):
            points = table.select(study=study, spacing=spacing)
            gaps = [p["gap"] for p in points if p["gap"] is not None]
            ax.plot([p["x"] for p in outline], [p["y"] for p in outline], color=FAINT, linewidth=1)
            line, = ax.plot([p["x"] for p in points], [p["y"] for p in points], color=colour, linestyle="none", marker="o", markersize=4)
            line.series_name = words
            line.reads = [f"point {k}" + (f", {general(p['gap'], 2)} of the mean gap from the last" if p["gap"] is not None else "") for k, p in enumerate(points)]
            ax.set_aspect("equal", adjustable="datalim")
            ax.set_title(f"{SPACED[study][0].upper()}{SPACED[study][1:]}, {words}", loc="left")
            if gaps:
                texts.append(f"{SPACED[study]}, {words}: gaps of {span(min(gaps), max(gaps), lambda gap: f'{gap:.2f}')} of the mean")
    return finish(canvas, "spacing", "Points at equal steps of t, left, and at equal steps of the length, right", "; ".join(texts) + ".", bottom=0.1)
