# SPDX-License-Identifier: MIT
"""Points of curves by any method, the true ones, and errors and bounds; derivatives, points of a grid, chords, halves, and boxes."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import FORMS, Array, GivenCurve, address, array_of, form_of, is_float, parameters, point_rows, strided_array_of
from ._library import NOT_FINITE, Batch, HalfEntry, Strides, check, library

# The methods of derivatives and grids that are taken without a name: they take every degree and every t.
_DERIVATIVES = {"bernstein": "differences_de_casteljau", "power": "power_derivative"}
_GRIDS = {"bernstein": "pointwise_de_casteljau", "power": "pointwise_horner", "rational": "pointwise_de_casteljau"}


class Points(NamedTuple):
    """Control points, not premultiplied, and their weights, None for a curve without."""

    points: Array
    weights: Array | None


class Halves(NamedTuple):
    """The control points of both halves, not premultiplied, and their weights, None for a curve without."""

    left: Array
    right: Array
    left_weights: Array | None
    right_weights: Array | None


class Chords(NamedTuple):
    """The ends of chords: parameters of shape (count,) and points of shape (count, dimension)."""

    t: Array
    points: Array


class Box(NamedTuple):
    """The lowest and the highest coordinates of a box, one for each axis."""

    low: Array
    high: Array


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


def _require_double(points: ArrayLike, why: str) -> None:
    if is_float(points):
        raise ValueError(f"{why}; give float64")


def _name(method: str | None, form: str, defaults: dict[str, str] | None = None) -> bytes | None:
    """The method as the library takes it. For None the default of the form, or None where there are no defaults: the library
    then takes the recommended evaluator."""
    if method is None:
        if defaults is None:
            return None
        if form not in defaults:
            raise ValueError(f"nothing takes curves of the form {form!r} here")
        return defaults[form].encode()
    if not isinstance(method, str):
        raise TypeError(f"method is a {type(method).__name__}; give the id of a method, see methods()")
    if not method or "\0" in method:
        raise ValueError(f"no method {method!r}; see methods()")
    return method.encode()


def _answered(at: Array, out: Array, answer: Callable[[Array, Array], int]) -> Array:
    """`out`, which `answer(t, out)` fills, with NaN where t is NaN: the library refuses such a t, and all others with it."""
    status = answer(at, out)
    given = ~np.isnan(at) if status == NOT_FINITE else np.True_
    if given.all():
        check(status)
        return out
    some = np.empty_like(out[given])
    if some.size:
        check(answer(np.ascontiguousarray(at[given]), some))
    out[...] = np.nan
    out[given] = some
    return out


def _result(t: Array, dimension: int, dtype: type = np.float64) -> Array:
    return np.empty((*t.shape, dimension), dtype=dtype)


def evaluate(points: ArrayLike, t: ArrayLike, method: str | None = None, *, form: str = "bernstein",
             weights: ArrayLike | None = None) -> Array:
    """The points at `t` by a method; see `methods()`.

    `points` has a row for each control point, or for each coefficient in ascending order with form "power"; `weights` make
    it a rational curve, whose points are not premultiplied. A scalar t gives the shape (d,), m of them (m, d). An array of
    float32 is evaluated in float, in Bernstein form only. Raises Error for a method that does not exist or does not take the
    curve.

    `points` of shape (m, n + 1, d), with weights of shape (m, n + 1), are m curves: t of shape (m,) has one parameter for each
    and gives the shape (m, d); (1, k) has the same k for all, (m, k) k for each, and both give (m, k, d). Arrays of any
    strides are read where they are.

    Without a method it is the one that `recommended` names.
    """
    if np.ndim(points) == 3:
        return _evaluate_curves(points, t, method, form, weights)
    if is_float(points):
        name = _name(method, "bernstein")
        rows, at = _float_curve(points, t, form, weights)
        return _answered(at, _result(at, rows.shape[1], np.float32), lambda some, out: library.bb_evaluate_float(
            name, rows.shape[1], rows.shape[0] - 1, address(rows), address(some), some.size, address(out)))
    curve = GivenCurve(points, form, weights)
    name = _name(method, curve.form)
    at = parameters(t)
    return _answered(at, _result(at, curve.dimension), lambda some, out: library.bb_curve_evaluate(
        name, curve.pointer, address(some), some.size, address(out)))


def _evaluate_curves(points: ArrayLike, t: ArrayLike, method: str | None, form: str, weights: ArrayLike | None) -> Array:
    dtype: type = np.float32 if is_float(points) else np.float64
    if dtype is np.float32:
        _require_bernstein(form, weights)
    form = form_of(form, weights)
    curves = strided_array_of(points, dtype)
    at = strided_array_of(t, dtype)
    m, coefficients, dimension = curves.shape
    if coefficients > 1024 or dimension > 3:
        raise ValueError(f"points have the shape {curves.shape}; give at most 1024 points a curve, in at most 3 dimensions")
    if at.shape != (m,) and (at.ndim != 2 or at.shape[0] not in (1, m)):
        raise ValueError(f"t has the shape {at.shape} for {m} curves; give ({m},) for one each, (1, k) or ({m}, k) for k each")
    of_each = at[:, np.newaxis] if at.ndim == 1 else np.broadcast_to(at, (m, at.shape[1]))
    own = None if weights is None else array_of(weights, dtype)
    if own is not None and own.shape != (m, coefficients):
        raise ValueError(f"weights have the shape {own.shape}; give {(m, coefficients)}, one for each point")
    name = _name(method, form)
    out = np.empty((*of_each.shape, dimension), dtype)
    function = library.bb_evaluate_curves_float if dtype is np.float32 else library.bb_evaluate_curves

    def status(of_each: Array) -> int:
        strides = [Strides(*(step // out.itemsize for step in values.strides)) for values in (curves, of_each)]
        batch = Batch(FORMS[form], dimension, coefficients - 1, m, of_each.shape[1], *map(ctypes.pointer, strides))
        return function(name, ctypes.byref(batch), address(curves), None if own is None else address(own), address(of_each),
                        address(out))

    found = status(of_each)
    if found == NOT_FINITE and (missing := np.isnan(of_each)).any():
        found = status(np.where(missing, dtype(0.5), of_each))
        out[missing] = np.nan
    check(found)
    return out[:, 0] if at.ndim == 1 else out


def recommended(points: ArrayLike, *, form: str = "bernstein", weights: ArrayLike | None = None) -> str:
    """The id of the method that `evaluate` takes for this curve without one, the same as in C and C++: of the methods that need
    neither a conversion nor a fused operation and whose bound is proved, one that is about as fast as the fastest and has the
    smallest errors, by the project's bundle results/answers."""
    if is_float(points):
        rows, _ = _float_curve(points, 0, form, weights)
        return library.bb_recommended(FORMS[form], rows.shape[0] - 1, 1).decode()
    curve = GivenCurve(points, form, weights)
    return library.bb_recommended(FORMS[curve.form], len(curve.points) - 1, 0).decode()


