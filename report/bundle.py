# SPDX-License-Identifier: MIT
"""The only way in: a bundle directory, its CSV files read by column name.

A file that is absent is a fact that a chapter can state; a file that is malformed, or is not as it was written, is an error that names
file and line.
"""

import copy
import re
import tomllib
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from . import files, schema
from .files import BundleError, shown
from .inline import visible, visible_json
from .rows import Missing, Row, Table

__all__ = ["Bundle", "BundleError", "Comparison", "Missing", "Row", "Study", "Table", "decided_by", "made_of"]

# What a calculation raises without rows that it requires, and what one raises with values that make no sense.
WITHOUT_ROWS = (ArithmeticError, LookupError, ValueError)
UNUSABLE = (*WITHOUT_ROWS, AttributeError, RuntimeError, TypeError)
# The columns of what `bezierbench compare` writes that the report reads, and those that are words, even where a value looks like a
# number (study 2.2).
COMPARISON = {
    "comparison.csv": ("kind study method degree mode a b ratio ratio_low ratio_high verdict against bundle file column "
                       "quality normalised normalised_low normalised_high rank_a rank_b").split(),
    "facts.csv": "against bundle fact a b".split(),
    "standings.csv": "rank bundle cpu compiler machine accuracy_rows_differing timings mean_ratio mean_normalised".split(),
}
WORDS = frozenset("kind study table form method scalar mode generator baseline verdict against bundle file column quality "
                  "fact cpu compiler machine".split())
# Ids as a suite has to write them; they stand in names of files and in commands that a reader copies.
ID = re.compile(r"[A-Za-z0-9._:+-]+")
IDS = frozenset("study accuracy_study worst_id search_id guarantee_id method conversion scalar generator mode".split())
SPAN = re.compile(r"\d+\.\.\d+")  # of degrees: a count of table 2.2 is over all of them


@dataclass(frozen=True)
class Study:
    """What a suite states about one of its studies."""

    id: str
    title: str
    kind: str
    suite: str  # the id of the suite; empty where suite.toml does not name the study
    printed: bool = False  # whether a source prints values of it
    on_sets: bool = False  # whether its curves are those of sets


def _unstable(file):
    """The file of the rows that depend on a library, next to that of the digested ones."""
    return "unstable.csv" if file == "accuracy.csv" else file.replace(".csv", "_unstable.csv")


@contextmanager
def made_of(bundle, part):
    """Around the computation of a part of the report: fields that make no sense end in one line."""
    try:
        yield
    except BundleError:
        raise
    except UNUSABLE as error:
        raise BundleError(f"{bundle.path}: {part} cannot be computed from its values ({type(error).__name__}: {shown(str(error))}); "
                          f"{bundle.advice}") from error


@contextmanager
def decided_by(bundle, part):
    """The same around a part that is left out where rows are missing."""
    try:
        with made_of(bundle, part):
            yield
    except BundleError as error:
        if isinstance(error.__cause__, WITHOUT_ROWS):
            raise Missing(f"its rows do not suffice: {visible(shown(str(error.__cause__)))}") from error
        raise


class Folder:
    """A directory of data files, as some command wrote it."""

    writer = "bezierbench run --out"
    advice = "run `bezierbench verify` on the bundle"  # about a malformed file

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise BundleError(f"{self.path}: no such directory; give the directory that `{self.writer}` wrote")
        self.name = visible(self.path.resolve().name)

    def fail(self, name, what, line=None):
        """Ends the reading of a file."""
        raise BundleError(f"{self.path / name}{'' if line is None else f':{line}'}: {what}; {self.advice}")

    def _bytes(self, name):
        """None where there is no such file."""
        try:
            return files.content(self.path / name)
        except files.NoFile:
            return None

    def _csv(self, name):
        """The table of a file that is there."""
        columns, lines = files.table(self.path / name, self._bytes(name))
        for column in schema.required(name) if schema.is_declared(name) else COMPARISON.get(name, ()):
            if column not in columns:
                raise BundleError(f"{self.path / name}:1: no column `{column}`; run the suite again with this program version")
        return Table(name, columns, [self._row(name, line, dict(zip(columns, fields))) for line, fields in lines])

    def _row(self, name, line, fields):
        values, texts = {}, {column: visible(text) for column, text in fields.items()}
        for column, text in fields.items():
            types = schema.types(name, column)
            number = None if types and "number" not in types or column in WORDS else files.number(text)
            if column in IDS and text and not ID.fullmatch(text):
                self.fail(name, f"`{column}` is '{shown(text)}', which is not an id", line)
            if text == "" and types and "empty" not in types:
                self.fail(name, f"`{column}` is empty", line)
            if text and number is None and "number" in types and "word" not in types and not (column == "degree" and SPAN.fullmatch(text)):
                self.fail(name, f"`{column}` is '{shown(text)}', a number was expected", line)
            values[column] = None if text == "" else texts[column] if number is None else number
        return Row(name, line, values, texts)


class Comparison(Folder):
    """What `bezierbench compare` found between bundles."""

    writer = "bezierbench compare BUNDLE... --out"
    advice = f"write it again with `{writer}`"

    def __init__(self, path):
        super().__init__(path)
        for name in COMPARISON:
            if self._bytes(name) is None:
                raise BundleError(f"{self.path / name}: missing; {self.advice}")
        self.facts, self.rows, self.standings = map(self._csv, ("facts.csv", "comparison.csv", "standings.csv"))


