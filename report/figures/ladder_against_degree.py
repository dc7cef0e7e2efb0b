# SPDX-License-Identifier: MIT
"""The ladder: every method by degree, evaluators of the given form apart from converted paths."""

from ..bundle import Missing
from ..methods import FORM
from ..wording import general
from .canvas import finish, panels, styled
from .method_lines import conversion, degree_axis, draw_methods, draw_paths, ends, error_axis, looks, path_colours, series

ID = "ladder-against-degree"
GENERATOR = "continuous"
APART = 1e3  # what ends above this many u p~ has a panel of its own: on its axis the others would be one line
KINDS = tuple(f"{how}, ending {where} {APART:g} u p~" for how in ("evaluated in the given form", "converted first, one line "
                                                                                                 "per path")
              for where in ("below", "above"))


def _kind(method, points):
    return KINDS[2 * bool(conversion(method)) + (points[-1][1] >= APART)]


@styled
def draw(bundle):
    """Mean error over u p~ against degree, continuous inputs: per form of curve, the evaluators, then the paths."""
    table = bundle.exact("ladder")
    parts = []
    for curve in table.distinct("curve"):
        rows = table.select(curve=curve, generator=GENERATOR, scalar="double", dimension=2)
        lines = series(rows, lambda r: r["degree"], "mean_error_u")
        for kind in KINDS:
            some = {m: points for m, points in lines.items() if _kind(m, points) == kind}
            if some:
                parts.append((curve, kind, some))
    if not parts:
        raise Missing(f"`accuracy.csv` has no `ladder-` row with `{GENERATOR}` inputs")
    canvas, axes = panels(len(parts), 1, height=2.7)
    words = []
    methods = dict.fromkeys(method for *_, some in parts for method in some)
    look, colours = looks(list(methods)), path_colours(methods)  # the same in every panel
    for ax, (curve, kind, some) in zip(axes[:, 0], parts):
        if kind in KINDS[:2]:
            draw_methods(ax, some, look)
        else:
            draw_paths(ax, some, colours)
        title = f"{FORM.get(curve, (curve,))[0]}, {kind}"
        title = title[0].upper() + title[1:]
        ax.set_title(title, loc="left")
        error_axis(ax)
        degree_axis(ax, {x for points in some.values() for x, _ in points})
        ax.set_ylabel("mean error / (u p~)")
        best, worst, last = ends(some)
        words.append(f"{title}: at the highest degree {best} has {general(last[best])}, {worst} {general(last[worst])}")
    axes[-1][0].set_xlabel("degree n")
    return finish(canvas, ID, "Mean error over u p~ against degree, every method, continuous inputs", "各方法的平均误差与阶数（以 u p~ 计）",
                  "Doubly logarithmic. " + "; ".join(words) + ".", bottom=0.1)
