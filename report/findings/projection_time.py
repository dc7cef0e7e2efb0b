# SPDX-License-Identifier: MIT
"""The time of a projection here and in other libraries."""

from .faster_than_peers import faster_than_peers

SUITE = "companion_peers"


def find(bundle):
    """Holds where the best of our methods takes less time than every other library."""
    return faster_than_peers(bundle, "projection_time", SUITE, "companion_peers-projection_speed", "The nearest point of a cubic")
