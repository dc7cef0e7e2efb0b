# SPDX-License-Identifier: MIT
"""The figures of the suites whose methods are lines: errors, evaluations, segments and shares of the peak."""

from ..bundle import Missing
from ..error_tables import named, swept
from ..findings.splines import GOAL
from ..methods import FORM
from ..tables import axis_label, axis_value
from ..time_tables import fits_with_times
from ..wording import general
from .canvas import DOTTED, FAINT, figure, finish, log_axis, panels
from .lines import (beside, best_and_worst, conversion, costs, degree_axis, draw_methods, draw_paths, ends_at, looks,
                    path_colours, positive, sentence_case, series, stacked)

SUBDIVIDED = (("subdivision-degree", "continuous", "Bezier curves"),
              ("subdivision-rational", "weights_mild", "rational curves, mild weights"),
              ("subdivision-rational", "weights_wild", "rational curves, wild weights"))
DERIVED = (("derivative-order", "continuous", "Control points in [-R, R]"),
           ("derivative-distant", "distant", "Control points in [R (1 - 2^-20), R]"))
DERIVED_DEGREE = 20
MEASURED = {"continuous": "random cubics", "integer": "cubics with small whole coordinates: cusps, turns, loops"}
FITTED = {"samples": "samples of cubics", "noisy": "samples with noise of 2^-10 R", "polyline": "points along control polygons"}
LADDER_GENERATOR = "continuous"
APART = 1e3  # what ends above this many u p~ has a panel of its own: on its axis the others would be one line
LADDER = tuple(f"{how}, ending {where} {APART:g} u p~" for how in ("evaluated in the given form", "converted first, one line per path")
               for where in ("below", "above"))
REGIMES_AXIS = {"interval": "interval of t", "coordinate_range": "range R (coordinates in [-R, R])", "degree": "degree n"}
PEAK_SCALAR = "double"
COSTS = (("max_error", "largest error", general), ("mean_segments", "mean segments", general))
MEAN, LARGEST = "mean error / (u p~)", "largest error / (u p~)"


def _parts(file, named_rows, x, column):
    """[(title, {method: points})] of the parts that have points; Missing where none has."""
    parts = [(title, lines) for title, rows in named_rows if (lines := series(rows, x, column))]
    if not parts:
        raise Missing(f"`{file}` has no row that a figure can show")
    return parts


@figure
def subdivision_against_degree(bundle):
    """Mean error over u p~ against the degree, a panel for each kind of curve."""
    def named_rows():
        for study, generator, title in SUBDIVIDED:
            rows = bundle["subdivision.csv"].select(study=study, generator=generator)
            size = min((r["coordinate_range"] for r in rows), key=lambda value: abs(value - 1), default=None)
            yield title, [r for r in rows if r["coordinate_range"] == size]
    return stacked("subdivision-against-degree", ("Mean error of the control points of both halves over u p~ against degree",
                                                  "分割曲线控制点的平均误差与阶数（以 u p~ 计）"),
                   _parts("subdivision.csv", named_rows(), "degree", "mean_error_u"), "degree n", MEAN, sharex=True)


@figure
def bspline_against_degree(bundle):
    """Largest error over u p~ against the degree, a panel for each kind of knots."""
    rows = [r for study in ("bspline-degree", "bspline-high_degree") for r in bundle["bspline.csv"].select(study=study)]
    parts = ((f"{knots} knots", [r for r in rows if r["knots"] == knots]) for knots in dict.fromkeys(r["knots"] for r in rows))
    return stacked("bspline-against-degree", ("Largest error of points of B-spline curves over u p~ against degree",
                                              "B 样条曲线点的最大误差与阶数（以 u p~ 计）"),
                   _parts("bspline.csv", parts, "degree", "max_error_u"), "degree n", LARGEST, sharex=True, bottom=0.08)


@figure
def grid_against_points(bundle):
    """Largest error over u p~ against the number of points, a panel for each degree."""
    rows = bundle["grid.csv"].select(study="grid-points")
    parts = ((f"degree {degree:g}", [r for r in rows if r["degree"] == degree]) for degree in sorted({r["degree"] for r in rows}))
    return stacked("grid-against-points", ("Largest error of the points of a grid over u p~ against their number",
                                           "网格点的最大误差与点数（以 u p~ 计）"),
                   _parts("grid.csv", parts, "points", "max_error_u"), "points of the grid", LARGEST, sharex=True,
                   across=lambda ax, lines: ax.set_xscale("log"), words=best_and_worst("on the finest grid"))


