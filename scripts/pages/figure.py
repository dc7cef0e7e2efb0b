# SPDX-License-Identifier: MIT
"""The figure of README.md: time and error at one degree, made of the same bundle as the table above it."""
import math
import os
import re
import xml.sax.saxutils

from report.wording import general
from scripts.pages.answers import NEEDS, number, times_of, winner
from scripts.pages.bundles import ROOT

DEGREE = 12
MOST_ERROR = 50  # in u p~; above it nobody would choose a method
FILE = ROOT / "results/pages/answers/time-and-error.svg"
DARK = {"#1b1f24": "#e6e9ec", "#fefefe": "#14171a"}  # ink and paper where the reader's screen is dark
STUDY = NEEDS[0].times


def points(bundle):
    """(method, ns, largest error in u p~, bound in u p~ or None), by time, of the methods that one might choose."""
    errors = {row["method"]: row for row in bundle.judged().select(study="answers-bezier", degree=DEGREE, scalar="double")}
    found = [(method, number(rows[DEGREE], "median_ns"), number(errors[method], "max_error_u"), errors[method]["bound_u"])
             for method, rows in times_of(bundle, NEEDS[0]).items() if method in errors]
    return sorted((point for point in found if point[2] <= MOST_ERROR), key=lambda point: point[1])


def chosen(bundle):
    """The methods that the table names for curves on [0, 1], one point at a time."""
    return {winner(bundle, need).method for need in NEEDS if need.times == STUDY and need.mode == "point" and winner(bundle, need)}


def words(bundle):
    """What the figure shows, for those who do not see it."""
    return "; ".join(f"{method}: {general(time, 2)} ns, {general(error, 2)} u p~"
                     + (f" of at most {general(bound, 2)}" if isinstance(bound, float) and math.isfinite(bound) else "")
                     for method, time, error, bound in points(bundle)) + "."


def draw(bundle):
    """The figure as SVG, for light and dark screens."""
    from report.figures.canvas import COLOURS, FAINT, finish, log_axis, panels, styled  # needs matplotlib

    @styled
    def drawn():
        shown = points(bundle)
        canvas, axes = panels(1, 2, height=0.2 * len(shown) + 0.4, sharey=True)
        times, errors = axes[0]
        for row, (method, time, error, bound) in enumerate(shown):
            colour = COLOURS[1] if method in chosen(bundle) else COLOURS[0]
            times.plot([time], [row], marker="o", markersize=6, color=colour)
            errors.plot([error], [row], marker="o", markersize=6, color=colour)
            if isinstance(bound, float) and math.isfinite(bound):
                errors.plot([error, bound], [row, row], color=colour, linewidth=1)
                errors.plot([bound], [row], color=colour, marker="|", markersize=8)
        for ax, what in ((times, "ns per point"), (errors, "largest error seen, and proved bound ( | ), u p~")):
            ax.xaxis._set_axes_scale("log")
            log_axis(ax.xaxis, [1, 2, 5, 10, 20, 50, 100, 200, 500])
            ax.set_xlabel(what)
        times.set_yticks(range(len(shown)), [method for method, *_ in shown])
        times.invert_yaxis()
        errors.axvline(1, color=FAINT, linewidth=0.9)
        return finish(canvas, "time-and-error", "", "", bottom=0.1)

    return for_both_screens(drawn().drawing.svg, words(bundle))


def for_both_screens(svg, description):
    names = {light: f"--c{at}" for at, light in enumerate(DARK)}
    for light, name in names.items():
        svg = svg.replace(light, f"var({name})")

    def rule(colours):
        return "svg { " + " ".join(f"{names[light]}: {colour};" for light, colour in colours) + " }"

    style = (f"<style>{rule((light, light) for light in DARK)} "
             f"@media (prefers-color-scheme: dark) {{ {rule(DARK.items())} }}</style>")
    head = f"<desc>{xml.sax.saxutils.escape(description)}</desc>{style}"
    return re.sub(r"(<svg[^>]*>)", lambda match: match[1] + head, svg, count=1)


def picture(bundle, page):
    """The figure as a page shows it."""
    return f"![{words(bundle)}]({os.path.relpath(FILE, page.parent)})"


def described(path=FILE):
    """What a drawn figure says that it shows."""
    found = re.search(r"<desc>(.*?)</desc>", path.read_text(encoding="utf-8")) if path.exists() else None
    return xml.sax.saxutils.unescape(found[1]) if found else None


def write(bundle):
    FILE.parent.mkdir(parents=True, exist_ok=True)
    FILE.write_text(draw(bundle), encoding="utf-8")
