# SPDX-License-Identifier: MIT
"""Other libraries: error and time by degree, a panel each."""

from ..bundle import Missing
from ..wording import general
from .canvas import finish, panels, styled
from .method_lines import degree_axis, draw_methods, ends, error_axis, looks, series

ID = "peers-against-degree"


@styled
def draw(bundle):
    """Mean error over u p~ against degree and, where the bundle has them, nanoseconds per prepared point."""
    errors = bundle.exact("peers").select(curve="bezier", scalar="double", dimension=2)
    quantities = [("mean error / (u p~)", series(errors, lambda r: r["degree"], "mean_error_u"))]
    try:
        times = [r for r in bundle["timing.csv"].of_suite("peers").rows if r["mode"] == "point" and r["degree"] is not None]
        quantities.append(("ns per point", series(times, lambda r: r["degree"], "median_ns")))
    except Missing:
        pass  # a run may leave timings out
    quantities = [(label, lines) for label, lines in quantities if lines]
    if not quantities:
        raise Missing("`accuracy.csv` has no errors in a study whose id starts with `peers-`")
    look = looks(list(dict.fromkeys(method for _, lines in quantities for method in lines)))
    canvas, axes = panels(len(quantities), 1, height=3, sharex=True)
    words = []
    for ax, (label, lines) in zip(axes[:, 0], quantities):
        draw_methods(ax, lines, look)
        error_axis(ax)
        degree_axis(ax, {x for points in lines.values() for x, _ in points})
        ax.set_ylabel(label)
        best, worst, last = ends(lines)
        words.append(f"{label}: at the highest degree {best} has {general(last[best])}, {worst} {general(last[worst])}")
    axes[-1][0].set_xlabel("degree n")
    return finish(canvas, ID, "Other libraries: error and time against degree", "其他程序库：误差、用时与阶数",
                  "Doubly logarithmic. " + "; ".join(words) + ".", bottom=0.1)
