# SPDX-License-Identifier: MIT
"""All chapters, in the order of the page."""

from ..bundle import Missing, decided_by, made_of
from ..document import Chapter, safe, with_unique_ids
from . import (
    answer, arc_length, audit, bspline, choosing, comparison, conditioning, conversion, derivative, figures, fitting, found, grid,
    guarantees, how_measured, interpolation, inverse_arc_length, ladder, method_list, opening, peers, projection, provenance, rational,
    regimes, roofline, scorecard, studies, subdivision, tables, timing, truth, worst)
from .suite_parts import COMPANION_PEERS

ROSTER = (opening, answer, found, scorecard, tables, figures, truth, ladder, regimes, conditioning, conversion, worst, guarantees,
          rational, derivative, arc_length, inverse_arc_length, projection, interpolation, fitting, subdivision, grid,
          bspline, timing, choosing, roofline, peers, comparison, audit, method_list, how_measured, provenance)
OF_THE_WHOLE = (opening, answer, comparison, audit, method_list, how_measured, provenance)
FIRST = ("opening", "answer")
LAST = ("comparison", "audit", "method-list", "how-measured", "provenance")

# Suites with findings or chapters of their own. Any other is a user's, and its chapter stands first.
KNOWN = frozenset({module.SUITE for module in ROSTER if hasattr(module, "SUITE")} | {"speed", "companion_speed", COMPANION_PEERS})
OF_ANY_SUITE = ("timing", "roofline")  # kinds whose chapter shows the studies of all known suites


def known_part(bundle):
    """The bundle without the studies of a user's own suites."""
    return bundle.only({one.id for one in bundle.studies.values() if one.suite in KNOWN})


def _has_chapter(study):
    return study.suite in KNOWN and (study.kind in OF_ANY_SUITE or study.suite == COMPANION_PEERS
                                     or any(getattr(module, "SUITE", None) == study.suite for module in ROSTER))


def _of_suites(bundle, own):
    """Chapters of the studies that no other chapter shows, by suite: a user's own, or what is left of the known ones."""
    suites = {}
    for study in map(bundle.studies.get, bundle.studied()):
        if (study.suite not in KNOWN) == own and not _has_chapter(study):
            suites.setdefault(study.suite, []).append(study.id)
    for suite, members in suites.items():
        title = studies.title(bundle, suite)
        with made_of(bundle, f"the chapter '{title}'"):
            yield Chapter(safe(f"suite-{suite}"), title, tuple(studies.blocks(bundle, members)))


def _concerns(module, bundle):
    """Whether a bundle's suites say that it has what the chapter is about."""
    if not hasattr(module, "SUITE") and not hasattr(module, "KIND"):
        return False
    return any(study.suite == getattr(module, "SUITE", None) or study.kind == getattr(module, "KIND", None)
               for study in bundle.studies.values() if study.suite in KNOWN)


def build_all(bundle, findings):
    """(chapters, [(title, what the bundle lacks)]): a user's own suites first. A chapter about what the bundle's suites have, but
    without its data, is said to be left out."""
    own, chapters, left_out = list(_of_suites(bundle, True)), [], []
    part = known_part(bundle)
    for module in ROSTER:
        try:
            name = module.__name__.rsplit(".", 1)[-1].replace("_", "-")
            whole = bundle if module in OF_THE_WHOLE else part
            with decided_by(bundle, f"the chapter '{module.TITLE}'"):
                chapters.append(Chapter(name, module.TITLE, tuple(module.blocks(whole, findings))))
        except Missing as lack:
            if _concerns(module, bundle):
                left_out.append((module.TITLE, str(lack)))
    after = next((i for i, chapter in enumerate(chapters) if chapter.id in LAST), len(chapters))
    before = sum(chapter.id in FIRST for chapter in chapters)
    return with_unique_ids([*chapters[:before], *own, *chapters[before:after], *_of_suites(bundle, False), *chapters[after:]]), left_out
