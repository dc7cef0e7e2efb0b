# SPDX-License-Identifier: MIT
"""Fits: what an error and a number of segments cost in time."""

from ..time_tables import fits_with_times
from ..wording import general
from .canvas import finish, panels, styled
from .fitting_segments import WORDS
from .method_lines import draw_methods, error_axis, looks, positive

ID = "fitting-time"
AGAINST = (("max_error", "largest error", general), ("mean_segments", "mean segments", general))


@styled
def draw(bundle):
    """Largest true error and mean segments against the time of a fit, a point for each tolerance."""
    pairs = fits_with_times(bundle)
    look = {m: {**style, "marker": "o"} for m, style in looks(sorted({time["method"] for time, _ in pairs})).items()}
    kinds = [data for data in WORDS if any(time["data"] == data for time, _ in pairs)]
    canvas, axes = panels(len(kinds), len(AGAINST), height=2.3)
    texts = []
    for line, data in zip(axes, kinds):
        for ax, (column, label, write) in zip(line, AGAINST):
            lines = {}
            for time, fit in sorted(pairs, key=lambda pair: -pair[0]["tolerance"]):
                if time["data"] == data and positive(fit, column):
                    lines.setdefault(time["method"], []).append((time["median_ns"] / 1e3, fit[column]))
            draw_methods(ax, lines, look)
            if ax is not line[-1]:
                ax.get_legend().remove()
            ax.set_title(WORDS[data][0].upper() + WORDS[data][1:] if ax is line[0] else "", loc="left")
            error_axis(ax)
            ax.set_xscale("log")
            ax.set_ylabel(label)
            texts.append(f"{label}, {WORDS[data]}: " + ", ".join(
                f"{m} ends at {general(points[-1][0])} µs with {write(points[-1][1])}" for m, points in lines.items()))
    for ax in axes[-1]:
        ax.set_xlabel("µs per fit")
    return finish(canvas, ID, "Largest true error and number of segments against the time of a fit, a point for each tolerance",
                  "拟合误差、段数与用时", "Doubly logarithmic. " + "; ".join(texts) + ".", bottom=0.1)
