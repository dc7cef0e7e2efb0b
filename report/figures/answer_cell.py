# SPDX-License-Identifier: MIT
"""The methods of the cell that the answer shows first, time against error."""

from ..answer import FORMS, NO_TIME, candidates, default_cell, useful
from ..bundle import Missing
from ..wording import general, shortest
from .canvas import FAINT, finish, panels, styled
from .method_lines import beside
from .time_against_error import mark

ID = "answer-figure"


@styled
def draw(bundle):
    """One panel; useless methods are left out, so that they do not stretch the axis."""
    cells = candidates(bundle)
    cell = default_cell(cells) if cells else None
    members = [one for one in cells.get(cell, ()) if useful(one.error_u, cell.scalar)]
    if not members or cell.mode == NO_TIME:
        raise Missing("`pareto.csv` has no times")
    canvas, axes = panels(1, 1, height=max(3.4, 0.17 * len(members)))
    ax = axes[0][0]
    for index, one in enumerate(members):
        mark(ax, one.timed, index)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.axhline(1, color=FAINT, linewidth=0.9)
    ax.set_xlabel("ns per point")
    ax.set_ylabel("largest error seen, u p~")
    beside(ax)
    words = "; ".join(f"{one.method}: {general(one.ns)} ns, {general(one.error_u)} u p~" for one in members)
    return finish(canvas, ID, f"Time against the largest error seen, {FORMS.get(cell.form, cell.form)}, degree {shortest(cell.degree)}; "
                  "the thin line upwards ends at the proved bound, filled marks are worth choosing", "用时与最大误差",
                  f"Doubly logarithmic. {words}.", bottom=0.1)
