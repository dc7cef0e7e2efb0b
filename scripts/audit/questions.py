# SPDX-License-Identifier: MIT
"""What the audit asks, and how wrong an answer is: truth from libbezierbench through Python, and a second way to each truth.

A problem has `asked`, the numbers that follow a curve's coordinates in a question; `exact`, the true answer; `error`, the absolute
error of an answer; and `check`, which computes the error of one answer again without the library and raises ValueError where
the two differ.
"""

from __future__ import annotations

import functools
import hashlib
import math
from collections.abc import Callable, Iterable
from decimal import Decimal, getcontext
from fractions import Fraction
from typing import NamedTuple

import bezierbench
import numpy as np

Point = tuple[float, float]
EASING_STEPS = 64  # questions for each easing curve
MONOTONE_STEPS = 2**20
ROUNDING = 1e-12  # a smaller step backwards does not count
getcontext().prec = 60


class Curve(NamedTuple):
    set: str
    id: str
    points: tuple[Point, ...]

    @property
    def size(self) -> float:
        return max(max(axis) - min(axis) for axis in zip(*self.points))

    @property
    def largest(self) -> float:
        return max(abs(value) for point in self.points for value in point)

    def drawn(self) -> list[float]:
        """Four numbers in [0, 1) that depend on the curve's name only."""
        digest = hashlib.sha256(f"{self.set}:{self.id}".encode()).digest()
        return [int.from_bytes(digest[k:k + 6], "big") / 2**48 for k in range(0, 24, 6)]


@functools.lru_cache(maxsize=None)
def length(points: tuple[Point, ...]) -> float:
    return bezierbench.exact_arc_length(points)


@functools.lru_cache(maxsize=None)
def foot(points: tuple[Point, ...], x: float, y: float) -> tuple[float, float]:
    return tuple(bezierbench.exact_project(points, [x, y]))


@functools.lru_cache(maxsize=None)
def at_length(points: tuple[Point, ...], asked: float) -> Point:
    return tuple(bezierbench.exact(points, bezierbench.at_length(points, asked, tolerance=1e-13).t))


UNITS: dict[str, Callable[[Curve], float]] = {
    "units": lambda curve: 1.0, "pieces": lambda curve: 1.0, "of the range": lambda curve: 1.0, "of the size": lambda curve: curve.size,
    "of the largest coordinate": lambda curve: curve.largest, "of the length": lambda curve: length(curve.points),
    "of the tolerance": lambda curve: 1e-3 * curve.size}


def _pairs(flat: Iterable[float]) -> list[Point]:
    values = list(flat)
    return list(zip(values[::2], values[1::2]))


def _distance(a: Iterable[float], b: Iterable[float]) -> float:
    return math.hypot(*(p - q for p, q in zip(a, b)))


def _largest_difference(a: Iterable[float], b: Iterable[float]) -> float:
    return max(abs(p - q) for p, q in zip(a, b))


def _rational(points: Iterable[Iterable[float]], t: float) -> list[list[tuple[Fraction, ...]]]:
    """The rows of de Casteljau's algorithm in rational arithmetic."""
    rows, t = [[tuple(map(Fraction, point)) for point in points]], Fraction(t)
    while len(rows[-1]) > 1:
        rows.append([tuple((1 - t) * p + t * q for p, q in zip(a, b)) for a, b in zip(rows[-1], rows[-1][1:])])
    return rows


def _enclosed_length(points: tuple[Point, ...], gap: float) -> tuple[float, float]:
    """The sums of the chords and of the control polygons of parts, which are halved until they differ by at most the gap."""
    low, high, pending = [], [], [([complex(*point) for point in points], gap, 0)]
    while pending:
        row, allowed, depth = pending.pop()
        chord, polygon = abs(row[-1] - row[0]), sum(abs(b - a) for a, b in zip(row, row[1:]))
        if polygon - chord <= allowed or depth == 40:
            low.append(chord)
            high.append(polygon)
            continue
        left, right = [], []
        while row:
            left.append(row[0])
            right.append(row[-1])
            row = [(a + b) / 2 for a, b in zip(row, row[1:])]
        pending += [(left, allowed / 2, depth + 1), (right[::-1], allowed / 2, depth + 1)]
    return math.fsum(low), math.fsum(high)