@figure
def derivative_against_order(bundle):
    """Mean error over u p~ against the order, methods for control points, degree 20."""
    def orders(ax, lines):
        ax.set_xticks(sorted({k for points in lines.values() for k, _ in points}))
        ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    parts = ((title, bundle["derivative.csv"].select(study=study, generator=generator, degree=DERIVED_DEGREE))
             for study, generator, title in DERIVED)
    return stacked("derivative-against-order", (f"Mean error of derivatives over u p~ against the order, degree {DERIVED_DEGREE}",
                                                f"{DERIVED_DEGREE} 阶曲线导数的平均误差与导数阶数（以 u p~ 计）"),
                   _parts("derivative.csv", parts, "order", "mean_error_u"), "order k", MEAN, across=orders, height=2.7,
                   words=best_and_worst("at the highest order"), scale="Logarithmic in the error")


@figure
def rational_against_degree(bundle):
    """Mean error over u p~ against degree in double, of the first study that varies the degree; a panel for each generator."""
    table = bundle.exact("rational")
    ladders = [s for s in table.distinct("study", scalar="double") if len(table.distinct("degree", study=s)) > 1]
    if not ladders:
        raise Missing("`accuracy.csv` has no `rational-` study in double that varies the degree")
    key = {"study": ladders[0], "scalar": "double"}
    parts = ((f"{generator} inputs", table.select(generator=generator, **key)) for generator in table.distinct("generator", **key))
    return stacked("rational-against-degree", ("Rational curves: mean error over u p~ against degree", "有理曲线：平均误差与阶数（以 u p~ 计）"),
                   _parts("accuracy.csv", parts, "degree", "mean_error_u"), "degree n", MEAN, look=looks(table.distinct("method", **key)),
                   height=2.7, sharex=True, sharey=True)


@figure
def peers_against_degree(bundle):
    """Mean error over u p~ against degree and, where the bundle has them, nanoseconds per prepared point."""
    quantities = [(MEAN, bundle.exact("peers").select(form="bernstein", scalar="double", dimension=2), "mean_error_u")]
    try:
        times = [r for r in bundle["timing.csv"].of_suite("peers").rows if r["mode"] == "point" and r["degree"] is not None]
        quantities.append(("ns per point", times, "median_ns"))
    except Missing:
        pass  # a run may leave timings out
    parts = [(label, lines) for label, rows, column in quantities if (lines := series(rows, "degree", column))]
    if not parts:
        raise Missing("`accuracy.csv` has no errors in a study whose id starts with `peers-`")
    return stacked("peers-against-degree", ("Other libraries: error and time against degree", "其他程序库：误差、用时与阶数"), parts, "degree n",
                   None, look=looks(list(dict.fromkeys(method for _, lines in parts for method in lines))), height=3, sharex=True)


@figure
def ladder_against_degree(bundle):
    """Mean error over u p~ against degree, continuous inputs: per form of curve, the evaluators, then the paths."""
    table = bundle.exact("ladder")
    parts = []
    for curve in table.distinct("form"):
        lines = series(table.select(form=curve, generator=LADDER_GENERATOR, scalar="double", dimension=2), "degree", "mean_error_u")
        for kind in LADDER:
            some = {m: points for m, points in lines.items() if LADDER[2 * bool(conversion(m)) + (points[-1][1] >= APART)] == kind}
            if some:
                parts.append((sentence_case(f"{FORM.get(curve, (curve,))[0]}, {kind}"), some))
    if not parts:
        raise Missing(f"`accuracy.csv` has no `ladder-` row with `{LADDER_GENERATOR}` inputs")
    methods = list(dict.fromkeys(method for _, some in parts for method in some))
    colours = path_colours(methods)

    def draw(ax, some, look):
        draw_paths(ax, some, colours) if conversion(next(iter(some))) else draw_methods(ax, some, look)
    return stacked("ladder-against-degree", ("Mean error over u p~ against degree, every method, continuous inputs",
                                             "各方法的平均误差与阶数（以 u p~ 计）"), parts, "degree n", MEAN, look=looks(methods), height=2.7, draw=draw)


@figure
def interpolation_residuals(bundle):
    """Largest residual of C2 over u max|K| of natural splines against the number of points, a line per method, and the goal."""
    def draw(ax, lines, look):
        ax.axhline(GOAL, color="0.4", linestyle=DOTTED, linewidth=0.9, label=f"goal, {GOAL}")
        draw_methods(ax, lines, look)
    lines = series(bundle["interpolation.csv"].select(study="interpolation-points"), "points", "max_c2_u")
    if not lines:
        raise Missing("`interpolation.csv` has no `interpolation-points` row that a figure can show")
    return stacked("interpolation-residuals", ("Largest C2 residual of natural splines against the number of points, random points",
                                               "自然样条的最大 C2 残差与点数"), [("", lines)], "points", "largest C2 residual / (u max |K|)",
                   height=2.7, draw=draw, words=best_and_worst("at the largest number of points"), also=f"; the goal is {GOAL}")


