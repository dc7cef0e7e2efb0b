# SPDX-License-Identifier: MIT
"""Worst cases: what a sample shows, what a search finds, what is proved."""

from ..document import Text
from ..search_tables import search_tables
from .suite_parts import figure, of_suite

TITLE = "Worst cases, sampled and searched"
SUITE = "worst"


def blocks(bundle, findings):
    """Findings, the figure, then sampled <= searched <= bound for every method and degree."""
    tables = search_tables(bundle, SUITE)
    yield from of_suite(findings, "worst")
    yield from figure("searched_maxima", bundle)
    yield from tables
    yield Text("A searched maximum is a lower bound of the worst case, and the proved bound an upper one; between them "
               "nothing is known. "
               "`reached`: the search gained what it is asked for over the sample. `near_bound`: it cannot, since the sample "
               "alone is that "
               "close to the bound. `short`: neither. `non_finite`: an input was found whose value is not finite. Every case "
               "can be replayed "
               "from its bits: `bezierbench replay BUNDLE ID` with the id of its line.")
