# SPDX-License-Identifier: MIT
"""The only way in: a bundle directory, its CSV files read by column name.

A file that is absent is a fact that a chapter can state; a file that is malformed is an error that names file and line.
"""

import csv
import json
import math
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

SCHEMA_VERSION = 1

# Columns that are words wherever they occur, even where a value looks like a number (study 2.2, table 2.4).
TEXT = frozenset(
    "study accuracy_study table curve method conversion scalar generator baseline status statistic verdict note tier mode "
    "relative_to target goal_met quality checked pareto id problem form bound bit_stable flops citation worst_id search_id t "
    "coefficients weights placement spacing data kind bundle against file column fact cpu compiler machine "
    "normalised_verdict".split())

_ACCURACY = ("study curve method scalar dimension degree coordinate_range t_min t_max generator trials baseline status "
             "mean_error max_error mean_error_u max_error_u bound_u bound_violations non_finite").split()
_SCORECARD = ("table curve method statistic degree coordinate_range t_min t_max published ours_median ours_p05 ours_p95 "
              "verdict note").split()
_PROJECTION = ("study method dimension degree coordinate_range generator placement trials status missed max_error_eps max_t_error "
               "non_converged").split()
_ARC_LENGTH = ("study curve method scalar dimension degree coordinate_range t_min t_max generator tolerance trials status "
               "mean_relative max_relative mean_evaluations non_converged broken_promises non_finite").split()

# What the report reads from each file. Files that are not named here can be read too; their types are inferred.
REQUIRED = {
    "accuracy.csv": _ACCURACY,
    "unstable.csv": _ACCURACY,
    "scorecard.csv": _SCORECARD + ["continuous_median", "against_exact"],
    "scorecard_timing.csv": _SCORECARD + ["prepared_median"],
    "conversion.csv": ("study conversion degree coordinate_range generator trials mean_error max_error "
                       "within_1e-5 within_1e-3 within_0.1").split(),
    "derivative.csv": ("study curve method scalar dimension degree coordinate_range t_min t_max generator order trials status "
                       "mean_error max_error mean_error_u max_error_u bound_u bound_violations non_finite").split(),
    "arc_length.csv": _ARC_LENGTH,
    "arc_length_unstable.csv": _ARC_LENGTH,
    "inverse_arc_length.csv": ("study curve method scalar dimension degree coordinate_range t_min t_max generator tolerance trials "
                               "status mean_relative max_relative max_t_error mean_iterations max_iterations mean_evaluations "
                               "non_converged broken_promises outside non_finite").split(),
    "spacing.csv": "study dimension degree coordinate_range generator trial spacing index t x y share gap".split(),
    "projection.csv": _PROJECTION,
    "projection_unstable.csv": _PROJECTION,
    "interpolation.csv": ("study method scalar dimension degree coordinate_range generator points trials status max_error_u max_data_u "
                          "max_c0_u max_c1_u max_c2_u max_natural_u bound_u bound_violations non_finite").split(),
    "fitting.csv": ("study curve method scalar dimension degree coordinate_range generator data points tolerance trials status "
                    "mean_segments one_segment max_error max_error_over_tolerance max_iterations non_converged broken_promises "
                    "understated non_finite").split(),
    "fitting_example.csv": "study data tolerance method segment index x y".split(),
    "timing.csv": "study curve method degree mode median_ns low_ns high_ns checked".split(),
    "complexity.csv": "study curve method mode first_degree last_degree exponent exponent_low exponent_high claimed verdict".split(),
    "pareto.csv": ("study accuracy_study curve method scalar dimension degree mode ns ns_low ns_high observed_max_u bound_u "
                   "quality pareto").split(),
    "roofline.csv": ("study curve method scalar dimension degree target median_ns peak_gflops mixed_peak_gflops share_of_peak "
                     "goal_share goal_ns goal_met quality checked t_min t_max").split(),
    "audit.csv": "study curve tier degree generator trials".split(),
    "search.csv": ("search_id study curve method scalar dimension degree coordinate_range t_min t_max generator trials budget "
                   "status sampled_error_u searched_error_u bound_u error t coefficients").split(),
    "worst.csv": ("worst_id study curve method scalar dimension degree coordinate_range t_min t_max generator trial error "
                  "error_u t coefficients").split(),
    "comparison.csv": ("kind study method degree mode a b ratio ratio_low ratio_high verdict against bundle file column "
                       "quality normalised normalised_low normalised_high normalised_verdict rank_a rank_b").split(),
    "facts.csv": "against bundle fact a b".split(),
    "standings.csv": "rank bundle cpu compiler machine accuracy_rows_differing timings mean_ratio mean_normalised".split(),
    "methods.csv": "id problem form min_degree max_degree bound bit_stable flops citation".split(),
}

# Columns that say what a row is about; a row of the files above without one of them is malformed.
KEYS = frozenset("study accuracy_study pareto table curve method conversion scalar dimension degree generator order points tolerance "
                 "trials baseline status statistic tier mode id search_id worst_id target placement spacing data".split())
