#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve fit` in rational arithmetic, on random and difficult points.

It shares no code with the program. For every data point a parameter is searched for in floating point, on a dense grid
and then by halving steps. The distance at that parameter is computed in fractions; it may exceed neither the tolerance
nor the maximum error that the program claims. Segments must join in data points, from the first point to the last.

check_fit.py PROGRAM [--seed S]    exits 1 with the first mismatches
"""
import random
import re
import sys
from fractions import Fraction

import judging

METHODS = ("schneider", "gauss_newton")
TOLERANCES = (0.0, 1e-13, 1e-6, 1e-2, 0.3)  # times the largest coordinate
GRID = 64
STARTS = 3  # from the best points of the grid


def basis(t):
    s = 1 - t
    return s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t


def squared_length_at(offsets, t):
    """|C(t) - P|^2; `offsets` are the control points minus P."""
    weights = basis(t)
    return sum(sum(w * b[axis] for w, b in zip(weights, offsets)) ** 2 for axis in range(len(offsets[0])))


def candidates(offsets):
    """Candidates (segment, t) for the nearest point, in floating point: the best of a grid, refined by steps that are
    halved."""
    grid = sorted((squared_length_at(segment, k / GRID), i, k / GRID)
                  for i, segment in enumerate(offsets) for k in range(GRID + 1))
    for distance, i, t in grid[:STARTS]:
        step = 0.5 / GRID
        while step > 2.0**-60 and distance > 0:
            near = min((squared_length_at(offsets[i], u), u) for u in (max(t - step, 0.0), min(t + step, 1.0)))
            if near[0] < distance:
                distance, t = near
            else:
                step /= 2
        yield i, t


def within(segments, point, limit):
    """Whether a point of the curve within `limit` of the point was found. True is certain; False may miss one."""
    offsets = [[[c - x for c, x in zip(b, point)] for b in segment] for segment in segments]
    size = max((abs(c) for segment in offsets for b in segment for c in b), default=0) or Fraction(1)
    scaled = [[[float(c / size) for c in b] for b in segment] for segment in offsets]
    return any(squared_length_at(offsets[i], Fraction(t)) <= limit**2 for i, t in candidates(scaled))


def judge(points, tolerance, rows, claimed):
    """Yields what is wrong, one line each."""
    if len(rows) % 4 or [(r["segment"], r["index"]) for r in rows] != [(str(k // 4), str(k % 4)) for k in range(len(rows))]:
        yield "rows are not those of whole segments"
        return
    axes = "xyz"[: len(points[0])]
    control = [[Fraction(float(r[axis])) for axis in axes] for r in rows]
    segments = [control[k:k + 4] for k in range(0, len(control), 4)]
    data = [[Fraction(x) for x in p] for p in points]
    if segments[0][0] != data[0] or segments[-1][3] != data[-1]:
        yield "the curve does not lead from the first point to the last"
    for i, (one, other) in enumerate(zip(segments, segments[1:])):
        if one[3] != other[0] or one[3] not in data:
            yield f"segments {i} and {i + 1} do not join in a data point"
    if claimed > tolerance:
        yield f"the claimed error {float(claimed)} exceeds the tolerance {float(tolerance)}"
    for k, point in enumerate(data):
        if not within(segments, point, claimed):
            yield f"point {k} is farther than the claimed error {float(claimed)}"


def walk(draw, n, d):
    place, way, points = [0.0] * d, [draw.uniform(-1, 1) for _ in range(d)], []
    for _ in range(n):
        points.append(place)
        way = [v + 0.3 * draw.uniform(-1, 1) for v in way]
        place = [x + v for x, v in zip(place, way)]
    return points


def samples(draw, n, d):
    segment = [[draw.uniform(-1, 1) for _ in range(d)] for _ in range(4)]
    return [[sum(w * b[axis] for w, b in zip(basis(k / max(n - 1, 1)), segment)) for axis in range(d)] for k in range(n)]


def closed(draw, n, d):
    points = samples(draw, n, d)
    return points + [points[0]]


def integers(draw, n, d):
    return [[float(draw.randint(-3, 3)) for _ in range(d)] for _ in range(n)]


def repeated(draw, n, d):
    points = samples(draw, n, d)
    return [points[max(k - draw.randrange(3), 0)] for k in range(n)]


def straight(draw, n, d):
    step = [draw.uniform(-1, 1) for _ in range(d)]
    return [[k * x for x in step] for k in range(n)]


def same(draw, n, d):
    return walk(draw, 1, d) * n


def times(make, size):
    def made(draw, n, d):
        return [[x * size for x in p] for p in make(draw, n, d)]
    made.__name__ = f"{make.__name__} times {size}"
    return made


def distant(draw, n, d):
    return [[x * 1e-6 + 1e9 for x in p] for p in samples(draw, n, d)]


KINDS = (walk, samples, closed, integers, repeated, straight, same, distant, times(samples, 1e300), times(walk, 1e-300),
         times(samples, 3e-320))


def cases(seed):
    """Yields (name, points, tolerance)."""
    draw = random.Random(seed)
    for kind in KINDS:
        for tolerance in TOLERANCES:
            n, d = draw.randint(2, 24), 1 + draw.randrange(3)
            points = kind(draw, n, d)
            yield f"{kind.__name__} {n}", points, tolerance * max(abs(x) for p in points for x in p)


def judge_fit(program, points, tolerance, method):
    rows, said = program.ask("fit", "--points", points, "--tolerance", tolerance.hex(), "--method", method)
    summary = re.fullmatch(r"bezierbench: (\d+) segments?, maximum error (\S+)\n", said)
    if not summary:
        raise ValueError(f"no summary on standard error: {said.strip()[:300]}")
    yield from judge(points, Fraction(tolerance), rows, Fraction(float(summary[2])))
    if len(rows) != 4 * int(summary[1]):
        yield "the number of segments is another than on standard error"


def questions(program, seed):
    for name, points, tolerance in cases(seed):
        for method in METHODS:
            yield f"{method}, {name}, tolerance {tolerance}", judge_fit(program, points, tolerance, method)


if __name__ == "__main__":
    sys.exit(judging.main(__doc__, "fits", len(KINDS) * len(TOLERANCES), questions))
