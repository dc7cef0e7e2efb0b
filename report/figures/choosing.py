# SPDX-License-Identifier: MIT
"""Time per point against the largest error, with what is known of both: intervals of the time, bounds of the error."""

import math

from ..answer import FORMS, NO_TIME, candidates, default_cell, useful
from ..bundle import Missing
from ..findings.times import ON, race_cell
from ..methods import FORM
from ..wording import general, shortest
from .canvas import COLOURS, FAINT, belongs, figure, finish, panels
from .lines import beside

MARKS = ("o", "s", "^", "D", "v", "P", "X")
PANELS = 3


@figure
def answer_cell(bundle):
    """One panel; useless methods are left out, so that they do not stretch the axis."""
    cells = candidates(bundle)
    cell = default_cell(cells) if cells else None
    members = [one for one in cells.get(cell, ()) if useful(one.error_u, cell.scalar)]
    if not members or cell.mode == NO_TIME:
        raise Missing("`pareto.csv` has no times")
    canvas, axes = panels(1, 1, height=max(3.4, 0.17 * len(members)))
    ax = axes[0][0]
    for index, one in enumerate(members):
        _mark(ax, one.timed, index)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.axhline(1, color=FAINT, linewidth=0.9)
    ax.set_xlabel("ns per point")
    ax.set_ylabel("largest error seen, u p~")
    beside(ax)
    words = "; ".join(f"{one.method}: {general(one.ns)} ns, {general(one.error_u)} u p~" for one in members)
    return finish(canvas, "answer-figure", f"Time against the largest error seen, {FORMS.get(cell.form, cell.form)}, degree {shortest(cell.degree)}; "
                  "the thin line upwards ends at the proved bound, filled marks are worth choosing", "用时与最大误差",
                  f"Doubly logarithmic. {words}.", bottom=0.1)


@figure
def time_against_error(bundle):
    """A panel for the lowest, a middle and the highest degree of the first form; filled marks are on the front."""
    rows = bundle["pareto.csv"].rows
    curve = rows[0]["form"] if rows else None
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
            _mark(ax, row, methods.index(row["method"]))
            words.append(f"degree {n:g}, {row['method']}: {general(row['ns'])} ns, {general(row['observed_max_u'])} u p~"
                         + (" (on the front)" if row["pareto"] == ON else ""))
        ax.set_xscale("log")
        ax.set_yscale("log")
        ax.axhline(1, color=FAINT, linewidth=0.9)
        ax.set_title(f"degree {n:g}", loc="left")
        ax.set_ylabel("largest error, u p~")
        beside(ax)
    axes[-1][0].set_xlabel(f"ns per point, {FORM.get(curve, (curve,))[0]}, one point at a time, double")
    return finish(canvas, "time-against-error", "Time per point against the largest error seen; the thin line upwards ends at the proved bound, "
                  "filled marks are worth choosing, useless methods are left out", "每点用时与最大误差", "Doubly logarithmic. " + "; ".join(words) + ".", bottom=0.1)


def _mark(ax, row, index):
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
