# SPDX-License-Identifier: MIT
"""Points of curves by any method, the true ones, and errors and bounds."""

from __future__ import annotations

import ctypes
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Array, GivenCurve, address, parameters, point_rows
from ._library import check, library

# For every degree, and t inside or outside of [0,1]; evaluate() says why.
_DEFAULTS = {"bernstein": "de_casteljau", "power": "horner", "rational": "de_casteljau"}


class Errors(NamedTuple):
    """Errors coordinate by coordinate; infinite where the value is not finite."""

    exact: Array  # the true values, each rounded once
    error: Array  # |value - true value|, rounded once
    error_ulp: Array  # over the spacing of doubles at the true value
    error_u: Array  # over u p~, with u = 2^-53 and p~ = sum |b_i B_i(t)| on the axis; 0 for no error


class Bounds(NamedTuple):
    """Proved bounds coordinate by coordinate; infinite where nothing is proved."""

    bound: Array  # in coordinate units
    bound_u: Array  # over u p~


def _is_float(points: ArrayLike) -> bool:
    return getattr(points, "dtype", None) == np.float32


def _require_double(points: ArrayLike, why: str) -> None:
    if _is_float(points):
        raise ValueError(f"{why}; give float64")


def _result(t: Array, dimension: int, dtype: type = np.float64) -> Array:
    return np.empty((*t.shape, dimension), dtype=dtype)


def evaluate(points: ArrayLike, t: ArrayLike, method: str | None = None, *, form: str = "bernstein",
             weights: ArrayLike | None = None) -> Array:
    """The points at `t` by a method; see `methods()`.

    `points` has a row for each control point, or for each coefficient in ascending order with form "power"; `weights` make
    it a rational curve, whose points are not premultiplied. A scalar t gives the shape (d,), m of them (m, d). An array of
    float32 is evaluated in float, in Bernstein form only. Raises Error for a method that does not exist or does not take the
    curve.

    Without a method it is de_casteljau for control points, with weights or without, and horner for power form. They take
    every degree, no binomial coefficient enters that could overflow, and their bounds hold for every finite t (with weights
    for t in [0, 1]). The price is time, which grows with the square of the degree for de_casteljau. For many points at a high
    degree give method="horner_bernstein", whose time grows with the degree, as the C++ function evaluate() chooses for up to
    degree 512; bound() says whether its bound is enough. Errors and times are in results/answers of the project: studies
    answers-bezier, -outside, -rational, -power and answers-bezier-time.
    """
    if _is_float(points):
        return _evaluate_float(points, t, method or _DEFAULTS["bernstein"], form, weights)
    curve = GivenCurve(points, form, weights)
    at = parameters(t)
    out = _result(at, curve.dimension)
    name = (method or _DEFAULTS[curve.form]).encode()
    check(library.bb_curve_evaluate(name, curve.pointer, address(at), at.size, address(out)))
    return out


def _evaluate_float(points: ArrayLike, t: ArrayLike, method: str, form: str, weights: ArrayLike | None) -> Array:
    rows, at = _float_curve(points, t, form, weights)
    out = _result(at, rows.shape[1], np.float32)
    check(library.bb_evaluate_float(method.encode(), rows.shape[1], rows.shape[0] - 1, address(rows), address(at), at.size,
                                    address(out)))
    return out


def _float_curve(points: ArrayLike, t: ArrayLike, form: str, weights: ArrayLike | None) -> tuple[Array, Array]:
    if form != "bernstein" or weights is not None:
        raise ValueError("float32 is for control points without weights; give float64")
    return point_rows(points, np.float32), parameters(t, np.float32)


