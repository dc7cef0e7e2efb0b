# SPDX-License-Identifier: MIT
"""Errors of converted coefficients by degree, with the norms of the conversions drawn over the data."""

from ..bundle import Missing
from ..findings.conversion import NORMS, UNIT, scale
from ..wording import scientific
from .canvas import COLOURS, DASHED, DOTTED, INK, finish, panels, styled
from .method_lines import beside, degree_axis, error_axis, positive

ID = "conversion-coefficients"
GENERATOR = "continuous"


@styled
def draw(bundle):
    """Largest error of a coefficient against degree, continuous inputs; the mean dotted."""
    table = bundle["conversion.csv"].of_suite("conversion")
    studies = [s for s in table.distinct("study") if table.select(study=s, generator=GENERATOR, curve=tuple(NORMS))]
    if not studies:
        raise Missing(f"`conversion.csv` has no `conversion-` row with `{GENERATOR}` inputs that names its curve")
    canvas, axes = panels(len(studies), 1, height=3.2)
    words = []
    for ax, study in zip(axes[:, 0], studies):
        rows = table.some(study=study, generator=GENERATOR)
        curve = rows[0]["curve"]
        for i, conversion in enumerate(dict.fromkeys(r["conversion"] for r in rows)):
            own = sorted((r for r in rows if r["conversion"] == conversion), key=lambda r: r["degree"])
            for column, style, label in (("max_error", "solid", conversion), ("mean_error", DOTTED, None)):
                points = [(r["degree"], r[column]) for r in own if positive(r, column)]
                ax.plot(*zip(*points), color=COLOURS[i % len(COLOURS)], linestyle=style, label=label)
            words.append(f"{conversion}: largest {scientific(own[0]['max_error'])} at degree {own[0]['degree']:g}, "
                         f"{scientific(own[-1]['max_error'])} at {own[-1]['degree']:g}")
        title, formula, norm = NORMS[curve]
        points = sorted({(r["degree"], UNIT * scale(r) * norm(int(r["degree"]))) for r in rows})
        ax.plot(*zip(*points), color=INK, linestyle=DASHED, linewidth=1.2, label=f"u R √d times {formula}")
        ax.set_title(title, loc="left")
        error_axis(ax)
        degree_axis(ax, {r["degree"] for r in rows})
        ax.set_ylabel("error of a coefficient\n(coordinate units)")
        beside(ax)
    axes[-1][0].set_xlabel("degree n")
    return finish(canvas, ID, "Error of converted coefficients against degree, continuous inputs: largest (solid) and mean "
                              "(dotted)",
                  "转换后系数的误差与阶数", "Doubly logarithmic, with the norm of the conversion dashed. " + "; ".join(words) + ".", bottom=0.1)
