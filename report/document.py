# SPDX-License-Identifier: MIT
"""What a chapter consists of. Chapters state their content; render.py and the templates turn it into HTML and Markdown.

Texts know two marks, as in Markdown: `code` and **strong**.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

SENTENCE = 30  # characters from which a cell is a sentence
LONG = 40  # lines from which a table scrolls by itself
# Ids of tables and figures are names of files, targets of links and attributes: from a fixed alphabet, and each but once.
SAFE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
LONGEST = 120  # characters; with what is added to them they are names of files everywhere
FIXED = ("content", "left-out", "title", "page-data", "page-script", "picker", "view", "said", "fault", "answer-sentence")  # of the page itself


class Block:
    """A part of a chapter."""

    @property
    def kind(self):
        """Its template."""
        return type(self).__name__.lower()


@dataclass(frozen=True)
class Cell:
    """What a reader sees, what the CSV file holds, and a mark (a verdict) that is shown by colour as well. `units` has the same
    quantity in other units, as a reader sees it."""

    text: str = ""
    raw: str = ""
    mark: str = ""
    units: tuple = ()  # of (name of the unit, text)


@dataclass(frozen=True)
class Group:
    """Rows of a table that share their first label."""

    label: str
    key: str
    rows: tuple  # of (label, [Cell])


@dataclass(frozen=True)
class Table(Block):
    """A table: two label columns (group and row), then one column per value of an axis."""

    id: str
    caption: str
    head: tuple  # labels of the value columns
    groups: tuple
    axis: str = ""  # what the value columns stand for
    every: str = ""  # what holds for every row
    caption_zh: str = ""  # of the tables of the source report
    group_head: str = "method"
    row_head: str = ""
    csv_head: tuple = ()  # filled where the CSV holds more than the page shows
    csv_rows: tuple = ()

    @property
    def single(self):
        """True where every group has one unlabelled row, so that one label column suffices."""
        return all(len(g.rows) == 1 and not g.rows[0][0] for g in self.groups)

    @property
    def of_methods(self):
        """True where groups are methods, which the page can filter."""
        return self.group_head in ("method", "conversion") and bool(self.groups)

    @property
    def in_units(self):
        """True where numbers can be shown in other units."""
        return any(cell.units for group in self.groups for _, cells in group.rows for cell in cells)

    @property
    def wordy(self):
        """For each value column, whether it holds sentences rather than numbers."""
        rows = [cells for g in self.groups for _, cells in g.rows]
        return [any(len(cells[i].text) > SENTENCE for cells in rows) for i in range(len(self.head))]

    @property
    def verbal(self):
        """For each value column, whether it holds words only, short ones included."""
        rows = [cells for g in self.groups for _, cells in g.rows]
        return [all(cells[i].text[:1].isalpha() for cells in rows if cells[i].text) for i in range(len(self.head))]

    @property
    def long(self):
        """True where the table would fill more than a screen."""
        return sum(len(g.rows) for g in self.groups) > LONG

    def csv(self):
        """Header and rows of the table's CSV file, with every digit that the bundle has."""
        if self.csv_head:
            return list(self.csv_head), [list(row) for row in self.csv_rows]
        labels = [self.group_head] if self.single else [self.group_head, self.row_head or "quantity"]
        rows = [[g.key] + ([] if self.single else [label]) + [c.raw for c in cells]
                for g in self.groups for label, cells in g.rows]
        return labels + list(self.head), rows


@dataclass(frozen=True)
class Series:
    """What a figure shows of one method: points in the units of the drawing, each with its values in words and its row, if known."""

    name: str
    colour: str
    points: tuple  # of (x, y, words, row or None)
    alike: tuple = ()  # other methods with the same points


@dataclass(frozen=True)
class Drawing:
    """What a figure shows. `svg` is a file of its own; render.py adapts it to be put into the page. What belongs to the series
    number i has an id that begins with `s<i>-`."""

    svg: str
    png: Callable  # () -> bytes, which takes as long again
    series: tuple  # of Series


