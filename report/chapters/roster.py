# SPDX-License-Identifier: MIT
"""All chapters: a user's own suites, then those that are declared, in the order of the page."""

from .. import schema
from ..bundle import Missing, decided_by, made_of
from ..document import Chapter, Heading, Text, safe, with_unique_ids
from ..error_tables import error_tables, swept
from .parts import COMPANION_PEERS, ROSTER, TABLES, replay, study_figure

FIRST = ("verdict", "opening", "real-curves", "answer")
LAST = ("comparison", "audit", "method-list", "how-measured", "provenance")
UNNAMED = "Studies that `suite.toml` does not name"

# Suites with findings or chapters of their own. Any other is a user's, and its chapter stands first.
KNOWN = frozenset({one.suite for one in ROSTER if one.suite} | {"speed", "companion_speed", COMPANION_PEERS})


def _known(study):
    """Whether a study may have a chapter of its suite: these are about drawn curves."""
    return study.suite in KNOWN and not study.on_sets


def known_part(bundle):
    """The bundle without the studies of a user's own suites, and of a user's own curves."""
    return bundle.only({one.id for one in bundle.studies.values() if _known(one)})


def _has_chapter(study):
    return _known(study) and (study.kind == "timing" or study.suite == COMPANION_PEERS or any(one.suite == study.suite for one in ROSTER))


def _of_suites(bundle, own):
    """Chapters of the studies that no other chapter shows, by suite: a user's own, or the remaining ones of known suites."""
    suites = {}
    for study in map(bundle.studies.get, bundle.studied()):
        if _known(study) != own and not _has_chapter(study):
            suites.setdefault(study.suite, []).append(study)
    for suite, members in suites.items():
        title = bundle.suites.get(suite, suite) if suite else UNNAMED
        with made_of(bundle, f"the chapter '{title}'"):
            yield Chapter(safe(f"suite-{suite}"), title, tuple(_studies(bundle, members)))


def _studies(bundle, studies):
    """Of some studies of one suite, in their order: a heading, the figure, the tables; then how to replay the worst trial."""
    for study in studies:
        yield Heading(study.title)
        if study.kind not in schema.kinds():
            yield Text(f"The study `{study.id}` is of a kind that this report does not know.")
            continue
        yield from study_figure(bundle, study.id)
        try:
            yield from TABLES.get(study.kind, _of_any_kind)(bundle, study.id)
        except Missing as lack:
            yield Text(f"Its tables are left out: {lack}.")
    yield from replay(bundle.only({study.id for study in studies}), studies[0].suite)


def _of_any_kind(bundle, study):
    """Tables of a kind that declares none: mean and largest error, by method."""
    rows = bundle.judged(f"{bundle.studies[study].kind}.csv").some(study=study)
    yield from error_tables(study, rows, *swept(rows))


def _concerns(one, bundle):
    """Whether a bundle has studies of the suite or kind of a chapter."""
    return any(one.suite and study.suite == one.suite or one.kind and study.kind == one.kind
               for study in bundle.studies.values() if _known(study))


def build_all(bundle, findings):
    """(chapters, [(title, what the bundle has not)]): a user's own suites first. A chapter about a suite of the bundle whose data are missing
    is named as left out."""
    own, chapters, left_out = list(_of_suites(bundle, True)), [], []
    part = known_part(bundle)
    for one in ROSTER:
        try:
            with decided_by(bundle, f"the chapter '{one.title}'"):
                chapters.append(Chapter(one.id, one.title, tuple(one.blocks(bundle if one.whole else part, findings))))
        except Missing as lack:
            if _concerns(one, bundle):
                left_out.append((one.title, str(lack)))
    after = next((i for i, chapter in enumerate(chapters) if chapter.id in LAST), len(chapters))
    before = sum(chapter.id in FIRST for chapter in chapters)
    return with_unique_ids([*chapters[:before], *own, *chapters[before:after], *_of_suites(bundle, False), *chapters[after:]]), left_out