# The exceptions: a sentinel is timed over all degrees of a study; data that curves are fitted to are no method's.
MAY_BE_EMPTY = frozenset({("timing.csv", "degree"), ("fitting_example.csv", "method")})
# Tables in which it depends on the row which columns apply and whether they hold a number.
MIXED = frozenset({"comparison.csv", "facts.csv"})

_DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|[+-]?inf|nan", re.ASCII)
_HEX = re.compile(r"[+-]?0[xX][0-9a-fA-F]*\.?[0-9a-fA-F]*([pP][+-]?\d+)?", re.ASCII)


class BundleError(Exception):
    """The bundle cannot be read; the message is the one line that the user sees."""


class Missing(Exception):
    """The bundle is sound but does not hold the rows that a finding, figure or chapter needs."""


def parse_number(text):
    """A float from decimal or C hexadecimal notation; None where `text` is neither."""
    if _DECIMAL.fullmatch(text):
        return float(text)
    if _HEX.fullmatch(text):
        try:
            return float.fromhex(text)
        except (ValueError, OverflowError):
            return None
    return None


@dataclass(frozen=True)
class Row:
    """One line of a CSV file: numbers as floats, words as text, empty fields as None."""

    file: str
    line: int
    values: dict = field(hash=False)
    texts: dict = field(hash=False)

    def __getitem__(self, column):
        return self.values.get(column)

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

    def __init__(self, file, columns, rows):
        self.file = file
        self.columns = columns
        self.rows = rows

    def select(self, **key):
        """Rows whose columns equal the given values; a tuple, list or set means any of its members."""
        def fits(row):
            return all(row[c] in v if isinstance(v, (tuple, list, set, frozenset)) else row[c] == v
                       for c, v in key.items())
        return [row for row in self.rows if fits(row)]

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

    def starting(self, prefix):
        """The rows of the studies whose id starts with `prefix`, or one of a tuple; Missing where there are none."""
        rows = [row for row in self.rows if (row["study"] or "").startswith(prefix)]
        if not rows:
            words = prefix if isinstance(prefix, str) else "` or `".join(prefix)
            raise Missing(f"`{self.file}` has no study whose id starts with `{words}`")
        return Table(self.file, self.columns, rows)

    def distinct(self, column, **key):
        """The different values of a column, in order of first appearance."""
        return list(dict.fromkeys(row[column] for row in self.select(**key)))


def _describe(key):
    def words(value):
        if isinstance(value, (tuple, list, set, frozenset)):
            return " or ".join(map(words, value))
        return f"{value:g}" if isinstance(value, (int, float)) else f"`{value}`"
    return ", ".join(f"{column} {words(value)}" for column, value in key.items())


class Folder:
    """A directory of data files, as some command wrote it."""

    writer = ""  # the command

    def __init__(self, path):
        self.path = Path(path)
        if not self.path.is_dir():
            raise BundleError(f"{self.path}: no such directory; give the directory that `{self.writer}` wrote")
        self.name = self.path.resolve().name

    def _read(self, name):
        path = self.path / name
        try:
            return path.read_bytes().decode("utf-8")
        except FileNotFoundError:
            return None
        except UnicodeDecodeError as error:
            raise BundleError(f"{path}: byte {error.start} is not UTF-8; {self.advice()}") from None
        except OSError as error:
            raise BundleError(f"{path}: {error.strerror}; check that it is a readable file") from None

    def advice(self):
        """What to do about a damaged file."""
        return f"write it again with `{self.writer}`"

    def _csv(self, path):
        text = self._read(path.name)
        if "\0" in text:
            raise BundleError(f"{path}: holds a NUL byte; {self.advice()}")
        reader = csv.reader(text.splitlines(keepends=True), strict=True)
        rows = []
        try:
            columns = next(reader, None)
            if not columns:
                raise BundleError(f"{path}:1: empty, a header line was expected; {self.advice()}")
            for column in REQUIRED.get(path.name, ()):
                if column not in columns:
                    raise BundleError(f"{path}:1: no column `{column}`; run the suite again with this program version")
            for fields in reader:
                if len(fields) != len(columns):
                    raise BundleError(f"{path}:{reader.line_num}: {len(fields)} fields where the header has "
                                      f"{len(columns)}; {self.advice()}")
                rows.append((reader.line_num, dict(zip(columns, fields))))
        except csv.Error as error:
            raise BundleError(f"{path}:{reader.line_num}: {error}; {self.advice()}") from None
        return Table(path.name, columns, [self._row(path, line, fields) for line, fields in rows])

    def _row(self, path, line, fields):
        strict = () if path.name in MIXED else REQUIRED.get(path.name, ())
        values = {}
        for column, text in fields.items():
            value = None if text == "" else text
            if value is None and column in strict and column in KEYS and (path.name, column) not in MAY_BE_EMPTY:
                raise BundleError(f"{path}:{line}: `{column}` is empty; {self.advice()}")
            if value is not None and column not in TEXT:
                value = parse_number(text)
                if value is None:
                    # A span such as the 1..20 of table 2.2 stays a word.
                    if column in strict and not (column == "degree" and ".." in text):
                        raise BundleError(f"{path}:{line}: `{column}` is '{text}', a number was expected; "
                                          f"{self.advice()}")
                    value = text
            values[column] = value
        return Row(path.name, line, values, fields)


