# SPDX-License-Identifier: MIT
"""Methods or families down, a value across: marks, bars and squares."""

from decimal import Decimal

from ..bundle import Missing
from ..findings.evaluators import UNIT
from ..guarantee_words import SEARCHES, of_all, share
from ..methods import FORM
from ..rows import grouped
from ..wording import general, listing, percent
from .canvas import COLOURS, DOTTED, FAINT, INK, belongs, figure, finish, panels
from .colours import chosen, leading, looks
from .lines import MOST_NAMED, beside, conversion, positive

HIGHEST = 1e6  # a relative error above this says no more than one of it
SHOWN = (3, "double")  # degree and scalar type
VERDICT_COLOUR = {"proved": COLOURS[2], "refuted": COLOURS[1], "not_refuted": FAINT}
VERDICT_MEANING = {"proved": "proved", "refuted": "broken, with the share of random inputs that break it", "not_refuted": "open"}
SEARCH_MARKS = ("o", "D", "s", "^")
STEP = 0.16  # from one search of a family to the next, in lines
MAXIMA_MARKS = (("sampled_error_u", "sampled", "o", COLOURS[0]), ("searched_error_u", "searched", "D", COLOURS[1]),
         ("bound_u", "proved bound", "|", INK))
LIMIT = 1e4  # an error beyond it is written at the edge: on its axis the others would be one point


@figure
def error_against_condition(bundle, whole=False):
    """One point per cell: median relative error against median condition number, a panel for each form of curve."""
    table = bundle.exact("conditioning")
    rows = [r for r in table.rows if positive(r, "p50_condition") and positive(r, "p50_relative")]
    curves = list(dict.fromkeys(r["form"] for r in rows))
    if not rows:
        raise Missing("`accuracy.csv` has no column `p50_condition` or `p50_relative`")
    canvas, axes = panels(len(curves), 1, height=3.9, sharex=True)
    words, some = [], False
    for ax, curve in zip(axes[:, 0], curves):
        points_of = {method: sorted((r["p50_condition"], r["p50_relative"]) for r in own)
                     for method, own in grouped((r for r in rows if r["form"] == curve), "method").items()}
        shown = list(points_of) if whole else leading(bundle, list(points_of), lambda method, points=points_of: points[method][-1][1])
        some = some or chosen(shown, points_of)
        for method, look in looks(bundle, shown).items():
            points = points_of[method]
            ax.plot(*zip(*points), **look, linestyle="none", markeredgewidth=1.1, markerfacecolor="none", label=method)
            words.append(f"{FORM.get(curve, (curve,))[0]}, {method}: {general(points[0][1])} at condition "
                         f"{general(points[0][0])} "
                         f"to {general(points[-1][1])} at {general(points[-1][0])}")
        ax.set_xscale("log")
        ax.set_yscale("log")
        ax.set_ylim(UNIT / 30, HIGHEST)
        ax.axhline(UNIT, color=INK, linewidth=0.9, linestyle=DOTTED)
        ax.text(1, UNIT, " u", fontsize=8.5, va="center", color=INK, transform=ax.get_yaxis_transform())
        for power in range(1, 5):
            ax.axvline(UNIT ** -power, color=FAINT, linewidth=1.1)
            ax.text(UNIT ** -power, HIGHEST / 4, f" 1/u{'' if power == 1 else f'^{power}'}", fontsize=8.5, va="top", color=INK)
        title = FORM.get(curve, (curve,))[0]
        ax.set_title(title[0].upper() + title[1:], loc="left")
        ax.set_ylabel("median relative error")
        if len(shown) <= MOST_NAMED:
            beside(ax)
    axes[-1][0].set_xlabel("median condition number p~/|p|")
    return finish(canvas, "error-against-condition", "Relative error against condition number; one point per cell, errors above 1e6 not drawn", "Doubly logarithmic, with lines at u and at condition 1/u to 1/u^4. " + "; ".join(words) + ".",
                  bottom=0.1, note=some or "", more=(lambda: error_against_condition(bundle, True)) if some else None)


@figure
def guarantee_matrix(bundle, study=None):
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
    ax, read = axes[0, 0], {}
    for at, method in enumerate(methods):
        for across, name in enumerate(properties):
            own = [r for r in rows if r["method"] == method and r["property"] == name]
            if not own:
                continue
            verdict = of_all(own)
            belongs(VERDICT_MEANING[verdict], *ax.fill([across - 0.46, across + 0.46, across + 0.46, across - 0.46], [at - 0.42, at - 0.42, at + 0.42, at + 0.42],
                                                       color=VERDICT_COLOUR[verdict], alpha=0.55, linewidth=0))
            read.setdefault(verdict, []).append((across, at, f"{method}, {name.replace('_', ' ')}" + (f", {percent(share(own))}" if verdict == "refuted" and share(own) else "")))
            if verdict == "refuted" and share(own):
                ax.text(across, at, percent(share(own)).replace("less than", "<").replace("more than", ">"), ha="center", va="center",
                        fontsize=6.5, color=INK)
    for verdict, cells in read.items():
        x, y, words = zip(*cells)
        point, = ax.plot(x, y, linestyle="none", color=VERDICT_COLOUR[verdict])
        point.series_name, point.reads = VERDICT_MEANING[verdict], words
    ax.set_xticks(range(len(properties)), [p.replace("_", "\n") for p in properties], fontsize=7)
    ax.set_yticks(range(len(methods)), methods, fontsize=8)
    ax.set_ylim(len(methods) - 0.5, -0.5)
    ax.set_xlim(-0.5, len(properties) - 0.5)
    ax.xaxis.tick_top()
    ax.grid(False)
    handles = [ax.fill([], [], color=colour, alpha=0.55, label=VERDICT_MEANING[verdict])[0] for verdict, colour in VERDICT_COLOUR.items()]
    canvas.legend(handles=handles, loc="lower center", ncol=3, fontsize=8)
    return finish(canvas, f"{study}-figure" if study else "guarantee-matrix", f"What each method keeps of a curve of degree {degree:g} in {scalar}",
                  f"A matrix of {len(methods)} methods and {len(properties)} properties; the table below says the same in words.",
                  bottom=0.35)