class Bundle(Folder):
    """A bundle directory, read and compared with its checksums when it is opened; `comparison` is a directory that `bezierbench compare` wrote
    about it, if any."""

    def __init__(self, path, comparison=None):
        super().__init__(path)
        self._listed = self._sums()
        self.info = self._json("bundle.json")
        files.check_version(self.path / "bundle.json", self.info)
        self.machine = self._json("machine.json")
        data = self._bytes("suite.toml")
        self.suite = None if data is None else files.text(self.path / "suite.toml", data)
        self.suites, self.studies = self._suites()  # {id: title} and {id: Study}
        self.tables = {name: self._csv(name) for name in sorted({path.name for path in self.path.glob("*.csv")} | {n for n in self._listed if n.endswith(".csv")})}
        self._add_unnamed()
        self.comparison = Comparison(comparison) if comparison else None

    def _sums(self):
        if super()._bytes("bundle.json") is None:
            raise BundleError(f"{self.path / 'bundle.json'}: missing; this directory is not a bundle, or its run never "
                              "started: run `bezierbench run SUITE --out BUNDLE`")
        data = super()._bytes(files.SUMS)
        if data is None:
            self.fail(files.SUMS, "is missing")
        return files.checksums(self.path / files.SUMS, data)

    def _bytes(self, name):
        data = super()._bytes(name)
        if data is None and name in self._listed:
            self.fail(name, "is missing")
        if data is not None and name not in self._listed:
            self.fail(visible(name), f"is not in {files.SUMS}")
        if data is not None and not files.fits(self._listed[name], data):
            self.fail(name, f"is not what {files.SUMS} lists")
        return data

    def _json(self, name):
        data = self._bytes(name)
        return None if data is None else visible_json(files.document(self.path / name, data))

    def __contains__(self, file):
        return file in self.tables

    def __getitem__(self, file):
        """The table of a file; Missing where the bundle has none."""
        if file not in self.tables:
            raise Missing(f"the bundle has no `{file}`")
        return self.tables[file]

    def judged(self, file="accuracy.csv"):
        """Rows of every method: those of the digest and those that depend on a library."""
        tables = [self.tables[f] for f in (file, _unstable(file)) if f in self.tables]
        if not tables:
            raise Missing(f"the bundle has no `{file}`")
        return tables[0].with_rows([row for t in tables for row in t.rows])

    def exact(self, *suites):
        """Rows of every method against the exact value, of the studies of these suites, or of all."""
        table = self.judged().of_suite(*suites) if suites else self.judged()
        return table.with_rows(table.some(baseline="exact"))

    def has_suite(self, suite):
        """Whether any file holds a row of that suite."""
        return any(self.studies[study].suite == suite for study in self.studied())

    def studied(self):
        """The ids of the studies that some file holds a row of, in the order of suite.toml."""
        there = {row["study"] for table in self.tables.values() if "study" in table.columns for row in table.rows}
        return [study for study in self.studies if study in there]

    def only(self, studies):
        """The bundle as if it had no other studies than these."""
        part = copy.copy(self)
        part.tables = {name: table.with_rows([row for row in table.rows if row["study"] in studies])
                       if "study" in table.columns else table for name, table in self.tables.items()}
        return part

    def drawn(self):
        """The bundle without the studies of curve sets."""
        return self.only({study.id for study in self.studies.values() if not study.on_sets})

    def title(self, study):
        """The title of that study in its suite; its id where the bundle has none."""
        return self.studies[study].title if study in self.studies else study

    def accuracy(self, **key):
        """The accuracy row, in double and in the plane, that fits."""
        return self.judged().one(scalar="double", dimension=2, **key)

    def _suites(self):
        """({suite: title}, {study: Study}) of one suite or of several, as the program resolves them."""
        try:
            resolved = tomllib.loads(self.suite or "")
            suites = [(one.get("suite", one) if one is resolved else one, one.get("study", []))
                      for one in resolved.get("suites", [resolved])]
            titles = {head["id"]: visible(head.get("title", "")) or head["id"] for head, _ in suites if "id" in head}
            studies = [Study(one["id"], visible(one.get("title", "")) or one["id"], one.get("kind", ""), head.get("id", ""), bool(one.get("published")), bool(one.get("curves")))
                       for head, members in suites for one in members]
        except tomllib.TOMLDecodeError as error:
            self.fail("suite.toml", str(error))
        except UNUSABLE:
            self.fail("suite.toml", "a study is not a table with an id, a title and a kind")
        for name in (*titles, *(name for one in studies for name in (one.id, one.kind or "none"))):
            if not (isinstance(name, str) and ID.fullmatch(name)):
                self.fail("suite.toml", f"'{shown(str(name))}' is not an id")
        return titles, {one.id: one for one in studies}

    def _add_unnamed(self):
        """Studies that suite.toml does not name follow those that it does; tables learn the suites of all."""
        for file, table in self.tables.items():
            kind = next((kind for kind in schema.kinds() if file in (f"{kind}.csv", _unstable(f"{kind}.csv"))), None)
            if kind and "study" in table.columns:
                self.studies.update((study, Study(study, study, kind, "")) for study in table.distinct("study") if study and study not in self.studies)
        for table in self.tables.values():
            table.suite_of = {study.id: study.suite for study in self.studies.values()}
