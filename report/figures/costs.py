# SPDX-License-Identifier: MIT
"""What accuracy costs: errors against evaluations, segments and times."""

import math

from ..answer import FORMS, NO_TIME, candidates, default_cell, useful
from ..bundle import Missing
from ..findings.times import ON, race_cell
from ..methods import FORM
from ..rows import distinct, grouped
from ..time_tables import fits_with_times
from ..wording import general, shortest
from .canvas import FAINT, belongs, figure, finish, panels
from .colours import chosen, leading, looks
from .lines import beside, draw_methods, positive, sentence_case

MEASURED = {"continuous": "random cubics", "integer": "cubics with small whole coordinates: cusps, turns, loops"}
FITTED = {"samples": "samples of cubics", "noisy": "samples with noise of 2^-10 R", "polyline": "points along control polygons"}
COSTS = {"max_error": "largest error", "mean_segments": "mean segments"}
PANELS = 3


def _by_method(rows, x, y):
    """{method: (x, y) in the order of the rows}, where both are positive."""
    return {method: points for method, own in grouped(rows, "method").items()
            if (points := [(r[x], r[y]) for r in own if positive(r, x) and positive(r, y)])}


def _against_cost(bundle, figure_id, caption, parts, x, unit, height):
    """Lines in double logarithmic panels. `parts` are lines of panels, each (title, what goes up, {method: points}); `unit` is that of x."""
    look = looks(bundle, sorted({method for line in parts for *_, methods in line for method in methods}))
    canvas, axes = panels(len(parts), len(parts[0]), height=height)
    words = []
    for line, shown in zip(axes, parts):
        for ax, (title, y, methods) in zip(line, shown):
            draw_methods(ax, methods, look)
            if ax is not line[-1]:
                ax.get_legend().remove()
            ax.set_title(title, loc="left")
            ax.set_xscale("log")
            ax.set_yscale("log")
            ax.set_ylabel(y)
            words += [f"{title or shown[0][0]}, {y}: " + ", ".join(
                f"{m} ends at {general(points[-1][0])} {unit} with {general(points[-1][1])}" for m, points in methods.items())]
    for ax in axes[-1]:
        ax.set_xlabel(x)
    return finish(canvas, figure_id, caption, f"Doubly logarithmic. {'; '.join(words)}.", bottom=0.1)


def _kinds(table, study, column, kinds, x, y, **key):
    """A panel for each kind of inputs that has points; Missing where none has."""
    parts = [[(sentence_case(words), "largest error" if y == "max_error" else "largest relative error", lines)] for kind, words in kinds.items()
             if (lines := _by_method(sorted(table.select(study=study, **{column: kind}, **key), key=lambda r: -r["tolerance"]), x, y))]
    if not parts:
        raise Missing(f"`{table.file}` has no `{study}` row that a figure can show")
    return parts


@figure
def arc_length_evaluations(bundle):
    """Largest relative error against the mean number of evaluations, a point for each tolerance."""
    parts = _kinds(bundle["arc_length.csv"], "arc_length-tolerance", "generator", MEASURED, "mean_evaluations", "max_relative", degree=3)
    return _against_cost(bundle, "arc-length-evaluations", "Largest relative error of an arc length against the number of evaluations, a point for "
                         "each tolerance", parts, "mean evaluations", "evaluations", 2.7)


@figure
def fitting_segments(bundle):
    """Largest true error against the mean number of segments, a point for each tolerance."""
    parts = _kinds(bundle["fitting.csv"], "fitting-cubics", "data", FITTED, "mean_segments", "max_error", dimension=2)
    return _against_cost(bundle, "fitting-segments", "Largest true error of fits against the number of segments, a point for each tolerance",
                         parts, "mean number of segments", "segments", 2.4)


@figure
def fitting_time(bundle):
    """Largest true error and mean segments against the time of a fit, a point for each tolerance."""
    pairs = sorted(fits_with_times(bundle), key=lambda pair: -pair[0]["tolerance"])

    def lines(data, column):
        found = {}
        for time, fit in pairs:
            if time["data"] == data and positive(fit, column):
                found.setdefault(time["method"], []).append((time["median_ns"] / 1e3, fit[column]))
        return found
    parts = [[(sentence_case(words) if column == "max_error" else "", label, lines(data, column)) for column, label in COSTS.items()]
             for data, words in FITTED.items() if any(time["data"] == data for time, _ in pairs)]
    return _against_cost(bundle, "fitting-time", "Largest true error and number of segments against the time of a fit, a point for each tolerance", parts,
                         "µs per fit", "µs", 2.3)


