# SPDX-License-Identifier: MIT
"""Figures: a function `name(bundle)` each, in a file for each way of drawing. Text in figures is English."""


def drawn(name, *given):
    """The figure of that name. Matplotlib is imported here, since --summary does without."""
    from . import by_degree, canvas, choosing, conversion, curves, marks, printed, study  # noqa: F401

    return canvas.FIGURES[name](*given)
