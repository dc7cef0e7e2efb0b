# SPDX-License-Identifier: MIT
"""Time per point against the largest error, with what is known of both: intervals of the time, bounds of the error."""

import math

from ..answer import useful
from ..bundle import Missing
from ..findings.times import ON, race_cell
from ..methods import FORM
from ..wording import general
from .canvas import COLOURS, FAINT, belongs, finish, panels, styled
from .method_lines import beside

ID = "time-against-error"
MARKS = ("o", "s", "^", "D", "v", "P", "X")
PANELS = 3


@styled
def draw(bundle):
    """A panel for the lowest, a middle and the highest degree of the first form; filled marks are on the front."""
    rows = bundle["pareto.csv"].rows
    curve = rows[0]["curve"] if rows else None
    degrees = race_cell([r for r in rows if useful(r["observed_max_u"], r["scalar"])], curve)
    if not degrees:
        raise Missing("`pareto.csv` has no times in double, mode `point`, of a method that is useful")
    values = list(degrees)
    shown = sorted({values[0], values[len(values) // 2], values[-1]})[:PANELS]
    methods = list(dict.fromkeys(r["method"] for n in shown for r in degrees[n]))
    canvas, axes = panels(len(shown), 1, height=3.0)
    words = []
    for ax, n in zip(axes[:, 0], shown):
        for row in degrees[n]:
            mark(ax, row, methods.index(row["method"]))
            words.append(f"degree {n:g}, {row['method']}: {general(row['ns'])} ns, {general(row['observed_max_u'])} u p~"
                         + (" (on the front)" if row["pareto"] == ON else ""))
        ax.set_xscale("log")
        ax.set_yscale("log")
        ax.axhline(1, color=FAINT, linewidth=0.9)
        ax.set_title(f"degree {n:g}", loc="left")
        ax.set_ylabel("largest error, u p~")
        beside(ax)
    axes[-1][0].set_xlabel(f"ns per point, {FORM.get(curve, (curve,))[0]}, one point at a time, double")
    return finish(canvas, ID, "Time per point against the largest error seen; the thin line upwards ends at the proved bound, "
                  "filled marks are worth choosing, useless methods are left out", "每点用时与最大误差", "Doubly logarithmic. " + "; ".join(words) + ".", bottom=0.1)


def mark(ax, row, index):
    """A method: its error, the interval of its time, and its bound."""
    time, error = row["ns"], row["observed_max_u"]
    if not (isinstance(error, float) and math.isfinite(error) and error > 0):
        return
    colour = COLOURS[index % len(COLOURS)]
    extent = ax.plot([row["ns_low"], row["ns_high"]], [error, error], color=colour, linewidth=2.2)
    bound = row["bound_u"]
    if isinstance(bound, float) and math.isfinite(bound) and bound > error:
        extent += ax.plot([time, time], [error, bound], color=colour, linewidth=0.8)
        extent += ax.plot([time], [bound], color=colour, marker="_", markersize=6)
    belongs(row["method"], *extent)
    point, = ax.plot([time], [error], linestyle="none", marker=MARKS[index // len(COLOURS) % len(MARKS)], markersize=7,
            markerfacecolor=colour if row["pareto"] == ON else "none", markeredgecolor=colour, markeredgewidth=1.3,
            label=row["method"])
    point.rows = [row]
