# SPDX-License-Identifier: MIT
"""Error of paths to power form by interval of t, with (1+2t)^n drawn over the data."""

from ..findings.conversion import growth, middle, to_power
from ..wording import interval, scientific
from .canvas import DASHED, DOTTED, INK, finish, panels, styled
from .method_lines import beside, conversion, draw_paths, error_axis, path_colours, series

ID = "conversion-interval"
STROKES = ("solid", DOTTED, (0, (5, 1.5, 1, 1.5)))  # of the methods that convert nothing


@styled
def draw(bundle):
    """Mean error against the middle of the interval; the norm is scaled to the worst path's error in the first interval."""
    rows = to_power(bundle)
    degrees = sorted({r["degree"] for r in rows})
    canvas, axes = panels(len(degrees), 1, height=2.5, sharex=True)
    words = []
    colours = path_colours(r["method"] for r in rows if conversion(r["method"]))
    places = sorted({(r["t_min"], r["t_max"]) for r in rows})
    for ax, degree in zip(axes[:, 0], degrees):
        lines = series([r for r in rows if r["degree"] == degree], middle, "mean_error")
        draw_paths(ax, {m: points for m, points in lines.items() if conversion(m)}, colours)
        given = {m: points for m, points in lines.items() if not conversion(m)}
        for stroke, (method, points) in zip(STROKES, given.items()):
            ax.plot(*zip(*points), color=INK, linewidth=1, linestyle=stroke, label=method)
        worst = max(lines.values(), key=lambda points: points[-1][1])
        start, level = worst[0]
        ax.plot([x for x, _ in worst], [level * growth(start, x, degree) for x, _ in worst], color=INK, linestyle=DASHED,
                linewidth=1.6, label="(1+2t)^n, scaled")
        error_axis(ax)
        ax.set_title(f"degree {degree:g}", loc="left")
        ax.set_ylabel("mean error\n(coordinate units)")
        beside(ax)
        words.append(f"degree {degree:g}: the worst path goes from {scientific(level)} to {scientific(worst[-1][1])}, "
                     "(1+2t)^n from "
                     f"there to {scientific(level * growth(start, worst[-1][0], degree))}")
    axes[-1][0].set_xticks([(a + b) / 2 for a, b in places], [interval(a, b) for a, b in places])
    axes[-1][0].set_xlabel("interval of t")
    return finish(canvas, ID, "Error of paths to power form against the interval of t; (1+2t)^n is scaled to the worst "
                              "path's error in "
                  "the first interval", "经幂基求值的误差与参数区间", "; ".join(words) + ".", bottom=0.1)