def _require_bernstein(form: str, weights: ArrayLike | None) -> None:
    if form != "bernstein" or weights is not None:
        raise ValueError("float32 is for control points without weights; give float64")


def _float_curve(points: ArrayLike, t: ArrayLike, form: str, weights: ArrayLike | None) -> tuple[Array, Array]:
    _require_bernstein(form, weights)
    return point_rows(points, np.float32), parameters(t, np.float32)


def exact(points: ArrayLike, t: ArrayLike, *, form: str = "bernstein", weights: ArrayLike | None = None) -> Array:
    """The true points at `t`, each coordinate rounded once; shapes as of `evaluate` for one curve."""
    if is_float(points):
        rows, at = _float_curve(points, t, form, weights)
        return _answered(at, _result(at, rows.shape[1], np.float32), lambda some, out: library.bb_exact_float(
            rows.shape[1], rows.shape[0] - 1, address(rows), address(some), some.size, address(out)))
    curve = GivenCurve(points, form, weights)
    at = parameters(t)
    return _answered(at, _result(at, curve.dimension), lambda some, out: library.bb_curve_exact(
        curve.pointer, address(some), some.size, address(out)))


def exact_fractions(points: ArrayLike, t: float, *, form: str = "bernstein",
                    weights: ArrayLike | None = None) -> list[Fraction]:
    """The true point at a number t without any rounding, a fraction for each axis."""
    curve = GivenCurve(points, form, weights)
    at = parameters(t)
    if at.ndim:
        raise ValueError(f"t has the shape {at.shape}; give one number")
    result = []
    for axis in range(curve.dimension):
        required = ctypes.c_size_t(0)
        text = ctypes.create_string_buffer(1024)
        for _ in range(2):  # once more, if that was too small
            status = library.bb_curve_exact_text(curve.pointer, float(at), axis, text, len(text), ctypes.byref(required))
            if status == 0 or required.value <= len(text):
                break
            text = ctypes.create_string_buffer(required.value)
        check(status)
        result.append(_fraction(text.value.decode()))
    return result


