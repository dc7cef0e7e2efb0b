# SPDX-License-Identifier: MIT
"""The only way in: a bundle directory, its CSV files read by column name.

A file that is absent is a fact that a chapter can state; a file that is malformed is an error that names file and line. Nothing
is read that is not as it was written, unless a damaged bundle was asked for; then `damage` says what is wrong with it.
"""

import copy
import tomllib
from contextlib import contextmanager
from dataclasses import dataclass, replace

from . import files, schema
from .files import BundleError, shown
from .folder import ID, Folder
from .foreign import literal
from .rows import Missing, Row, Table

__all__ = ["Bundle", "BundleError", "Comparison", "Missing", "Row", "Study", "Table", "decided_by", "made_of"]

# What a calculation raises where rows are lacking that it counts on, and where a field is empty or no number makes sense.
LACKING = (ArithmeticError, LookupError, ValueError)
UNUSABLE = (*LACKING, AttributeError, RuntimeError, TypeError)


@dataclass(frozen=True)
class Study:
    """What a suite says of one of its studies."""

    id: str
    title: str
    kind: str
    suite: str  # the id of the suite; empty where suite.toml does not name the study
    printed: bool = False  # whether a source prints values of it


def _unstable(file):
    """The file of the rows that depend on a library, beside those of the digest."""
    return "unstable.csv" if file == "accuracy.csv" else file.replace(".csv", "_unstable.csv")


def _kind_of(file):
    """The kind of the studies that the rows of a file are of; None where other files say it."""
    return next((kind for kind in schema.kinds() if file in (f"{kind}.csv", _unstable(f"{kind}.csv"))), None)


@contextmanager
def made_of(bundle, part):
    """Around what computes a part of the report: fields that make no sense end in one line."""
    try:
        yield
    except BundleError:
        raise
    except UNUSABLE as error:
        raise BundleError(f"{bundle.path}: {part} cannot be made of its values ({type(error).__name__}: {shown(str(error))}); "
                          f"{bundle.advice()}") from error


@contextmanager
def decided_by(bundle, part):
    """The same around a part that may be left out: it is where rows are lacking."""
    try:
        with made_of(bundle, part):
            yield
    except BundleError as error:
        if isinstance(error.__cause__, LACKING):
            raise Missing(f"its rows do not suffice: {literal(shown(str(error.__cause__)))}") from error
        raise


class Comparison(Folder):
    """What `bezierbench compare` found between bundles."""

    writer = "bezierbench compare BUNDLE... --out"

    def __init__(self, path):
        super().__init__(path)
        for name in ("facts.csv", "comparison.csv", "standings.csv"):
            if self._bytes(name) is None:
                raise BundleError(f"{self.path / name}: missing; {self.advice()}")
        self.facts, self.rows, self.standings = map(self._csv, ("facts.csv", "comparison.csv", "standings.csv"))


