# SPDX-License-Identifier: MIT
"""B-spline curves and NURBS."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Array, address, array_of, parameters, point_rows
from ._library import NO_POINT, BsplineEntry, Error, check, library
from .curve_files import FileCurve, copied, taken


class Bspline:
    """A B-spline curve over t from `knots[degree]` to `knots[count]` for `count` control points, with weights a NURBS.

    `points` has a row for each control point. There are degree + 1 more `knots`, which must not descend. The curves that methods
    return have the true coordinates and weights, each rounded once; control points without influence are left out. Raises ValueError
    for what is not a curve.
    """

    def __init__(self, points: ArrayLike, knots: ArrayLike, weights: ArrayLike | None = None) -> None:
        self.points = point_rows(points)
        self.knots = array_of(knots, np.float64)
        self.weights = None if weights is None else array_of(weights, np.float64)
        count, dimension = self.points.shape
        self.degree = self.knots.size - count - 1
        if self.knots.ndim != 1 or not 1 <= self.degree < count:
            raise ValueError(f"knots have the shape {self.knots.shape}; give {count + 2} to {2 * count}, degree + 1 more than points")
        if self.weights is not None and self.weights.shape != (count,):
            raise ValueError(f"weights have the shape {self.weights.shape}; give one for each of the {count} points")
        if np.any(self.knots[1:] < self.knots[:-1]):
            raise ValueError("knots descend; give them in ascending order")
        if self.knots[self.degree] == self.knots[count]:
            raise ValueError(f"the curve begins and ends at {self.knots[count]}; give knots[{self.degree}] below knots[{count}]")
        if self.weights is not None and np.any(self.weights <= 0):
            raise ValueError("a weight is not above 0; give weights above 0")
        self._entry = BsplineEntry(dimension, self.degree, count, address(self.points),
                                   None if self.weights is None else address(self.weights), address(self.knots))
        check(library.bb_bspline_exact(self._pointer, None, 0, None))

    def __call__(self, t: ArrayLike, method: str = "de_boor") -> Array:
        """The points at t by a method for the problem "bspline"; shaped as those of `evaluate`."""
        return self._values(t, lambda *rest: library.bb_bspline_evaluate(method.encode(), *rest))

    def exact(self, t: ArrayLike) -> Array:
        """The true points, each coordinate rounded once."""
        return self._values(t, library.bb_bspline_exact)

    def spans(self) -> list[FileCurve]:
        """The spans that are not empty in Bernstein or rational form, each over [0, 1] and rounded once, with their numbers as ids."""
        handle = ctypes.c_void_p()
        check(library.bb_bspline_spans(self._pointer, ctypes.byref(handle)))
        return taken(handle)

    def insert(self, *knots: float) -> Bspline:
        """The same curve with these knots inserted. Knots at an end clamp it."""
        for knot in set(knots):
            times, most = self._times(knot) + knots.count(knot), self.degree + (knot in self._ends)
            if times > most:
                raise ValueError(f"the knot {knot} would stand {times} times; leave {min(times - most, knots.count(knot))} of them out")
        return self._made(library.bb_bspline_insert, *_knots(knots))

    def remove(self, *knots: float, tolerance: float = 0) -> Bspline:
        """The curve without these knots, where no point moves farther than `tolerance`; otherwise a ValueError says how far one
        might move."""
        if not tolerance >= 0:
            raise ValueError(f"the tolerance is {tolerance}; give a distance, 0 or more")
        for knot in set(knots):
            times = 0 if knot in self._ends else self._times(knot)
            if times < knots.count(knot):
                raise ValueError(f"the knot {knot} stands {times} times between the ends; give one that stands there, as often at most")
        deviation = ctypes.c_double()
        result = self._made(library.bb_bspline_remove, *_knots(knots), after=(ctypes.byref(deviation),))
        if not deviation.value <= tolerance:
            raise ValueError(f"a point might move by {deviation.value!r}; give that as tolerance to allow it")
        return result

    def elevate(self, degree: int) -> Bspline:
        """The same curve in a degree from its own to 64: time grows with its fourth power."""
        if not self.degree <= degree <= 64:
            raise ValueError(f"the degree {degree} is not one from that of the curve, {self.degree}, to 64; give one")
        return self._made(library.bb_bspline_elevate, degree)

    def part(self, start: float, stop: float) -> Bspline:
        """The part over t in [start, stop], clamped."""
        if start >= stop:
            raise ValueError(f"the part begins at {start} and ends at {stop}; give start below stop")
        return self._made(library.bb_bspline_part, start, stop)

    def derivative(self, order: int = 1) -> Bspline:
        """The derivative of an order below the degree, of a curve without weights."""
        if self.weights is not None:
            raise ValueError("the derivative of a curve with weights is not one of its degree; take a curve without weights")
        if not 0 <= order < self.degree:
            raise ValueError(f"the order {order} is not below the degree, {self.degree}; give one from 0 to {self.degree - 1}")
        return self._made(library.bb_bspline_derivative, order)

    @property
    def _ends(self) -> tuple[float, float]:
        return float(self.knots[self.degree]), float(self.knots[len(self.points)])

    def _times(self, knot: float) -> int:
        return int(np.count_nonzero(self.knots == knot))

    @property
    def _pointer(self) -> Any:
        return ctypes.byref(self._entry)

    def _values(self, t: ArrayLike, call: Any) -> Array:
        values = parameters(t)
        out = np.empty((*values.shape, self.points.shape[1]))
        check(call(self._pointer, address(values), values.size, address(out)))
        return out

    def _made(self, call: Any, *arguments: Any, after: tuple[Any, ...] = ()) -> Bspline:
        handle, entry = ctypes.c_void_p(), BsplineEntry()
        status = call(self._pointer, *arguments, ctypes.byref(handle), *after)
        if status == NO_POINT:
            raise Error(status, "a weight of the new curve would not be above 0; give weights that differ less")
        check(status)
        try:
            check(library.bb_bspline_get(handle, ctypes.byref(entry)))
            count = entry.count
            return Bspline(copied(entry.points, count * entry.dimension).reshape(count, -1), copied(entry.knots, count + entry.degree + 1),
                           copied(entry.weights, count) if entry.weights else None)
        finally:
            library.bb_bspline_free(handle)


def _knots(knots: tuple[float, ...]) -> tuple[Any, int]:
    values = array_of(np.array(knots, dtype=object), np.float64)
    return values.ctypes.data_as(ctypes.c_void_p), values.size