def _agree(error: float, low: float, high: float, rounding: float) -> None:
    """Raises ValueError unless the error is in [low, high], of which both are known up to rounding."""
    if not low - rounding <= error <= high + rounding:
        raise ValueError(f"the error {error} is {low} to {high} by the second way")


class Problem(NamedTuple):
    asked: Callable[[Curve], list[list[float]]]
    exact: Callable[[Curve, list[float]], list[float]]
    error: Callable[[Curve, list[float], list[float]], float]
    check: Callable[[Curve, list[float], list[float], float], None]
    as_asked: str = ""  # of adapters, where it is another problem's question
    only: Callable[[Curve], bool] = lambda curve: True
    faults: Callable[[list[float]], int] | None = None  # in an answer, where one covers many; the questions are then the steps


def _check_length(curve: Curve, asked: list[float], answer: list[float], error: float) -> None:
    low, high = _enclosed_length(curve.points, max(0.01 * error, 3e-9 * length(curve.points)))
    bounds = sorted((abs(answer[0] - low), abs(answer[0] - high)))
    _agree(error, 0 if low <= answer[0] <= high else bounds[0], bounds[1], 1e-12 * high)


LENGTH = Problem(lambda curve: [[]], lambda curve, asked: [length(curve.points)],
                 lambda curve, asked, answer: abs(answer[0] - length(curve.points)), _check_length)


@functools.lru_cache(maxsize=None)
def _halves(points: tuple[Point, ...], t: float) -> list[float]:
    """Control point k of the left half is a point of the curve of the first k + 1 control points; likewise on the right."""
    parts = [points[:k + 1] for k in range(len(points))] + [points[k:] for k in range(len(points))]
    return [float(value) for part in parts for value in bezierbench.exact(part, t)]


def _exact_halves(curve: Curve, asked: list[float]) -> list[float]:
    return _halves(curve.points, asked[0])


def _check_halves(curve: Curve, asked: list[float], answer: list[float], error: float) -> None:
    rows = _rational(curve.points, asked[0])
    exact = [value for point in [row[0] for row in rows] + [row[-1] for row in reversed(rows)] for value in point]
    again = float(max(abs(Fraction(a) - b) for a, b in zip(answer, exact)))
    _agree(error, again, again, 3e-16 * curve.largest)


def _moved_ends(curve: Curve, asked: list[float], answer: list[float]) -> float:
    n = len(curve.points)
    halves = _pairs(answer)
    return max(_largest_difference(*pair) for pair in
               ((halves[0], curve.points[0]), (halves[n - 1], halves[n]), (halves[-1], curve.points[-1])))


def _check_ends(curve: Curve, asked: list[float], answer: list[float], error: float) -> None:
    n, values = 2 * len(curve.points), [Fraction(value) for value in answer]
    flat = [Fraction(value) for point in curve.points for value in point]
    gaps = zip(values[:2] + values[n - 2:n] + values[-2:], flat[:2] + values[n:n + 2] + flat[-2:])
    again = float(max(abs(a - b) for a, b in gaps))
    _agree(error, again, again, 1e-15 * error)


def _target(curve: Curve) -> list[list[float]]:
    """A point in the box of the control points, twice as large about its middle."""
    box = [(min(axis), max(axis)) for axis in zip(*curve.points)]
    return [[low + (2 * u - 0.5) * max(high - low, 0.5 * curve.size) for (low, high), u in zip(box, curve.drawn()[1:])]]


def _check_nearest(curve: Curve, asked: list[float], answer: list[float], error: float) -> None:
    """A curve's point that is nearer by the error, up to the distance of samples; the error is not larger than stated by what
    the exact foot's distance is in rational arithmetic."""
    distances = [math.sqrt(sum((p - Fraction(q))**2 for p, q in zip(_rational(curve.points, t)[-1][0], asked)))
                 for t in (answer[0], foot(curve.points, *asked)[0])]
    _agree(error, *[abs(distances[0] - distances[1])] * 2, 1e-14 * curve.largest)
    t = np.linspace(0, 1, 20001)[:, None]
    row = [np.array(point) + 0 * t for point in curve.points]
    while len(row) > 1:
        row = [(1 - t) * a + t * b for a, b in zip(row, row[1:])]
    sampled = float(np.min(np.hypot(*(row[0] - asked).T)))
    _agree(distances[1], sampled - 1e-3 * curve.size, sampled, 1e-14 * curve.largest)


