# SPDX-License-Identifier: MIT
"""Table 2.3.2 divided by the range: where the grid bends the curve."""

from ..methods import FORM, name
from ..wording import scientific
from .canvas import finish, legend, log_axis, panels, reproduced, styled
from .printed_rows import COLOUR, LEGEND, METHODS, UNDER, rows_of

ID = "error-over-range"


@styled
def draw(bundle):
    """Mean error divided by R: flat for a method that does not care about the range."""
    canvas, axes = panels(1, 2, height=3.6)
    words = []
    for ax, (curve, methods) in zip(axes[0], METHODS.items()):
        # de Casteljau is seven decades below and flat: it would hide what this figure is about
        for method in methods[-1:] if curve == "bezier" else methods:
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
    return finish(canvas, ID, "Mean error divided by the range (table 2.3.2)", "平均误差除以坐标范围（表 2.3.2）",
                  "Mean error over range against range. " + "; ".join(words) + ".")
