# SPDX-License-Identifier: MIT
"""How errors grow with the degree: not at all, no faster than the degree, or faster."""

from ..document import Finding
from ..methods import FORM
from ..wording import factor, general, span
from .series import by_degree, growth, names

SUITE = "ladder"
GENERATOR = "continuous"
FLAT = 2  # the mean error at most doubles over the ladder
LOST = 2.0 ** 53  # in units of u p~: an error as large as the terms of the curve


def find(bundle):
    """Holds where every method that evaluates the given form grows at most with the degree, and some converted path faster."""
    table = bundle.exact("ladder")
    lines, flat, fast, native_fast, used = [], [], [], [], []
    for curve in table.distinct("curve", generator=GENERATOR):
        methods = by_degree(table.select(curve=curve, generator=GENERATOR, scalar="double", dimension=2))
        grown = {m: growth(rows) for m, rows in methods.items()}
        limit = max(n for rows in methods.values() for n in rows) / min(n for rows in methods.values() for n in rows)
        mine = {"flat": [m for m in grown if grown[m] <= FLAT], "fast": [m for m in grown if grown[m] > limit]}
        between = [m for m in grown if m not in mine["flat"] and m not in mine["fast"]]
        flat += mine["flat"]
        fast += mine["fast"]
        native_fast += [m for m in mine["fast"] if ":" not in m]
        used += [rows[n] for rows in methods.values() for n in (min(rows), max(rows))]
        lost = {m: min((n for n, r in methods[m].items() if r["mean_error_u"] > LOST), default=None) for m in mine["fast"]}
        at = [n for n in lost.values() if n is not None]
        title = FORM[curve][0][0].upper() + FORM[curve][0][1:]
        lines.append(
            f"{title}. Flat, at most doubled from the lowest degree to any other: {names(mine['flat']) or 'none'}. "
            + (f"Growing, but no faster than the degree: {names(between)}, by a factor of "
               f"{span(min(grown[m] for m in between), max(grown[m] for m in between), factor)}. " if between else "")
            + (f"Faster than the degree: {names(mine['fast'])}, by "
               f"{span(min(grown[m] for m in mine['fast']), max(grown[m] for m in mine['fast']), factor)}"
               + (f"; {'all' if len(at) == len(lost) else len(at)} of these {len(lost)} lose every digit on average, the "
                  f"first at degree {min(at):g}." if at else ".")
               if mine["fast"] else "None grows faster than the degree."))
    holds = bool(fast) and not native_fast
    paths = len({r["method"] for r in table.rows if ":" in r["method"]})
    return Finding(
        id="ladder_growth", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"No method that evaluates the given form grows faster than the degree; {len(fast)} of {general(paths)} "
                 "converted paths do."
        if holds else
        (f"Of the methods that evaluate the given form, {names(native_fast)} grow faster than the degree; of "
         f"{general(paths)} converted "
         f"paths {len(fast) - len(native_fast)} do." if native_fast else
         "No method and no converted path grows faster than the degree."),
        detail=tuple(lines), rows=tuple(used))
