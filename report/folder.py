# SPDX-License-Identifier: MIT
"""A directory of data files, as some command wrote it: the files read, decoded and taken apart, or one line about what is wrong."""

import re
from pathlib import Path

from . import files, schema
from .files import BundleError, shown
from .foreign import literal, literal_json
from .rows import Row, Table

LARGEST = 64 << 20  # bytes of a file; the tables of the shipped suites are smaller by a factor of ten
MOST_ROWS = 200_000
MOST_STUDIES = 1000  # of a table; each has tables and lines of its own on the page
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
_SPAN = re.compile(r"\d{1,4}\.\.\d{1,4}", re.ASCII)  # of degrees: a count of table 2.2 is over all of them


class Folder:
    """A directory of data files; a subclass names the command that writes such."""

    writer = ""  # the command

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise BundleError(f"{self.path}: no such directory; give the directory that `{self.writer}` wrote")
        self.name = literal(self.path.resolve().name)

    def advice(self):
        """What to do about a damaged file."""
        return f"write it again with `{self.writer}`"

    def fail(self, name, what, line=None):
        """Ends the reading of a file."""
        place = self.path / name if line is None else f"{self.path / name}:{line}"
        raise BundleError(f"{place}: {what}; {self.advice()}")

    def _bytes(self, name):
        """None where there is no such file."""
        try:
            return files.content(self.path / name, LARGEST)
        except files.NoFile:
            return None

    def _text(self, name):
        data = self._bytes(name)
        return None if data is None else files.text(self.path / name, data)

    def _json(self, name):
        data = self._bytes(name)
        return None if data is None else literal_json(files.document(self.path / name, data))

    def _csv(self, name):
        """The table of a file that is there."""
        columns, fields_of = files.table(self.path / name, self._bytes(name))
        self._check_header(name, columns)
        rows = []
        for line, fields in fields_of:
            if len(rows) == MOST_ROWS:
                self.fail(name, f"more than {MOST_ROWS} rows", line)
            rows.append(self._row(name, line, dict(zip(columns, fields))))
        if len({row["study"] for row in rows}) > MOST_STUDIES:
            self.fail(name, f"more than {MOST_STUDIES} studies")
        return Table(name, columns, rows)

    def _check_header(self, name, columns):
        for column in schema.required(name) if schema.is_declared(name) else COMPARISON.get(name, ()):
            if column not in columns:
                raise BundleError(f"{self.path / name}:1: no column `{column}`; run the suite again with this program version")

    def _row(self, name, line, fields):
        values, texts = {}, {}
        for column, text in fields.items():
            texts[column] = literal(text)
            if text == "":
                values[column] = None
                if not schema.may_be_empty(name, column):
                    self.fail(name, f"`{column}` is empty", line)
            elif schema.holds_words(name, column) or column in WORDS:
                self._check_id(name, line, column, text)
                values[column] = texts[column]
            else:
                values[column] = self._number(name, line, column, text, self._holds_numbers(name, column))
        return Row(name, line, values, texts)

    @staticmethod
    def _holds_numbers(name, column):
        return schema.holds_numbers(name, column) or name not in MIXED and column in COMPARISON.get(name, ())

    def _check_id(self, name, line, column, text):
        allowed = ID if column in IDS else NAME if column in NAMES else None
        if allowed and not allowed.fullmatch(text):
            self.fail(name, f"`{column}` is '{shown(text)}', which no suite takes for an id", line)

    def _number(self, name, line, column, text, strict):
        """The number, or the text where the column may hold words."""
        value = files.number(text)
        if value is None:
            if strict and not (column == "degree" and _SPAN.fullmatch(text)):
                self.fail(name, f"`{column}` is '{shown(text)}', a number was expected", line)
            return literal(text)
        if column == "degree" and not (0 <= value <= MOST_DEGREE and value == int(value)):
            self.fail(name, f"`{column}` is '{shown(text)}', a whole number up to {MOST_DEGREE} was expected", line)
        return value
