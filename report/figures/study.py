# SPDX-License-Identifier: MIT
"""A study of any kind: what it measures, along the axis that it varies."""

import textwrap

from .. import schema
from ..bundle import Missing
from ..findings.finding import names
from ..rows import distinct, grouped
from ..tables import AXIS, axis_label
from ..wording import general, listing, span
from .canvas import belongs, figure, finish, panels
from .colours import chosen, leading, looks
from .lines import MOST_NAMED, degree_axis, draw_methods, point_of, positive

APART = ("form", "scalar", "mode", "target")  # a panel for each value
BESIDE = ("degree", "dimension", "order", "coordinate_range", "interval", "curves", "generator", "tolerance", "points", "data", "placement",
          "knots", "curve_id")
FEWEST = 3  # points that are worth a figure
FAR, FARTHEST = 1e3, 1e5  # times the best, in the largest value of a line
MOST_TICKS = 12  # places that are named
WIDTH = 28  # characters that fit the height of a panel
APART_AXES = ("interval", "curves", "generator", "placement", "data", "knots", "curve_id")  # whose values are places side by side, that no line joins
LONG = 10  # characters from which the names of places are written aslant, each of them
WORDS = {"placement": "placement of the point", "data": "data", "knots": "kind of knots", "generator": "inputs",
         "dimension": "axes of a point", "curve_id": "curve", "tolerance": "tolerance", "points": "points", **AXIS}


def _axis(kind, rows):
    """The sets of curves where there are several; else the first axis that the rows vary, of the kind or else of all; the last of the kind
    where they vary none."""
    axes = ("curves", *schema.across(kind))
    return next((a for a in (*axes, *BESIDE) if len(distinct(rows, a)) > 1), axes[-1])


def _rows(bundle, study, kind):
    """The rows of the study in the table of its kind; of accuracy those against the exact value, where there are any."""
    rows = bundle.judged(f"{kind}.csv").some(study=study)
    return [r for r in rows if r["baseline"] == "exact"] or rows


def _parts(rows):
    """{what sets a panel apart: rows}."""
    varies = [c for c in APART if len(distinct(rows, c)) > 1]
    return {", ".join(str(own[0][c]) for c in varies if own[0][c]): own for own in grouped(rows, *APART).values()}


def _merged(rows, axis):
    """What else varies, of which each point shows the largest value."""
    names = {"generator": "placement of the curves"} if rows[0]["curves"] else {}
    return [names.get(one, one.replace("_", " ")) for one in BESIDE if one != axis and len(distinct(rows, one)) > 1]


def _lines(rows, where, axis, column, method):
    """{method: points ascending}, at each place the row of the largest value."""
    best = {}
    for row in rows:
        if positive(row, column) is not None:
            key = row[method], where[row[axis]]
            if key not in best or row[column] > best[key][column]:
                best[key] = row
    lines = {}
    for (name, place), row in sorted(best.items(), key=lambda item: item[0][1]):
        lines.setdefault(name, []).append(point_of(row, place, row[column]))
    return lines


def _zeros(rows, axis, column, method):
    """{method: places at which all of its values are 0, which a logarithmic axis does not show}"""
    found = {}
    for (name, place), own in grouped(rows, method, axis).items():
        if all(row[column] == 0 for row in own):
            found.setdefault(name, []).append(place)
    return found


def _not_drawn(where, zeros, lines, shown):
    """Of a panel, the methods without any mark, and those drawn without one at some places."""
    without, partly = [m for m in zeros if m not in lines], [m for m in zeros if m in lines and m in shown]
    said = [names(without) if lines else "all methods" if without else "", f"at some places {names(partly)}" if partly else ""]
    return [f"of {where} {', and '.join(filter(None, said))}"] if any(said) else []


def _apart(lines):
    """Lines that a common axis can show; outliers have a panel of their own, so that the others remain distinguishable."""
    highest = {method: max(y for _, y in points) for method, points in lines.items()}
    limit = FAR * min(highest.values(), default=0)
    near = {method: points for method, points in lines.items() if highest[method] <= limit}
    far = {method: points for method, points in lines.items() if method not in near}
    if not far or max(highest.values()) < FARTHEST * min(highest.values()):
        return [("", lines)] if lines else []
    return [("the better methods", near), ("the others", far)]


