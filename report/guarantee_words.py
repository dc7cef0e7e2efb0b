# SPDX-License-Identifier: MIT
"""Verdicts of guarantees.csv in words, of one row, and of a method and property over degrees and scalar types; searches of hard_cases.csv."""

from .wording import percent

WORDS = {"proved": "proved", "refuted": "broken", "not_refuted": "open"}
MARKS = {"proved": "inside", "refuted": "outside", "not_refuted": "explained"}
SEARCHES = {"tie": "on a boundary", "nearest": "next to a boundary", "cancelled": "cancelled most", "zero": "cancelled to 0"}
ORDER = ("refuted", "not_refuted", "proved")  # of rows that differ the first stands for all


def of_all(rows):
    """The verdict that stands for several rows."""
    return next(verdict for verdict in ORDER if any(row["verdict"] == verdict for row in rows))


def share(rows):
    """Of the counts of these rows, the largest share of random inputs that break the property; None where no input was judged."""
    shares = [row["broken"] / row["trials"] for row in rows if row["trials"]]
    return max(shares, default=None)


def by_degree(rows):
    """`proved`, or `proved for n = 1; broken`: degrees of one verdict together, from the lowest on."""
    parts = []
    for degree in sorted({int(row["degree"]) for row in rows}):
        verdict = of_all([row for row in rows if row["degree"] == degree])
        if parts and parts[-1][0] == verdict:
            parts[-1][2] = degree
        else:
            parts.append([verdict, degree, degree])
    if len(parts) == 1:
        return WORDS[parts[0][0]]
    return "; ".join(f"{WORDS[verdict]} for n = {low}" + (f" to {high}" if high > low else "") for verdict, low, high in parts)


def with_share(rows):
    """`broken (17 %)`: with the largest share of random inputs that break it, where any does."""
    largest = share(rows)
    return by_degree(rows) + (f" ({percent(largest)})" if largest else "")