def _fraction(text: str) -> Fraction:
    numerator, _, denominator = text.partition("/")
    return Fraction(_integer(numerator), _integer(denominator or "1"))


def _integer(text: str) -> int:
    """int(text), which refuses more digits than sys.get_int_max_str_digits(), 4300 unless somebody changed it."""
    digits, most, value = text.lstrip("-"), 512, 0
    for begin in range(0, len(digits), most):
        part = digits[begin:begin + most]
        value = value * 10**len(part) + int(part)
    return -value if text.startswith("-") else value


def error(points: ArrayLike, t: ArrayLike, values: ArrayLike, *, form: str = "bernstein",
          weights: ArrayLike | None = None) -> Errors:
    """The errors of `values`, from wherever they are: one point for each t, in the shape that `evaluate` returns for one curve.

    For points of float32 the units are those of float, u = 2^-24, and `exact` has the nearest float.
    """
    curve = GivenCurve(points, form, weights)
    at = parameters(t, np.float32).astype(np.float64) if is_float(points) else parameters(t)
    given = array_of(values, np.float64)
    if given.shape != (*at.shape, curve.dimension):
        raise ValueError(f"values have the shape {given.shape} instead of {(*at.shape, curve.dimension)}")
    judged = np.ascontiguousarray(given[~np.isnan(at)])  # lives until the library has read it
    out = _answered(at, np.empty((*given.shape, 4)), lambda some, out: library.bb_curve_error(
        curve.pointer, address(some), some.size, address(judged), address(out)))
    errors = Errors(*(out[..., k] for k in range(4)))
    return _in_float(errors, exact(points, at)) if is_float(points) else errors


def _in_float(errors: Errors, exact: Array) -> Errors:
    """Errors in units of double as errors in units of float."""
    with np.errstate(divide="ignore", invalid="ignore"):
        # The spacing of doubles at the true value itself; at the rounded one it may be twice that.
        exponent = np.rint(np.log2(errors.error / errors.error_ulp)) + 52
        ulp = np.ldexp(1.0, np.nan_to_num(np.maximum(exponent, -126)).astype(int) - 23)
        in_ulp = np.where(errors.error > 0, errors.error / ulp, errors.error)
    return Errors(exact, errors.error, in_ulp, errors.error_u * 2.0**-29)


