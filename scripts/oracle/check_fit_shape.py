#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges the shape of what `bezierbench curve fit` draws: no fit may leave the polyline of its data.

It shares no code with the program. Four families of data:
  lines     straight lines, rounded to pixels
  glyphs    contours of reference/curves/glyph_outlines.csv, sampled coarsely or finely, rounded to font units or not
  reported  the data of public reports on fits that ran away
  smooth    samples of Bezier curves of degree 3 to 8 and of closed ovals
No point of a fit may be farther from the polyline than five tolerances or a tenth of the data's extent, whichever is
more. Fits to smooth data have at most 1.15 times the segments that gauss_newton had before it was held to this: the
numbers below, of the program at commit 286c7fa.

check_fit_shape.py PROGRAM [--seed S] [--every N]    exits 1 with the first mismatches
"""
import csv
import math
import random
import sys
from pathlib import Path

import judging
from exact import point_at

METHODS = ("schneider", "gauss_newton")
OUTLINES = Path(__file__).resolve().parents[2] / "reference/curves/glyph_outlines.csv"
STEPS = 64  # places of a segment at which it is judged
SMOOTH = 150
SEGMENTS = {1: 1206, 2: 1377, 3: 1087}  # of all smooth data of a seed, by gauss_newton at commit 286c7fa
REPORTED = (  # paperjs/paper.js#414, #620; soswow/fit-curve#8; fontforge/fontforge#5093
    (0.1, ((0, 0), (1, 0.01), (2, 0), (3, 0.01), (4, 0))),
    (1, ((0, 0), (10, 3), (20, 7), (30, 10), (40, 13))),
    (2, ((824, 1032), (889, 1006), (889, 929), (889, 851), (889, 774))),
    (1, ((0, 0), (10, 8), (20, 4), (26, 2), (30, -5))),
    (4, ((0, 0), (1, 0), (100, 0), (99, 0), (98, 1))),
    (1, ((0, 0), (1, -8), (0, -8), (0, -1))),
)


def lines(draw):
    for number in range(1200):
        first, last = ([draw.uniform(0, 500), draw.uniform(0, 500)] for _ in range(2))
        steps = draw.randint(2, 119)
        points = [tuple(float(round(p + (q - p) * k / steps)) for p, q in zip(first, last)) for k in range(steps + 1)]
        yield f"line {number}", draw.choice((0.5, 1, 1, 1.5, 2, 4)), points


def glyphs(draw):
    contours = {}
    with OUTLINES.open(encoding="utf-8") as text:
        for row in csv.DictReader(line for line in text if not line.startswith("#")):
            contours.setdefault(row["contour"], []).append((row["on"] == "1", (float(row["x"]), float(row["y"]))))
    for name, outline in contours.items():
        parts, sides, rounded = draw.choice((1, 2, 3, 4, 8, 12)), draw.random() < 0.3, draw.random() < 0.7
        nodes = [k for k, (on, _) in enumerate(outline) if on]
        points = []
        for first, last in zip(nodes, nodes[1:] + [len(outline)]):
            control = [outline[k % len(outline)][1] for k in range(first, last + 1)]
            pieces = parts if len(control) > 2 or sides else 1
            points += [point_at(control, k / pieces) for k in range(pieces)]
        points.append(points[0])
        yield name, draw.choice((0.5, 1, 2, 4, 8, 16)), [tuple(float(round(c)) for c in p) for p in points] if rounded else points


def reported(_draw):
    for number, (tolerance, points) in enumerate(REPORTED):
        yield f"reported {number}", tolerance, [tuple(map(float, p)) for p in points]


def smooth(draw):
    for number in range(SMOOTH):
        count, tolerance = draw.choice((20, 40, 100)), draw.choice((1e-1, 1e-2, 1e-3, 1e-4, 1e-6))
        if number % 4:
            d, n = draw.choice((2, 2, 3)), draw.choice((3, 3, 5, 8))
            control = [tuple(draw.uniform(-1, 1) for _ in range(d)) for _ in range(n + 1)]
            points = [point_at(control, k / (count - 1)) for k in range(count)]
        else:
            wave, height = draw.uniform(0, 0.2), draw.uniform(0.3, 1)
            angles = [2 * math.pi * k / count for k in range(count)]
            points = [(math.cos(a) * (1 + wave * math.cos(6 * a)), height * math.sin(a)) for a in angles]
            points.append(points[0])
        yield f"smooth {number}", tolerance, points


def distance(point, first, last):
    """The distance of a point from a line segment."""
    step = [b - a for a, b in zip(first, last)]
    square = sum(x * x for x in step)
    along = sum((p - a) * x for p, a, x in zip(point, first, step))
    share = min(max(along / square, 0), 1) if square else 0
    return math.dist(point, [a + share * x for a, x in zip(first, step)])


def judge(points, tolerance, segments):
    """Yields a line where the curve is too far from the polyline."""
    allowed = max(5 * tolerance, max(max(axis) - min(axis) for axis in zip(*points)) / 10)
    sides = list(zip(points, points[1:]))
    for number, segment in enumerate(segments):
        for k in range(STEPS + 1):
            point = point_at(segment, k / STEPS)
            if all(distance(point, *side) > allowed for side in sides):
                yield f"segment {number} is farther than {allowed:g} from the polyline at t = {k / STEPS}: at {point}"
                return


def fitted(program, points, tolerance, method):
    rows, _ = program.ask("fit", "--points", points, "--tolerance", repr(float(tolerance)), "--method", method)
    control = [tuple(float(row[axis]) for axis in "xyz"[:len(points[0])]) for row in rows]
    return [control[k:k + 4] for k in range(0, len(control), 4)]


def questions(program, seed):
    drawn = 0

    def of(family, points, tolerance, method):
        nonlocal drawn
        segments = fitted(program, points, tolerance, method)
        yield from judge(points, tolerance, segments)
        if family is smooth and method == "gauss_newton":
            drawn += len(segments)
            if drawn > 1.15 * SEGMENTS.get(seed, math.inf):
                yield f"{drawn} segments for smooth data so far; all of them had {SEGMENTS[seed]}"

    for family in (reported, lines, glyphs, smooth):
        for name, tolerance, points in family(random.Random(f"{family.__name__} {seed}")):
            for method in METHODS:
                yield f"{method}, {name}, tolerance {tolerance}", of(family, points, tolerance, method)


if __name__ == "__main__":
    sys.exit(judging.main(__doc__, "fits", 2 * (1200 + 108 + len(REPORTED) + SMOOTH), questions))
