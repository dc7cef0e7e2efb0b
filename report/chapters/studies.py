# SPDX-License-Identifier: MIT
"""Chapters of suites that have none of their own, a user's first of all: every study with its figure and its tables."""

from ..bundle import Missing
from ..document import Heading, Text
from .kinds import TABLES
from .suite_parts import replay, study_figure

UNNAMED = "Studies that `suite.toml` does not name"


def title(bundle, suite):
    """What the suite calls itself."""
    return bundle.suites.get(suite, suite) if suite else UNNAMED


def blocks(bundle, studies):
    """Of some studies of one suite, in their order: a heading, the figure, the tables; then how to replay the worst trial."""
    for study in map(bundle.studies.get, studies):
        yield Heading(study.title)
        if study.kind not in TABLES:
            yield Text(f"The study `{study.id}` is of a kind that this report does not know.")
            continue
        yield from study_figure(bundle, study.id)
        try:
            yield from TABLES[study.kind](bundle, study.id)
        except Missing as lack:
            yield Text(f"Its tables are left out: {lack}.")
    yield from replay(bundle.only(set(studies)), bundle.studies[studies[0]].suite)
