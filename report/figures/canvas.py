# SPDX-License-Identifier: MIT
"""The look that all figures share, and their deterministic SVG and PNG."""

import contextlib
import functools
import io
import itertools
import math
import re
from pathlib import Path

with contextlib.chdir(Path(__file__).parent):  # it reads a file matplotlibrc of the current folder
    import matplotlib

matplotlib.use("Agg")

from matplotlib.colors import to_hex  # noqa: E402
from matplotlib.figure import Figure as Canvas  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.patches import Patch  # noqa: E402
from matplotlib.ticker import FixedFormatter, FixedLocator, FuncFormatter, LogFormatter, LogLocator, NullLocator  # noqa: E402

from ..document import Drawing, Figure, Series  # noqa: E402
from ..methods import name  # noqa: E402
from ..wording import general, shortest  # noqa: E402

# Ink and paper are replaced by the page's colours where a figure is put into the page.
INK = "#1b1f24"
PAPER = "#fefefe"
FAINT = "#8a929b"
# Readable on light and dark paper, and distinguished by people who see no red or green.
COLOURS = ("#2f7fc1", "#d2691e", "#2a9d6f", "#a05fb4", "#b8860b", "#c0506a", "#5b7a99")
DASHED, DOTTED = (0, (5, 2)), (0, (1, 1.5))
POINTS = 72  # of an inch in SVG
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
    @functools.wraps(draw)
    def with_style(*given):
        with matplotlib.rc_context():
            matplotlib.rcdefaults()  # a user's own settings change no page
            matplotlib.rcParams.update(STYLE)
            return draw(*given)
    return with_style


FIGURES = {}  # by the name of the function


def figure(draw):
    """A function that draws a figure of a bundle, which chapters ask for by its name."""
    FIGURES[draw.__name__] = styled(draw)
    return FIGURES[draw.__name__]


def panels(rows, columns, height=3.1, **more):
    """A figure with its axes as a grid."""
    canvas = Canvas(figsize=(9.2, height * rows + 1.1))
    axes = canvas.subplots(rows, columns, squeeze=False, **more)
    return canvas, axes


class _Decades(LogLocator):
    """Powers of ten; within two decades 2 and 5 are named as well."""

    def tick_values(self, vmin, vmax):
        self.set_params(subs=(1, 2, 5) if vmax < 100 * vmin else (1,))
        return super().tick_values(vmin, vmax)


def log_axis(axis, ticks=None):
    """Decades written as in the tables: 1e-9."""
    axis.set_minor_locator(NullLocator())
    axis.set_major_locator(FixedLocator(ticks) if ticks else _Decades(numticks=9))
    axis.set_major_formatter(FuncFormatter(lambda value, _: shortest(float(f"{value:.6g}"))))  # 0.9985 is not 1


def reproduced(ax, x, rows, colour, below=False, dashed="continuous_median", dotted="against_exact", scale=None):
    """One printed row: our median with its 5-95 % band, two companions as dashed and dotted lines, printed points.

    `below` draws it broader, so that it still shows where another row lies on top of it.
    """
    over = scale or [1] * len(rows)

    def values(column):
        numbers = [row[column] for row in rows]
        return [n / s if isinstance(n, float) else float("nan") for n, s in zip(numbers, over)]

    method = name(rows[0]["method"])
    band = [ax.fill_between(x, values("ours_p05"), values("ours_p95"), color=colour, alpha=0.24, linewidth=0)]
    median, = ax.plot(x, values("ours_median"), color=colour, linewidth=2.9 if below else 1.6)
    for column, style in ((dashed, DASHED), (dotted, DOTTED)):
        if column and any(row[column] is not None for row in rows):
            band += ax.plot(x, values(column), color=colour, linestyle=style, linewidth=2.2 if below else 1.3)
    printed, = ax.plot(x, values("published"), linestyle="none", marker=PRINTED, markersize=9.5 if below else 6, markeredgewidth=1.5,
                       markeredgecolor=colour, markerfacecolor=PAPER, zorder=4)
    belongs(method, *band)
    for line, what in ((median, "ours"), (printed, "printed")):
        line.series_name, line.prefix = method, f"{what}, "


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


def belongs(name, *artists):
    """Says that these lines or areas are of the method of that name, beside those that its values are read from."""
    for artist in artists:
        artist.series_name, artist.beside = name, True


def _name(artist):
    label = artist.get_label()
    return getattr(artist, "series_name", None) or (label if label and not str(label).startswith("_") else None)


def _written(axis, value):
    """A value as the axis names it: its own words where it has any."""
    named = dict(zip(axis.get_majorticklocs(), (tick.get_text() for tick in axis.get_majorticklabels()))) \
        if isinstance(axis.get_major_formatter(), FixedFormatter) else {}
    return named.get(value) or general(float(value))


