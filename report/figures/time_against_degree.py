# SPDX-License-Identifier: MIT
"""Table 2.4 as curves."""

from ..methods import FORM, name
from ..wording import general
from .canvas import COLOURS, FAINT, finish, legend, panels, reproduced, styled
from .printed_rows import UNDER

ID = "time-against-degree"
ORDER = {
    "bezier": ("direct", "de_casteljau", "factorial:power_sum"),
    "polynomial": ("power_sum", "forward_substitution:de_casteljau", "forward_substitution:direct"),
}
# de Casteljau and the power form keep the colours that they have in the figures of error
COLOUR = {m: COLOURS[i] for m, i in (("direct", 4), ("de_casteljau", 0), ("factorial:power_sum", 1), ("power_sum", 5),
                                     ("forward_substitution:de_casteljau", 2), ("forward_substitution:direct", 3))}
TICK = 1.0  # ms: the step of the clock behind the printed times


@styled
def draw(bundle):
    """Time per curve with the conversion charged to every curve, and per point when prepared once."""
    table = bundle["scorecard_timing.csv"]
    canvas, axes = panels(1, 2, height=4.4, sharey=True)
    words = []
    for ax, (curve, methods) in zip(axes[0], ORDER.items()):
        for method in methods:
            rows = sorted(table.some(table="2.4", curve=curve, method=method), key=lambda r: r.number("degree"))
            degrees = [r.number("degree") for r in rows]
            reproduced(ax, degrees, rows, COLOUR[method], method == UNDER, dashed="prepared_median", dotted=None)
            zero = [n for n, r in zip(degrees, rows) if r["published"] == 0]
            ax.plot(zero, [0.62 * TICK] * len(zero), linestyle="none", marker="v", markersize=7, markeredgewidth=1.5,
                    markeredgecolor=COLOUR[method], markerfacecolor="none")
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
    legend(canvas, [(name(m), c) for m, c in COLOUR.items()], dashed="prepared once, per point", dotted=None)
    return finish(canvas, ID, "Time against degree (table 2.4)", "用时与阶数（表 2.4）",
                  "Logarithmic plots of our times with the printed whole milliseconds. " + "; ".join(words) + ".",
                  bottom=0.95)
