# SPDX-License-Identifier: MIT
"""Share of the peak against degree, a panel for each target."""

from ..bundle import Missing
from ..wording import general
from .canvas import FAINT, finish, panels, styled
from .method_lines import beside, looks

ID = "share-of-peak"
SCALAR = "double"


@styled
def draw(bundle):
    """Methods in double; the line at 100 % is the peak of fused multiply-adds."""
    rows = [r for r in bundle["roofline.csv"].rows if r["scalar"] == SCALAR and r["share_of_peak"] is not None]
    if not rows:
        raise Missing(f"`roofline.csv` has no share of a peak in {SCALAR}")
    axes_drawn = min(r["dimension"] for r in rows if r["dimension"] >= 2 or all(o["dimension"] < 2 for o in rows))
    rows = [r for r in rows if r["dimension"] == axes_drawn]
    targets = list(dict.fromkeys(r["target"] for r in rows))
    look = looks(list(dict.fromkeys(r["method"] for r in rows)))
    canvas, axes = panels(len(targets), 1, height=3.6)
    words = []
    for ax, target in zip(axes[:, 0], targets):
        lines = {}
        for row in (r for r in rows if r["target"] == target):
            lines.setdefault(row["method"], []).append((row.number("degree"), 100 * row.number("share_of_peak")))
        for method, points in sorted(lines.items(), key=lambda item: -max(item[1])[1]):
            ax.plot(*zip(*sorted(points)), **look[method], label=method)
            words.append(f"{target}, {method}: {general(max(points)[1])} % at degree {max(points)[0]:g}")
        ax.axhline(100, color=FAINT, linewidth=0.9, zorder=0)
        ax.set_ylim(bottom=0)
        ax.set_title(target, loc="left")
        ax.set_ylabel("% of the peak")
        beside(ax)
    axes[-1][0].set_xlabel("degree n")
    return finish(canvas, ID, f"Share of the multiply-add peak that the batch kernels reach ({SCALAR}, {axes_drawn:g} axes)",
                  "批量求值达到乘加峰值的比例", "; ".join(words) + ".", bottom=0.1)
