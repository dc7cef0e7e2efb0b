# SPDX-License-Identifier: MIT
"""What an arc length costs here and in other libraries."""

from .faster_than_peers import faster_than_peers

SUITE = "companion_peers"


def find(bundle):
    """Holds where our adaptive Gauss-Legendre rule takes less time than every other library."""
    return faster_than_peers(bundle, "arc_length_time", SUITE, "companion_peers-length_speed", "gauss_legendre_adaptive",
                             "The length of a cubic")
