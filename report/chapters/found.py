# SPDX-License-Identifier: MIT
"""The first minute: what holds and what does not."""

from ..bundle import Missing
from ..document import Bullets, Heading, Text
from ..findings.roster import grouped
from ..wording import listing

TITLE = "What was found"


def blocks(bundle, findings):
    """Findings under their headings, then those that the bundle cannot decide."""
    found, undecided = findings
    if not found and not undecided:
        raise Missing("there is nothing to judge")
    if bundle.has_suite("report"):
        yield Text("“The report” is the source report whose tables are reproduced here. Every number and every judgement is "
                   "computed from the bundle; under each statement stand the rows that decide it.")
    for heading, members in grouped(found):
        yield Heading(heading)
        if all(f.suite for f in members):  # each stands in full in the chapter of its suite
            yield Bullets(tuple(f.headline for f in members))
        else:
            yield from members
    if undecided:
        yield Text(f"Not decided, since the bundle lacks rows for it: {listing(name.replace('_', ' ') for name, _ in undecided)}.")