def _power(row):
    """log10 of the distance; None on a boundary. Many distances lie below the smallest double."""
    distance = Decimal(row.text("distance_ulp"))
    return float(distance.log10()) if distance else None


def _words(label, families, rows):
    """Of each family the least distance that is not 0."""
    least = {family: min((_power(r) for r in rows if r["family"] == family and _power(r) is not None), default=None) for family in families}
    return f"{label}: " + ", ".join(f"{family} from {'no other than 0' if power is None else f'about 1e{power:.0f}'}" for family, power in least.items())


@figure
def hard_case_distances(bundle, study):
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
                line, = ax.plot([_power(r) for r in own], places, linestyle="none", marker=SEARCH_MARKS[at], markersize=4, markerfacecolor="none",
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
                  "and search" + (f"; {len(on)} cases on a boundary, of {listing(dict.fromkeys(r['family'] for r in on))}, have none" if on else ""), "Logarithmic. " + "; ".join(_words(s, families, [r for r in rows if r["scalar"] == s]) for s in scalars) + ".",
                  bottom=0.35)


def _line(ax, y, row):
    shown = [(positive(row, column), name, mark, colour) for column, name, mark, colour in MAXIMA_MARKS if positive(row, column)]
    ends = [min(value, LIMIT) for value, *_ in shown]
    ax.plot([min(ends), max(ends)], [y, y], color=FAINT, linewidth=0.8, zorder=1)
    for value, name, mark, colour in shown:
        if value < LIMIT:
            point, = ax.plot([value], [y], linestyle="none", marker=mark, color=colour, markersize=9 if mark == "|" else 5,
                             markeredgewidth=2 if mark == "|" else 0.5, zorder=2)
            point.series_name, point.rows, point.reads = name, [row], [f"{row['method']} {general(value)} u p~"]
    beyond = [(f"{name} {general(value)}", colour) for value, name, _, colour in shown if value >= LIMIT]
    if beyond:  # in one text: each at the same edge would lie upon the others
        colour = beyond[0][1] if len(beyond) == 1 else INK
        ax.annotate(", ".join(text for text, _ in beyond) + " →", (LIMIT, y), xytext=(-3, 4), textcoords="offset points", ha="right",
                    fontsize=7.5, color=colour)


@figure
def searched_maxima(bundle):
    """A panel for each form and degree; converted paths, whose bounds lie decades higher, stand in the table."""
    rows = [r for r in bundle["search.csv"].of_suite("worst").rows if not conversion(r["method"]) and positive(r, "searched_error_u")]
    if not rows:
        raise Missing("`search.csv` has no `worst-` row of a method without conversion")
    curves = list(dict.fromkeys(r["form"] for r in rows))
    degrees = sorted({r["degree"] for r in rows})
    methods = {c: list(dict.fromkeys(r["method"] for r in rows if r["form"] == c)) for c in curves}
    heights = [len(m) + 1 for m in methods.values()]
    canvas, axes = panels(len(curves), len(degrees), height=0.115 * sum(heights) + 0.6, gridspec_kw={"height_ratios": heights},
                          sharex=True)
    words = []
    for line, curve in enumerate(curves):
        for ax, degree in zip(axes[line], degrees):
            cells = {r["method"]: r for r in rows if r["form"] == curve and r["degree"] == degree}
            for y, method in enumerate(methods[curve]):
                if method in cells:
                    _line(ax, y, cells[method])
            ax.set_yticks(range(len(methods[curve])), methods[curve] if ax is axes[line][0] else [""] * len(methods[curve]), fontsize=8)
            ax.set_ylim(len(methods[curve]) - 0.4, -0.6)
            ax.set_xscale("log")
            ax.set_xlim(right=min(2 * max(positive(r, c) or 0 for r in rows for c, *_ in MAXIMA_MARKS), LIMIT))
            ax.set_title(f"{FORM.get(curve, (curve,))[0]}, degree {degree:g}", loc="left", fontsize=9)
            if cells:
                worst = max(cells.values(), key=lambda r: r["searched_error_u"])
                words.append(f"{FORM.get(curve, (curve,))[0]}, degree {degree:g}: the largest searched maximum is "
                             f"{general(worst['searched_error_u'])} by {worst['method']}")
    for ax in axes[-1]:
        ax.set_xlabel("error / (u p~)")
    handles = [axes[0][0].plot([], [], linestyle="none", marker=mark, color=colour, markersize=7, markeredgewidth=2 if mark == "|" else 0.5,
                               label=name)[0] for _, name, mark, colour in MAXIMA_MARKS]
    canvas.legend(handles=handles, loc="lower center", ncol=3, fontsize=9)
    return finish(canvas, "searched-maxima", "Sampled and searched maximum and proved bound, methods that evaluate the given form", "Logarithmic. " + "; ".join(words) + ".", bottom=0.35)
