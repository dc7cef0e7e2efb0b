# SPDX-License-Identifier: MIT
"""The pictures of docs/introduction.md, drawn from formulas, exact arithmetic and results/answers: `scripts/site --pictures` writes them."""
import math
import re
from fractions import Fraction

import numpy

from report.bundle import Bundle
from report.figures.canvas import COLOURS, FAINT, INK, finish, log_axis, panels, styled
from report.figures.lines import degree_axis
from scripts.pages.bundles import ANSWERS
from scripts.pages.figure import for_both_screens

from .repository import ROOT

FOLDER = ROOT / "docs/pictures"
POINTS = (0.3, -0.8, 0.9, -0.6, 0.7, -0.9, 0.5)  # one axis of a curve of degree 6
T = numpy.linspace(0, 1, 201)
ROUNDOFF = 2.0 ** -24  # of float
PICTURES = {}


def picture(draw):
    PICTURES[f"introduction-{draw.__name__}"] = styled(draw)
    return draw


def bernstein(n, i, t):
    return math.comb(n, i) * t ** i * (1 - t) ** (n - i)


def power_coefficients(points):
    n = len(points) - 1
    return [math.comb(n, j) * sum((-1) ** (j - i) * math.comb(j, i) * points[i] for i in range(j + 1)) for j in range(n + 1)]


@picture
def basis():
    """The Bernstein polynomials of degree 3 beside the powers of t."""
    canvas, ((left, right),) = panels(1, 2, 2.6)
    for i in range(4):
        left.plot(T, bernstein(3, i, T), color=COLOURS[i])
        left.annotate(f"B_{i}", (i / 3, bernstein(3, i, i / 3)), xytext=(0, 4), textcoords="offset points", ha="center", color=COLOURS[i])
        right.plot(T, T ** i, color=COLOURS[i])
        right.annotate(f"t^{i}", (0.62 + 0.1 * i, (0.62 + 0.1 * i) ** i), xytext=(-4, 4), textcoords="offset points", ha="right", color=COLOURS[i])
    left.set_title("Bernstein polynomials: each leads somewhere", loc="left")
    right.set_title("powers of t: all lead to t = 1", loc="left")
    return canvas


@picture
def terms():
    """One axis of a curve of degree 6 as a sum, in both forms."""
    canvas, ((left, right),) = panels(1, 2, 2.8)
    n, coefficients = len(POINTS) - 1, power_coefficients(POINTS)
    total = sum(point * bernstein(n, i, T) for i, point in enumerate(POINTS))
    for i, (point, coefficient) in enumerate(zip(POINTS, coefficients)):
        left.plot(T, point * bernstein(n, i, T), color=COLOURS[i], linewidth=1)
        right.plot(T, coefficient * T ** i, color=COLOURS[i], linewidth=1)
    for ax, words in ((left, f"terms b_i B_i(t), at most {max(map(abs, POINTS)):g}"), (right, f"terms q_j t^j, up to {max(map(abs, coefficients)):.0f}")):
        ax.plot(T, total, color=INK, linewidth=2.6, label="their sum, the same curve")
        ax.set_title(words, loc="left")
        ax.set_xlabel("t")
        ax.legend(loc="lower left", fontsize=8.5)
    return canvas


@picture
def numbers():
    """The numbers with four significant bits from 1/2 to 2, and a value between two of them."""
    canvas, ((ax,),) = panels(1, 1, 1.0)
    grid = [k / 16 for k in range(8, 16)] + [k / 8 for k in range(8, 17)]
    ax.plot(grid, [0] * len(grid), linestyle="none", marker="|", markersize=16, color=COLOURS[0])
    value, nearest = 1.29, 1.25
    ax.plot([value], [0], marker="o", color=COLOURS[1])
    ax.annotate("x", (value, 0), xytext=(4, 12), textcoords="offset points", color=COLOURS[1])
    ax.annotate("fl(x)", (nearest, 0), xytext=(-10, 12), textcoords="offset points", color=COLOURS[0])
    for start, end, words in ((1.5, 1.625, "one ulp"), (0.75, 0.8125, "one ulp, half as long")):
        ax.annotate("", (start, -0.6), (end, -0.6), arrowprops={"arrowstyle": "<->", "color": INK, "shrinkA": 0, "shrinkB": 0})
        ax.annotate(words, ((start + end) / 2, -0.6), xytext=(0, -13), textcoords="offset points", ha="center")
    ax.set_ylim(-1.6, 1.2)
    ax.set_xlim(0.45, 2.05)
    ax.set_yticks([])
    ax.grid(False)
    ax.set_title("all numbers with four significant bits from 1/2 to 2; u = 1/16", loc="left")
    return canvas


