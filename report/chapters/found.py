# SPDX-License-Identifier: MIT
"""The first minute: what holds and what does not."""

from ..document import Bullets, Heading, Text
from ..findings.roster import grouped
from ..wording import listing

TITLE = "What was found"


def blocks(bundle, findings):
    """Findings under their headings, then those that the bundle cannot decide."""
    found, undecided = findings
    if bundle.info.get("state") != "complete":
        yield Text(f"**This bundle is {bundle.info.get('state', 'of unknown state')}: a run that is not complete.** Every number "
                   "below is of the part that is there.")
    if found:
        yield Text("“The report” is the source report whose tables are reproduced here. Every number and every judgement is "
                   "computed from the bundle; under each statement stand the rows that decide it.")
    for heading, members in grouped(found):
        yield Heading(heading)
        if all(f.suite for f in members):  # each stands in full in the chapter of its suite
            yield Bullets(tuple(f.headline for f in members))
        else:
            yield from members
    if undecided:
        yield Heading("What this bundle cannot decide")
        by_lack = {}
        for name, lack in undecided:
            by_lack.setdefault(lack, []).append(name.replace("_", " "))
        for lack, names in by_lack.items():
            words = listing(names)
            yield Text(f"**{words[0].upper()}{words[1:]}**: {lack}.")
    if not found and not undecided:
        yield Text("There is nothing to judge in this bundle.")
