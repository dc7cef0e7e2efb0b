# SPDX-License-Identifier: MIT
"""Where the error of a converted path comes from: its parts beside each other, method by method."""

from ..findings.conversion import SOURCES, sources
from ..methods import FORM
from ..wording import interval, scientific
from .canvas import COLOURS, FAINT, finish, panels, styled
from .method_lines import positive

ID = "conversion-sources"
MARKERS = ("s", "D", "o")


@styled
def draw(bundle):
    """Mean parts of the error at the highest degree, in the first and the last interval of t; parts that are 0 are not drawn."""
    rows = sources(bundle)
    studies = list(dict.fromkeys(r["study"] for r in rows))
    heights = [len({r["method"] for r in rows if r["study"] == s}) for s in studies]
    canvas, axes = panels(len(studies), 2, height=0.105 * sum(heights) + 0.9, gridspec_kw={"height_ratios": heights})
    words = []
    for line, study in enumerate(studies):
        own = [r for r in rows if r["study"] == study]
        degree = max(r["degree"] for r in own)
        intervals = sorted({(r["t_min"], r["t_max"]) for r in own})
        methods = list(dict.fromkeys(r["method"] for r in own))
        for ax, place in zip(axes[line], (intervals[0], intervals[-1])):
            cells = {r["method"]: r for r in own if r["degree"] == degree and (r["t_min"], r["t_max"]) == place}
            for k, (column, _) in enumerate(SOURCES):
                points = [(cells[m][column], y) for y, m in enumerate(methods) if m in cells and positive(cells[m], column)]
                if points:
                    ax.plot(*zip(*points), linestyle="none", marker=MARKERS[k], markersize=5.5, color=COLOURS[k], alpha=0.9)
            ax.set_yticks(range(len(methods)), methods if ax is axes[line][0] else [""] * len(methods), fontsize=7.5)
            ax.set_ylim(len(methods) - 0.4, -0.6)
            ax.set_xscale("log")
            ax.tick_params(axis="x", labelsize=8)
            ax.grid(axis="y", color=FAINT, alpha=0.28)
            title = FORM.get(own[0]["curve"], (own[0]["curve"],))[0]
            ax.set_title(f"{title}, degree {degree:g}, t in {interval(*place)}", loc="left", fontsize=9)
            worst = max(cells.values(), key=lambda r: r["mean_error"])
            words.append(f"{title}, t in {interval(*place)}: the worst path is {worst['method']} with "
                         + ", ".join(f"{name} {scientific(worst[column])}" for column, name in SOURCES))
    for ax in axes[-1]:
        ax.set_xlabel("mean error (coordinate units)")
    handles = [axes[0][0].plot([], [], linestyle="none", marker=MARKERS[k], color=COLOURS[k], label=name)[0]
               for k, (_, name) in enumerate(SOURCES)]
    canvas.legend(handles=handles, loc="lower center", ncol=3, fontsize=9)
    return finish(canvas, ID, "Parts of the error of a path: conversion, rounding of 1-t, evaluation; a part that is 0 has "
                              "no mark",
                  "路径误差的来源：转换、1-t 的舍入、求值", "; ".join(words) + ".", bottom=0.35)
