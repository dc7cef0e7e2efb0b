# SPDX-License-Identifier: MIT
"""Figures: functions `name(bundle)`, in a file for each way of drawing. Text in figures is English."""


def drawn(name, *given):
    """The figure of that name. Matplotlib is imported here, since --summary does without."""
    from . import canvas, conversion, costs, curve_sets, curves, marks, printed, real_curves, study  # noqa: F401

    return canvas.FIGURES[name](*given)
