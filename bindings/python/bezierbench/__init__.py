# SPDX-License-Identifier: MIT
"""bezierbench in Python: Bezier evaluators by name, the exact reference, errors and bounds, and readers of bundles.

>>> import bezierbench
>>> bezierbench.evaluate([[0, 0], [1, 2], [3, 0]], 0.5)
array([1.25, 1.  ])

It calls libbezierbench.so, whose header bezierbench.h says what each function promises. Functions may be called by several
threads at once; the library runs without the interpreter's lock.
"""

from ._library import Error
from .bspline import Bspline
from .bundles import Bundle, numbers, read
from .curve_files import FileCurve, curves
from .files import BundleError
from .listing import Method, methods, version
from .points import (
    Bounds,
    Box,
    Chords,
    Errors,
    Halves,
    Points,
    Prepared,
    bound,
    box,
    derivative,
    elevate,
    error,
    evaluate,
    exact,
    exact_fractions,
    flatten,
    grid,
    part,
    recommended,
    split,
)
from .problems import (
    ExactFoot,
    Fit,
    Foot,
    Length,
    Parameter,
    Root,
    arc_length,
    arc_length_error,
    at_length,
    ease,
    exact_arc_length,
    exact_ease,
    exact_project,
    fit,
    interpolate,
    project,
    project_error,
    roots,
)

__version__ = version()
__all__ = ["Bounds", "Box", "Bspline", "Bundle", "BundleError", "Chords", "Error", "Errors", "ExactFoot", "FileCurve", "Fit", "Foot", "Halves",
           "Length", "Method", "Parameter", "Points", "Prepared", "Root", "arc_length", "arc_length_error", "at_length", "bound", "box", "curves",
           "derivative", "ease", "elevate", "error", "evaluate", "exact", "exact_arc_length", "exact_ease", "exact_fractions", "exact_project", "fit",
           "flatten", "grid", "interpolate", "methods", "numbers", "part", "project", "project_error", "read", "recommended", "roots", "split", "version"]
