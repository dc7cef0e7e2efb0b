# SPDX-License-Identifier: MIT
"""A directory of data files, as some command wrote it: the files read, decoded and taken apart, or one line about what is wrong."""

import csv
import json
import re
from pathlib import Path

from . import regular_file, schema
from .columns import COMPARISON, ID, IDS, MIXED, MOST_DEGREE, NAME, NAMES, WORDS
from .foreign import literal, literal_json, shown
from .rows import Row, Table, parse_number

MOST_ROWS = 200_000
MOST_STUDIES = 1000  # of a table; each has tables and lines of its own on the page
_SPAN = re.compile(r"\d{1,4}\.\.\d{1,4}", re.ASCII)  # of degrees: a count of table 2.2 is over all of them


class BundleError(Exception):
    """The bundle cannot be read; the message is the one line that the user sees."""


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
        path = self.path / name
        try:
            return regular_file.read(path)
        except FileNotFoundError:
            return None
        except regular_file.Refused as error:
            raise BundleError(f"{path}: {error.strerror}") from None
        except OSError as error:
            raise BundleError(f"{path}: {error.strerror}; check that it is a readable file") from None

    def _text(self, name):
        data = self._bytes(name)
        try:
            return None if data is None else data.decode("utf-8")
        except UnicodeDecodeError as error:
            self.fail(name, f"byte {error.start} is not UTF-8")

    def _json(self, name):
        text = self._text(name)
        if text is None:
            return None
        try:
            value = json.loads(text)
        except json.JSONDecodeError as error:
            self.fail(name, error.msg, f"{error.lineno}:{error.colno}")
        except (ValueError, RecursionError):  # a number of thousands of digits, brackets thousands deep
            self.fail(name, "a number or a nesting beyond all use")
        if not isinstance(value, dict):
            self.fail(name, "not a JSON object")
        return literal_json(value)

    def _csv(self, name):
        """The table of a file that is there."""
        text = self._text(name)
        if "\0" in text:
            self.fail(name, "holds a NUL byte")
        reader = csv.reader(text.splitlines(keepends=True), strict=True)
        rows = []
        try:
            columns = next(reader, None)
            self._check_header(name, columns)
            for fields in reader:
                if len(fields) != len(columns):
                    self.fail(name, f"{len(fields)} fields where the header has {len(columns)}", reader.line_num)
                if len(rows) == MOST_ROWS:
                    self.fail(name, f"more than {MOST_ROWS} rows", reader.line_num)
                rows.append(self._row(name, reader.line_num, dict(zip(columns, fields))))
        except csv.Error as error:
            self.fail(name, str(error), reader.line_num)
        if len({row["study"] for row in rows}) > MOST_STUDIES:
            self.fail(name, f"more than {MOST_STUDIES} studies")
        return Table(name, columns, rows)

    def _check_header(self, name, columns):
        if not columns:
            self.fail(name, "empty, a header line was expected", 1)
        if len(set(columns)) != len(columns):
            self.fail(name, "a column stands twice in the header", 1)
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
        value = parse_number(text)
        if value is None:
            if strict and not (column == "degree" and _SPAN.fullmatch(text)):
                self.fail(name, f"`{column}` is '{shown(text)}', a number was expected", line)
            return literal(text)
        if column == "degree" and not (0 <= value <= MOST_DEGREE and value == int(value)):
            self.fail(name, f"`{column}` is '{shown(text)}', a whole number up to {MOST_DEGREE} was expected", line)
        return value
