# SPDX-License-Identifier: MIT
"""Arrays of the caller as the library takes them."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._library import Curve

FORMS = {"bernstein": 0, "power": 1, "rational": 2}
FORM_NAMES = {number: name for name, number in FORMS.items()}
Array = NDArray[Any]


def array_of(values: ArrayLike, dtype: type) -> Array:
    """`values` as numbers of `dtype`, bit for bit. Raises ValueError for what would be rounded, or lose a part, on the way: an
    integer or a fraction that no double is, an imaginary part, a mask, a date, a text."""
    given: Any = np.ma.asanyarray(values) if isinstance(values, np.ma.MaskedArray) else np.asarray(values)
    if np.ma.is_masked(given):
        raise ValueError("an array has masked values; leave them out")
    if given.dtype.kind not in "fiubO":
        raise ValueError(f"an array of {given.dtype} is given; give real numbers")
    try:
        with np.errstate(over="ignore"):
            result: Array = np.ascontiguousarray(given, dtype=dtype).reshape(given.shape)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"values are not real numbers that {np.dtype(dtype)} can hold") from None
    # Python compares numbers of any type exactly. A double for a float is rounded as NumPy does with numbers of Python.
    small = given.dtype.kind in "bfiu" and given.dtype.itemsize <= 8 and (given.dtype.kind == "f" or np.all(np.abs(result) <= 2**24))
    for before, after in () if small else zip(given.ravel().tolist(), result.ravel().tolist()):
        if before == before and before != after:
            raise ValueError(f"{before} is not a {np.dtype(dtype)}; round it first")
    return result


def strided_array_of(values: ArrayLike, dtype: type) -> Array:
    """The same, but an array of `dtype` is taken as it is, whatever its strides are."""
    if type(values) is np.ndarray and values.dtype == dtype and values.flags.aligned:
        if not any(stride % values.itemsize for stride in values.strides):
            return values
    return array_of(values, dtype)


def is_float(points: ArrayLike) -> bool:
    """Whether `points` is an array of float32, of either byte order."""
    dtype = getattr(points, "dtype", None)
    return dtype is not None and dtype.newbyteorder("=") == np.float32


def point_rows(points: ArrayLike, dtype: type = np.float64) -> Array:
    """Points as an array of shape (count, dimension); a flat sequence is a curve of dimension 1."""
    rows = array_of(points, dtype)
    if rows.ndim == 1:
        rows = rows.reshape(-1, 1)
    if rows.ndim != 2 or rows.size == 0:
        raise ValueError(f"points have the shape {rows.shape}; give one row for each point: (count, dimension)")
    return rows


def parameters(t: ArrayLike, dtype: type = np.float64) -> Array:
    """Parameters as an array, of which a scalar has no dimension and others have one."""
    values = array_of(t, dtype)
    if values.ndim > 1:
        raise ValueError(f"t has the shape {values.shape}; give a number or a flat sequence")
    return values


def address(values: Array) -> int:
    return int(values.ctypes.data)


def form_of(form: str, weights: ArrayLike | None) -> str:
    """The form of curves for which the caller names this one. Raises ValueError where it does not fit the weights."""
    if weights is not None:
        if form not in ("bernstein", "rational"):
            raise ValueError(f"weights belong to control points, not to the form {form!r}")
        return "rational"
    if form == "rational":
        raise ValueError("a rational curve needs weights")
    if not isinstance(form, str) or form not in FORMS:
        raise ValueError(f"no form {form!r}; use {', '.join(FORMS)}")
    return form


class GivenCurve:
    """A curve for the library, with the arrays that it points to."""

    def __init__(self, points: ArrayLike, form: str = "bernstein", weights: ArrayLike | None = None) -> None:
        self.points = point_rows(points)
        count, self.dimension = self.points.shape
        self.form = form_of(form, weights)
        self.weights = None if weights is None else array_of(weights, np.float64)
        if self.weights is not None and self.weights.shape != (count,):
            raise ValueError(f"weights have the shape {self.weights.shape}; give one for each of the {count} points")
        self.entry = Curve(FORMS[self.form], self.dimension, count - 1, address(self.points),
                           None if self.weights is None else address(self.weights))

    @property
    def pointer(self) -> Any:
        return ctypes.byref(self.entry)
