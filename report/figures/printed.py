# SPDX-License-Identifier: MIT
"""The source report's tables as curves: printed points, our medians, and what lies beside them."""

from ..methods import FORM, STATISTIC, name
from ..wording import general, interval, scientific
from .canvas import FAINT, figure, finish, legend, log_axis, panels, reproduced
from .colours import WELL_KNOWN

METHODS = {
    "bernstein": ("de_casteljau", "factorial:power_sum"),
    "power": ("forward_substitution:de_casteljau", "forward_substitution:direct"),
}
UNDER = "forward_substitution:de_casteljau"  # nearly everywhere on the same line as its sibling
COLOUR = {m: WELL_KNOWN[m] for methods in METHODS.values() for m in methods}
LEGEND = [(name(m), c) for m, c in COLOUR.items()]
TIMED = {
    "bernstein": ("direct", "de_casteljau", "factorial:power_sum"),
    "power": ("power_sum", "forward_substitution:de_casteljau", "forward_substitution:direct"),
}
TICK = 1.0  # ms: the step of the clock behind the printed times


def rows_of(bundle, table, curve, method, statistic, order):
    """Rows of one printed row, ascending in `order`; Missing where there are none."""
    return sorted(bundle["scorecard.csv"].some(table=table, form=curve, method=method, statistic=statistic), key=order)


def describe(rows, axis):
    """`via power form, mean error: 2.8e-10 at degree 4 to 1.2e-3 at degree 20`, from our medians."""
    first, last = rows[0], rows[-1]
    return (f"{name(first['method'])}, {STATISTIC[first['statistic']][0]}, {FORM[first['form']][0]}: "
            f"{scientific(first['ours_median'])} at {axis(first)} to {scientific(last['ours_median'])} at {axis(last)}")


def _errors(bundle, figure_id, captions, table, order, across, plots):
    """The figure of mean and largest error of a printed table, for both forms of curve. `order` is what rows ascend in, and `across`
    names a row's place in words, and draws the axis across for the rows of one panel."""
    place, named, axis = across
    canvas, axes = panels(2, 2, sharex=True, sharey="row")
    words = []
    for column, (curve, methods) in enumerate(METHODS.items()):
        for line, statistic in enumerate(("mean_error", "max_error")):
            ax = axes[line][column]
            for method in methods:
                rows = rows_of(bundle, table, curve, method, statistic, order)
                reproduced(ax, place(rows), rows, COLOUR[method], below=method == UNDER)
                words.append(describe(rows, named))
            ax.set_yscale("log")
            label = axis(ax, rows)
            if line == 0:
                ax.set_title(FORM[curve][0])
            else:
                ax.set_xlabel(label)
            if column == 0:
                ax.set_ylabel(f"{STATISTIC[statistic][0]} (coordinate units)")
    legend(canvas, LEGEND)
    return finish(canvas, figure_id, captions[0], f"{plots} plots of our medians with the printed points. " + "; ".join(words) + ".", caption_zh=captions[1])


def _column(name):
    """Rows ascend in that column, whose values are their places."""
    return lambda r: r.number(name), lambda rows: [r.number(name) for r in rows]


@figure
def error_against_degree(bundle):
    """Table 2.3.1: mean and largest error against the degree."""
    def axis(ax, rows):
        ax.set_xticks(places(rows))
        return "degree n"
    order, places = _column("degree")
    return _errors(bundle, "error-against-degree", ("Error against degree (table 2.3.1)", "误差与阶数（表 2.3.1）"), "2.3.1", order,
                   (places, lambda r: f"degree {r['degree']:g}", axis), "Logarithmic")


@figure
def error_against_range(bundle):
    """Table 2.3.2: mean and largest error against the range."""
    def axis(ax, rows):
        ax.set_xscale("log")
        log_axis(ax.xaxis, places(rows))
        return "range R (coordinates in [-R, R])"
    order, places = _column("coordinate_range")
    return _errors(bundle, "error-against-range", ("Error against coordinate range (table 2.3.2)", "误差与坐标范围（表 2.3.2）"), "2.3.2", order,
                   (places, lambda r: f"R = {r['coordinate_range']:g}", axis), "Doubly logarithmic")


