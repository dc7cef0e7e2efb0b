# SPDX-License-Identifier: MIT
"""How many printed accuracy cells the reproduction meets."""

from ..document import Finding
from ..wording import count, general, percent
from .printed import accuracy_cells, experiments

BAND = 0.95 - 0.05


def find(bundle):
    """Holds where no more cells are outside than a band of this width leaves there on average."""
    printed = bundle["scorecard.csv"].some(table=("2.3.1", "2.3.2", "2.3.3"))
    cells = accuracy_cells(bundle)
    inside, outside, explained = ([r for r in cells if r["verdict"] == v] for v in ("inside", "outside", "explained"))
    n = len(cells)
    expected = n * (1 - BAND)
    holds = len(outside) <= expected
    below = sum(r.number("published") < r.number("ours_p05") for r in outside)
    drawn = experiments(cells)
    missed = sum(any(r["verdict"] == "outside" for r in one) for one in drawn)
    tail = (f"{count(len(outside), 'cell')} {'lies' if len(outside) == 1 else 'lie'} outside without a cause "
            f"({below} below the band, {len(outside) - below} above). "
            f"A band that holds {percent(BAND)} of honest repetitions leaves about {general(expected, 2)} of {n} outside by "
            "luck alone")
    shared = (f"The cells are of {count(len(drawn), 'independent experiment')}, each a form, degree, range and interval. In our "
              "repetitions all methods and both statistics of an experiment share its trials and move together, so luck spreads "
              f"further than for single cells. {missed} of these experiments {'has' if missed == 1 else 'have'} a cell outside.")
    return Finding(
        id="cells_inside_band", about="reproduction", claim="", holds=holds,
        headline=f"{len(inside)} of the {n} distinct accuracy cells that the report prints lie inside our 5–95 % band; "
                 f"{len(explained)} more {'is' if len(explained) == 1 else 'are'} explained.",
        detail=(tail + (", so there are no more misses than luck would give." if holds else
                        ", so there are more misses than luck would give: the experiment is not fully reproduced."),
                shared, f"The report prints {len(printed)} accuracy cells, of which {len(printed) - n} repeat others."),
        rows=tuple(outside + explained))
