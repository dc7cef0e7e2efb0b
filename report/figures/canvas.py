# SPDX-License-Identifier: MIT
"""The look that all figures share, and their deterministic SVG and PNG."""

import contextlib
import io
import re
from pathlib import Path

with contextlib.chdir(Path(__file__).parent):  # it reads a file matplotlibrc of the current folder
    import matplotlib

matplotlib.use("Agg")

from matplotlib.figure import Figure as Canvas  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Patch  # noqa: E402
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullLocator  # noqa: E402

from ..document import Figure  # noqa: E402
from ..foreign import restored  # noqa: E402
from ..wording import shortest  # noqa: E402

# Ink and paper are replaced by the page's colours where a figure is put into the page.
INK = "#1b1f24"
PAPER = "#fefefe"
FAINT = "#8a929b"
# Readable on light and dark paper, and told apart by people who see no red or green.
COLOURS = ("#2f7fc1", "#d2691e", "#2a9d6f", "#a05fb4", "#b8860b", "#c0506a", "#5b7a99")
DASHED, DOTTED = (0, (5, 2)), (0, (1, 1.5))
PRINTED = "o"  # marker of the values that the source report prints

STYLE = {
    "svg.hashsalt": "bezierbench", "svg.fonttype": "none", "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"], "font.size": 9.5, "axes.titlesize": 10, "axes.labelsize": 9.5,
    "axes.edgecolor": FAINT, "axes.linewidth": 0.8, "text.color": INK, "axes.labelcolor": INK, "axes.titlecolor": INK,
    "xtick.color": INK, "ytick.color": INK, "axes.facecolor": PAPER, "figure.facecolor": PAPER, "savefig.facecolor": PAPER,
    "axes.grid": True, "grid.color": FAINT, "grid.alpha": 0.28, "grid.linewidth": 0.6, "axes.spines.top": False,
    "axes.spines.right": False, "legend.frameon": False, "lines.linewidth": 1.7, "axes.unicode_minus": False,
    "text.parse_math": False,  # a dollar sign is one
}


def styled(draw):
    """Draws under the common style and leaves the global settings alone."""
    def with_style(bundle):
        with matplotlib.rc_context():
            matplotlib.rcdefaults()  # a user's own settings change no page
            matplotlib.rcParams.update(STYLE)
            return draw(bundle)
    with_style.__doc__ = draw.__doc__
    return with_style


def panels(rows, columns, height=3.1, **more):
    """A figure with its axes as a grid."""
    canvas = Canvas(figsize=(9.2, height * rows + 1.1))
    axes = canvas.subplots(rows, columns, squeeze=False, **more)
    return canvas, axes


def log_axis(axis, ticks=None):
    """Decades written as in the tables: 1e-9."""
    axis.set_minor_locator(NullLocator())
    axis.set_major_locator(FixedLocator(ticks) if ticks else LogLocator(numticks=9))
    axis.set_major_formatter(FuncFormatter(lambda value, _: shortest(float(f"{value:.3g}"))))


def reproduced(ax, x, rows, colour, below=False, dashed="continuous_median", dotted="against_exact", scale=None):
    """One printed row: our median with its 5-95 % band, two companions as dashed and dotted lines, printed points.

    `below` draws it broader, so that it still shows where another row lies on top of it.
    """
    over = scale or [1] * len(rows)

    def values(column):
        numbers = [row[column] for row in rows]
        return [n / s if isinstance(n, float) else float("nan") for n, s in zip(numbers, over)]

    ax.fill_between(x, values("ours_p05"), values("ours_p95"), color=colour, alpha=0.24, linewidth=0)
    ax.plot(x, values("ours_median"), color=colour, linewidth=2.9 if below else 1.6)
    for column, style in ((dashed, DASHED), (dotted, DOTTED)):
        if column and any(row[column] is not None for row in rows):
            ax.plot(x, values(column), color=colour, linestyle=style, linewidth=2.2 if below else 1.3)
    ax.plot(x, values("published"), linestyle="none", marker=PRINTED, markersize=9.5 if below else 6, markeredgewidth=1.5,
            markeredgecolor=colour, markerfacecolor=PAPER, zorder=4)


def legend(canvas, methods, dashed="continuous inputs", dotted="against exact"):
    """Two legends under the axes: colours are methods, line styles are quantities."""
    first = [Line2D([], [], color=colour, linewidth=3, label=name) for name, colour in methods]
    second = [Line2D([], [], color=INK, label="ours, median"), Patch(facecolor=INK, alpha=0.24, label="ours, 5 to 95 %")]
    for label, style in ((dashed, DASHED), (dotted, DOTTED)):
        if label:
            second.append(Line2D([], [], color=INK, linestyle=style, linewidth=1.3, label=label))
    second.append(Line2D([], [], color=INK, linestyle="none", marker=PRINTED, markersize=6, markeredgewidth=1.5,
                         markerfacecolor=PAPER, label="printed"))
    inches = canvas.get_figheight()
    columns = len(first) if len(first) <= 4 else 3
    canvas.legend(handles=first, loc="lower center", ncol=columns, bbox_to_anchor=(0.5, 0.30 / inches), fontsize=9,
                  columnspacing=1.6)
    canvas.legend(handles=second, loc="lower center", ncol=len(second), bbox_to_anchor=(0.5, 0.04 / inches), fontsize=9,
                  columnspacing=1.6, handlelength=2.3)


def finish(canvas, figure_id, caption, caption_zh, alt, bottom=0.75):
    """Lays the figure out and renders it twice, without dates or versions."""
    canvas.tight_layout(rect=(0, bottom / canvas.get_figheight(), 1, 1))
    svg, png = io.StringIO(), io.BytesIO()
    canvas.savefig(svg, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    canvas.savefig(png, format="png", dpi=150, metadata={"Software": None})
    return Figure(id=figure_id, caption=caption, caption_zh=caption_zh, alt=alt, svg=restored(_lean(svg.getvalue())),
                  png=png.getvalue())


def _lean(svg):
    """Without trailing blanks and with coordinates to a hundredth of a point: smaller and easier to compare."""
    svg = re.sub(r"(\d+\.\d{2})\d+", r"\1", svg)
    return "\n".join(line.rstrip() for line in svg.splitlines()) + "\n"