def _reads(ax, canvas):
    """The words of both axes: of a column of panels only the lowest names the axis across."""
    x = ax.get_xlabel() or next((other.get_xlabel() for other in reversed(canvas.axes) if other.get_xlabel()
                                 and abs(other.get_position().x0 - ax.get_position().x0) < 1e-6), "")
    y = ax.get_ylabel() or next((other.get_ylabel() for other in canvas.axes if other.get_ylabel()
                                 and abs(other.get_position().y0 - ax.get_position().y0) < 1e-6), "")
    return ax.get_title(loc="left") or ax.get_title(), x, y


def _all_series(canvas):
    """What is drawn, by method; every artist of a method gets an id that says so."""
    found, height, scale, numbers = {}, canvas.get_figheight() * POINTS, POINTS / canvas.dpi, itertools.count()
    for ax in canvas.axes:
        title, across, up = _reads(ax, canvas)
        for artist in (*ax.get_lines(), *ax.collections, *ax.patches):
            name = _name(artist)
            if name is None or not ax.get_visible():
                continue
            colour, points, alike = found.setdefault(name, (to_hex(_colour(artist)), [], []))
            alike.extend(getattr(artist, "alike", ()))
            order = list(found).index(name)
            artist.set_gid(f"s{order}-{next(numbers)}")
            if not isinstance(artist, Line2D) or getattr(artist, "beside", False):
                continue
            rows, reads = getattr(artist, "rows", None), getattr(artist, "reads", None)  # `reads`: what points say instead of their place
            for at, (x, y) in enumerate(zip(artist.get_xdata(), artist.get_ydata())):
                place = ax.transData.transform((x, y)) * scale
                if not (isinstance(x, (int, float)) and isinstance(y, (int, float)) and all(map(math.isfinite, place))):
                    continue
                words = reads[at] if reads else getattr(artist, "prefix", "") + f"{across} {_written(ax.xaxis, x)}, {up} {_written(ax.yaxis, y)}"
                words += (f" ({title})" if title else "") + (f"; the same: {', '.join(artist.alike)}" if getattr(artist, "alike", ()) else "")
                points.append((round(float(place[0]), 1), round(float(height - place[1]), 1), words, rows[at] if rows else None))
    for legend in [*canvas.legends, *(ax.get_legend() for ax in canvas.axes if ax.get_legend())]:
        for text in legend.get_texts():
            if text.get_text() in found:
                text.set_gid(f"s{list(found).index(text.get_text())}-{next(numbers)}")
    return tuple(Series(name, colour, tuple(points), tuple(alike)) for name, (colour, points, alike) in found.items())


def _colour(artist):
    if isinstance(artist, Line2D):
        return artist.get_markeredgecolor() if artist.get_linestyle() == "None" else artist.get_color()
    colour = artist.get_facecolor()
    return colour[0] if getattr(colour, "ndim", 1) == 2 else colour


def finish(canvas, figure_id, caption, alt, bottom=0.75, more=None, note="", caption_zh=""):
    """The figure of this canvas, whose lowest `bottom` inches are for legends; `more` makes that of all methods where it shows those of the `note`."""
    return Figure(id=figure_id, caption=caption, caption_zh=caption_zh, alt=alt, draw=lambda: _draw(canvas, bottom), more=more, note=note)


@styled
def _draw(canvas, bottom):
    """Lays the figure out and renders it twice, without dates or versions; logarithmic axes are written as `log_axis` does."""
    for axis in (one for ax in canvas.axes for one in (ax.xaxis, ax.yaxis)):
        if isinstance(axis.get_major_formatter(), LogFormatter):
            log_axis(axis)
    canvas.tight_layout(rect=(0, bottom / canvas.get_figheight(), 1, 1))
    series = _all_series(canvas)
    svg = io.StringIO()
    canvas.savefig(svg, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    return Drawing(svg=_lean(svg.getvalue()), png=functools.partial(styled(_png), canvas), series=series)


def _png(canvas):
    png = io.BytesIO()
    canvas.savefig(png, format="png", dpi=150, metadata={"Software": None})
    return png.getvalue()


def _lean(svg):
    """Without trailing blanks and with coordinates to a hundredth of a point, of tags and not of what they enclose: smaller and easier
    to compare."""
    svg = re.sub(r"<[^>]*>", lambda tag: re.sub(r"(\d+\.\d{2})\d+", r"\1", tag[0]), svg)
    return "\n".join(line.rstrip() for line in svg.splitlines()) + "\n"