def bound(points: ArrayLike, t: ArrayLike, method: str | None = None, *, form: str = "bernstein",
          weights: ArrayLike | None = None) -> Bounds:
    """The proved bounds of a method for its points at `t`; the default method is that of `evaluate`.

    For points of float32 the bounds are those of `evaluate` in float, with u = 2^-24. Raises Error for a method that has no
    proved bound.
    """
    if is_float(points):
        rows, some = _float_curve(points, t, form, weights)
        name = _name(method, form)
        out = _answered(some, np.empty((*some.shape, rows.shape[1], 2)), lambda at, out: library.bb_bound_float(
            name, rows.shape[1], rows.shape[0] - 1, address(rows), address(at), at.size, address(out)))
        return Bounds(out[..., 0], out[..., 1])
    curve = GivenCurve(points, form, weights)
    at = parameters(t)
    name = _name(method, curve.form)
    out = _answered(at, np.empty((*at.shape, curve.dimension, 2)), lambda some, out: library.bb_curve_bound(
        name, curve.pointer, address(some), some.size, address(out)))
    return Bounds(out[..., 0], out[..., 1])


def derivative(points: ArrayLike, t: ArrayLike, order: int = 1, method: str | None = None, *, form: str = "bernstein") -> Array:
    """The derivative of an order >= 0 in t at `t`, in the shape that `evaluate` returns for one curve; `form` is "bernstein" or "power"."""
    _require_double(points, "derivatives are computed in double")
    curve = GivenCurve(points, form)
    name = _name(method, curve.form, _DERIVATIVES)
    at = parameters(t)
    return _answered(at, _result(at, curve.dimension), lambda some, out: library.bb_derivative(
        name, curve.pointer, order, address(some), some.size, address(out)))


def grid(points: ArrayLike, count: int, method: str | None = None, *, form: str = "bernstein",
         weights: ArrayLike | None = None) -> Array:
    """The points at t = k / (count - 1), of shape (count, dimension); `count` is a power of two and one, up to 524289."""
    _require_double(points, "grids are computed in double")
    curve = GivenCurve(points, form, weights)
    steps = count - 1
    if not 1 <= steps <= 524288 or steps & (steps - 1):
        raise ValueError(f"count is {count}; give a power of two and one, 2 to 524289")
    out = np.empty((count, curve.dimension))
    check(library.bb_grid(_name(method, curve.form, _GRIDS), curve.pointer, steps, address(out)))
    return out


def flatten(points: ArrayLike, tolerance: float, method: str | None = None, *, weights: ArrayLike | None = None) -> Chords:
    """The curve as chords, none farther than `tolerance` > 0, in coordinate units, from its piece of the curve. Without a method
    that is `equal_errors` up to degree 3, `halving_distance` above and with weights. Raises ValueError where the method says that
    it did not keep the tolerance."""
    _require_double(points, "curves are flattened in double")
    curve = GivenCurve(points, weights=weights)
    fewest = "equal_errors" if weights is None and len(curve.points) <= 4 else "halving_distance"
    name = _name(method or fewest, curve.form)
    ends, complete = ctypes.c_size_t(), ctypes.c_int()
    check(library.bb_flatten(name, curve.pointer, tolerance, None, None, 0, ctypes.byref(ends), ctypes.byref(complete)))
    if not complete.value:
        raise ValueError(f"the tolerance {tolerance} is too fine for the coordinates; give a larger one")
    chords = Chords(np.empty(ends.value), np.empty((ends.value, curve.dimension)))
    check(library.bb_flatten(name, curve.pointer, tolerance, address(chords.t), address(chords.points), ends.value,
                             ctypes.byref(ends), ctypes.byref(complete)))
    return chords


def split(points: ArrayLike, t: float, method: str = "de_casteljau_split", *, weights: ArrayLike | None = None) -> Halves:
    """Both halves of a curve that is split at t, which are curves of its degree: the left one ends where the right begins."""
    _require_double(points, "curves are split in double")
    curve = GivenCurve(points, weights=weights)
    halves = [(np.empty(curve.points.shape), None if curve.weights is None else np.empty(len(curve.points))) for _ in range(2)]
    entries = [HalfEntry(address(half), None if own is None else address(own)) for half, own in halves]
    check(library.bb_split(_name(method, "bernstein"), curve.pointer, t, ctypes.byref(entries[0]), ctypes.byref(entries[1])))
    (left, left_weights), (right, right_weights) = halves
    return Halves(left, right, left_weights, right_weights)


