# SPDX-License-Identifier: MIT
"""libbezierbench.so through ctypes: where it is, and its functions with their types."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from ctypes import POINTER, c_char_p, c_double, c_int, c_int64, c_size_t, c_ssize_t, c_uint, c_void_p
from pathlib import Path

SONAME = "libbezierbench.so.1"


class Error(ValueError):
    """What the library refuses; `status` is the bb_status of bezierbench.h."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status


class Curve(ctypes.Structure):
    _fields_ = [("form", c_int), ("dimension", c_int), ("degree", c_int), ("points", c_void_p), ("weights", c_void_p)]


class Strides(ctypes.Structure):
    _fields_ = [("curve", c_ssize_t), ("point", c_ssize_t), ("axis", c_ssize_t)]


class Batch(ctypes.Structure):
    _fields_ = [("form", c_int), ("dimension", c_int), ("degree", c_int), ("curves", c_size_t), ("count", c_size_t),
                ("points", POINTER(Strides)), ("t", POINTER(Strides)), ("out", POINTER(Strides))]


class MethodEntry(ctypes.Structure):
    _fields_ = [("id", c_char_p), ("label", c_char_p), ("problem", c_char_p), ("bound", c_char_p), ("flops", c_char_p),
                ("citation", c_char_p), ("form", c_int), ("min_degree", c_int), ("max_degree", c_int),
                ("max_degree_float", c_int), ("unit_interval_only", c_int), ("bit_stable", c_int)]


class LengthEntry(ctypes.Structure):
    _fields_ = [("length", c_double), ("error_estimate", c_double), ("evaluations", c_int64), ("converged", c_int)]


class FootEntry(ctypes.Structure):
    _fields_ = [("t", c_double), ("distance", c_double), ("candidates", c_int), ("converged", c_int)]


class ParameterEntry(ctypes.Structure):
    _fields_ = [("t", c_double), ("error_estimate", c_double), ("iterations", c_int64), ("converged", c_int)]


class HalfEntry(ctypes.Structure):
    _fields_ = [("points", c_void_p), ("weights", c_void_p)]


class SplineEntry(ctypes.Structure):
    _fields_ = [("parameters", c_int), ("ends", c_int), ("monotone", c_int), ("start_derivative", c_void_p),
                ("end_derivative", c_void_p)]


class BsplineEntry(ctypes.Structure):
    _fields_ = [("dimension", c_int), ("degree", c_int), ("count", c_size_t), ("points", c_void_p), ("weights", c_void_p),
                ("knots", c_void_p)]


