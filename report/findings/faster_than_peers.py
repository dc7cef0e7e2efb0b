# SPDX-License-Identifier: MIT
"""Compares one of our methods with other libraries in the same races, for the findings about times."""

from collections import Counter

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, general, listing, shortest, span

PEER = "peer_"


def _race(race, ours):
    """A sentence with the times of one race: `To 1e-3: a 500 ns, b 900 ns.`"""
    tolerance = race[ours]["tolerance"]
    times = ", ".join(f"`{m}` {general(row['median_ns'])} ns" for m, row in race.items() if m == ours or m.startswith(PEER))
    return (f"To {shortest(tolerance)}: " if tolerance is not None else "") + times + "."


def _ours(races):
    """Our own method that is right in most races and, of several, has the least median in most; None where there is
    none."""
    right, fastest = Counter(), Counter()
    for race in races:
        own = {m: row for m, row in race.items() if not m.startswith(PEER)}
        right.update({m: row["checked"] == "yes" for m, row in own.items()})
        fastest.update([min(own, key=lambda m, own=own: own[m].number("median_ns"))] if own else [])
    return max(right, key=lambda m: (right[m], fastest[m]), default=None)


def faster_than_peers(bundle, finding_id, suite, study, what):
    """A finding that holds where, in every race, our best method is right and its interval of times is below that of
    every other library."""
    rows = bundle["timing.csv"].some(study=study)
    races = {}
    for row in rows:
        races.setdefault(tuple(row[c] for c in ("dimension", "degree", "tolerance")), {})[row["method"]] = row
    ours = _ours(races.values())
    races = {asked: race for asked, race in races.items() if ours in race}
    duels = [(race[ours], rival) for race in races.values() for m, rival in race.items() if m.startswith(PEER)]
    if not duels:
        raise Missing(f"`{study}` needs a method of ours in a race with a method of another library")
    won = [(us, them) for us, them in duels if us.number("high_ns") < them.number("low_ns") and us["checked"] == "yes"]
    ratios = {}
    for us, them in duels:
        ratios.setdefault(them["method"], []).append(them.number("median_ns") / us.number("median_ns"))
    holds = len(won) == len(duels)
    wrong = list(dict.fromkeys(them["method"] for _, them in duels if them["checked"] != "yes"))
    lost = list(dict.fromkeys(them["method"] for us, them in duels if (us, them) not in won))
    return Finding(
        id=finding_id, about="suite", suite=suite, claim="", holds=holds,
        headline=f"{what} by `{ours}` takes less time than by any other library here: "
                 + listing(f"`{m}` takes {span(min(r), max(r), factor)} times as long" for m, r in ratios.items()) + "." if holds else
        f"{what} by `{ours}` does not take less time than by {listing(f'`{m}`' for m in lost)}.",
        detail=(*(_race(race, ours) for race in races.values()),
                f"Not every answer of {listing(f'`{m}`' for m in wrong)} is right." if wrong else ""),
        rows=tuple(dict.fromkeys(row for duel in duels for row in duel)))