class Bundle(Folder):
    """A bundle directory. Files are read, and checked, when the bundle is opened; `comparison` is a directory that
    `bezierbench compare` wrote about it, if any. With `damaged`, files that are not as they were written are read, too."""

    writer = "bezierbench run --out"

    def __init__(self, path, comparison=None, damaged=False):
        super().__init__(path)
        self.damage = []
        self._take_damage = damaged
        self._listed = {}
        self._listed = self._sums()
        self.info = self._json("bundle.json")
        self._check_info()
        self.machine = self._json("machine.json")
        self.suite = self._text("suite.toml")
        self.suites, self.studies = self._suites()  # {id: title} and {id: Study}
        self.tables = {name: self._csv(name) for name in self._tables()}
        self._add_unnamed()
        self.comparison = Comparison(comparison) if comparison else None

    def advice(self):
        return "run `bezierbench verify` on the bundle"

    def _damaged(self, name, what):
        if not self._take_damage:
            raise BundleError(f"{self.path / name}: {what}; restore it, or read the bundle as it is with --damaged")
        self.damage.append(f"{name} {what}")

    def _sums(self):
        if super()._bytes("bundle.json") is None:
            raise BundleError(f"{self.path / 'bundle.json'}: missing; this directory is not a bundle, or its run never "
                              "started: run `bezierbench run SUITE --out BUNDLE`")
        data = self._bytes(files.SUMS)
        if data is None:
            self._damaged(files.SUMS, "is missing")
            return {}
        try:
            return files.checksums(self.path / files.SUMS, data)
        except BundleError as error:
            if not self._take_damage:
                raise BundleError(f"{error}, or read the bundle as it is with --damaged") from None
            self._damaged(files.SUMS, "is not a list of checksums")
            return {}

    def _bytes(self, name):
        data = super()._bytes(name)
        if name == files.SUMS or self.damage[:1] and not self._listed:  # no sums to check by: said once
            return data
        if data is None and name in self._listed:
            self._damaged(name, "is missing")
        elif data is not None and name not in self._listed:
            self._damaged(name, f"is not in {files.SUMS}")
        elif data is not None and not files.fits(self._listed[name], data):
            self._damaged(name, f"is not what {files.SUMS} lists")
        return data

    def _tables(self):
        """The names of the tables that are there or should be."""
        present = {path.name for path in self.path.glob("*.csv")}
        for name in sorted({name for name in self._listed if name.endswith(".csv")} - present):
            self._damaged(name, "is missing")
        for name in sorted(present):
            if not ID.fullmatch(name):
                self.fail(literal(name), "is no name of a table")
        return sorted(present)

    def _check_info(self):
        files.check_version(self.path / "bundle.json", self.info)
        suites = self.info.setdefault("suites", {})
        ids = suites.setdefault("ids", []) if isinstance(suites, dict) else None
        if not isinstance(ids, list) or not all(isinstance(one, str) and ID.fullmatch(one) for one in ids):
            self.fail("bundle.json", "`suites` is not an object with the `ids` of suites")
        for key, kind in (("state", str), ("seed", (int, str))):
            if not isinstance(self.info.get(key, ""), kind):
                self.fail("bundle.json", f"`{key}` is neither text nor a number that a run writes")

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
        """Rows of every method against the exact value, of the studies of these suites."""
        table = self.judged().of_suite(*suites)
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

    def title(self, study):
        """What the suite calls that study; its id where the bundle does not say."""
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
            titles = {head["id"]: head.get("title", "") for head, _ in suites if "id" in head}
            studies = [Study(study["id"], study.get("title", ""), study.get("kind", ""), head.get("id", ""), bool(study.get("published")))
                       for head, members in suites for study in members]
            for name, title in [*titles.items(), *((study.id, study.title) for study in studies)]:
                self._check_title(name, title)
            if not all(isinstance(study.kind, str) and ID.fullmatch(study.kind or "none") for study in studies):
                self.fail("suite.toml", "the kind of a study is no word")
        except tomllib.TOMLDecodeError as error:
            self.fail("suite.toml", str(error))
        except BundleError:
            raise
        except UNUSABLE:
            self.fail("suite.toml", "its studies are no tables with an id")
        return ({name: literal(title) or name for name, title in titles.items()},
                {one.id: replace(one, title=literal(one.title) or one.id) for one in studies})

    def _check_title(self, name, title):
        if not (isinstance(name, str) and ID.fullmatch(name) and isinstance(title, str)):
            self.fail("suite.toml", f"a suite or study has the id '{shown(str(name))}' or a title that no suite takes")

    def _add_unnamed(self):
        """Studies that suite.toml does not name follow those that it does; tables learn the suites of all."""
        for file, table in self.tables.items():
            named = dict.fromkeys(row["study"] for row in table.rows) if "study" in table.columns else {}
            unnamed = [study for study in named if study is not None and study not in self.studies]
            if unnamed and (kind := _kind_of(file)):
                self.studies.update((study, Study(study, study, kind, "")) for study in unnamed)
            table.suite_of = {study.id: study.suite for study in self.studies.values()}
