# SPDX-License-Identifier: MIT
"""A study of any kind: what it measures, along the axis that it varies."""

import textwrap

from .. import schema
from ..bundle import Missing
from ..rows import distinct, grouped
from ..tables import AXIS, axis_label
from ..wording import general, listing
from .canvas import figure, finish, panels
from .lines import degree_axis, draw_methods, draw_paths, looks, path_colours, point_of, positive

APART = ("form", "scalar", "mode", "target")  # a panel for each value
BESIDE = ("degree", "dimension", "order", "coordinate_range", "interval", "curves", "generator", "tolerance", "points", "data", "placement",
          "knots", "curve_id")
MOST = 20  # lines with a look of their own
FAR, FARTHEST = 1e3, 1e5  # times the best, in the largest value of a line
MOST_TICKS = 12  # places that are named
WIDTH = 28  # characters that fit the height of a panel
NARROW = ("interval", "curves", "generator", "placement", "data", "knots", "curve_id")  # axes whose values are places side by side
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
def study_lines(bundle, study):
    """A panel for each measure and, side by side under each other, each form, scalar type and mode."""
    kind = bundle.studies[study].kind
    rows = [r for r in _rows(bundle, study, kind) if r["method"] != "sentinel"]
    axis = _axis(kind, rows)
    values = distinct(rows, axis)
    if not any(v is None or isinstance(v, str) for v in values):
        values.sort()
    if None in values:
        raise Missing(f"the study `{study}` has no axis that a figure can show")
    side_by_side = axis in NARROW or axis == "coordinate_range"  # 1e-300 to 1e300 is too far for a logarithmic axis
    where = dict(zip(values, range(len(values)) if side_by_side else values))
    drawn = [(", ".join(filter(None, (label, more))), what, lines) for label, part in _parts(rows).items()
             for column, what in schema.measures(kind) for more, lines in _apart(_lines(part, where, axis, column, schema.method(kind)))]
    if not drawn:
        raise Missing(f"the study `{study}` has no value that a logarithmic axis can show")
    canvas, axes = panels(len(drawn), 1, height=max(2.6, 0.17 * min(max(len(lines) for *_, lines in drawn), MOST)))
    words = []
    methods = dict.fromkeys(method for *_, lines in drawn for method in lines)
    look = looks(list(methods), "o")  # the same in every panel
    colours = path_colours(methods)
    for ax, (label, what, lines) in zip(axes[:, 0], drawn):
        if len(lines) <= MOST:
            draw_methods(ax, lines, look)
        else:
            draw_paths(ax, lines, colours)
        ax.set_yscale("log")
        if side_by_side:
            aslant = axis in ("curves", "curve_id") and max(map(len, values)) > LONG
            named = values if aslant else values[::-(-len(values) // MOST_TICKS)]
            ax.set_xticks([where[v] for v in named], [axis_label(v, axis) for v in named],
                          **({"fontsize": 7, "rotation": 40, "ha": "right"} if aslant else {"fontsize": 8}))
        else:
            degree_axis(ax, values)
        ax.set_title(label, loc="left")
        ax.set_ylabel(textwrap.fill(what, WIDTH))
        last = {m: points[-1][1] for m, points in lines.items()}
        low, high = min(last, key=last.get), max(last, key=last.get)
        words.append(f"{label + ', ' if label else ''}{what}: at the end {low} has the least, {general(last[low])}, and {high} the "
                     f"largest, {general(last[high])}")
    axes[-1][0].set_xlabel(WORDS[axis])
    merged = _merged(rows, axis)
    return finish(canvas, f"{study}-figure", f"{bundle.title(study)}, against {WORDS[axis]}"
                  + (f"; each point is the largest value over {listing(merged)}" if merged else ""), "各方法的结果",
                  "Logarithmic. " + "; ".join(words) + ".", bottom=0.1)