@picture
def growth():
    """How large power coefficients get, and the largest errors of three methods."""
    canvas, ((left, right),) = panels(1, 2, 2.8)
    degrees = range(1, 31)
    left.plot(degrees, [max(math.comb(n, j) * 2 ** j for j in range(n + 1)) for n in degrees], color=COLOURS[1])
    left.set_title("largest power coefficient for |b_i| <= 1", loc="left")
    rows = Bundle(ANSWERS).judged().select(study="answers-bezier", scalar="double")
    for at, (method, words) in enumerate((("factorial:horner", "by way of power form"), ("de_casteljau", "de Casteljau"), ("horner_bernstein", "Horner-Bernstein"))):
        line = sorted((row["degree"], row["max_error_u"]) for row in rows if row["method"] == method)
        right.plot(*zip(*line), marker="o", markersize=4, color=COLOURS[(1, 0, 2)[at]], label=words)
    right.set_title("largest error of 4,000 random curves, u p~", loc="left")
    right.legend(loc="upper left", fontsize=8.5)
    for ax in (left, right):
        degree_axis(ax, (2, 3, 5, 12, 30))
        ax.set_yscale("log")
        log_axis(ax.yaxis)
        ax.set_xlabel("degree n")
    return canvas


def errors(points=POINTS, count=300):
    """[(t, error of de Casteljau's algorithm in float, p~)], the error against the exact value."""
    single = numpy.float32
    given, found = [single(b) for b in points], []
    exact = [Fraction(float(b)) for b in given]
    for k in range(1, count):
        t = single(k / count)
        level, true, size, x = list(given), list(exact), [abs(b) for b in exact], Fraction(float(t))
        while len(level) > 1:
            level = [single(single((single(1) - t) * a) + single(t * b)) for a, b in zip(level, level[1:])]
            true, size = ([(1 - x) * a + x * b for a, b in zip(one, one[1:])] for one in (true, size))
        found.append((float(t), float(abs(Fraction(float(level[0])) - true[0])), float(size[0])))
    return found


@picture
def error():
    """The error of de Casteljau's algorithm in float over t, one unit u p~ and the proved bound."""
    canvas, ((ax,),) = panels(1, 1, 3.0)
    rows, k = errors(), 3 * (len(POINTS) - 1)
    t = [row[0] for row in rows]
    ax.plot(t, [row[1] or math.nan for row in rows], linestyle="none", marker=".", markersize=3, color=COLOURS[0], label="error of one point")
    ax.plot(t, [ROUNDOFF * row[2] for row in rows], color=COLOURS[2], label="u p~, the unit")
    ax.plot(t, [k * ROUNDOFF / (1 - k * ROUNDOFF) * row[2] for row in rows], color=COLOURS[1], label=f"proved bound, gamma_{k} p~")
    ax.set_yscale("log")
    log_axis(ax.yaxis)
    ax.set_ylim(bottom=1e-11)
    ax.set_xlabel("t")
    ax.legend(loc="lower center", ncol=3, fontsize=8.5)
    ax.axhline(1e-11, color=FAINT, linewidth=0.5)
    return canvas


def drawn(name):
    """A picture as SVG, for light and dark screens."""
    return for_both_screens(finish(PICTURES[name](), figure_id=name, caption="", caption_zh="", alt="", bottom=0.05).drawing.svg, (PICTURES[name].__doc__ or "").strip())


def labels(svg):
    return re.findall(r"<text[^>]*>([^<]*)</text>", svg)


def write():
    for name in PICTURES:
        (FOLDER / f"{name}.svg").write_text(drawn(name), encoding="utf-8")
