# SPDX-License-Identifier: MIT
"""The curves of the sets that a bundle keeps: how far from the origin they are over their size, and some of them as outlines."""

import numpy as np

from ..bundle import Missing
from ..rows import grouped
from ..wording import count, general, large
from .canvas import COLOURS, figure, finish, panels

PREFIX = "curves_"  # of the copies of sets in a bundle
MOST = 3  # sets
ACROSS, DOWN = 8, 4  # outlines of a set
STEPS, RANKS = 33, 200  # points of an outline and of a distribution


def _curves(table):
    """The control points and the weights, or None, of each curve that has control points in at least two axes and a size."""
    axes = [axis for axis in "xyz" if axis in table.columns]
    for rows in grouped(table.rows, "curve").values():
        given = [axis for axis in axes if rows[0][axis] is not None]
        if len(given) < 2:
            continue
        points = np.array([[row[axis] for axis in given] for row in rows if row[given[0]] is not None], dtype=float)
        weights = np.array([row["w"] for row in rows[:len(points)]]) if "w" in table.columns and rows[0]["w"] is not None else None
        if ("form" not in table.columns or rows[0]["form"] != "power") and np.ptp(points, axis=0).max() > 0:
            yield points, weights


def _distance(points):
    return float(np.abs(points).max() / np.ptp(points, axis=0).max())


def _outline(points, weights):
    """The first two axes of points of the curve, by de Casteljau's algorithm, in a square of 1 about the origin."""
    low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    plane = (points[:, :2] - (low + high) / 2) / np.ptp(points, axis=0).max()
    weights = np.ones(len(points)) if weights is None else weights
    t = np.linspace(0, 1, STEPS)[:, None, None]
    row = np.column_stack((plane * weights[:, None], weights))[None]
    while row.shape[1] > 1:
        row = (1 - t) * row[:, :-1] + t * row[:, 1:]
    return (row[:, 0, :2] / row[:, 0, 2:]).T


@figure
def curves_of_sets(bundle):
    """A line for each set: on the left the share of curves that are nearer than a distance, on the right every so many-th curve."""
    sets = {name[len(PREFIX):-len(".csv")]: list(_curves(bundle[name])) for name in bundle.tables if name.startswith(PREFIX)}
    sets = {name: curves for name, curves in sets.items() if curves}
    if not sets:
        raise Missing("the bundle keeps no curves with two axes")
    shown = dict(list(sets.items())[:MOST])
    canvas, axes = panels(len(shown), 2, width_ratios=(1, 1.4))
    words = []
    for (left, right), (name, curves), colour in zip(axes, shown.items(), COLOURS):
        distances = sorted(_distance(points) for points, _ in curves)
        ranks = np.unique(np.linspace(0, len(distances) - 1, RANKS).astype(int))
        line, = left.step([distances[k] for k in ranks], (ranks + 1) / len(distances), where="post", color=colour)
        line.series_name = name
        left.set_xscale("log")
        left.set_ylim(0, 1.02)
        left.set_title(f"{name}: {large(len(curves))} curve{'' if len(curves) == 1 else 's'}", loc="left")
        left.set_ylabel("share of curves")
        chosen = curves[::-(-len(curves) // (ACROSS * DOWN))]
        for k, (points, weights) in enumerate(chosen):
            x, y = _outline(points, weights)
            right.plot(1.3 * (k % ACROSS) + x, -1.3 * (k // ACROSS) + y, color=colour, linewidth=1.2)
        right.set_aspect("equal")
        right.axis("off")
        right.set_title(f"{count(len(chosen), 'curve')} of it, each at its own scale, y upwards", loc="left")
        words.append(f"{name}: half of the curves are nearer than {general(distances[(len(distances) - 1) // 2])} times their size")
    axes[-1][0].set_xlabel("largest coordinate over the size, at most")
    left_out = f"; {count(len(sets) - MOST, 'other set')} left out" if len(sets) > MOST else ""
    return finish(canvas, "curves-of-sets", f"How far from the origin the curves of a set are, over their size, and what some of them look like{left_out}", f"{'; '.join(words)}.", bottom=0.1)
