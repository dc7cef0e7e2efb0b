# SPDX-License-Identifier: MIT
"""Methods as lines or, over categories, as marks: each in its colour, one line for methods that agree in every point."""

import math

from .canvas import belongs, log_axis

MOST_NAMED = 20  # entries of a legend beside the axes; the page has another for more
ROOM = 0.05  # of a logarithmic axis, for the name of a place
DODGE = 0.09  # of the distance of two categories, from one method to the next


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


def draw_methods(ax, lines, look, apart=False):
    """One line per method, those that agree everywhere as one; marks side by side where places are `apart`; the legend beside the axes, highest
    end first."""
    alike = {}
    for method, points in lines.items():
        alike.setdefault(tuple(points), []).append(method)
    for at, (points, (first, *others)) in enumerate(sorted(alike.items(), key=lambda item: -item[0][-1][1])):
        places, values = zip(*points)
        if apart:
            places = [x + (at - (len(alike) - 1) / 2) * min(DODGE, 0.8 / len(alike)) for x in places]
        line, = ax.plot(places, values, **look[first], linestyle="none" if apart else "solid", label=first + (f" (+{len(others)} alike)" if others else ""))
        line.rows, line.alike = [getattr(point, "row", None) for point in points], others
        for x, row in zip(places, line.rows):
            if row and row.file == "timing.csv":
                belongs(line.get_label(), *ax.plot([x, x], [row["low_ns"], row["high_ns"]], color=line.get_color(), linewidth=1, alpha=0.6))
    if len(alike) <= MOST_NAMED:
        beside(ax)


def beside(ax):
    """The legend at the right of the axes."""
    ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=7.5, handlelength=2.6, labelspacing=0.35)


def degree_axis(ax, degrees):
    """Degrees on an axis that is logarithmic where none is 0: the first, the last, and as many between as there is room for."""
    if min(degrees) > 0:
        ax.set_xscale("log")
    log_axis(ax.xaxis, _apart(sorted(degrees)))


def _apart(values):
    """Those that are far enough from the one before and from the last."""
    first, last = values[0], values[-1]
    least = (last / first) ** ROOM if first > 0 else 1.3
    kept = [first]
    for value in values[1:-1]:
        if value >= least * kept[-1] and value * least <= last:
            kept.append(value)
    return kept + [last] * (last != first)


def sentence_case(words):
    return words[:1].upper() + words[1:]
