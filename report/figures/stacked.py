# SPDX-License-Identifier: MIT
"""Panels one above the other, each with the errors of many methods as lines."""

from ..wording import general
from .canvas import panels
from .method_lines import degree_axis, draw_methods, ends, error_axis, looks


def stacked(parts, prepare_x, label, at, height=2.4, sharex=False):
    """(canvas, its lowest axes, best and worst of each panel in words). `parts` are pairs of a title and {method: points};
    `prepare_x(axes, lines)` makes the axis across, `label` names the errors, and `at` says in words where the lines end."""
    canvas, axes = panels(len(parts), 1, height=height, sharex=sharex)
    look = looks(sorted({m for _, lines in parts for m in lines}))  # the same in every panel
    words = []
    for ax, (title, lines) in zip(axes[:, 0], parts):
        draw_methods(ax, lines, look)
        ax.set_title(title, loc="left")
        error_axis(ax)
        prepare_x(ax, lines)
        ax.set_ylabel(label)
        best, worst, last = ends(lines)
        words.append(f"{title}: {at} {best} has {general(last[best])}, {worst} {general(last[worst])}")
    return canvas, axes[-1][0], "; ".join(words)


def degrees_across(ax, lines):
    """The axis across for lines over degrees."""
    degree_axis(ax, {x for points in lines.values() for x, _ in points})