@figure
def answer_cell(bundle):
    """One panel; useless methods are left out, so that they do not stretch the axis."""
    cells = candidates(bundle)
    cell = default_cell(cells) if cells else None
    members = [one for one in cells.get(cell, ()) if useful(one.error_u, cell.scalar)]
    if not members or cell.mode == NO_TIME:
        raise Missing("`pareto.csv` has no times")
    canvas, axes = panels(1, 1, height=3.6)
    methods = [one.method for one in members]
    shown = leading(bundle, methods, methods.index)
    _marks(bundle, axes[0][0], [one.timed for one in members], shown)
    axes[0][0].set_xlabel("ns per point")
    words = "; ".join(f"{one.method}: {general(one.ns)} ns, {general(one.error_u)} u p~" for one in members)
    return finish(canvas, "answer-figure", f"Time against the largest observed error, {FORMS.get(cell.form, cell.form)}, degree {shortest(cell.degree)}; "
                  f"the thin line upwards ends at the proved bound, filled marks are not dominated",
                  f"Doubly logarithmic. {words}.", bottom=0.1, note=_grey(shown, methods))


def _grey(shown, methods):
    return f"{chosen(shown, methods)}; the others are grey" if len(shown) < len(methods) else ""


@figure
def time_against_error(bundle, whole=False):
    """A panel for the lowest, a middle and the highest degree of the first form; filled marks are on the front."""
    rows = bundle["pareto.csv"].rows
    curve = rows[0]["form"] if rows else None
    degrees = race_cell([r for r in rows if useful(r["observed_max_u"], r["scalar"])], curve)
    if not degrees:
        raise Missing("`pareto.csv` has no times in double, mode `point`, of a method that is useful")
    values = list(degrees)
    drawn = sorted({values[0], values[len(values) // 2], values[-1]})[:PANELS]
    methods = distinct((r for n in drawn for r in degrees[n]), "method")
    shown = methods if whole else leading(bundle, methods, methods.index)
    canvas, axes = panels(len(drawn), 1, height=3.0)
    words = []
    for ax, n in zip(axes[:, 0], drawn):
        _marks(bundle, ax, degrees[n], shown)
        words += [f"degree {n:g}, {row['method']}: {general(row['ns'])} ns, {general(row['observed_max_u'])} u p~"
                  + (" (on the front)" if row["pareto"] == ON else "") for row in degrees[n]]
        ax.set_title(f"degree {n:g}", loc="left")
    axes[-1][0].set_xlabel(f"ns per point, {FORM.get(curve, (curve,))[0]}, one point at a time, double")
    return finish(canvas, "time-against-error", "Time per point against the largest observed error; the thin line upwards ends at the proved bound, "
                  f"filled marks are not dominated, useless methods are left out",
                  f"Doubly logarithmic. {'; '.join(words)}.", bottom=0.1, note=_grey(shown, methods),
                  more=(lambda: time_against_error(bundle, True)) if len(shown) < len(methods) else None)


def _marks(bundle, ax, rows, shown):
    """Errors up, times across, on logarithmic axes."""
    look = looks(bundle, shown)
    for row in rows:
        _mark(ax, row, look.get(row["method"]))
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.axhline(1, color=FAINT, linewidth=0.9)
    ax.set_ylabel("largest observed error, u p~")
    beside(ax)


def _mark(ax, row, look):
    """A method: its error, the interval of its time, and its bound; a grey point where it has no look of its own."""
    time, error, bound = row["ns"], row["observed_max_u"], row["bound_u"]
    if not positive(row, "observed_max_u"):
        return
    if look is None:
        point, = ax.plot([time], [error], linestyle="none", marker=".", markersize=5, color=FAINT)
    else:
        colour = look["color"]
        extent = ax.plot([row["ns_low"], row["ns_high"]], [error, error], color=colour, linewidth=2.2)
        if isinstance(bound, float) and math.isfinite(bound) and bound > error:
            extent += ax.plot([time, time], [error, bound], color=colour, linewidth=0.8)
            extent += ax.plot([time], [bound], color=colour, marker="_", markersize=6)
        belongs(row["method"], *extent)
        point, = ax.plot([time], [error], linestyle="none", marker=look["marker"], markersize=7, markerfacecolor=colour if row["pareto"] == ON else "none",
                         markeredgecolor=colour, markeredgewidth=1.3, label=row["method"])
    point.series_name, point.rows = row["method"], [row]
