# SPDX-License-Identifier: MIT
"""How a finding is declared: a function of the bundle that returns a verdict, and the words that several findings share."""

import functools
from dataclasses import replace

from ..document import Finding
from ..rows import distinct
from ..wording import count, large, listing, shortest

ROSTER = []  # (function, suite), in the order in which they are declared


def finding(suite="report", about="suite", claim="", place=""):
    """Declares a function that returns a verdict or raises Missing, as the finding of its name. `suite` is the one whose bundles it is about,
    None for any bundle; for the source report, `claim` is what it says, and `place` where."""
    def declare(find):
        @functools.wraps(find)
        def found(bundle):
            said = find(bundle)
            return replace(said, id=find.__name__, about=said.about or about, claim=said.claim or claim, place=place,
                           suite=suite if suite and about == "suite" else "")
        ROSTER.append((found, suite))
        return found
    return declare


def verdict(holds, yes, no, *detail, rows, **more):
    """Whether a statement holds: the sentence if it does, the one if it does not, sentences with the numbers behind it, and the rows that decide
    it."""
    return Finding(id="", about=more.pop("about", ""), claim=more.pop("claim", ""), holds=bool(holds), headline=yes if holds else no,
                   detail=tuple(filter(None, detail)), rows=tuple(rows))


def names(methods, most=6):
    """The names as text: `a`, `b` and 3 more."""
    methods = [f"`{m}`" for m in methods]
    return listing(methods) if len(methods) <= most else f"{', '.join(methods[:most - 1])} and {len(methods) - most + 1} more"


def methods_of(rows):
    """The names of the methods of these rows as text."""
    return names(distinct(rows, "method"))


def how_many_methods(rows):
    return count(len(distinct(rows, "method")), "method")


def trials_of(rows):
    """How many trials these rows are of, as text."""
    return large(sum(r.number("trials") for r in rows))


def degrees(values):
    return f"degree {listing(shortest(n) for n in values)}"


def by_winners(winners):
    """`a` at degree 3 and `b` at degree 4 and 5: of {degree: methods}."""
    groups = {}
    for n, methods in winners.items():
        groups.setdefault(methods, []).append(n)
    return "; ".join(f"{names(methods)} at {degrees(at)}" for methods, at in groups.items())
