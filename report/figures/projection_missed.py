# SPDX-License-Identifier: MIT
"""Missed foot points and the largest error of the distance, method by method."""

from ..findings.curves import by_method
from ..wording import general, percent
from .canvas import COLOURS, finish, panels, styled

ID = "projection-missed"


@styled
def draw(bundle):
    """Two panels with a bar per method: the share of missed foot points, and the largest error in units of 2^-52."""
    methods = by_method(bundle)
    names = list(methods)
    shares = [100 * methods[m].share for m in names]
    errors = [max(methods[m].largest, 1e-2) for m in names]
    canvas, axes = panels(1, 2, height=3, sharey=True)
    places = range(len(names))
    colours = [COLOURS[i % len(COLOURS)] for i in places]
    for ax, values, label in zip(axes[0], (shares, errors), ("missed foot points, %",
                                                            "largest error / (2^-52 max |coordinate|)")):
        ax.barh(places, values, color=colours)
        ax.set_xlabel(label)
    axes[0][0].invert_yaxis()  # both, for they share it
    axes[0][0].set_yticks(list(places), names)
    axes[0][1].set_xscale("log")
    words = "; ".join(f"{m} misses {percent(methods[m].share)}, largest error {general(methods[m].largest)} units" for m in names)
    return finish(canvas, ID, "Foot points: missed, and the largest error of the distance", "垂足：漏掉的最近点与距离的最大误差",
                  f"Bars by method: {words}.", bottom=0.1)