def exact(points: ArrayLike, t: ArrayLike, *, form: str = "bernstein", weights: ArrayLike | None = None) -> Array:
    """The true points at `t`, each coordinate rounded once; shapes as of `evaluate`."""
    if _is_float(points):
        rows, at = _float_curve(points, t, form, weights)
        out = _result(at, rows.shape[1], np.float32)
        check(library.bb_exact_float(rows.shape[1], rows.shape[0] - 1, address(rows), address(at), at.size, address(out)))
        return out
    curve = GivenCurve(points, form, weights)
    at = parameters(t)
    out = _result(at, curve.dimension)
    check(library.bb_curve_exact(curve.pointer, address(at), at.size, address(out)))
    return out


def exact_fractions(points: ArrayLike, t: float, *, form: str = "bernstein",
                    weights: ArrayLike | None = None) -> list[Fraction]:
    """The true point at a number t without any rounding, a fraction for each axis."""
    curve = GivenCurve(points, form, weights)
    result = []
    for axis in range(curve.dimension):
        needed = ctypes.c_size_t(0)
        text = ctypes.create_string_buffer(1024)
        for _ in range(2):  # once more, if that was too small
            status = library.bb_curve_exact_text(curve.pointer, t, axis, text, len(text), ctypes.byref(needed))
            if status == 0 or needed.value <= len(text):
                break
            text = ctypes.create_string_buffer(needed.value)
        check(status)
        result.append(_fraction(text.value.decode()))
    return result


def _fraction(text: str) -> Fraction:
    numerator, _, denominator = text.partition("/")
    return Fraction(int(numerator), int(denominator or 1))


def error(points: ArrayLike, t: ArrayLike, values: ArrayLike, *, form: str = "bernstein",
          weights: ArrayLike | None = None) -> Errors:
    """The errors of `values`, from wherever they are: one point for each t, in the shape that `evaluate` returns."""
    curve = GivenCurve(points, form, weights)
    at = parameters(t)
    given = np.ascontiguousarray(values, dtype=np.float64)
    if given.shape != (*at.shape, curve.dimension):
        raise ValueError(f"values have the shape {given.shape} instead of {(*at.shape, curve.dimension)}")
    out = np.empty((*given.shape, 4))
    check(library.bb_curve_error(curve.pointer, address(at), at.size, address(given), address(out)))
    return Errors(*(out[..., k] for k in range(4)))


def bound(points: ArrayLike, t: ArrayLike, method: str | None = None, *, form: str = "bernstein",
          weights: ArrayLike | None = None) -> Bounds:
    """The proved bounds of a method for its points at `t`; the default method is that of `evaluate`.

    Raises Error for a method that has no proved bound, and ValueError for float32, which `evaluate` computes in float.
    """
    _require_double(points, "bounds are those of methods in double")
    curve = GivenCurve(points, form, weights)
    at = parameters(t)
    out = np.empty((*at.shape, curve.dimension, 2))
    name = (method or _DEFAULTS[curve.form]).encode()
    check(library.bb_curve_bound(name, curve.pointer, address(at), at.size, address(out)))
    return Bounds(out[..., 0], out[..., 1])


class Prepared:
    """A curve as a method prepared it, for many calls: `Prepared(points, method)(t)` is `evaluate(points, t, method)`.

    In double only: raises ValueError for float32.
    """

    def __init__(self, points: ArrayLike, method: str | None = None, *, form: str = "bernstein",
                 weights: ArrayLike | None = None) -> None:
        _require_double(points, "curves are prepared in double")
        curve = GivenCurve(points, form, weights)
        self._handle = ctypes.c_void_p()
        self.dimension = curve.dimension
        self.method = method or _DEFAULTS[curve.form]
        check(library.bb_prepare(self.method.encode(), curve.pointer, ctypes.byref(self._handle)))

    def __call__(self, t: ArrayLike) -> Array:
        at = parameters(t)
        out = _result(at, self.dimension)
        check(library.bb_prepared_evaluate(self._handle, address(at), at.size, address(out)))
        return out

    def __del__(self, free: Any = library.bb_prepared_free) -> None:
        handle = getattr(self, "_handle", None)
        if handle:
            free(handle)
