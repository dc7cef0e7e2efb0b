# SPDX-License-Identifier: MIT
"""Shares of misrounded coordinates: of curves of size 1 against their distance, beside those of sets."""

from .. import inputs
from ..bundle import Missing
from ..findings.real_curves import judged, kinds, share
from ..rows import distinct, grouped
from ..wording import shortest
from .canvas import figure, finish, panels
from .colours import chosen, leading, looks
from .lines import MOST_NAMED, draw_methods, point_of, positive, series

LOCAL = "local"
MOST = 3  # panels under each other


@figure
def misrounded_by_distance(bundle, whole=False):
    """For each degree of the local curves that sets have, in the first type: the distance across on the left, sets on the right."""
    rows = judged(bundle)
    local = grouped((r for r in rows if r["generator"] == LOCAL and not r["curves"]), "form", "degree", "dimension", "scalar")
    sets = kinds(rows)
    cells = [(key, own, [r for r in sets[key[:3]] if r["scalar"] == key[3]]) for key, own in local.items() if key[:3] in sets]
    cells = [cell for cell in cells if cell[0][3] == cells[0][0][3]][:MOST]
    if not cells:
        raise Missing("`accuracy.csv` has no curves of the generator `local` of a degree that sets have")
    methods = distinct((r for _, own, _ in cells for r in own), "method")
    share_of = {r["method"]: r["misrounded"] or 0 for _, own, _ in cells for r in own}
    shown = methods if whole else leading(bundle, methods, share_of.get)
    look = looks(bundle, shown)
    canvas, axes = panels(len(cells), 2, sharey="row", width_ratios=(1.2, 1))
    words = []
    for (left, right), ((_, degree, _, scalar), own, on_sets) in zip(axes, cells):
        draw_methods(left, series([r for r in own if r["method"] in shown], lambda r: r["coordinate_range"], "misrounded"), look)
        handles = left.get_legend_handles_labels()
        if left.get_legend():
            left.get_legend().remove()
        left.set_xscale("log")
        left.set_yscale("log")
        left.set_title(f"degree {shortest(degree)}, {scalar}: size 1, distance R", loc="left")
        left.set_ylabel("share misrounded")
        places = {key: at for at, key in enumerate(grouped(on_sets, *inputs.ONE_SET))}
        for method in shown:
            points = [point_of(r, float(places[tuple(r[c] for c in inputs.ONE_SET)]), r["misrounded"]) for r in on_sets
                      if r["method"] == method and positive(r, "misrounded")]
            if points:
                line, = right.plot(*zip(*points), **look[method], linestyle="none", label=method)
                line.rows = [point.row for point in points]
        right.set_xticks(range(len(places)), [f"{curves}, {placement}" for curves, placement, *_ in places], fontsize=7, rotation=40, ha="right")
        right.margins(x=0.15)
        right.set_title("sets, by placement", loc="left")
        if len(shown) <= MOST_NAMED:
            right.legend(*handles, loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=7.5, handlelength=2.6)
        words.append(f"degree {shortest(degree)}: " + ", ".join(f"{r['method']} {share(r['misrounded'])} at R = {shortest(r['coordinate_range'])}"
                                                                for r in {r["method"]: r for r in own}.values()))
    axes[-1][0].set_xlabel("R, the distance over the size")
    return finish(canvas, "misrounded-by-distance", "Share of misrounded coordinates: curves of size 1 at a distance R, and the sets; no mark where there is none",
                  f"Logarithmic. {'; '.join(words)}.", bottom=0.1, note=chosen(shown, methods),
                  more=(lambda: misrounded_by_distance(bundle, True)) if len(shown) < len(methods) else None)