NEAREST = Problem(_target, lambda curve, asked: list(foot(curve.points, *asked)),
                  lambda curve, asked, answer: abs(_distance(bezierbench.exact(curve.points, answer[0]), asked)
                                                   - foot(curve.points, *asked)[1]), _check_nearest)


def _check_distance(curve: Curve, asked: list[float], answer: list[float], error: float) -> None:
    t, true = foot(curve.points, *asked)
    _check_nearest(curve, asked, [t], 0.0)
    _agree(error, abs(answer[1] - true), abs(answer[1] - true), 1e-14 * curve.largest)


def _check_at_length(curve: Curve, asked: list[float], answer: list[float], error: float) -> None:
    """The length up to the true point, by sums of chords, is the one asked for."""
    t = bezierbench.at_length(curve.points, asked[0], tolerance=1e-13).t
    rows = _rational(curve.points, t)
    left = tuple((float(row[0][0]), float(row[0][1])) for row in rows)
    low, high = _enclosed_length(left, 1e-7 * length(curve.points))
    _agree(asked[0], low, high, 1e-12 * high)
    again = _distance(answer, left[-1])
    _agree(error, again, again, 1e-14 * curve.largest)


def _deviation(curve: Curve, answer: list[float], samples: int = 17) -> float:
    """The largest distance between pieces and the equal parts of the curve, at equal parameters: at least the deviation."""
    pieces = np.array(answer).reshape(-1, 3, 2)
    u = np.linspace(0, 1, samples)[:, None, None]
    quadratics = (1 - u)**2 * pieces[:, 0] + 2 * u * (1 - u) * pieces[:, 1] + u**2 * pieces[:, 2]
    t = (np.arange(len(pieces))[:, None] + u) / len(pieces)
    b = np.array(curve.points)
    cubic = (1 - t)**3 * b[0] + 3 * t * (1 - t)**2 * b[1] + 3 * t**2 * (1 - t) * b[2] + t**3 * b[3]
    return float(np.max(np.hypot(*np.moveaxis(quadratics - cubic, -1, 0))))


def _check_deviation(curve: Curve, asked: list[float], answer: list[float], error: float) -> None:
    pieces, again = len(answer) // 6, 0.0
    for k in range(pieces):
        for j in range(17):
            u = Fraction(j, 16)
            a, b = (_rational(points, at)[-1][0] for points, at in
                    ((_pairs(answer[6 * k:6 * k + 6]), u), (curve.points, (k + u) / pieces)))
            again = max(again, math.sqrt(sum((p - q)**2 for p, q in zip(a, b))))
    _agree(error, again, again, 1e-14 * curve.largest)


def _right(curve: Curve) -> float:
    """A power of two, at least the size."""
    return 2.0 ** math.ceil(math.log2(curve.size))


def _check_moved(curve: Curve, asked: list[float], answer: list[float], error: float) -> None:
    if any(Fraction(x) + Fraction(asked[1]) != x + asked[1] for x, _ in curve.points):
        raise ValueError("the curve was changed by rounding when it was moved")
    _agree(error, abs(answer[1] - answer[0]), abs(answer[1] - answer[0]), 0)


def _is_easing(curve: Curve) -> bool:
    return len(curve.points) == 4 and curve.points[0] == (0, 0) and curve.points[3] == (1, 1) and all(
        0 <= x <= 1 for x, _ in curve.points[1:3])


@functools.lru_cache(maxsize=None)
def _eased_at(points: tuple[Point, ...], asked: float) -> list[float]:
    """y where x is the one asked for, by halving in 60 digits, and t there."""
    (x1, y1), (x2, y2) = [[Decimal(value) for value in point] for point in points[1:3]]
    x, low, high = Decimal(asked), Decimal(0), Decimal(1)
    for _ in range(150):
        t = (low + high) / 2
        low, high = (t, high) if t * (3 * (1 - t) * ((1 - t) * x1 + t * x2) + t * t) < x else (low, t)
    return [float(low * (3 * (1 - low) * ((1 - low) * y1 + low * y2) + low * low)), float(low)]


