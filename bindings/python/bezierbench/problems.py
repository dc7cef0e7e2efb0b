# SPDX-License-Identifier: MIT
"""Arc length, projection, roots, fitting and easing, with their true results; interpolation."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Array, GivenCurve, address, array_of, point_rows
from ._library import FootEntry, LengthEntry, ParameterEntry, SplineEntry, check, interruptible, library


class Length(NamedTuple):
    length: float
    error_estimate: float  # of the method, absolute; NaN where it has none
    evaluations: int  # of the speed or, for chords, of the curve
    converged: bool


class Parameter(NamedTuple):
    t: float
    error_estimate: float  # of the method, of the length up to t, absolute
    iterations: int
    converged: bool


class Foot(NamedTuple):
    t: float
    distance: float
    candidates: int  # parameters or pieces whose distances were compared
    converged: bool  # False where the method gave up; it is then the best that it found


class ExactFoot(NamedTuple):
    t: float
    distance: float


class Root(NamedTuple):
    t: float  # rounded once
    multiplicity: int  # an odd one changes the sign


class Fit(NamedTuple):
    segments: Array  # of shape (count, 4, dimension): cubic Bezier segments
    max_error: float  # the distance of the points from the curve, as the method bounds it
    exact_error: float  # the true one, rounded once


def _check_truth(curve: GivenCurve, call: Callable[[], int]) -> None:
    """Above degree 20 a truth may take so long that somebody wants to interrupt it; below, a thread would take longer."""
    check(interruptible(call) if len(curve.points) > 21 else call())


def arc_length(points: ArrayLike, method: str = "gauss_legendre_adaptive", *, weights: ArrayLike | None = None, start: float = 0,
               stop: float = 1, tolerance: float = 1e-9) -> Length:
    """The length of a Bezier curve, with `weights` of a rational one, between two parameters in [0,1], up to `tolerance` times that
    length."""
    curve = GivenCurve(points, weights=weights)
    found = LengthEntry()
    check(library.bb_arc_length(method.encode(), curve.pointer, start, stop, tolerance, ctypes.byref(found)))
    return Length(found.length, found.error_estimate, found.evaluations, bool(found.converged))


def at_length(points: ArrayLike, length: float, method: str = "bracketed_newton", *, weights: ArrayLike | None = None,
              tolerance: float = 1e-9) -> Parameter:
    """The parameter at which the length from the beginning of a Bezier curve is `length`, up to `tolerance` times the length
    of the curve. A length beyond that of the curve by no more than this, as a computed one may be, is that of the curve."""
    curve = GivenCurve(points, weights=weights)
    found = ParameterEntry()
    check(library.bb_at_length(method.encode(), curve.pointer, length, tolerance, ctypes.byref(found)))
    return Parameter(found.t, found.error_estimate, found.iterations, bool(found.converged))


def exact_arc_length(points: ArrayLike, *, weights: ArrayLike | None = None, start: float = 0, stop: float = 1) -> float:
    """The true length, rounded once."""
    curve = GivenCurve(points, weights=weights)
    length = ctypes.c_double()
    _check_truth(curve, lambda: library.bb_exact_arc_length(curve.pointer, start, stop, ctypes.byref(length)))
    return length.value


def arc_length_error(points: ArrayLike, length: float, *, weights: ArrayLike | None = None, start: float = 0, stop: float = 1) -> float:
    """|length - true length|, rounded once; 0 where it is within 1e-30 of the length."""
    curve = GivenCurve(points, weights=weights)
    error = ctypes.c_double()
    _check_truth(curve, lambda: library.bb_arc_length_error(curve.pointer, start, stop, length, ctypes.byref(error)))
    return error.value


def _point(point: ArrayLike, curve: GivenCurve) -> Array:
    coordinates = array_of(point, np.float64).reshape(-1)
    if coordinates.size != curve.dimension:
        raise ValueError(f"the point has {coordinates.size} coordinates, the curve {curve.dimension}")
    return coordinates


def project(points: ArrayLike, point: ArrayLike, method: str = "subdivide_hull", *, weights: ArrayLike | None = None) -> Foot:
    """The nearest point of a Bezier curve, with `weights` of a rational one, to `point`."""
    curve = GivenCurve(points, weights=weights)
    at = _point(point, curve)
    found = FootEntry()
    check(library.bb_project(method.encode(), curve.pointer, address(at), ctypes.byref(found)))
    return Foot(found.t, found.distance, found.candidates, bool(found.converged))


def exact_project(points: ArrayLike, point: ArrayLike, *, weights: ArrayLike | None = None) -> ExactFoot:
    """The true nearest point, of equally near ones the first: its parameter and distance, each rounded once."""
    curve = GivenCurve(points, weights=weights)
    at = _point(point, curve)
    t, distance = ctypes.c_double(), ctypes.c_double()
    _check_truth(curve, lambda: library.bb_exact_project(curve.pointer, address(at), ctypes.byref(t), ctypes.byref(distance)))
    return ExactFoot(t.value, distance.value)


def project_error(points: ArrayLike, point: ArrayLike, t: float, distance: float, *, weights: ArrayLike | None = None) -> float:
    """The error of a foot: |distance - true distance|, or how much farther than the nearest point the curve is at t, where
    that is more than twice as much."""
    curve = GivenCurve(points, weights=weights)
    at = _point(point, curve)
    error = ctypes.c_double()
    _check_truth(curve, lambda: library.bb_project_error(curve.pointer, address(at), t, distance, ctypes.byref(error)))
    return error.value


ROOTS_OF = ("value", "extrema", "inflections")  # in the order of bb_roots_of


def roots(points: ArrayLike, value: float = 0, *, axis: int = 0, of: str = "value", form: str = "bernstein",
          weights: ArrayLike | None = None) -> list[Root]:
    """All parameters in [0,1] at which coordinate `axis` is `value`, the true ones, ascending; with `of="extrema"` those at which its
    derivative is 0, with `of="inflections"` those at which x'y'' = x''y' on a curve in the plane: an odd multiplicity at a point with
    a tangent is an inflection, an even one a flat point; an ordinary cusp has 2. Raises ValueError where every parameter is a root."""
    curve = GivenCurve(points, form, weights)
    if of not in ROOTS_OF:
        raise ValueError(f"no {of!r}; use {', '.join(ROOTS_OF)}")
    if not 0 <= axis < curve.dimension:
        raise ValueError(f"axis {axis}: must be from 0 to {curve.dimension - 1}")
    capacity = 3 * len(curve.points)
    t, multiplicities = np.empty(capacity), np.empty(capacity, np.intc)
    count = ctypes.c_size_t()
    _check_truth(curve, lambda: library.bb_roots(curve.pointer, ROOTS_OF.index(of), axis, value, address(t), address(multiplicities),
                                                 capacity, ctypes.byref(count)))
    if count.value > capacity:
        raise ValueError("every parameter is a root; the coordinate is constant, or the curve is straight")
    return [Root(float(at), int(multiplicity)) for at, multiplicity in zip(t[:count.value], multiplicities[:count.value])]


def _easing(bezier: ArrayLike, x: ArrayLike, dtype: type) -> tuple[Array, Array, Array]:
    curve = array_of(bezier, dtype).reshape(-1)
    if curve.size != 4:
        raise ValueError(f"an easing curve has 4 numbers, x1, y1, x2 and y2, not {curve.size}")
    at = array_of(x, dtype)
    return curve, at, np.empty_like(at)


def ease(bezier: ArrayLike, x: ArrayLike, method: str = "easing_correctly_rounded") -> Array:
    """y at each x of the easing curve (0,0) (x1,y1) (x2,y2) (1,1), cubic-bezier(x1, y1, x2, y2) of CSS; x1 and x2 are in [0,1],
    and outside [0,1] the curve goes on along its tangents. `x` of dtype float32 is answered in float."""
    is_float = getattr(x, "dtype", None) == np.float32
    curve, at, y = _easing(bezier, x, np.float32 if is_float else np.float64)
    call = library.bb_ease_float if is_float else library.bb_ease
    check(call(method.encode(), address(curve), address(at), at.size, address(y)))
    return y


def exact_ease(bezier: ArrayLike, x: ArrayLike) -> Array:
    """The true y at each x, rounded once."""
    curve, at, y = _easing(bezier, x, np.float64)
    check(library.bb_exact_ease(address(curve), address(at), at.size, address(y)))
    return y


PARAMETERS = ("centripetal", "uniform", "chord")  # in the order of bb_parameters
ENDS = ("natural", "clamped", "not-a-knot")  # in the order of bb_ends, of which BB_CLOSED follows


def interpolate(points: ArrayLike, parameters: str = "centripetal", ends: str = "natural", closed: bool = False, *,
                monotone: bool = False, start_derivative: ArrayLike | None = None,
                end_derivative: ArrayLike | None = None) -> Array:
    """The cubic Bezier segments, of shape (count, 4, dimension), of a spline through points, C2 in its parameter.

    Steps of the parameter are the square root of the distance of points ("centripetal"), 1 ("uniform") or the distance
    ("chord"). Ends have the second derivative 0 ("natural"), the given derivatives 3 (P1 - P0) of the first segment and
    3 (P3 - P2) of the last ("clamped"), or one cubic over two segments ("not-a-knot"). A closed spline has none; a last segment
    goes back to the first point. `monotone` makes each coordinate monotone between neighbouring points, and the spline C1 only.
    Raises Error where a point repeats the one before it, except at uniform parameters.
    """
    rows = point_rows(points)
    count, dimension = rows.shape
    for word, words in ((parameters, PARAMETERS), (ends, ENDS)):
        if word not in words:
            raise ValueError(f"no {word!r}; use {', '.join(words)}")
    if closed and ends != "natural":
        raise ValueError(f"a closed spline has no ends that could be {ends}")
    entry = SplineEntry(PARAMETERS.index(parameters), len(ENDS) if closed else ENDS.index(ends), monotone)
    derivatives = [None if given is None else array_of(given, np.float64).reshape(-1)
                   for given in (start_derivative, end_derivative)]
    for derivative in derivatives:
        if (derivative is not None) != (ends == "clamped"):
            raise ValueError("clamped ends, and no others, have start_derivative and end_derivative")
        if derivative is not None and derivative.size != dimension:
            raise ValueError(f"a derivative has {derivative.size} coordinates, the points {dimension}")
    entry.start_derivative, entry.end_derivative = (None if given is None else address(given) for given in derivatives)
    segments = np.empty((max(count - 1 + closed, 0), 4, dimension))
    check(library.bb_interpolate(ctypes.byref(entry), dimension, address(rows), count, address(segments)))
    return segments


def fit(points: ArrayLike, tolerance: float, method: str = "gauss_newton", *, closed: bool = False,
        start_direction: ArrayLike | None = None, end_direction: ArrayLike | None = None) -> Fit:
    """Cubic Bezier segments, one after the other, with no point farther than `tolerance` from them. Between the points they
    stay near the straight lines from one to the next. `closed` leads back to the first point; points whose last one equals
    the first are closed as well. The directions are vectors along the curve."""
    rows = point_rows(points)
    if closed and not np.array_equal(rows[0], rows[-1]):
        rows = np.vstack([rows, rows[:1]])
    count, dimension = rows.shape
    start, end = _direction(start_direction, dimension), _direction(end_direction, dimension)
    handle = ctypes.c_void_p()
    check(library.bb_fit_directed(method.encode(), dimension, address(rows), count, tolerance,
                                  None if start is None else address(start), None if end is None else address(end),
                                  ctypes.byref(handle)))
    try:
        error = ctypes.c_double()
        check(library.bb_fitted_exact_error(handle, ctypes.byref(error)))
        segments = library.bb_fitted_segments(handle)
        control = np.ctypeslib.as_array(library.bb_fitted_points(handle), (segments, 4, dimension)).copy()
        return Fit(control, library.bb_fitted_max_error(handle), error.value)
    finally:
        library.bb_fitted_free(handle)


def _direction(direction: ArrayLike | None, dimension: int) -> Array | None:
    if direction is None:
        return None
    values: Array = array_of(direction, np.float64)
    if values.shape != (dimension,) or not values.any():
        raise ValueError(f"the direction {direction} is not one of {dimension} coordinates, not all 0")
    return values
