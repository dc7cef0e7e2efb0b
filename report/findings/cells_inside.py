# SPDX-License-Identifier: MIT
"""How many printed errors and counts the reproduction meets."""

from collections import Counter

from ..document import Finding
from ..wording import count, general, percent
from .printed import RARE, accuracy_cells, events, experiments, outside_by_chance


def verdicts(found):
    """How many events have which verdict, in words, and whether chance explains those outside."""
    by = Counter(event.verdict for event in found)
    expected, probability = outside_by_chance(found)
    holds = probability >= RARE
    return by, holds, (f"{'as many as' if holds else 'more than'} chance leaves outside, which are {general(expected, 2)} of "
                       f"{len(found)} on average")


def find(bundle):
    """Holds where chance leaves as many events outside as there are, but for a rare accident."""
    found = events(bundle)
    by, holds, chance = verdicts(found)
    outside = [event for event in found if event.verdict == "outside"]
    below = sum(event.rows[0].number("published") < event.rows[0].number("ours_p05") for event in outside)
    _, probability = outside_by_chance(found)
    drawn = experiments(accuracy_cells(bundle))
    missed = sum(any(r["verdict"] == "outside" for r in one) for one in drawn)
    cells = sum(len(event.rows) for event in found)
    return Finding(
        id="cells_inside_band", about="reproduction", claim="", holds=holds,
        headline=f"{by['inside']} of the {len(found)} distinct errors and counts that the report prints lie inside our 5–95 % band, "
                 f"{by['edge']} on its edge and {by['outside']} outside, {chance}; {by['explained']} more "
                 f"{'is' if by['explained'] == 1 else 'are'} explained.",
        detail=(f"Of those outside {below} lie below the band and {len(outside) - below} above. If they were independent, chance would "
                f"leave at least as many outside with a probability of {percent(probability)}"
                + ("." if holds else ": the experiment is not fully reproduced."),
                f"The accuracy cells are of {count(len(drawn), 'independent experiment')}, each a form, degree, range and interval. In "
                "our repetitions all methods and both statistics of an experiment share its trials and move together, so chance spreads "
                f"further than for single cells. {missed} of these experiments {'has' if missed == 1 else 'have'} a cell outside.",
                f"The report prints {cells} errors and counts, of which {cells - len(found)} repeat another of the same run: the last "
                "range of table 2.3.2 is the last degree of table 2.3.1, and two methods can agree to the printed digits."),
        rows=tuple(row for event in found if event.verdict != "inside" for row in event.rows))
