# SPDX-License-Identifier: MIT
"""The matrix of verdicts: methods down, properties across, for cubics in double, or what a study has first."""

from ..bundle import Missing
from ..guarantee_words import of_all, share
from ..wording import percent
from .canvas import COLOURS, FAINT, INK, finish, panels, styled

ID = "guarantee-matrix"
SHOWN = (3, "double")  # degree and scalar type
COLOUR = {"proved": COLOURS[2], "refuted": COLOURS[1], "not_refuted": FAINT}
MEANING = {"proved": "proved", "refuted": "broken, with the share of random inputs that break it", "not_refuted": "open"}


@styled
def draw(bundle, study=None):
    """A square for each method without conversion and each property, of a study or of all of the suite."""
    table = bundle.judged("guarantees.csv")
    rows = [r for r in (table.some(study=study) if study else table.of_suite("guarantees").rows) if ":" not in r["method"]]
    if not rows:
        raise Missing("`guarantees.csv` has no row of a method without conversion")
    cells = dict.fromkeys((r["degree"], r["scalar"]) for r in rows)
    degree, scalar = SHOWN if SHOWN in cells else next(iter(cells))
    rows = [r for r in rows if (r["degree"], r["scalar"]) == (degree, scalar)]
    methods, properties = (list(dict.fromkeys(r[c] for r in rows)) for c in ("method", "property"))
    canvas, axes = panels(1, 1, height=0.26 * len(methods) + 1.4)
    ax = axes[0, 0]
    for at, method in enumerate(methods):
        for across, name in enumerate(properties):
            own = [r for r in rows if r["method"] == method and r["property"] == name]
            if not own:
                continue
            verdict = of_all(own)
            ax.fill([across - 0.46, across + 0.46, across + 0.46, across - 0.46], [at - 0.42, at - 0.42, at + 0.42, at + 0.42],
                    color=COLOUR[verdict], alpha=0.55, linewidth=0)
            if verdict == "refuted" and share(own):
                ax.text(across, at, percent(share(own)).replace("less than", "<").replace("more than", ">"), ha="center", va="center",
                        fontsize=6.5, color=INK)
    ax.set_xticks(range(len(properties)), [p.replace("_", "\n") for p in properties], fontsize=7)
    ax.set_yticks(range(len(methods)), methods, fontsize=8)
    ax.set_ylim(len(methods) - 0.5, -0.5)
    ax.set_xlim(-0.5, len(properties) - 0.5)
    ax.xaxis.tick_top()
    ax.grid(False)
    handles = [ax.fill([], [], color=colour, alpha=0.55, label=MEANING[verdict])[0] for verdict, colour in COLOUR.items()]
    canvas.legend(handles=handles, loc="lower center", ncol=3, fontsize=8)
    return finish(canvas, f"{study}-figure" if study else ID, f"What each method keeps of a curve of degree {degree:g} in {scalar}",
                  "各方法所保持的性质",
                  f"A matrix of {len(methods)} methods and {len(properties)} properties; the table below says the same in words.",
                  bottom=0.35)
