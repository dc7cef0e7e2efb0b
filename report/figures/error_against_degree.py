# SPDX-License-Identifier: MIT
"""Table 2.3.1 as curves."""

from ..methods import FORM, STATISTIC
from .canvas import finish, legend, panels, reproduced, styled
from .printed_rows import COLOUR, LEGEND, METHODS, UNDER, describe, rows_of

ID = "error-against-degree"


@styled
def draw(bundle):
    """Mean and largest error against the degree, for both forms of curve."""
    canvas, axes = panels(2, 2, sharex=True, sharey="row")
    words = []
    for column, (curve, methods) in enumerate(METHODS.items()):
        for line, statistic in enumerate(("mean_error", "max_error")):
            ax = axes[line][column]
            for method in methods:
                rows = rows_of(bundle, "2.3.1", curve, method, statistic, lambda r: r.number("degree"))
                degrees = [r.number("degree") for r in rows]
                reproduced(ax, degrees, rows, COLOUR[method], below=method == UNDER)
                words.append(describe(rows, lambda r: f"degree {r['degree']:g}"))
            ax.set_yscale("log")
            ax.set_xticks(degrees)
            if line == 0:
                ax.set_title(FORM[curve][0])
            else:
                ax.set_xlabel("degree n")
            if column == 0:
                ax.set_ylabel(f"{STATISTIC[statistic][0]} (coordinate units)")
    legend(canvas, LEGEND)
    return finish(canvas, ID, "Error against degree (table 2.3.1)", "误差与阶数（表 2.3.1）",
                  "Logarithmic plots of our medians with the printed points. " + "; ".join(words) + ".")