@figure
def error_against_interval(bundle):
    """Table 2.3.3: mean and largest error for each interval of t, by its middle, then its width."""
    def order(row):
        low, high = row.number("t_min"), row.number("t_max")
        return low + high, high - low

    def axis(ax, rows):
        ax.set_xticks(list(range(len(rows))), [interval(r["t_min"], r["t_max"]) for r in rows])
        ax.margins(x=0.08)
        return "interval of t, by its middle, then its width"
    return _errors(bundle, "error-against-interval", ("Error against parameter interval (table 2.3.3)", "误差与参数区间（表 2.3.3）"), "2.3.3",
                   order, (lambda rows: range(len(rows)), lambda r: interval(r["t_min"], r["t_max"]), axis), "Logarithmic")


@figure
def error_over_range(bundle):
    """Mean error divided by R: flat for a method that does not care about the range."""
    canvas, axes = panels(1, 2, height=3.6)
    words = []
    for ax, (curve, methods) in zip(axes[0], METHODS.items()):
        # de Casteljau is seven decades below and flat: it would hide what this figure is about
        for method in methods[-1:] if curve == "bernstein" else methods:
            rows = rows_of(bundle, "2.3.2", curve, method, "mean_error", lambda r: r.number("coordinate_range"))
            ranges = [r.number("coordinate_range") for r in rows]
            reproduced(ax, ranges, rows, COLOUR[method], below=method == UNDER, scale=ranges)
            words.append(f"{name(method)}, {FORM[curve][0]}: {scientific(rows[0].number('ours_median') / ranges[0])} at R = "
                         f"{ranges[0]:g} to {scientific(rows[-1].number('ours_median') / ranges[-1])} at R = {ranges[-1]:g}")
        ax.set_xscale("log")
        ax.set_ylim(bottom=0)
        log_axis(ax.xaxis, ranges)
        ax.yaxis.set_major_formatter(lambda value, _: scientific(value, 2))
        ax.set_title(FORM[curve][0])
        ax.set_xlabel("range R (coordinates in [-R, R])")
    axes[0][0].set_ylabel("mean error / R")
    legend(canvas, [entry for entry in LEGEND if entry[0] != name("de_casteljau")])
    return finish(canvas, "error-over-range", "Mean error divided by the range (table 2.3.2)",
                  "Mean error over range against range. " + "; ".join(words) + ".", caption_zh="平均误差除以坐标范围（表 2.3.2）")


@figure
def time_against_degree(bundle):
    """Time per curve with the conversion charged to every curve, and per point when prepared once."""
    table = bundle["scorecard_timing.csv"]
    canvas, axes = panels(1, 2, height=4.4, sharey=True)
    words = []
    for ax, (curve, methods) in zip(axes[0], TIMED.items()):
        for method in methods:
            rows = sorted(table.some(table="2.4", form=curve, method=method), key=lambda r: r.number("degree"))
            degrees = [r.number("degree") for r in rows]
            reproduced(ax, degrees, rows, WELL_KNOWN[method], method == UNDER, dashed="prepared_median", dotted=None)
            zero = [n for n, r in zip(degrees, rows) if r["published"] == 0]
            ax.plot(zero, [0.62 * TICK] * len(zero), linestyle="none", marker="v", markersize=7, markeredgewidth=1.5,
                    markeredgecolor=WELL_KNOWN[method], markerfacecolor="none")
            words.append(f"{name(method)}, {FORM[curve][0]}: {general(rows[0]['ours_median'])} µs at degree {degrees[0]:g} "
                         f"to {general(rows[-1]['ours_median'])} µs at degree {degrees[-1]:g}")
        ax.set_yscale("log", nonpositive="mask")
        ax.axhline(TICK, color=FAINT, linewidth=0.9, zorder=0)
        ax.set_xticks(degrees)
        ax.set_title(FORM[curve][0])
        ax.set_xlabel("degree n")
    axes[0][0].annotate("below one tick of the report's clock\ntriangle: printed as 0", (0.98, TICK * 0.85), fontsize=8,
                        xycoords=("axes fraction", "data"), ha="right", va="top")
    axes[0][0].set_ylabel("µs per curve (ms per 1000 curves)")
    legend(canvas, [(name(m), WELL_KNOWN[m]) for methods in TIMED.values() for m in methods], dashed="prepared once, per point", dotted=None)
    return finish(canvas, "time-against-degree", "Time against degree (table 2.4)",
                  "Logarithmic plots of our times with the printed whole milliseconds. " + "; ".join(words) + ".",
                  bottom=0.95, caption_zh="用时与阶数（表 2.4）")


# In the order of the page.
TABLES = (error_against_degree, error_against_range, error_over_range, error_against_interval, time_against_degree)
