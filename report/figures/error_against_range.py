# SPDX-License-Identifier: MIT
"""Table 2.3.2 as curves."""

from ..methods import FORM, STATISTIC
from .canvas import finish, legend, log_axis, panels, reproduced, styled
from .printed_rows import COLOUR, LEGEND, METHODS, UNDER, describe, rows_of

ID = "error-against-range"


@styled
def draw(bundle):
    """Mean and largest error against the range, for both forms of curve."""
    canvas, axes = panels(2, 2, sharex=True, sharey="row")
    words = []
    for column, (curve, methods) in enumerate(METHODS.items()):
        for line, statistic in enumerate(("mean_error", "max_error")):
            ax = axes[line][column]
            for method in methods:
                rows = rows_of(bundle, "2.3.2", curve, method, statistic, lambda r: r.number("coordinate_range"))
                ranges = [r.number("coordinate_range") for r in rows]
                reproduced(ax, ranges, rows, COLOUR[method], below=method == UNDER)
                words.append(describe(rows, lambda r: f"R = {r['coordinate_range']:g}"))
            ax.set_xscale("log")
            ax.set_yscale("log")
            log_axis(ax.xaxis, ranges)
            if line == 0:
                ax.set_title(FORM[curve][0])
            else:
                ax.set_xlabel("range R (coordinates in [-R, R])")
            if column == 0:
                ax.set_ylabel(f"{STATISTIC[statistic][0]} (coordinate units)")
    legend(canvas, LEGEND)
    return finish(canvas, ID, "Error against coordinate range (table 2.3.2)", "误差与坐标范围（表 2.3.2）",
                  "Doubly logarithmic plots of our medians with the printed points. " + "; ".join(words) + ".")