class Comparison(Folder):
    """What `bezierbench compare` found between bundles."""

    writer = "bezierbench compare BUNDLE... --out"

    def __init__(self, path):
        super().__init__(path)
        for name in ("facts.csv", "comparison.csv", "standings.csv"):
            if not (self.path / name).is_file():
                raise BundleError(f"{self.path / name}: missing; {self.advice()}")
        self.facts, self.rows, self.standings = (self._csv(self.path / name)
                                                 for name in ("facts.csv", "comparison.csv", "standings.csv"))


class Bundle(Folder):
    """A bundle directory. Files are read, and checked, when the bundle is opened; `comparison` is a directory that
    `bezierbench compare` wrote about it, if any."""

    writer = "bezierbench run --out"

    def __init__(self, path, comparison=None):
        super().__init__(path)
        self.info = self._json("bundle.json")
        if self.info is None:
            raise BundleError(f"{self.path / 'bundle.json'}: missing; this directory is not a bundle, or its run never "
                              "started: run `bezierbench run SUITE --out BUNDLE`")
        version = self.info.get("schema_version")
        if version != SCHEMA_VERSION:
            raise BundleError(f"{self.path / 'bundle.json'}: schema_version is {version!r}, this report reads "
                              f"{SCHEMA_VERSION}; run the bundle again or use the report of its program version")
        suites = self.info.get("suites", {})
        if not isinstance(suites, dict) or not all(isinstance(s, str) for s in suites.get("ids", [])):
            raise BundleError(f"{self.path / 'bundle.json'}: `suites` is not an object with `ids`; run `bezierbench verify` "
                              "on the bundle")
        self.machine = self._json("machine.json")
        self.suite = self._text("suite.toml")
        self.titles = self._titles()
        self.tables = {p.name: self._csv(p) for p in sorted(self.path.glob("*.csv"))}
        self.comparison = Comparison(comparison) if comparison else None

    def advice(self):
        return "run `bezierbench verify` on the bundle"

    def __contains__(self, file):
        return file in self.tables

    def __getitem__(self, file):
        """The table of a file; Missing where the bundle has none."""
        if file not in self.tables:
            raise Missing(f"the bundle has no `{file}`")
        return self.tables[file]

    def judged(self, file="accuracy.csv"):
        """Rows of every method: those of the digest and those that depend on a library."""
        unstable = "unstable.csv" if file == "accuracy.csv" else file.replace(".csv", "_unstable.csv")
        tables = [self.tables[f] for f in (file, unstable) if f in self.tables]
        if not tables:
            raise Missing(f"the bundle has no `{file}`")
        return Table(file, tables[0].columns, [row for t in tables for row in t.rows])

    def exact(self, prefix):
        """Rows of every method against the exact value, of the studies whose id starts with `prefix`."""
        table = self.judged().starting(prefix)
        return Table(table.file, table.columns, table.some(baseline="exact"))

    def has_suite(self, suite):
        """Whether any file holds a study of that suite: studies are named after the suite that they stand in."""
        return any((row["study"] or "").startswith(f"{suite}-") for table in self.tables.values() if "study" in table.columns
                   for row in table.rows)

    def title(self, study):
        """What the suite calls that study; its id where the bundle does not say."""
        return self.titles.get(study, study)

    def accuracy(self, **key):
        """The accuracy row, in double and in the plane, that fits."""
        return self.judged().one(scalar="double", dimension=2, **key)

    def _titles(self):
        """Of one suite or of several, as the program resolves them."""
        try:
            resolved = tomllib.loads(self.suite or "")
        except tomllib.TOMLDecodeError as error:
            raise BundleError(f"{self.path / 'suite.toml'}: {error}; {self.advice()}") from None
        suites = resolved.get("suites", [resolved])
        return {study["id"]: study["title"] for suite in suites for study in suite.get("study", []) if study.get("title")}

    def _text(self, name):
        return self._read(name)

    def _json(self, name):
        text = self._read(name)
        if text is None:
            return None
        path = self.path / name
        try:
            value = json.loads(text)
        except json.JSONDecodeError as error:
            raise BundleError(f"{path}:{error.lineno}:{error.colno}: {error.msg}; run `bezierbench verify` on the "
                              "bundle") from None
        if not isinstance(value, dict):
            raise BundleError(f"{path}: not a JSON object; run `bezierbench verify` on the bundle")
        return value
