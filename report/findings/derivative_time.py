# SPDX-License-Identifier: MIT
"""Which method for derivatives is the fastest."""

from .fastest_right import SUITE, fastest_right

__all__ = ["SUITE", "find"]


def find(bundle):
    """Holds where one method certainly takes less time than every other that is right, from degree 5 on."""
    return fastest_right(bundle, "derivative_time", "companion_speed-derivative", "Derivatives of curves from degree 5 on", lambda row: row["degree"] >= 5)
