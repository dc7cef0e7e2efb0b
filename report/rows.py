# SPDX-License-Identifier: MIT
"""Rows of a CSV file, read by column name: numbers as floats, words as text, empty fields as None."""

import math
from dataclasses import dataclass, field


class Missing(Exception):
    """The bundle is sound but does not have the rows that a finding, figure or chapter requires."""


@dataclass(frozen=True)
class Row:
    """One line of a CSV file: numbers as floats, words as text, empty fields as None."""

    file: str
    line: int
    values: dict = field(hash=False)
    texts: dict = field(hash=False)

    def __getitem__(self, column):
        """The value; `interval` is (t_min, t_max)."""
        return (self.values.get("t_min"), self.values.get("t_max")) if column == "interval" else self.values.get(column)

    def text(self, column):
        """The field as it stands in the file."""
        return self.texts.get(column, "")

    def number(self, column):
        """A finite number, or Missing: what a sentence can be built on."""
        value = self.values.get(column)
        if not isinstance(value, float) or not math.isfinite(value):
            raise Missing(f"`{column}` is {self.text(column) or 'empty'} in `{self.file}`, line {self.line}")
        return value


class Table:
    """The rows of one CSV file, in file order."""

    def __init__(self, file, columns, rows, suite_of=None):
        self.file = file
        self.columns = columns
        self.rows = rows
        self.suite_of = suite_of or {}  # by study

    def select(self, **key):
        """Rows whose columns equal the given values; a tuple, list or set means any of its members."""
        return [row for row in self.rows if fits(row, key)]

    def some(self, **key):
        """As select, but Missing where there is none."""
        rows = self.select(**key)
        if not rows:
            raise Missing(f"`{self.file}` has no row with {_describe(key)}")
        return rows

    def one(self, **key):
        """The only row that fits; Missing where there is none or more than one."""
        rows = self.some(**key)
        if len(rows) > 1:
            raise Missing(f"`{self.file}` has {len(rows)} rows with {_describe(key)} where one is meant")
        return rows[0]

    def of_suite(self, *suites):
        """The rows of the studies of these suites; Missing where there are none."""
        rows = [row for row in self.rows if self.suite_of.get(row["study"]) in suites]
        if not rows:
            raise Missing(f"`{self.file}` has no study of the suite `{'` or `'.join(suites)}`")
        return self.with_rows(rows)

    def with_rows(self, rows):
        """A table of these rows instead."""
        return Table(self.file, self.columns, rows, self.suite_of)

    def distinct(self, column, **key):
        """The different values of a column, in order of first appearance."""
        return distinct(self.select(**key), column)


def fits(row, key):
    """Whether the columns of a row equal the values of {column: value}; a tuple of values means any of them, except for `interval`."""
    return all(row[c] in v if isinstance(v, (tuple, list, set, frozenset)) and c != "interval" else row[c] == v for c, v in key.items())


def distinct(rows, column):
    """The different values of a column, in order of first appearance."""
    return list(dict.fromkeys(row[column] for row in rows))


def grouped(rows, *columns):
    """{value of the column: rows}, or of several columns {values: rows}, in order of first appearance."""
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[c] for c in columns) if len(columns) > 1 else row[columns[0]], []).append(row)
    return groups


def _describe(key):
    def words(value):
        if isinstance(value, (tuple, list, set, frozenset)):
            return " or ".join(map(words, value))
        return f"{value:g}" if isinstance(value, (int, float)) else f"`{value}`"
    return ", ".join(f"{column} {words(value)}" for column, value in key.items())
