# SPDX-License-Identifier: MIT
"""Table 2.3.3 as curves."""

from ..methods import FORM, STATISTIC
from ..wording import interval
from .canvas import finish, legend, panels, reproduced, styled
from .printed_rows import COLOUR, LEGEND, METHODS, UNDER, describe, rows_of

ID = "error-against-interval"


def _place(row):
    """Intervals by their middle, then by their width."""
    low, high = row.number("t_min"), row.number("t_max")
    return low + high, high - low


@styled
def draw(bundle):
    """Mean and largest error for each interval of t, for both forms of curve."""
    canvas, axes = panels(2, 2, sharex=True, sharey="row")
    words = []
    for column, (curve, methods) in enumerate(METHODS.items()):
        for line, statistic in enumerate(("mean_error", "max_error")):
            ax = axes[line][column]
            for method in methods:
                rows = rows_of(bundle, "2.3.3", curve, method, statistic, _place)
                places = range(len(rows))
                reproduced(ax, places, rows, COLOUR[method], below=method == UNDER)
                words.append(describe(rows, lambda r: interval(r["t_min"], r["t_max"])))
            ax.set_yscale("log")
            ax.set_xticks(list(places), [interval(r["t_min"], r["t_max"]) for r in rows])
            ax.margins(x=0.08)
            if line == 0:
                ax.set_title(FORM[curve][0])
            else:
                ax.set_xlabel("interval of t, by its middle, then its width")
            if column == 0:
                ax.set_ylabel(f"{STATISTIC[statistic][0]} (coordinate units)")
    legend(canvas, LEGEND)
    return finish(canvas, ID, "Error against parameter interval (table 2.3.3)", "误差与参数区间（表 2.3.3）",
                  "Logarithmic plots of our medians with the printed points. " + "; ".join(words) + ".")
