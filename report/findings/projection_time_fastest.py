# SPDX-License-Identifier: MIT
"""Which method for foot points is the fastest."""

from .fastest_right import SUITE, fastest_right

__all__ = ["SUITE", "find"]


def find(bundle):
    """Holds where the isolation of all critical points takes less time than every other right method."""
    return fastest_right(bundle, "projection_time_fastest", "companion_speed-projection", "quintic_isolate",
                         "Foot points on cubics")
