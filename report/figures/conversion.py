# SPDX-License-Identifier: MIT
"""Conversion between forms: errors of coefficients, of paths by interval, and where they come from."""

from ..bundle import Missing
from ..findings.conversion import NORMS, SOURCES, UNIT, growth, middle, scale, sources, to_power
from ..methods import FORM
from ..wording import interval, scientific
from .canvas import COLOURS, DASHED, DOTTED, FAINT, INK, figure, finish, panels
from .colours import chosen, leading, looks
from .lines import beside, conversion, degree_axis, draw_methods, positive, series

GENERATOR = "continuous"
MARKERS = ("s", "D", "o")


@figure
def conversion_coefficients(bundle):
    """Largest error of a coefficient against degree, continuous inputs; the mean dotted."""
    table = bundle["conversion.csv"].of_suite("conversion")
    studies = [s for s in table.distinct("study") if table.select(study=s, generator=GENERATOR, form=tuple(NORMS))]
    if not studies:
        raise Missing(f"`conversion.csv` has no `conversion-` row with `{GENERATOR}` inputs that names its curve")
    canvas, axes = panels(len(studies), 1, height=3.2)
    words = []
    for ax, study in zip(axes[:, 0], studies):
        rows = table.some(study=study, generator=GENERATOR)
        curve = rows[0]["form"]
        for name, look in looks(bundle, list(dict.fromkeys(r["conversion"] for r in rows))).items():
            own = sorted((r for r in rows if r["conversion"] == name), key=lambda r: r["degree"])
            for column, style, label in (("max_error", "solid", name), ("mean_error", DOTTED, None)):
                points = [(r["degree"], r[column]) for r in own if positive(r, column)]
                line, = ax.plot(*zip(*points), **look, linestyle=style, label=label)
                line.series_name = name
            words.append(f"{name}: largest {scientific(own[0]['max_error'])} at degree {own[0]['degree']:g}, "
                         f"{scientific(own[-1]['max_error'])} at {own[-1]['degree']:g}")
        title, formula, norm = NORMS[curve]
        points = sorted({(r["degree"], UNIT * scale(r) * norm(int(r["degree"]))) for r in rows})
        ax.plot(*zip(*points), color=INK, linestyle=DASHED, linewidth=1.2, label=f"u R √d times {formula}")
        ax.set_title(title, loc="left")
        ax.set_yscale("log")
        degree_axis(ax, {r["degree"] for r in rows})
        ax.set_ylabel("error of a coefficient\n(coordinate units)")
        beside(ax)
    axes[-1][0].set_xlabel("degree n")
    return finish(canvas, "conversion-coefficients", "Error of converted coefficients against degree, continuous inputs: largest (solid) and mean "
                              "(dotted)", "Doubly logarithmic, with the norm of the conversion dashed. " + "; ".join(words) + ".", bottom=0.1)


