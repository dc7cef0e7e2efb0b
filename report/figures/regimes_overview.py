# SPDX-License-Identifier: MIT
"""The regimes side by side, for the methods that evaluate the given form."""

from ..bundle import Missing
from ..error_tables import named, swept
from ..tables import axis_label, axis_value
from .canvas import finish, panels, styled
from .method_lines import conversion, degree_axis, error_axis, looks, positive

ID = "regimes-overview"
AXIS = {"interval": "interval of t", "coordinate_range": "range R (coordinates in [-R, R])", "degree": "degree n"}


def _panels(table):
    """(study, axis across, kind down, its value drawn, rows): of a study with a second axis that does not change the
    unit, the highest value stands for all; scalars are drawn side by side."""
    for study in table.distinct("study"):
        rows = [r for r in table.select(study=study) if not conversion(r["method"])]
        if not rows:
            continue
        across, down = swept(rows)
        kinds = list(dict.fromkeys(r[down] for r in rows))
        yield study, across, down, kinds if down == "scalar" else kinds[-1:], rows


def _draw(ax, across, down, kinds, rows, look):
    places = sorted({axis_value(r, across) for r in rows})
    where = dict(zip(places, places if across == "degree" else range(len(places))))
    for method in dict.fromkeys(r["method"] for r in rows):
        for kind in kinds:
            points = sorted((where[axis_value(r, across)], positive(r, "mean_error_u")) for r in rows
                            if r["method"] == method and r[down] == kind and positive(r, "mean_error_u"))
            if points:
                filled = {"markersize": 5, "marker": "o", "markerfacecolor": "none", "linestyle": "none"} if kind == "float" else {}
                ax.plot(*zip(*points), **{**look[method], **filled})
    error_axis(ax)
    if across == "degree":
        degree_axis(ax, places)
    else:  # 1e-300 to 1e300 is too far for a logarithmic axis, whose margins would overflow
        ax.set_xticks(list(where.values()), [axis_label(p, across) for p in places], fontsize=7.5)


@styled
def draw(bundle):
    """A panel for each study: mean error over u p~ along its axis."""
    table = bundle.exact("regimes")
    parts = list(_panels(table))
    if not parts:
        raise Missing("`accuracy.csv` has no row of the suite `regimes` of a method without conversion")
    look = looks(list(dict.fromkeys(r["method"] for *_, rows in parts for r in rows)))
    lines = (len(parts) + 1) // 2
    canvas, axes = panels(lines, 2, height=2.9)
    for ax in axes.flat[len(parts):]:
        ax.set_visible(False)
    for ax, (study, across, down, kinds, rows) in zip(axes.flat, parts):
        _draw(ax, across, down, kinds, rows, look)
        shown = "" if len({r[down] for r in rows}) == 1 else (
            ": lines are double, circles float" if down == "scalar" else f": {named(down, kinds[0])}")
        ax.set_title(f"{bundle.title(study)}{shown}", loc="left", fontsize=8.5)
        ax.set_xlabel(AXIS[across])
        ax.set_ylabel("mean error / (u p~)")
    handles = [axes.flat[0].plot([], [], **look[m], label=m)[0] for m in look]
    canvas.legend(handles=handles, loc="lower center", ncol=3, fontsize=8, handlelength=3, columnspacing=1.6)
    return finish(canvas, ID, "Mean error over u p~ at the limits, methods that evaluate the given form; those that agree "
                              "share a line", "极端情形下的平均误差（以 u p~ 计）",
                  f"{len(parts)} panels, logarithmic: " + ", ".join(f"{bundle.title(s)} along {a}" for s, a, *_ in parts) +
                  ". The numbers stand in the tables below.", bottom=0.25 + 0.17 * ((len(look) + 2) // 3))
