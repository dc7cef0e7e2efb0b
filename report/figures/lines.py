# SPDX-License-Identifier: MIT
"""Methods as lines: colours by family, one line for methods that agree in every point."""

import math

from .canvas import COLOURS, DASHED, DOTTED, log_axis

STROKES = ("solid", DASHED, DOTTED, (0, (5, 1.5, 1, 1.5)), (0, (7, 3)))
MARKERS = (None, "s", "^", "v")


def positive(row, column):
    """The value where a logarithmic axis can show it, else None."""
    value = row[column]
    return value if isinstance(value, float) and math.isfinite(value) and value > 0 else None


class Point(tuple):
    """(x, y) of a figure that knows the row that it is of."""

    row = None


def point_of(row, x, y):
    """The point of a row."""
    point = Point((x, y))
    point.row = row
    return point


def series(rows, x, column):
    """{method: points ascending} of the rows that a logarithmic axis can show. `x` is a function of a row."""
    points = {}
    for row in rows:
        value = positive(row, column)
        if value is not None:
            points.setdefault(row["method"], []).append(point_of(row, x(row), value))
    return {method: sorted(line) for method, line in points.items()}


def conversion(method):
    """`factorial` of `factorial:horner`; empty for a method that evaluates the given form."""
    return method.rpartition(":")[0]


def looks(methods, marker=None):
    """{method: how to draw it}: methods whose ids start alike (`direct`, `direct_pow`) share a colour and differ in stroke; `marker`
    is for those that have none."""
    def root(method):
        return min((m for m in methods if method == m or method.startswith(f"{m}_")), key=len)
    families = {}
    for method in methods:
        families.setdefault(root(method), []).append(method)
    return {method: {"color": COLOURS[i % len(COLOURS)], "linestyle": STROKES[j % len(STROKES)],
                     "marker": MARKERS[i // len(COLOURS) % len(MARKERS)] or marker, "markersize": 4}
            for i, family in enumerate(families.values()) for j, method in enumerate(family)}


def draw_methods(ax, lines, look):
    """One line per method, those that agree everywhere as one; the legend beside the axes, highest end first."""
    alike = {}
    for method, points in lines.items():
        alike.setdefault(tuple(points), []).append(method)
    for points, (first, *others) in sorted(alike.items(), key=lambda item: -item[0][-1][1]):
        line, = ax.plot(*zip(*points), **look[first], label=first + (f" (+{len(others)} alike)" if others else ""))
        line.rows = [getattr(point, "row", None) for point in points]
    beside(ax)


def _converted(method):
    return conversion(method) or "given form"


def path_colours(methods):
    """{conversion: colour} of all methods of a figure."""
    return {name: COLOURS[i % len(COLOURS)] for i, name in enumerate(dict.fromkeys(map(_converted, methods)))}


def draw_paths(ax, lines, colours):
    """One thin line per path, coloured by its conversion."""
    groups = {}
    for method, points in lines.items():
        groups.setdefault(_converted(method), []).append((method, points))
    ordered = sorted(groups.items(), key=lambda item: -max(points[-1][1] for _, points in item[1]))
    for name, group in ordered:
        for k, (method, points) in enumerate(group):
            line, = ax.plot(*zip(*points), color=colours[name], linewidth=0.9, alpha=0.85,
                            label=f"{name} ({len(group)})" if k == 0 else None)
            line.series_name, line.rows = method, [getattr(point, "row", None) for point in points]
    beside(ax)


def beside(ax):
    """The legend at the right of the axes."""
    ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=7.5, handlelength=2.6, labelspacing=0.35)


def degree_axis(ax, degrees):
    """Degrees on an axis that is logarithmic where none is 0, as many of them named as there is room for."""
    if min(degrees) > 0:
        ax.set_xscale("log")
    log_axis(ax.xaxis, _apart(sorted(degrees)))


def _apart(values):
    kept = []
    for value in values:
        if not kept or value >= 1.3 * kept[-1]:
            kept.append(value)
    return kept


def sentence_case(words):
    return words[:1].upper() + words[1:]
