# SPDX-License-Identifier: MIT
"""Nanoseconds per point of every timed method. Times of other problems stand in the chapters of these."""

from .. import schema
from ..bundle import Missing
from ..document import Text
from ..limits import reading_limits, reading_load
from ..time_tables import EVALUATION, reading_times, time_tables, times
from .suite_parts import study_figure

TITLE = "Time per point on this machine"
KIND = "timing"


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
    for study in dict.fromkeys(r["study"] for r in times(bundle, EVALUATION)):
        yield from study_figure(bundle, study)
        yield from time_tables(bundle.only({study}), EVALUATION)


def study_tables(bundle, study):
    """Medians with their intervals, whatever problem was timed."""
    part = bundle.only({study})
    for problem in schema.timed():
        if times(part, problem):
            yield from time_tables(part, problem)
            yield reading_times(part, problem)
