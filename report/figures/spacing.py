# SPDX-License-Identifier: MIT
"""Points at equal steps of t and at equal steps of the length."""

from ..bundle import Missing
from ..wording import span
from .canvas import COLOURS, FAINT, finish, panels, styled

ID = "spacing"
STUDIES = {"inverse_arc_length-tolerance": "random curve", "inverse_arc_length-cusp": "curve that stops inside"}
SPACINGS = {"parameter": "equal steps of t", "arc_length": "equal steps of the length"}


@styled
def draw(bundle):
    """A row for each curve: its outline, with points of the one and of the other spacing."""
    table = bundle["spacing.csv"]
    studies = [s for s in STUDIES if table.select(study=s, dimension=2)]
    if not studies:
        raise Missing("`spacing.csv` has no planar curve of the studies that a figure shows")
    canvas, axes = panels(len(studies), len(SPACINGS), height=2.9)
    texts = []
    for row, study in zip(axes, studies):
        outline = table.select(study=study, spacing="outline")
        for ax, (spacing, words), colour in zip(row, SPACINGS.items(), COLOURS):
            points = table.select(study=study, spacing=spacing)
            gaps = [p["gap"] for p in points if p["gap"] is not None]
            ax.plot([p["x"] for p in outline], [p["y"] for p in outline], color=FAINT, linewidth=1)
            ax.plot([p["x"] for p in points], [p["y"] for p in points], color=colour, linestyle="none", marker="o", markersize=4)
            ax.set_aspect("equal", adjustable="datalim")
            ax.set_title(f"{STUDIES[study][0].upper()}{STUDIES[study][1:]}, {words}", loc="left")
            if gaps:
                texts.append(f"{STUDIES[study]}, {words}: gaps of {span(min(gaps), max(gaps), lambda gap: f'{gap:.2f}')} of the mean")
    return finish(canvas, ID, "Points at equal steps of t, left, and at equal steps of the length, right",
                  "等参数步长（左）与等弧长（右）取点", "; ".join(texts) + ".", bottom=0.1)