@figure
def arc_length_evaluations(bundle):
    """Largest relative error against the mean number of evaluations, a point for each tolerance."""
    table = bundle["arc_length.csv"]
    parts = [(sentence_case(words), {m: sorted(points) for m, points in lines.items()}) for generator, words in MEASURED.items()
             if (lines := costs(table.select(study="arc_length-tolerance", degree=3, generator=generator), "mean_evaluations", "max_relative"))]
    if not parts:
        raise Missing("`arc_length.csv` has no `arc_length-tolerance` row of degree 3 that a figure can show")
    return stacked("arc-length-evaluations", ("Largest relative error of an arc length against the evaluations that it took, a point for each "
                                              "tolerance", "弧长最大相对误差与求值次数"), parts, "mean evaluations", "largest relative error",
                   across=lambda ax, lines: ax.set_xscale("log"), look=looks(sorted({m for _, lines in parts for m in lines}), "o"),
                   height=2.7, words=ends_at("evaluations"))


@figure
def fitting_segments(bundle):
    """Largest true error against the mean number of segments, a point for each tolerance."""
    def across(ax, _lines):
        ax.set_xscale("log")
        log_axis(ax.xaxis, (1, 2, 5, 10, 20, 50))
    parts = []
    for data, words in FITTED.items():
        rows = sorted(bundle["fitting.csv"].select(study="fitting-cubics", dimension=2, data=data), key=lambda r: -r["tolerance"])
        if lines := costs(rows, "mean_segments", "max_error"):
            parts.append((sentence_case(words), lines))
    if not parts:
        raise Missing("`fitting.csv` has no `fitting-cubics` row that a figure can show")
    return stacked("fitting-segments", ("Largest true error of fits against the number of segments, a point for each tolerance",
                                        "拟合误差与段数"), parts, "mean number of segments", "largest error", across=across,
                   look=looks(sorted({m for _, lines in parts for m in lines}), "o"), words=ends_at("segments"))


@figure
def share_of_peak(bundle):
    """Methods in double; the line at 100 % is the peak of fused multiply-adds."""
    rows = [r for r in bundle["roofline.csv"].rows if r["scalar"] == PEAK_SCALAR and r["share_of_peak"] is not None]
    if not rows:
        raise Missing(f"`roofline.csv` has no share of a peak in {PEAK_SCALAR}")
    axes_drawn = min(r["dimension"] for r in rows if r["dimension"] >= 2 or all(o["dimension"] < 2 for o in rows))
    rows = [r for r in rows if r["dimension"] == axes_drawn]
    targets = list(dict.fromkeys(r["target"] for r in rows))
    look = looks(list(dict.fromkeys(r["method"] for r in rows)))
    canvas, axes = panels(len(targets), 1, height=3.6)
    words = []
    for ax, target in zip(axes[:, 0], targets):
        lines = {}
        for row in (r for r in rows if r["target"] == target):
            lines.setdefault(row["method"], []).append((row.number("degree"), 100 * row.number("share_of_peak")))
        for method, points in sorted(lines.items(), key=lambda item: -max(item[1])[1]):
            ax.plot(*zip(*sorted(points)), **look[method], label=method)
            words.append(f"{target}, {method}: {general(max(points)[1])} % at degree {max(points)[0]:g}")
        ax.axhline(100, color=FAINT, linewidth=0.9, zorder=0)
        ax.set_ylim(bottom=0)
        ax.set_title(target, loc="left")
        ax.set_ylabel("% of the peak")
        beside(ax)
    axes[-1][0].set_xlabel("degree n")
    return finish(canvas, "share-of-peak", f"Share of the multiply-add peak that the batch kernels reach ({PEAK_SCALAR}, {axes_drawn:g} axes)",
                  "批量求值达到乘加峰值的比例", "; ".join(words) + ".", bottom=0.1)


