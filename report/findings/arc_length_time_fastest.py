# SPDX-License-Identifier: MIT
"""Which method for arc lengths is the fastest."""

from .fastest_right import SUITE, fastest_right

__all__ = ["SUITE", "find"]


def find(bundle):
    """Holds where adaptive Gauss-Legendre rules take less time than every other right method."""
    return fastest_right(bundle, "arc_length_time_fastest", "companion_speed-length", "gauss_legendre_adaptive",
                         "Lengths of cubics")
