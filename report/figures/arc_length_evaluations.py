# SPDX-License-Identifier: MIT
"""Arc lengths: what a digit costs."""

from ..bundle import Missing
from ..wording import general
from .canvas import finish, panels, styled
from .method_lines import draw_methods, error_axis, looks, positive

ID = "arc-length-evaluations"
STUDY, DEGREE = "arc_length-tolerance", 3
WORDS = {"continuous": "random cubics", "integer": "cubics with small whole coordinates: cusps, turns, loops"}


@styled
def draw(bundle):
    """Largest relative error against the mean number of evaluations, a point for each tolerance."""
    table = bundle["arc_length.csv"]
    parts = []
    for generator, words in WORDS.items():
        lines = {}
        for row in table.select(study=STUDY, degree=DEGREE, generator=generator):
            if positive(row, "max_relative") and positive(row, "mean_evaluations"):
                lines.setdefault(row["method"], []).append((row["mean_evaluations"], row["max_relative"]))
        if lines:
            parts.append((words, {m: sorted(points) for m, points in lines.items()}))
    if not parts:
        raise Missing(f"`arc_length.csv` has no `{STUDY}` row of degree {DEGREE} that a figure can show")
    canvas, axes = panels(len(parts), 1, height=2.7)
    look = {m: {**style, "marker": "o"} for m, style in looks(sorted({m for _, lines in parts for m in lines})).items()}
    texts = []
    for ax, (title, lines) in zip(axes[:, 0], parts):
        draw_methods(ax, lines, look)
        title = title[0].upper() + title[1:]
        ax.set_title(title, loc="left")
        error_axis(ax)
        ax.set_xscale("log")
        ax.set_ylabel("largest relative error")
        texts.append(f"{title}: " + ", ".join(f"{m} ends at {general(points[-1][0])} evaluations with {general(points[-1][1])}"
                                              for m, points in lines.items()))
    axes[-1][0].set_xlabel("mean evaluations")
    return finish(canvas, ID, "Largest relative error of an arc length against the evaluations that it took, a point for each "
                  "tolerance", "弧长最大相对误差与求值次数", "Doubly logarithmic. " + "; ".join(texts) + ".", bottom=0.1)
