# SPDX-License-Identifier: MIT
"""What chapters are declared with and consist of: findings first, figures where there are rows, tables, times, how to replay."""

import functools
from collections.abc import Callable
from dataclasses import dataclass

from .. import inputs
from ..bundle import Missing
from ..document import Heading, Text
from ..figures import drawn
from ..time_tables import reading_times, time_tables, times
from ..wording import general, large, shortest

COMPANION_PEERS = "companion_peers"  # studies of several problems, each in the chapter of its own


@dataclass(frozen=True)
class Declared:
    """A chapter: `blocks(bundle, findings)` makes it, or raises Missing. `suite` and `kind` say whose studies it shows; one of the `whole`
    bundle shows a user's own suites, too."""

    id: str
    title: str
    blocks: Callable
    suite: str
    kind: str
    whole: bool


ROSTER = []  # of Declared, in the order of the page
TABLES = {}  # by kind of study: a function of (bundle, study) to tables and texts


def chapter(title, suite="", kind="", whole=False):
    """Declares the function `blocks` of a chapter, whose name is its id."""
    def declare(blocks):
        ROSTER.append(Declared(blocks.__name__.replace("_", "-"), title, blocks, suite, kind, whole))
        return blocks
    return declare


def tables_of(kind):
    """Declares the function (bundle, study) that makes the tables of a study of that kind."""
    def declare(study_tables):
        TABLES[kind] = study_tables
        return study_tables
    return declare


def of_suite(findings, suite):
    """The findings of a suite, in their order."""
    return [f for f in findings[0] if f.suite == suite]


def figure(name, bundle, *study):
    """The figure of that name as a list, empty where the bundle has no rows for it."""
    try:
        return [drawn(name, bundle, *study)]
    except Missing:
        return []


def study_figure(bundle, study):
    """The figure of one study, as a list, empty where there is nothing to draw: that of its kind, else lines along the axis that it
    varies."""
    name = {"guarantees": "guarantee_matrix", "hard_cases": "hard_case_distances"}.get(bundle.studies[study].kind, "study_lines")
    return figure(name, bundle, study)


def of_studies(bundle, studies):
    """The figure and the tables of each study."""
    for study in studies:
        yield from study_figure(bundle, study)
        yield from TABLES[bundle.studies[study].kind](bundle, study)


def with_times(problem, *figures):
    """For the blocks of a chapter about that problem: the times of one answer follow them, with these figures. The chapter is left
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
    return [Text(f"The trial behind each largest error is kept in `worst.csv`, with its inputs to the last bit ({large(len(kept))} here). "
                 f"`bezierbench replay BUNDLE {worst['worst_id']}` recomputes the largest of them, {general(worst['error_u'])} u p~ by "
                 f"`{worst['method']}` (degree {shortest(worst['degree'])}, {inputs.words(worst)}), step by step "
                 "against the exact value.")]
