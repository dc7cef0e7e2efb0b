# SPDX-License-Identifier: MIT
"""Which method for inverse arc lengths is the fastest."""

from .fastest_right import SUITE, fastest_right

__all__ = ["SUITE", "find"]


def find(bundle):
    """Holds where Halley's method takes less time than every other right method."""
    return fastest_right(bundle, "inverse_arc_length_time", "companion_speed-at_length", "halley",
                         "Parameters at a length of cubics")
