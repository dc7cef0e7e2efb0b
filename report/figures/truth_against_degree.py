# SPDX-License-Identifier: MIT
"""Methods against the exact value."""

import math

from ..methods import FORM
from ..wording import general
from .canvas import INK, PAPER, finish, panels, styled

ID = "truth-against-degree"
CURVES = ("bezier", "polynomial")


def _shade(i, n):
    """From light to full blue."""
    low, high = (0.60, 0.77, 0.93), (0.10, 0.36, 0.64)
    f = i / max(n - 1, 1)
    return tuple(a + f * (b - a) for a, b in zip(low, high))


def _errors(bundle, curve):
    """[(method, {degree: mean error over u p~})], worst at its highest degree first."""
    rows = bundle.judged().some(study=f"truth-{curve}", baseline="exact", generator="continuous", scalar="double",
                                dimension=2)
    methods = {}
    for row in rows:
        value = row["mean_error_u"]
        if isinstance(value, float) and math.isfinite(value) and value > 0:
            methods.setdefault(row["method"], {})[row["degree"]] = value
    return sorted(methods.items(), key=lambda item: -item[1][max(item[1])])


@styled
def draw(bundle):
    """Mean error over u p~: one line per method, one dot per degree."""
    errors = {curve: _errors(bundle, curve) for curve in CURVES}
    heights = [len(e) for e in errors.values()]
    degrees = sorted({n for e in errors.values() for _, points in e for n in points})
    canvas, axes = panels(2, 1, height=0.105 * sum(heights) + 0.9, gridspec_kw={"height_ratios": heights}, sharex=True)
    words = []
    for curve, ax in zip(CURVES, axes[:, 0]):
        title = FORM[curve][0]
        for line, (_, points) in enumerate(errors[curve]):
            ax.plot(list(points.values()), [line] * len(points), color=INK, linewidth=0.6, alpha=0.5, zorder=1)
            for degree in sorted(points):
                ax.plot(points[degree], line, linestyle="none", marker="o", markersize=7, markeredgewidth=0.6,
                        markeredgecolor=PAPER, color=_shade(degrees.index(degree), len(degrees)), zorder=2 + degree)
        ax.set_yticks(range(len(errors[curve])), [method for method, _ in errors[curve]], fontsize=8.5)
        ax.set_ylim(len(errors[curve]) - 0.4, -0.6)
        ax.set_xscale("log")
        ax.set_title(title)
        (worst, bad), (best, good) = errors[curve][0], errors[curve][-1]
        words.append(f"{title}: the worst at its highest degree is {worst} with {general(bad[max(bad)])}, the best {best} "
                     f"with {general(good[max(good)])}")
    axes[-1][0].set_xlabel("mean error / (u p~)")
    handles = [axes[-1][0].plot([], [], linestyle="none", marker="o", markersize=7, color=_shade(i, len(degrees)),
                                label=f"n = {degree:g}")[0] for i, degree in enumerate(degrees)]
    canvas.legend(handles=handles, loc="lower center", ncol=len(handles), fontsize=9, columnspacing=1.2, handletextpad=0.2)
    return finish(canvas, ID, "Mean error over u p~ of every method, against the exact value",
                  "各方法相对精确值的平均误差（以 u p~ 计）",
                  "One line per method, one dot per degree, logarithmic. " + "; ".join(words) + ".", bottom=0.35)
