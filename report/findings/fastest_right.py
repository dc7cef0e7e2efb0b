# SPDX-License-Identifier: MIT
"""Finds the fastest correct method of a companion problem, for the findings about times."""

from collections import Counter

from ..bundle import Missing
from ..document import Finding
from ..wording import count, factor, listing, span

SUITE = "companion_speed"
ASKED = ("scalar", "dimension", "degree", "mode", "order", "tolerance", "points", "data", "coordinate_range", "t_min", "t_max",
         "generator")  # what the rows of one race have in common


def _races(rows):
    """[{method: row}] for the races in which the method that times are relative to took part."""
    races = {}
    for row in rows:
        races.setdefault(tuple(row[c] for c in ASKED), {})[row["method"]] = row
    return [race for race in races.values() if all(row["relative_to"] in race for row in race.values())]


def _ratio(row):
    """(low end, ratio, high end) of the time relative to the race's reference method."""
    if row["method"] == row["relative_to"]:
        return 1.0, 1.0, 1.0
    return row.number("ratio_low"), row.number("ratio"), row.number("ratio_high")


def _right(race):
    return [row for row in race.values() if row["checked"] == "yes"]


def _winner(races, study):
    """(method, wins): of the methods that are right in every race, the one that most often has the least ratio of the
    right ones."""
    always = [m for m in races[0] if all(m in race and race[m]["checked"] == "yes" for race in races)] if races else []
    if not always or not any(len(_right(race)) > 1 for race in races):
        raise Missing(f"`{study}` needs ratios of two methods that are right")
    wins = Counter(min(_right(race), key=lambda row: _ratio(row)[1])["method"] for race in races)
    best = max(always, key=lambda m: wins[m])
    return best, wins[best]


def _times(races, best):
    """Two sentences: the ratios of the right methods and those of the wrong ones, as in the bundle."""
    base = next(iter(races[0].values()))["relative_to"]
    right, wrong = {}, {}
    for race in races:
        for m, row in race.items():
            if m != base:
                (right if row["checked"] == "yes" else wrong).setdefault(m, []).append(_ratio(row)[1])
    of = "its own" if best == base else f"that of `{base}`"

    def words(ratios):
        return listing(f"`{m}` {span(min(r), max(r), factor)}" for m, r in ratios.items())
    return (f"Times of the others over {of}, in {count(len(races), 'race')}: {words(right)}." if best == base else
            f"Times over {of}, in {count(len(races), 'race')}: {words(right)}.",
            f"Where answers were not right: {words(wrong)}." if wrong else "")


def fastest_right(bundle, finding_id, study, answers, belongs=lambda row: True):
    """A finding that holds where one method is right in every race that `belongs` accepts, and every other right method
    certainly takes longer there: the intervals of their ratios, taken round by round, do not overlap."""
    races = _races(r for r in bundle["timing.csv"].some(study=study) if r["degree"] is not None and belongs(r))
    best, wins = _winner(races, study)
    duels = [(race[best], row) for race in races for row in _right(race) if row["method"] != best]
    beaten = [(own, row) for own, row in duels if _ratio(row)[0] > _ratio(own)[2]]
    holds = len(beaten) == len(duels)
    return Finding(
        id=finding_id, about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"{answers} come fastest by `{best}`, of the methods that are right." if holds else
        f"{answers} come certainly fastest by no one method: `{best}`, the fastest in {wins} of {count(len(races), 'race')}, is "
        f"certainly faster than {len(beaten)} of {count(len(duels), 'right rival')}.",
        detail=_times(races, best), rows=tuple(row for race in races for row in race.values()))