@figure
def conversion_interval(bundle, whole=False):
    """Mean error against the middle of the interval; the norm is scaled to the worst path's error in the first interval."""
    rows = to_power(bundle)
    degrees = sorted({r["degree"] for r in rows})
    canvas, axes = panels(len(degrees), 1, height=2.5, sharex=True)
    words = []
    found = {degree: series([r for r in rows if r["degree"] == degree], middle, "mean_error") for degree in degrees}
    methods = list(dict.fromkeys(method for lines in found.values() for method in lines))
    last = {method: points[-1][1] for lines in found.values() for method, points in lines.items()}
    shown = methods if whole else leading(bundle, methods, last.get)
    look = looks(bundle, shown)
    places = sorted({(r["t_min"], r["t_max"]) for r in rows})
    for ax, (degree, lines) in zip(axes[:, 0], found.items()):
        worst = max(lines.values(), key=lambda points: points[-1][1])
        start, level = worst[0]
        ax.plot([x for x, _ in worst], [level * growth(start, x, degree) for x, _ in worst], color=INK, linestyle=DASHED,
                linewidth=1.6, label="(1+2t)^n, scaled")
        draw_methods(ax, {m: points for m, points in lines.items() if m in shown}, look)
        ax.set_yscale("log")
        ax.set_title(f"degree {degree:g}", loc="left")
        ax.set_ylabel("mean error\n(coordinate units)")
        words.append(f"degree {degree:g}: the worst path goes from {scientific(level)} to {scientific(worst[-1][1])}, "
                     f"(1+2t)^n from there to {scientific(level * growth(start, worst[-1][0], degree))}")
    axes[-1][0].set_xticks([(a + b) / 2 for a, b in places], [interval(a, b) for a, b in places])
    axes[-1][0].set_xlabel("interval of t")
    return finish(canvas, "conversion-interval", "Error of paths to power form against the interval of t; (1+2t)^n is scaled to the worst path's error in "
                  "the first interval", "; ".join(words) + ".", bottom=0.1, note=chosen(shown, methods),
                  more=(lambda: conversion_interval(bundle, True)) if len(shown) < len(methods) else None)


@figure
def conversion_sources(bundle):
    """Mean parts of the error at the highest degree, in the first and the last interval of t; parts that are 0 are not drawn."""
    rows = sources(bundle)
    studies = list(dict.fromkeys(r["study"] for r in rows))
    heights = [len({r["method"] for r in rows if r["study"] == s}) for s in studies]
    canvas, axes = panels(len(studies), 2, height=0.105 * sum(heights) + 0.9, gridspec_kw={"height_ratios": heights})
    words = []
    for line, study in enumerate(studies):
        own = [r for r in rows if r["study"] == study]
        degree = max(r["degree"] for r in own)
        intervals = sorted({(r["t_min"], r["t_max"]) for r in own})
        methods = list(dict.fromkeys(r["method"] for r in own))
        for ax, place in zip(axes[line], (intervals[0], intervals[-1])):
            cells = {r["method"]: r for r in own if r["degree"] == degree and (r["t_min"], r["t_max"]) == place}
            for k, (column, source) in enumerate(SOURCES):
                points = [(cells[m][column], y) for y, m in enumerate(methods) if m in cells and positive(cells[m], column)]
                if points:
                    marks, = ax.plot(*zip(*points), linestyle="none", marker=MARKERS[k], markersize=5.5, color=COLOURS[k], alpha=0.9)
                    marks.series_name, marks.reads = source, [f"{methods[y]}: {scientific(value)}" for value, y in points]
            ax.set_yticks(range(len(methods)), methods if ax is axes[line][0] else [""] * len(methods), fontsize=7.5)
            ax.set_ylim(len(methods) - 0.4, -0.6)
            ax.set_xscale("log")
            ax.tick_params(axis="x", labelsize=8)
            ax.grid(axis="y", color=FAINT, alpha=0.28)
            title = FORM.get(own[0]["form"], (own[0]["form"],))[0]
            ax.set_title(f"{title}, degree {degree:g}, t in {interval(*place)}", loc="left", fontsize=9)
            worst = max(cells.values(), key=lambda r: r["mean_error"])
            words.append(f"{title}, t in {interval(*place)}: the worst path is {worst['method']} with "
                         + ", ".join(f"{name} {scientific(worst[column])}" for column, name in SOURCES))
    for ax in axes[-1]:
        ax.set_xlabel("mean error (coordinate units)")
    handles = [axes[0][0].plot([], [], linestyle="none", marker=MARKERS[k], color=COLOURS[k], label=name)[0]
               for k, (_, name) in enumerate(SOURCES)]
    canvas.legend(handles=handles, loc="lower center", ncol=3, fontsize=9)
    return finish(canvas, "conversion-sources", "Parts of the error of a path: conversion, rounding of 1-t, evaluation; a part that is 0 has "
                              "no mark", "; ".join(words) + ".", bottom=0.35)
