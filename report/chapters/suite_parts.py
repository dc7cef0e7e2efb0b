# SPDX-License-Identifier: MIT
"""What the chapters of the suites have in common: findings first, figures where there are rows, times, how to replay."""

import functools

from ..bundle import Missing
from ..document import Heading, Text
from ..figures import drawn
from ..time_tables import reading_times, time_tables, times
from ..wording import general, interval, large, shortest


COMPANION_PEERS = "companion_peers"  # studies of several problems, each in the chapter of its own


def of_suite(findings, suite):
    """The findings of a suite, in their order."""
    return [f for f in findings[0] if f.suite == suite]


def figure(name, bundle):
    """The figure of that name as a list, empty where the bundle has no rows for it."""
    try:
        return [drawn(name, bundle)]
    except Missing:
        return []


def study_figure(bundle, study):
    """The figure of one study, as a list, empty where there is nothing to draw: that of its kind, else lines along the axis that it
    varies."""
    name = {"guarantees": "guarantee_matrix", "hard_cases": "hard_case_distances"}.get(bundle.studies[study].kind, "study_lines")
    try:
        return [drawn(name, bundle, study)]
    except Missing:
        return []


def of_studies(bundle, findings, suite, studies, tables, *figures):
    """What the chapter of a suite says first: its findings, these figures, then the figure and the tables of each study."""
    yield from of_suite(findings, suite)
    for name in figures:
        yield from figure(name, bundle)
    for study in studies:
        yield from study_figure(bundle, study)
        yield from tables(bundle, study)


def with_times(problem, *figures):
    """For the blocks of a chapter about that problem: what one answer costs follows them, with these figures. The chapter is left
    out where the bundle has neither errors nor times."""
    def around(errors):
        @functools.wraps(errors)
        def blocks(bundle, findings):
            timed = bool(times(bundle, problem))
            try:
                yield from list(errors(bundle, findings))
            except Missing as lack:
                if not timed:
                    raise
                yield Text(f"The errors are left out: {lack}.")
            if not timed:
                return
            yield Heading("Times")
            yield from (f for f in findings[0] if f.id.startswith(f"{problem}_time"))
            for name in figures:
                yield from figure(name, bundle)
            yield from time_tables(bundle, problem)
            yield reading_times(bundle, problem)
        return blocks
    return around


def replay(bundle, suite):
    """Where the inputs of the largest errors are, with the largest of them all as the example."""
    try:
        kept = bundle["worst.csv"].of_suite(suite).rows
    except Missing:
        return []
    worst = max(kept, key=lambda r: r["error_u"] or 0)
    return [Text("The trial behind each largest error is kept in `worst.csv` with its inputs to the last bit "
                 f"({large(len(kept))} "
                 f"here). `bezierbench replay BUNDLE {worst['worst_id']}` recomputes the largest of them, "
                 f"{general(worst['error_u'])} "
                 f"u p~ by `{worst['method']}` (degree {shortest(worst['degree'])}, `{worst['generator']}`, t in "
                 f"{interval(worst['t_min'], worst['t_max'])}), step by step against the exact value.")]
