# SPDX-License-Identifier: MIT
"""Relative error against the condition number: where the digits go near multiple and clustered roots."""

from ..bundle import Missing
from ..findings.evaluators import UNIT
from ..methods import FORM
from ..wording import general
from .canvas import DOTTED, FAINT, INK, finish, panels, styled
from .method_lines import beside, looks, positive

ID = "error-against-condition"
MARKS = ("o", "s", "^", "D", "v", "x", "+", "P")
HIGHEST = 1e6  # a relative error above this says no more than one of it


@styled
def draw(bundle):
    """One point per cell: median relative error against median condition number, a panel for each form of curve."""
    table = bundle.exact("conditioning")
    rows = [r for r in table.rows if positive(r, "p50_condition") and positive(r, "p50_relative")]
    curves = list(dict.fromkeys(r["curve"] for r in rows))
    if not rows:
        raise Missing("`accuracy.csv` has no column `p50_condition` or `p50_relative`")
    canvas, axes = panels(len(curves), 1, height=3.9, sharex=True)
    words = []
    for ax, curve in zip(axes[:, 0], curves):
        methods = list(dict.fromkeys(r["method"] for r in rows if r["curve"] == curve))
        for method, look in looks(methods).items():
            points = sorted((r["p50_condition"], r["p50_relative"]) for r in rows if r["curve"] == curve and r["method"] == method)
            ax.plot(*zip(*points), linestyle="none", marker=MARKS[methods.index(method) % len(MARKS)], markersize=4.5,
                    markeredgewidth=1.1, markerfacecolor="none", color=look["color"], label=method)
            words.append(f"{FORM.get(curve, (curve,))[0]}, {method}: {general(points[0][1])} at condition "
                         f"{general(points[0][0])} "
                         f"to {general(points[-1][1])} at {general(points[-1][0])}")
        ax.set_xscale("log")
        ax.set_yscale("log")
        ax.set_ylim(UNIT / 30, HIGHEST)
        ax.axhline(UNIT, color=INK, linewidth=0.9, linestyle=DOTTED)
        ax.text(1, UNIT, " u", fontsize=8.5, va="center", color=INK, transform=ax.get_yaxis_transform())
        for power in range(1, 5):
            ax.axvline(UNIT ** -power, color=FAINT, linewidth=1.1)
            ax.text(UNIT ** -power, HIGHEST / 4, f" 1/u{'' if power == 1 else f'^{power}'}", fontsize=8.5, va="top", color=INK)
        title = FORM.get(curve, (curve,))[0]
        ax.set_title(title[0].upper() + title[1:], loc="left")
        ax.set_ylabel("median relative error")
        beside(ax)
    axes[-1][0].set_xlabel("median condition number p~/|p|")
    return finish(canvas, ID, "Relative error against condition number; one point per cell, errors above 1e6 not drawn",
                  "相对误差与条件数", "Doubly logarithmic, with lines at u and at condition 1/u to 1/u^4. " + "; ".join(words) + ".",
                  bottom=0.1)