@dataclass(frozen=True)
class Figure(Block):
    """A figure, which takes long to draw: `draw` is called where `drawing` is first read."""

    id: str
    caption: str
    alt: str
    draw: Callable  # () -> Drawing
    caption_zh: str = ""  # of the source report alone, as that of a table
    note: str = ""  # which methods it shows, where these are not all
    more: Callable | None = None  # () -> the Figure of all methods, where this one shows some of them

    @cached_property
    def drawing(self):
        return self.draw()

    @cached_property
    def whole(self):
        """The figure of all methods, as a part of the page alone; None where this is it."""
        return self.more and replace(self.more(), id=f"{self.id}-all", more=None)


@dataclass(frozen=True)
class Text(Block):
    text: str


@dataclass(frozen=True)
class Heading(Block):
    text: str


@dataclass(frozen=True)
class Bullets(Block):
    items: tuple


@dataclass(frozen=True)
class Definitions(Block):
    items: tuple  # of (term, meaning)


@dataclass(frozen=True)
class Tile:
    """One fact of the first glance; `full` where the value is the beginning of something longer."""

    label: str
    value: str
    note: str = ""
    mark: str = ""
    full: str = ""


@dataclass(frozen=True)
class Tiles(Block):
    items: tuple  # of Tile


@dataclass(frozen=True)
class Answer(Block):
    """The picker: every cell with its candidates, the one to show first, and its table, which is what stands there without script."""

    cells: dict
    first: object
    sentence: str
    table: Table


@dataclass(frozen=True)
class Finding(Block):
    """One statement about the source report that the bundle decides."""

    id: str
    about: str  # conclusion: the report's, tested; correction: ours, against it; reproduction; note; suite: another suite's
    claim: str  # what the report says, in our words; empty where the statement is about the reproduction
    holds: bool  # whether the bundle supports the statement; where it does not, the sentences state the opposite
    headline: str
    detail: tuple = ()
    rows: tuple = ()  # the rows of the bundle that decide it
    place: str = ""  # where the report says so: section and paragraph
    suite: str = ""  # the suite whose chapter it stands in; the report's own stand under their headings

    @property
    def evidence(self):
        """Where the numbers are: `accuracy.csv lines 3, 7`, file by file."""
        lines = {}
        for row in self.rows:
            lines.setdefault(row.file, set()).add(row.line)
        return [(file, _ranges(sorted(found))) for file, found in lines.items()]


def _ranges(lines):
    """3, 5 to 9: consecutive lines as spans."""
    spans = []
    for line in lines:
        if spans and line == spans[-1][1] + 1:
            spans[-1][1] = line
        else:
            spans.append([line, line])
    return ", ".join(str(a) if a == b else f"{a}–{b}" for a, b in spans)


@dataclass(frozen=True)
class Chapter:
    id: str
    title: str
    blocks: tuple


def safe(text):
    """The text with anything else replaced, and not too long."""
    return re.sub(r"[^A-Za-z0-9._-]", "_", text).lstrip("._-")[:LONGEST] or "unnamed"


def unique(text, taken):
    """A safe id that none of `taken` equals, whatever their case; it is added to them."""
    wanted = found = safe(text)
    number = 1
    while found.casefold() in taken:
        number += 1
        found = f"{wanted}-{number}"
    taken.add(found.casefold())
    return found


def with_unique_ids(chapters):
    """The chapters with ids that name files and places, of tables and figures in the order of the page."""
    taken = {*FIXED, *(chapter.id.casefold() for chapter in chapters),
             *(f"finding-{block.id}".casefold() for chapter in chapters for block in chapter.blocks if block.kind == "finding")}

    def own(block):
        if block.kind == "answer":
            return replace(block, table=own(block.table))
        return replace(block, id=unique(block.id, taken)) if block.kind in ("table", "figure") else block
    return [replace(chapter, blocks=tuple(map(own, chapter.blocks))) for chapter in chapters]
