# SPDX-License-Identifier: MIT
"""Which method for foot points is the fastest."""

from .fastest_right import SUITE, fastest_right

__all__ = ["SUITE", "find"]


def find(bundle):
    """Holds where one method certainly takes less time than every other that is right."""
    return fastest_right(bundle, "projection_time_fastest", "companion_speed-projection", "Foot points on cubics")