_ARRAY = c_void_p  # doubles or floats of NumPy
_CURVE = POINTER(Curve)
_DOUBLE = POINTER(c_double)
_BSPLINE = POINTER(BsplineEntry)
_SIGNATURES: dict[str, tuple[type | None, list[type]]] = {
    "bb_version": (c_uint, []),
    "bb_strerror": (c_char_p, [c_int]),
    "bb_stop_when": (None, [c_void_p]),
    "bb_method_count": (c_size_t, []),
    "bb_method_at": (c_int, [c_size_t, POINTER(MethodEntry)]),
    "bb_recommended": (c_char_p, [c_int, c_int, c_int]),
    "bb_evaluate_float": (c_int, [c_char_p, c_int, c_int, _ARRAY, _ARRAY, c_size_t, _ARRAY]),
    "bb_evaluate_curves": (c_int, [c_char_p, POINTER(Batch), _ARRAY, _ARRAY, _ARRAY, _ARRAY]),
    "bb_evaluate_curves_float": (c_int, [c_char_p, POINTER(Batch), _ARRAY, _ARRAY, _ARRAY, _ARRAY]),
    "bb_exact_float": (c_int, [c_int, c_int, _ARRAY, _ARRAY, c_size_t, _ARRAY]),
    "bb_curve_evaluate": (c_int, [c_char_p, _CURVE, _ARRAY, c_size_t, _ARRAY]),
    "bb_curve_exact": (c_int, [_CURVE, _ARRAY, c_size_t, _ARRAY]),
    "bb_prepare": (c_int, [c_char_p, _CURVE, POINTER(c_void_p)]),
    "bb_prepared_evaluate": (c_int, [c_void_p, _ARRAY, c_size_t, _ARRAY]),
    "bb_prepared_free": (None, [c_void_p]),
    "bb_curve_exact_text": (c_int, [_CURVE, c_double, c_int, c_char_p, c_size_t, POINTER(c_size_t)]),
    "bb_curve_error": (c_int, [_CURVE, _ARRAY, c_size_t, _ARRAY, _ARRAY]),
    "bb_curve_bound": (c_int, [c_char_p, _CURVE, _ARRAY, c_size_t, _ARRAY]),
    "bb_bound_float": (c_int, [c_char_p, c_int, c_int, _ARRAY, _ARRAY, c_size_t, _ARRAY]),
    "bb_derivative": (c_int, [c_char_p, _CURVE, c_int, _ARRAY, c_size_t, _ARRAY]),
    "bb_grid": (c_int, [c_char_p, _CURVE, c_int, _ARRAY]),
    "bb_box": (c_int, [c_char_p, _CURVE, _ARRAY]),
    "bb_roots": (c_int, [_CURVE, c_int, c_int, c_double, _ARRAY, _ARRAY, c_size_t, POINTER(c_size_t)]),
    "bb_flatten": (c_int, [c_char_p, _CURVE, c_double, _ARRAY, _ARRAY, c_size_t, POINTER(c_size_t), POINTER(c_int)]),
    "bb_split": (c_int, [c_char_p, _CURVE, c_double, POINTER(HalfEntry), POINTER(HalfEntry)]),
    "bb_part": (c_int, [_CURVE, c_double, c_double, POINTER(HalfEntry)]),
    "bb_elevate": (c_int, [_CURVE, c_int, POINTER(HalfEntry)]),
    "bb_at_length": (c_int, [c_char_p, _CURVE, c_double, c_double, POINTER(ParameterEntry)]),
    "bb_arc_length": (c_int, [c_char_p, _CURVE, c_double, c_double, c_double, POINTER(LengthEntry)]),
    "bb_exact_arc_length": (c_int, [_CURVE, c_double, c_double, _DOUBLE]),
    "bb_arc_length_error": (c_int, [_CURVE, c_double, c_double, c_double, _DOUBLE]),
    "bb_project": (c_int, [c_char_p, _CURVE, _ARRAY, POINTER(FootEntry)]),
    "bb_exact_project": (c_int, [_CURVE, _ARRAY, _DOUBLE, _DOUBLE]),
    "bb_project_error": (c_int, [_CURVE, _ARRAY, c_double, c_double, _DOUBLE]),
    "bb_ease": (c_int, [c_char_p, _ARRAY, _ARRAY, c_size_t, _ARRAY]),
    "bb_ease_float": (c_int, [c_char_p, _ARRAY, _ARRAY, c_size_t, _ARRAY]),
    "bb_exact_ease": (c_int, [_ARRAY, _ARRAY, c_size_t, _ARRAY]),
    "bb_interpolate": (c_int, [POINTER(SplineEntry), c_int, _ARRAY, c_size_t, _ARRAY]),
    "bb_fit_directed": (c_int, [c_char_p, c_int, _ARRAY, c_size_t, c_double, _ARRAY, _ARRAY, POINTER(c_void_p)]),
    "bb_fitted_segments": (c_size_t, [c_void_p]),
    "bb_fitted_points": (_DOUBLE, [c_void_p]),
    "bb_fitted_max_error": (c_double, [c_void_p]),
    "bb_fitted_exact_error": (c_int, [c_void_p, _DOUBLE]),
    "bb_fitted_free": (None, [c_void_p]),
    "bb_bspline_evaluate": (c_int, [c_char_p, _BSPLINE, _ARRAY, c_size_t, _ARRAY]),
    "bb_bspline_exact": (c_int, [_BSPLINE, _ARRAY, c_size_t, _ARRAY]),
    "bb_bspline_spans": (c_int, [_BSPLINE, POINTER(c_void_p)]),
    "bb_bspline_insert": (c_int, [_BSPLINE, _ARRAY, c_size_t, POINTER(c_void_p)]),
    "bb_bspline_remove": (c_int, [_BSPLINE, _ARRAY, c_size_t, POINTER(c_void_p), _DOUBLE]),
    "bb_bspline_elevate": (c_int, [_BSPLINE, c_int, POINTER(c_void_p)]),
    "bb_bspline_part": (c_int, [_BSPLINE, c_double, c_double, POINTER(c_void_p)]),
    "bb_bspline_derivative": (c_int, [_BSPLINE, c_int, POINTER(c_void_p)]),
    "bb_bspline_get": (c_int, [c_void_p, _BSPLINE]),
    "bb_bspline_free": (None, [c_void_p]),
    "bb_curves_read": (c_int, [c_char_p, c_char_p, c_size_t, POINTER(c_void_p)]),
    "bb_curves_count": (c_size_t, [c_void_p]),
    "bb_curves_at": (c_int, [c_void_p, c_size_t, _CURVE]),
    "bb_curves_begins_path": (c_int, [c_void_p, c_size_t, POINTER(c_int)]),
    "bb_curves_id": (c_int, [c_void_p, c_size_t, c_char_p, c_size_t, POINTER(c_size_t)]),
    "bb_curves_free": (None, [c_void_p]),
}


def _candidates() -> list[str]:
    """Where the library may be, the likeliest first: named by the environment, inside of this package (a wheel),
    installed beside it, built in this source tree, or known to the system."""
    named = os.environ.get("BEZIERBENCH_LIBRARY")
    if named:
        return [named]
    package = Path(__file__).resolve().parent
    places = [package, package.parents[2]]  # lib/python3/dist-packages/bezierbench
    if (package.parents[2] / "CMakePresets.json").exists():  # bindings/python/bezierbench
        builds = package.parents[2] / "build"
        places = [builds / "release/lib", *sorted(builds.glob("*/lib"))]
    return [str(place / SONAME) for place in places if (place / SONAME).exists()] + [SONAME]


def _load() -> ctypes.CDLL:
    tried = []
    for candidate in _candidates():
        try:
            library = ctypes.CDLL(candidate)
        except OSError as error:
            tried.append(f"{candidate}: {error}")
            continue
        for name, (result, arguments) in _SIGNATURES.items():
            function = getattr(library, name)
            function.restype, function.argtypes = result, arguments
        return library
    raise ImportError("libbezierbench is not found; name it in the environment variable BEZIERBENCH_LIBRARY. Tried "
                      + "; ".join(tried))


library = _load()
NOT_FINITE = 6
NO_POINT = 9


def interruptible(call: Callable[[], int]) -> int:
    """The status of a call that may take minutes. Python runs the handlers of signals, for instance of Ctrl-C, on the
    main thread only, so another thread computes; an exception of a handler stops it."""
    stop = c_int(0)
    with ThreadPoolExecutor(1, initializer=library.bb_stop_when, initargs=(ctypes.byref(stop),)) as threads:
        status = threads.submit(call)
        try:
            return status.result()
        except BaseException:
            stop.value = 1
            raise


def check(status: int) -> None:
    """Raises what a status of the library means; nothing for success."""
    if status == 0:
        return
    message = library.bb_strerror(status).decode()
    if status == 14:
        raise MemoryError(message)
    raise Error(status, message)
