# SPDX-License-Identifier: MIT
"""Hard cases: how far the exact values lie from a rounding boundary, a line of marks for each family of inputs."""

from decimal import Decimal

from ..bundle import Missing
from ..chapters.hard_cases import SEARCHES
from ..wording import listing
from .canvas import COLOURS, finish, panels, styled

MARKS = ("o", "D", "s", "^")
STEP = 0.16  # from one search of a family to the next, in lines


def _power(row):
    """log10 of the distance; None on a boundary. Many distances lie below the smallest double."""
    distance = Decimal(row.text("distance_ulp"))
    return float(distance.log10()) if distance else None


def _words(label, families, rows):
    """Of each family the least distance that is not 0."""
    least = {family: min((_power(r) for r in rows if r["family"] == family and _power(r) is not None), default=None) for family in families}
    return f"{label}: " + ", ".join(f"{family} from {'no other than 0' if power is None else f'about 1e{power:.0f}'}" for family, power in least.items())


@styled
def draw(bundle, study):
    """A panel for each scalar type: families down, the distance across, a colour for each search."""
    rows = bundle["hard_cases.csv"].some(study=study)
    families, scalars = (list(dict.fromkeys(r[c] for r in rows)) for c in ("family", "scalar"))
    if all(_power(r) is None for r in rows):
        raise Missing(f"every case of the study `{study}` lies on a rounding boundary")
    canvas, axes = panels(len(scalars), 1, height=0.3 * len(families) + 1.1)
    for ax, scalar in zip(axes[:, 0], scalars):
        for at, (search, words) in enumerate(SEARCHES.items()):
            own = [r for r in rows if (r["scalar"], r["search"]) == (scalar, search) and _power(r) is not None]
            if own:
                places = [families.index(r["family"]) + (at - (len(SEARCHES) - 1) / 2) * STEP for r in own]
                line, = ax.plot([_power(r) for r in own], places, linestyle="none", marker=MARKS[at], markersize=4, markerfacecolor="none",
                                markeredgecolor=COLOURS[at], label=words)
                line.reads = [f"{r['family']}, degree {r['degree']:g}: {Decimal(r.text('distance_ulp')):.2e} ulp" for r in own]
        ax.set_yticks(range(len(families)), families, fontsize=8)
        ax.set_ylim(len(families) - 0.5, -0.5)
        ax.xaxis.set_major_formatter(lambda power, _: f"1e{power:.0f}" if power else "1")
        ax.set_title(scalar, loc="left")
    axes[-1][0].set_xlabel("distance from a rounding boundary, ulp")
    handles = {text: handle for ax in axes[:, 0] for handle, text in zip(*ax.get_legend_handles_labels())}
    canvas.legend(list(handles.values()), list(handles), loc="lower center", ncol=len(handles), fontsize=8)
    on = [r for r in rows if _power(r) is None]
    return finish(canvas, f"{study}-figure", f"{bundle.title(study)}: the distance of each exact value from a rounding boundary, by family "
                  "and search" + (f"; {len(on)} cases on a boundary, of {listing(dict.fromkeys(r['family'] for r in on))}, have none" if on else ""),
                  "真值与舍入边界的距离", "Logarithmic. " + "; ".join(_words(s, families, [r for r in rows if r["scalar"] == s]) for s in scalars) + ".",
                  bottom=0.35)
