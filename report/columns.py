# SPDX-License-Identifier: MIT
"""What the report knows of the columns that it reads, beside what the schema of a bundle's tables says of them."""

import re

# What `bezierbench compare` writes: the columns that the report reads, and those that are words, even where a value looks like
# a number (study 2.2). In MIXED it depends on the row which columns apply and whether they hold a number.
COMPARISON = {
    "comparison.csv": ("kind study method degree mode a b ratio ratio_low ratio_high verdict against bundle file column "
                       "quality normalised normalised_low normalised_high normalised_verdict rank_a rank_b").split(),
    "facts.csv": "against bundle fact a b".split(),
    "standings.csv": "rank bundle cpu compiler machine accuracy_rows_differing timings mean_ratio mean_normalised".split(),
}
WORDS = frozenset("kind study table curve method scalar mode generator baseline verdict against bundle file column quality "
                  "normalised_verdict fact cpu compiler machine".split())
MIXED = frozenset({"comparison.csv", "facts.csv"})

# Ids of studies and suites as a suite has to write them, and of what it names: a path is `conversion:evaluator`.
ID = re.compile(r"[A-Za-z0-9._-]+")
NAME = re.compile(r"[A-Za-z0-9._:+-]+")
IDS = frozenset("study accuracy_study worst_id search_id guarantee_id".split())
NAMES = frozenset("method conversion curve scalar generator mode".split())
MOST_DEGREE = 1023  # of a suite
