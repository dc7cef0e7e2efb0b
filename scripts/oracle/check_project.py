#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges `bezierbench curve project` in rational arithmetic, on random and difficult curves.

It shares no code with the program. The distance at the program's exact_t is computed from the definition. (C - P).C'
must change its sign there, or vanish, or at an end point out of the interval. No point of a grid may be nearer, and of
two parameters that are exactly as near exact_t must be the first.

check_project.py PROGRAM [--seed S]    exits 1 with the first mismatches
"""
import math
import random
import sys
from fractions import Fraction

import judging
from exact import point_at
from judging import constant, graded, integers, mirrored, straight, uniform

COLUMNS = "method,t,distance,candidates,exact_t,exact_distance,error".split(",")
GRID = 128
ALWAYS = {"quintic_isolate", "quintic_companion", "quintic_durand_kerner", "quintic_jenkins_traub", "subdivide_hull", "scan_bisect",
          "scan_refine", "scan_length", "seed_004_scan", "seed_004_subdivide"}
RATIONAL = {"subdivide_hull", "scan_bisect", "scan_refine"}


def on_curve(lifted, t):
    """The point at t of a curve whose control points are followed by their weights and multiplied with them."""
    *point, weight = point_at(lifted, t)
    return [x / weight for x in point]


def squared_distance(lifted, target, t):
    return sum((a - b) ** 2 for a, b in zip(on_curve(lifted, t), target))


def slope(lifted, target, t):
    """(C - P).C' W / n: C' is (A' - C W') / W."""
    difference = [[b - a for a, b in zip(p, q)] for p, q in zip(lifted, lifted[1:])]
    (*velocity, change), sign = point_at(difference, t), point_at(lifted, t)[-1]
    return sum((a - b) * (v - a * change) for a, b, v in zip(on_curve(lifted, t), target, velocity)) / sign


KINDS = (uniform, integers, graded, straight, constant, mirrored)
TARGETS = {
    "drawn": lambda draw, points: uniform(draw, 0, len(points[0]))[0],
    "at a control point": lambda draw, points: draw.choice(points),
    "on the curve": lambda draw, points: [float(x) for x in point_at([list(map(Fraction, p)) for p in points],
                                                                     Fraction(draw.random()))],
    "at the origin": lambda draw, points: [0.0] * len(points[0]),
    "far away": lambda draw, points: [x * 1e12 for x in uniform(draw, 0, len(points[0]))[0]],
}


def there_and_back(draw):
    """C(t) = C(1 - t)."""
    half = integers(draw, draw.randint(1, 3), 1 + draw.randrange(3))
    return half + half[::-1][draw.randrange(2):], Fraction(1, 2)


def turned(draw):
    """A line or parabola of 3 t^2 - 2 t, which is the same at t and 2/3 - t."""
    a, b = integers(draw, 1, 2)
    power = [[0, 0], [-2 * x for x in a], [3 * x + 4 * y for x, y in zip(a, b)], [-12 * y for y in b], [9 * y for y in b]]
    return [[sum(12 * math.comb(k, j) / math.comb(4, j) * row[axis] for j, row in enumerate(power[:k + 1])) for axis in range(2)]
            for k in range(5)], Fraction(1, 3)


def cases(seed):
    """Yields (name, control points, point), and for curves that are the same at t and 2 c - t also c."""
    draw = random.Random(seed)
    five = [[-3.0, 1.0], [4.0, -7.0], [-4.0, 7.0], [3.0, -1.0]]
    yield "five critical points", five, [0.0, 0.0]
    for kind in KINDS:
        for name, target in TARGETS.items():
            for n in (1, 3, draw.choice((2, 4, 5, 6)), 3):
                points = kind(draw, n, 1 + draw.randrange(3))
                yield f"{kind.__name__} {n}, point {name}", points, target(draw, points)
    for tie in (there_and_back, turned):
        for _ in range(30):
            points, centre = tie(draw)
            yield tie.__name__, points, integers(draw, 0, len(points[0]))[0], centre


def rational_cases(seed):
    """Yields (name, control points, point, weights): positive weights, and ones of both signs without a pole."""
    draw = random.Random(seed)
    yield "quarter circle", [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [3.0, 4.0], [1.0, 1.0, 2.0]
    for kind in (uniform, integers, mirrored, constant):
        for n in (1, 2, 3, 4, 5):
            points = kind(draw, n, 1 + draw.randrange(3))
            inner = (lambda: draw.uniform(-1, 1) / n) if n % 2 else (lambda: draw.uniform(0.25, 4))
            weights = [draw.uniform(1, 2) if i in (0, n) else inner() for i in range(n + 1)]
            yield f"{kind.__name__} {n}", points, uniform(draw, 0, len(points[0]))[0], weights


def judge(program, points, target, centre=0, weights=None):
    """Yields what is wrong with the program's rows, one line each."""
    given = [[*p, w] for p, w in zip(points, weights)] if weights else points
    rows, _ = program.ask("project", "--curve", given, "--point=" + ",".join(x.hex() for x in target),
                          columns=[*"xyz"[:len(target)], "w"])
    exact_target = list(map(Fraction, target))
    exact_points = [[*(Fraction(x) * Fraction(w) for x in p), Fraction(w)] for p, w in zip(points, weights or [1] * len(points))]
    size = max(abs(x) for p in [*points, target] for x in p) or 1.0
    methods = {row["method"] for row in rows}
    if not rows or list(rows[0]) != [*COLUMNS, *"xyz"[:len(target)]] or not (RATIONAL if weights else ALWAYS) <= methods or (
            ("quintic_seed_002" in methods) != (len(points) == 4 and not weights)):
        yield f"columns or methods: {rows[:1]} {sorted(methods)}"
        return
    for row in rows:
        truth = on_curve(exact_points, Fraction(float(row["t"])))
        if any(abs(Fraction(float(row[axis])) - x) > Fraction(size) / 2**50 for axis, x in zip("xyz", truth)):
            yield f"{row['method']}: the point at t = {row['t']} is not that of the curve"
    t, distance = Fraction(float(rows[0]["exact_t"])), float(rows[0]["exact_distance"])
    if not 0 <= t <= 1:
        yield f"exact_t {float(t)} is outside [0, 1]"
    if centre + Fraction(1, 2**53) < t <= 2 * centre:
        yield f"exact_t {float(t)}, but {float(2 * centre - t)} is as near and before it"
    here = math.sqrt(squared_distance(exact_points, exact_target, t))
    if abs(here - distance) > 2.0**-50 * size:  # t is rounded
        yield f"exact_distance {distance}, but {here} at exact_t"
    step = Fraction(1, 2**51)
    before = slope(exact_points, exact_target, t - step)
    after = slope(exact_points, exact_target, t + step)
    if not ((t == 0 or before <= 0) and (t == 1 or after >= 0)):
        yield f"no minimum at exact_t {float(t)}: (C - P).C' is {float(before)}, then {float(after)}"
    least = min(squared_distance(exact_points, exact_target, Fraction(i, GRID)) for i in range(GRID + 1))
    if least < (Fraction(distance) * (1 - Fraction(1, 2**52))) ** 2:
        yield f"exact_distance {distance}, but a point of the grid is at {math.sqrt(least)}"
    for row in rows:
        there = math.sqrt(squared_distance(exact_points, exact_target, Fraction(float(row["t"]))))
        said, place = abs(float(row["distance"]) - distance), there - distance
        error = place if place > 2 * said + 2.0**-50 * distance else said  # error of the distance or, if larger, of the place
        if abs(float(row["error"]) - error) > 2.0**-50 * (distance + error):
            yield f"{row['method']}: error {row['error']}, not {error}"
        if abs(there - float(row["distance"])) > 2.0**-50 * there + (2.0**-44 if weights else 2.0**-97) * size:  # u and c_2 u^2, c_2 < 2^9
            yield f"{row['method']}: distance {row['distance']}, but {there} at t = {row['t']}"
        if row["method"] == "quintic_isolate" and float(row["error"]) > 4 * 2.0**-52 * size:
            yield f"quintic_isolate is {float(row['error']) / size * 2**52} units off"


def questions(program, seed):
    for name, points, target, weights in rational_cases(seed):
        yield f"{name} {points} {target} {weights}", judge(program, points, target, 0, weights)
    for name, *question in cases(seed):
        yield " ".join(map(str, (name, *question))), judge(program, *question)


if __name__ == "__main__":
    sys.exit(judging.main(__doc__, "projections", 160, questions))
