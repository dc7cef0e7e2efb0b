# SPDX-License-Identifier: MIT
"""Which method for inverse arc lengths is the fastest."""

from .fastest_right import SUITE, fastest_right

__all__ = ["SUITE", "find"]


def find(bundle):
    """Holds where one method certainly takes less time than every other that is right."""
    return fastest_right(bundle, "inverse_arc_length_time", "companion_speed-at_length", "Parameters at a length of cubics")
