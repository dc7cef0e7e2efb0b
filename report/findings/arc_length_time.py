# SPDX-License-Identifier: MIT
"""The time of arc lengths here and in other libraries."""

from .faster_than_peers import faster_than_peers

SUITE = "companion_peers"


def find(bundle):
    """Holds where the best of our methods takes less time than every other library."""
    return faster_than_peers(bundle, "arc_length_time", SUITE, "companion_peers-length_speed", "The length of a cubic")