@figure
def study_lines(bundle, study, whole=False):
    """A panel for each measure and each form, scalar type and mode; of the leading methods, or of all in the `whole`."""
    kind = bundle.studies[study].kind
    rows = [r for r in _rows(bundle, study, kind) if r["method"] != "sentinel"]
    axis = _axis(kind, rows)
    values = distinct(rows, axis)
    if not any(v is None or isinstance(v, str) for v in values):
        values.sort()
    if None in values:
        raise Missing(f"the study `{study}` has no axis that a figure can show")
    side_by_side = axis in APART_AXES or axis == "coordinate_range"  # 1e-300 to 1e300 is too far for a logarithmic axis
    where = dict(zip(values, range(len(values)) if side_by_side else values))
    method = schema.method(kind)
    found = [(label, what, _lines(part, where, axis, column, method), _zeros(part, axis, column, method))
             for label, part in _parts(rows).items() for column, what in schema.measures(kind)]
    methods = list(dict.fromkeys(m for _, _, lines, _ in found for m in lines))
    last = {m: next(lines[m][-1][1] for _, _, lines, _ in found if m in lines) for m in methods}
    shown = methods if whole else leading(bundle, methods, last.get)
    drawn = [(", ".join(filter(None, (label, more))), what, some) for label, what, lines, _ in found
             for more, some in _apart({m: points for m, points in lines.items() if m in shown})]
    hidden = [part for label, what, lines, zeros in found for part in _not_drawn(_panel(label, what), zeros, lines, shown)]
    hidden = f"0, not drawn: {'; '.join(hidden)}" if hidden else ""
    if not drawn:
        raise Missing(f"the study `{study}` has no value that a logarithmic axis can show")
    if sum(len(points) for *_, lines in drawn for points in lines.values()) < FEWEST:
        raise Missing(f"the study `{study}` has too few values for a figure")
    draw = _ranked if len(values) == 1 else _against
    canvas, axes = panels(len(drawn), 1, height=max(2.6, 0.17 * min(max(len(lines) for *_, lines in drawn), MOST_NAMED)))
    look = looks(bundle, shown)
    for ax, (label, what, lines) in zip(axes[:, 0], drawn):
        draw(ax, what, lines, look, (axis, values, where, side_by_side))
        ax.set_title(label, loc="left")
    if draw is _against:
        axes[-1][0].set_xlabel(WORDS[axis])
    merged = _merged(rows, axis)
    across = "" if draw is _ranked else "over all places " if axis in APART_AXES else "at the end "
    return finish(canvas, f"{study}-figure", f"{bundle.title(study)}{f', against {WORDS[axis]}' if draw is _against else ''}"
                  + (f"; each point is the largest value over {listing(merged)}" if merged else "") + (f"; {hidden}" if hidden else ""),
                  "Logarithmic. " + "; ".join(_words(*one, across) for one in drawn) + "." + (f" {hidden}." if hidden else ""), bottom=0.1,
                  note=chosen(shown, methods),
                  more=(lambda: study_lines(bundle, study, True)) if len(shown) < len(methods) else None)


def _panel(label, what):
    return f"{label}, {what}" if label else what


def _words(label, what, lines, across):
    """The least and the largest of what is drawn: of the last place where the places have an order."""
    drawn = [(y, m, x) for m, points in lines.items() for x, y in points]
    end = max(x for *_, x in drawn)
    drawn = [one for one in drawn if one[-1] == end or across != "at the end "]
    (low, least, _), (high, most, _) = min(drawn), max(drawn)
    methods = {m for _, m, _ in drawn}
    if len(methods) == 1:
        return f"{_panel(label, what)}: {across}{least} has {span(low, high, general)}"
    if low == high:
        return f"{_panel(label, what)}: {across}all that is drawn is {general(low)}"
    return f"{_panel(label, what)}: {across}{least} has the least that is drawn, {general(low)}, and {most} the largest, {general(high)}"


def _against(ax, what, lines, look, across):
    """Values up, places across: lines, or marks over places that have no order."""
    axis, values, where, side_by_side = across
    draw_methods(ax, lines, look, apart=axis in APART_AXES)
    ax.set_yscale("log")
    if side_by_side:
        aslant = axis in ("curves", "curve_id") and max(map(len, values)) > LONG
        step = 1 if aslant else -(-len(values) // MOST_TICKS)
        named = [*values[:-step:step], values[-1]]
        ax.set_xticks([where[v] for v in named], [axis_label(v, axis) for v in named],
                      **({"fontsize": 7, "rotation": 40, "ha": "right"} if aslant else {"fontsize": 8}))
        ax.set_xlim(-0.5, len(values) - 0.5)
    else:
        degree_axis(ax, values)
    ax.set_ylabel(textwrap.fill(what, WIDTH))


def _ranked(ax, what, lines, look, _across):
    """One place: methods down, the largest at the top, their values across."""
    ordered = sorted(lines, key=lambda m: lines[m][0][1])
    for y, method in enumerate(ordered):
        point, = lines[method]
        line, = ax.plot([point[1]], [y], **look[method], label=method)
        line.rows, line.reads = [point.row], [f"{what} {general(point[1])}"]
        if point.row.file == "timing.csv":
            belongs(method, *ax.plot([point.row["low_ns"], point.row["high_ns"]], [y, y], color=line.get_color(), linewidth=1))
    ax.set_yticks(range(len(ordered)), ordered, fontsize=8)
    ax.set_xscale("log")
    ax.set_xlabel(what)
