# SPDX-License-Identifier: MIT
"""Which method for derivatives is the fastest."""

from .fastest_right import SUITE, fastest_right

__all__ = ["SUITE", "find"]


def find(bundle):
    """Holds where nested multiplication on differences takes less time than every other right method from degree 5 on."""
    return fastest_right(bundle, "derivative_time", "companion_speed-derivative", "differences_horner",
                         "Derivatives of curves from degree 5 on", lambda row: row["degree"] >= 5)
