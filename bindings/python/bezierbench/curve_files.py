# SPDX-License-Identifier: MIT
"""Files of curves: CSV, SVG, path data, JSON, fonts."""

from __future__ import annotations

import ctypes
import os
from typing import NamedTuple

import numpy as np

from ._arrays import FORM_NAMES, Array
from ._library import Curve, Error, check, library

_LONGEST_MESSAGE = 4096
_FILE = 19  # BB_ERROR_FILE


class FileCurve(NamedTuple):
    id: str
    form: str  # "bernstein", "power" or "rational"
    points: Array  # of shape (degree + 1, dimension)
    weights: Array | None  # of a rational curve
    begins_path: bool  # False where it starts at the end of the curve before it, as a segment of the same path


def copied(address: int, count: int) -> Array:
    return np.array((ctypes.c_double * count).from_address(address), dtype=np.float64)


def _curve(handle: ctypes.c_void_p, index: int) -> FileCurve:
    entry, begins, size = Curve(), ctypes.c_int(), ctypes.c_size_t()
    check(library.bb_curves_at(handle, index, ctypes.byref(entry)))
    check(library.bb_curves_begins_path(handle, index, ctypes.byref(begins)))
    library.bb_curves_id(handle, index, None, 0, ctypes.byref(size))
    name = ctypes.create_string_buffer(size.value)
    check(library.bb_curves_id(handle, index, name, size, None))
    count = entry.degree + 1
    return FileCurve(name.value.decode(), FORM_NAMES[entry.form], copied(entry.points, count * entry.dimension).reshape(count, -1),
                     copied(entry.weights, count) if entry.weights else None, bool(begins.value))


def taken(handle: ctypes.c_void_p) -> list[FileCurve]:
    """The curves of a bb_curves, which is freed."""
    try:
        return [_curve(handle, index) for index in range(library.bb_curves_count(handle))]
    finally:
        library.bb_curves_free(handle)


def curves(file: str | os.PathLike[str]) -> list[FileCurve]:
    """The curves of a file: CSV, SVG, SVG path data, JSON or a font, by its extension or else by what is in it. Lines are curves of
    degree 1, arcs rational ones of degree 2. Raises Error with one line about a file that cannot be read."""
    handle = ctypes.c_void_p()
    message = ctypes.create_string_buffer(_LONGEST_MESSAGE)
    status = library.bb_curves_read(os.fsencode(file), message, len(message), ctypes.byref(handle))
    if status == _FILE:
        raise Error(status, message.value.decode(errors="replace"))
    check(status)
    return taken(handle)
