# SPDX-License-Identifier: MIT
"""Fits: what a digit costs in segments."""

from ..bundle import Missing
from ..wording import general
from .canvas import finish, log_axis, panels, styled
from .method_lines import draw_methods, error_axis, looks, positive

ID = "fitting-segments"
STUDY, DIMENSION = "fitting-cubics", 2
WORDS = {"samples": "samples of cubics", "noisy": "samples with noise of 2^-10 R", "polyline": "points along control polygons"}


@styled
def draw(bundle):
    """Largest true error against the mean number of segments, a point for each tolerance."""
    table = bundle["fitting.csv"]
    parts = []
    for data, words in WORDS.items():
        lines = {}
        for row in sorted(table.select(study=STUDY, dimension=DIMENSION, data=data), key=lambda r: -r["tolerance"]):
            if positive(row, "max_error") and positive(row, "mean_segments"):
                lines.setdefault(row["method"], []).append((row["mean_segments"], row["max_error"]))
        if lines:
            parts.append((words, lines))
    if not parts:
        raise Missing(f"`fitting.csv` has no `{STUDY}` row that a figure can show")
    canvas, axes = panels(len(parts), 1, height=2.4)
    look = {m: {**style, "marker": "o"} for m, style in looks(sorted({m for _, lines in parts for m in lines})).items()}
    texts = []
    for ax, (words, lines) in zip(axes[:, 0], parts):
        draw_methods(ax, lines, look)
        ax.set_title(words[0].upper() + words[1:], loc="left")
        error_axis(ax)
        ax.set_xscale("log")
        log_axis(ax.xaxis, (1, 2, 5, 10, 20, 50))
        ax.set_ylabel("largest error")
        texts.append(f"{words}: " + ", ".join(f"{m} ends at {general(points[-1][0])} segments with {general(points[-1][1])}"
                                              for m, points in lines.items()))
    axes[-1][0].set_xlabel("mean number of segments")
    return finish(canvas, ID, "Largest true error of fits against the number of segments, a point for each tolerance",
                  "拟合误差与段数", "Doubly logarithmic. " + "; ".join(texts) + ".", bottom=0.1)