@figure
def fitting_time(bundle):
    """Largest true error and mean segments against the time of a fit, a point for each tolerance."""
    pairs = fits_with_times(bundle)
    look = {m: {**style, "marker": "o"} for m, style in looks(sorted({time["method"] for time, _ in pairs})).items()}
    kinds = [data for data in FITTED if any(time["data"] == data for time, _ in pairs)]
    canvas, axes = panels(len(kinds), len(COSTS), height=2.3)
    texts = []
    for line, data in zip(axes, kinds):
        for ax, (column, label, write) in zip(line, COSTS):
            lines = {}
            for time, fit in sorted(pairs, key=lambda pair: -pair[0]["tolerance"]):
                if time["data"] == data and positive(fit, column):
                    lines.setdefault(time["method"], []).append((time["median_ns"] / 1e3, fit[column]))
            draw_methods(ax, lines, look)
            if ax is not line[-1]:
                ax.get_legend().remove()
            ax.set_title(FITTED[data][0].upper() + FITTED[data][1:] if ax is line[0] else "", loc="left")
            ax.set_yscale("log")
            ax.set_xscale("log")
            ax.set_ylabel(label)
            texts.append(f"{label}, {FITTED[data]}: " + ", ".join(
                f"{m} ends at {general(points[-1][0])} µs with {write(points[-1][1])}" for m, points in lines.items()))
    for ax in axes[-1]:
        ax.set_xlabel("µs per fit")
    return finish(canvas, "fitting-time", "Largest true error and number of segments against the time of a fit, a point for each tolerance",
                  "拟合误差、段数与用时", "Doubly logarithmic. " + "; ".join(texts) + ".", bottom=0.1)


def _regimes(table):
    """(study, axis across, kind down, its value drawn, rows): of a study with a second axis that does not change the
    unit, the highest value stands for all; scalars are drawn side by side."""
    for study in table.distinct("study"):
        rows = [r for r in table.select(study=study) if not conversion(r["method"])]
        if not rows:
            continue
        across, down = swept(rows)
        kinds = list(dict.fromkeys(r[down] for r in rows))
        yield study, across, down, kinds if down == "scalar" else kinds[-1:], rows


def _draw_regime(ax, across, down, kinds, rows, look):
    places = sorted({axis_value(r, across) for r in rows})
    where = dict(zip(places, places if across == "degree" else range(len(places))))
    for method in dict.fromkeys(r["method"] for r in rows):
        for kind in kinds:
            points = sorted((where[axis_value(r, across)], positive(r, "mean_error_u")) for r in rows
                            if r["method"] == method and r[down] == kind and positive(r, "mean_error_u"))
            if points:
                filled = {"markersize": 5, "marker": "o", "markerfacecolor": "none", "linestyle": "none"} if kind == "float" else {}
                ax.plot(*zip(*points), **{**look[method], **filled})
    ax.set_yscale("log")
    if across == "degree":
        degree_axis(ax, places)
    else:  # 1e-300 to 1e300 is too far for a logarithmic axis, whose margins would overflow
        ax.set_xticks(list(where.values()), [axis_label(p, across) for p in places], fontsize=7.5)


@figure
def regimes_overview(bundle):
    """A panel for each study: mean error over u p~ along its axis."""
    table = bundle.exact("regimes")
    parts = list(_regimes(table))
    if not parts:
        raise Missing("`accuracy.csv` has no row of the suite `regimes` of a method without conversion")
    look = looks(list(dict.fromkeys(r["method"] for *_, rows in parts for r in rows)))
    lines = (len(parts) + 1) // 2
    canvas, axes = panels(lines, 2, height=2.9)
    for ax in axes.flat[len(parts):]:
        ax.set_visible(False)
    for ax, (study, across, down, kinds, rows) in zip(axes.flat, parts):
        _draw_regime(ax, across, down, kinds, rows, look)
        shown = "" if len({r[down] for r in rows}) == 1 else (
            ": lines are double, circles float" if down == "scalar" else f": {named(down, kinds[0])}")
        ax.set_title(f"{bundle.title(study)}{shown}", loc="left", fontsize=8.5)
        ax.set_xlabel(REGIMES_AXIS[across])
        ax.set_ylabel("mean error / (u p~)")
    handles = [axes.flat[0].plot([], [], **look[m], label=m)[0] for m in look]
    canvas.legend(handles=handles, loc="lower center", ncol=3, fontsize=8, handlelength=3, columnspacing=1.6)
    return finish(canvas, "regimes-overview", "Mean error over u p~ at the limits, methods that evaluate the given form; those that agree "
                              "share a line", "极端情形下的平均误差（以 u p~ 计）",
                  f"{len(parts)} panels, logarithmic: " + ", ".join(f"{bundle.title(s)} along {a}" for s, a, *_ in parts) +
                  ". The numbers stand in the tables below.", bottom=0.25 + 0.17 * ((len(look) + 2) // 3))