def part(points: ArrayLike, start: float, stop: float, *, weights: ArrayLike | None = None) -> Points:
    """The control points of a curve over t in [start, stop], each coordinate the true one rounded once. The parameters may lie outside
    [0,1], and from 1 to 0 is the reversed curve. Parts that meet share their end to the bit. The time is cubic in the degree."""
    _require_double(points, "parts of curves are computed in double")
    curve = GivenCurve(points, weights=weights)
    return _control_points(curve, len(curve.points), lambda out: library.bb_part(curve.pointer, start, stop, out))


LARGEST_DEGREE = 1023  # that of the library


def elevate(points: ArrayLike, degree: int, *, weights: ArrayLike | None = None) -> Points:
    """The control points of a curve in a degree at least its own, each coordinate the true one rounded once."""
    _require_double(points, "degrees are elevated in double")
    curve = GivenCurve(points, weights=weights)
    own = len(curve.points) - 1
    if not own <= degree <= LARGEST_DEGREE:
        raise ValueError(f"degree {degree}: must be from {own}, that of the curve, to {LARGEST_DEGREE}")
    return _control_points(curve, degree + 1, lambda out: library.bb_elevate(curve.pointer, degree, out))


def _control_points(curve: GivenCurve, count: int, call: Callable[[Any], int]) -> Points:
    found = Points(np.empty((max(count, 0), curve.dimension)), None if curve.weights is None else np.empty(max(count, 0)))
    check(call(ctypes.byref(HalfEntry(address(found.points), None if found.weights is None else address(found.weights)))))
    return found


def box(points: ArrayLike, method: str = "exact_box", *, weights: ArrayLike | None = None) -> Box:
    """A box of a curve over t in [0, 1]. `exact_box` and `split_box` leave no point of the curve outside; `exact_box` is the
    tightest box of doubles or at most one double larger on each side. Weights of both signs give an infinite box."""
    _require_double(points, "boxes are computed in double")
    curve = GivenCurve(points, weights=weights)
    sides = np.empty((curve.dimension, 2))
    check(library.bb_box(_name(method, "bernstein"), curve.pointer, address(sides)))
    return Box(sides[:, 0].copy(), sides[:, 1].copy())


class _PreparedOwner:
    """What bb_prepare made, freed with the last Prepared that shares it."""

    def __init__(self, method: bytes, curve: GivenCurve) -> None:
        self.handle = ctypes.c_void_p()
        check(library.bb_prepare(method, curve.pointer, ctypes.byref(self.handle)))

    def __del__(self, free: Any = library.bb_prepared_free) -> None:
        if self.handle:
            free(self.handle)


class Prepared:
    """A curve as a method prepared it, for many calls: `Prepared(points, method)(t)` is `evaluate(points, t, method)`.

    In double only: raises ValueError for float32. A copy by `copy.copy` shares the prepared curve.
    """

    def __init__(self, points: ArrayLike, method: str | None = None, *, form: str = "bernstein",
                 weights: ArrayLike | None = None) -> None:
        _require_double(points, "curves are prepared in double")
        curve = GivenCurve(points, form, weights)
        self.dimension = curve.dimension
        self.method = recommended(points, form=form, weights=weights) if method is None else method
        self._owner = _PreparedOwner(_name(self.method, curve.form), curve)

    def __call__(self, t: ArrayLike) -> Array:
        at = parameters(t)
        return _answered(at, _result(at, self.dimension), lambda some, out: library.bb_prepared_evaluate(
            self._owner.handle, address(some), some.size, address(out)))
