# SPDX-License-Identifier: MIT
"""Nanoseconds per point of every timed method. Times of other problems stand in the chapters of these."""

from ..bundle import Missing
from ..document import Text
from ..limits import reading_limits, reading_load
from ..time_tables import EVALUATION, reading_times, time_tables, times

TITLE = "Time per point on this machine"


def blocks(bundle, _findings):
    """What the times are, then one table per study: median with its interval, by mode."""
    if not bundle["timing.csv"].rows:
        raise Missing("`timing.csv` has no rows")
    if not times(bundle, EVALUATION):
        raise Missing("`timing.csv` times no evaluation; times of other problems stand in their chapters")
    yield Text("`one_shot`: prepare a curve and evaluate one point. `point`: prepared, one point at a time. "
               "`latency`: likewise, each t waiting for the last point. `batch`: one curve, many t.")
    yield reading_times(bundle, EVALUATION)
    yield from filter(None, (reading_load(bundle), reading_limits(times(bundle, EVALUATION))))
    yield from time_tables(bundle, EVALUATION)
