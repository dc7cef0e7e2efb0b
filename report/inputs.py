# SPDX-License-Identifier: MIT
"""The inputs of a row in words: curves that a generator draws from a range, or the curves of a set at a placement."""

from .rows import grouped
from .wording import interval, shortest

PLACED = {"stored": "as stored", "scaled": "scaled", "translated": "translated on a page"}  # rows of sets have these as generators
ONE_SET = ("curves", "generator", "form", "dimension")  # what rows of one set at one placement share


def kind(generator):
    """`continuous inputs`, or the placement of a set: `as stored`."""
    return PLACED.get(generator, f"{generator} inputs")


def parts(row):
    """{column: its words}: `curves of the set dejavu` and `as stored`; or `R = 1`, `t in [0, 1]` and `continuous inputs`."""
    place = {"curves": f"curves of the set {row['curves']}"} if row["curves"] else {
        "coordinate_range": f"R = {shortest(row['coordinate_range'])}", "interval": f"t in {interval(*row['interval'])}"}
    return {**place, "generator": kind(row["generator"])} if row["generator"] else place


def words(row, *without):
    """The parts as text, except for those of some columns."""
    return ", ".join(text for column, text in parts(row).items() if column not in without)


def by_set(rows):
    """[(what their captions add, rows)]: drawn curves together, and those of each set at a placement by themselves."""
    if not rows[0]["curves"]:
        return [("", rows)]
    return [(f", {words(own[0])}", own) for own in grouped(rows, *ONE_SET).values()]
