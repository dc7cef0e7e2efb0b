# SPDX-License-Identifier: MIT
"""Sampled maximum, searched maximum and proved bound of the methods that evaluate the given form."""

from ..bundle import Missing
from ..methods import FORM
from ..wording import general
from .canvas import COLOURS, FAINT, INK, finish, panels, styled
from .method_lines import conversion, positive

ID = "searched-maxima"
MARKS = (("sampled_error_u", "sampled", "o", COLOURS[0]), ("searched_error_u", "searched", "D", COLOURS[1]),
         ("bound_u", "proved bound", "|", INK))
LIMIT = 1e4  # an error beyond it is written at the edge: on its axis the others would be one point


def _line(ax, y, row):
    shown = [(positive(row, column), name, mark, colour) for column, name, mark, colour in MARKS if positive(row, column)]
    ends = [min(value, LIMIT) for value, *_ in shown]
    ax.plot([min(ends), max(ends)], [y, y], color=FAINT, linewidth=0.8, zorder=1)
    for value, _, mark, colour in shown:
        if value < LIMIT:
            ax.plot(value, y, marker=mark, color=colour, markersize=9 if mark == "|" else 5,
                    markeredgewidth=2 if mark == "|" else 0.5, zorder=2)
    beyond = [(f"{name} {general(value)}", colour) for value, name, _, colour in shown if value >= LIMIT]
    if beyond:  # in one text: each at the same edge would lie upon the others
        colour = beyond[0][1] if len(beyond) == 1 else INK
        ax.annotate(", ".join(text for text, _ in beyond) + " →", (LIMIT, y), xytext=(-3, 4), textcoords="offset points", ha="right",
                    fontsize=7.5, color=colour)


@styled
def draw(bundle):
    """A panel for each form and degree; converted paths, whose bounds lie decades higher, stand in the table."""
    rows = [r for r in bundle["search.csv"].of_suite("worst").rows if not conversion(r["method"]) and positive(r, "searched_error_u")]
    if not rows:
        raise Missing("`search.csv` has no `worst-` row of a method without conversion")
    curves = list(dict.fromkeys(r["curve"] for r in rows))
    degrees = sorted({r["degree"] for r in rows})
    methods = {c: list(dict.fromkeys(r["method"] for r in rows if r["curve"] == c)) for c in curves}
    heights = [len(m) + 1 for m in methods.values()]
    canvas, axes = panels(len(curves), len(degrees), height=0.115 * sum(heights) + 0.6, gridspec_kw={"height_ratios": heights},
                          sharex=True)
    words = []
    for line, curve in enumerate(curves):
        for ax, degree in zip(axes[line], degrees):
            cells = {r["method"]: r for r in rows if r["curve"] == curve and r["degree"] == degree}
            for y, method in enumerate(methods[curve]):
                if method in cells:
                    _line(ax, y, cells[method])
            ax.set_yticks(range(len(methods[curve])), methods[curve] if ax is axes[line][0] else [""] * len(methods[curve]), fontsize=8)
            ax.set_ylim(len(methods[curve]) - 0.4, -0.6)
            ax.set_xscale("log")
            ax.set_xlim(right=min(2 * max(positive(r, c) or 0 for r in rows for c, *_ in MARKS), LIMIT))
            ax.set_title(f"{FORM.get(curve, (curve,))[0]}, degree {degree:g}", loc="left", fontsize=9)
            if cells:
                worst = max(cells.values(), key=lambda r: r["searched_error_u"])
                words.append(f"{FORM.get(curve, (curve,))[0]}, degree {degree:g}: the largest searched maximum is "
                             f"{general(worst['searched_error_u'])} by {worst['method']}")
    for ax in axes[-1]:
        ax.set_xlabel("error / (u p~)")
    handles = [axes[0][0].plot([], [], linestyle="none", marker=mark, color=colour, markersize=7, markeredgewidth=2 if mark == "|" else 0.5,
                               label=name)[0] for _, name, mark, colour in MARKS]
    canvas.legend(handles=handles, loc="lower center", ncol=3, fontsize=9)
    return finish(canvas, ID, "Sampled and searched maximum and proved bound, methods that evaluate the given form",
                  "抽样最大误差、搜索最大误差与已证误差界", "Logarithmic. " + "; ".join(words) + ".", bottom=0.35)