def _eased(curve: Curve, asked: list[float]) -> list[float]:
    return _eased_at(curve.points, asked[0])


def _check_easing(curve: Curve, asked: list[float], answer: list[float], error: float) -> None:
    """In rational arithmetic, x is reached between two parameters 2^-100 apart, and y there is the true one."""
    y, near = _eased(curve, asked)
    low, high = Fraction(near) - Fraction(1, 2**52), Fraction(near) + Fraction(1, 2**52)
    while high - low > Fraction(1, 2**100):
        t = (low + high) / 2
        low, high = (t, high) if _rational(curve.points, t)[-1][0][0] < Fraction(asked[0]) else (low, t)
    again = float(abs(Fraction(answer[0]) - _rational(curve.points, low)[-1][0][1]))
    _agree(error, again, again, 1e-15)


def _check_monotone(curve: Curve, asked: list[float], answer: list[float], error: float) -> None:
    """The curve increases, and the library's second value is below its first."""
    if not all(0 <= y <= 1 for _, y in curve.points) or bool(answer[0]) != (answer[2] - answer[3] > ROUNDING):
        raise ValueError("the curve need not increase, or the count is wrong")
    _agree(error, answer[2] - answer[3], answer[2] - answer[3], 0)


PROBLEMS = {
    "length": LENGTH, "approximate_length": LENGTH,
    "flattened_length": LENGTH._replace(asked=lambda curve: [[1e-4 * curve.size]], as_asked="length"),
    "point": Problem(lambda curve: [curve.drawn()[:1]], lambda curve, asked: list(map(float, bezierbench.exact(curve.points, asked[0]))),
                     lambda curve, asked, answer: _largest_difference(answer, bezierbench.exact(curve.points, asked[0])),
                     lambda curve, asked, answer, error: _agree(
                         error, *[_largest_difference(map(Fraction, answer), _rational(curve.points, asked[0])[-1][0])] * 2,
                         3e-16 * curve.largest)),
    "split": Problem(lambda curve: [curve.drawn()[:1]], _exact_halves,
                     lambda curve, asked, answer: _largest_difference(answer, _exact_halves(curve, asked)), _check_halves),
    "ends": Problem(lambda curve: [curve.drawn()[:1]], _exact_halves, _moved_ends, _check_ends, as_asked="split"),
    "nearest": NEAREST,
    "distance": NEAREST._replace(error=lambda curve, asked, answer: abs(answer[1] - foot(curve.points, *asked)[1]),
                                 check=_check_distance, as_asked="nearest"),
    "at_length": Problem(lambda curve: [[curve.drawn()[0] * length(curve.points)]],
                         lambda curve, asked: list(map(float, at_length(curve.points, asked[0]))),
                         lambda curve, asked, answer: _distance(answer, at_length(curve.points, asked[0])), _check_at_length),
    "quadratics": Problem(lambda curve: [[1e-3 * curve.size]], lambda curve, asked: asked,
                          lambda curve, asked, answer: _deviation(curve, answer), _check_deviation),
    "moved": Problem(lambda curve: [[1e-3 * curve.size, _right(curve)]], lambda curve, asked: [0],
                     lambda curve, asked, answer: abs(answer[1] - answer[0]), _check_moved,
                     only=lambda curve: all(Fraction(x) + Fraction(_right(curve)) == x + _right(curve) for x, _ in curve.points)),
    "easing": Problem(lambda curve: [[(k + 0.5) / EASING_STEPS] for k in range(EASING_STEPS)], _eased,
                      lambda curve, asked, answer: abs(answer[0] - _eased(curve, asked)[0]), _check_easing, only=_is_easing),
    "monotone": Problem(lambda curve: [[MONOTONE_STEPS, ROUNDING]], lambda curve, asked: [0], lambda curve, asked, answer: max(0.0, answer[2] - answer[3]),
                        _check_monotone, only=lambda curve: _is_easing(curve) and all(0 <= y <= 1 for _, y in curve.points),
                        faults=lambda answer: int(answer[0])),
}
