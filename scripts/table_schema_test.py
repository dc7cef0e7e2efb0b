#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Checks the CSV tables, bundle.json and machine.json of bundles against their schemas, and the schemas against them.

table_schema_test.py PROGRAM    checks a run of PROGRAM with every kind of study, and the committed bundles
"""
import copy
import csv
import functools
import json
import re
import subprocess
import sys
import tempfile
import unittest
from decimal import Decimal
from pathlib import Path

import jsonschema

ROOT = Path(__file__).resolve().parent.parent
SCHEMAS = ROOT / "experiments/bundle/schema"
SCHEMA = json.loads((SCHEMAS / "tables.schema.json").read_text(encoding="utf-8"))
COMMITTED = sorted(path.parent for path in ROOT.glob("results/*/bundle.json"))
# Only methods of other libraries write these tables, and external methods that fail.
OF_OTHERS = {"arc_length_unstable.csv", "untimed.csv"}
PROGRAM = Path(sys.argv.pop(1)).resolve()

INTEGER = re.compile(r"-?(0|[1-9][0-9]*)")
DECIMAL = re.compile(r"-?[0-9]+(\.[0-9]+)?(e[+-][0-9]+)?")

# Studies that give every table and fields that are rarely filled: degrees that a method does not support, weights, both
# scalar types, printed cells.
REPORT = 'coordinate_range = [1e6]\ngenerator = ["report"]\npublished = "report_tables.csv"'
STUDIES = {
    "2.3.1-bezier": ("accuracy", "bernstein", 'degree = [4, 300]\nscalar = ["double", "float"]\nbaseline = ["exact", "direct"]\n'
                     'methods = ["direct", "direct_pow", "differences:horner"]\ntrials = 9\ndecomposed_trials = 9\n' + REPORT),
    "weights": ("accuracy", "rational", 'degree = [3]\nmethods = ["direct"]\ntrials = 9'),
    "2.2": ("conversion", "bernstein", 'degree = [3, 300]\nmethods = ["factorial+forward_substitution"]\ntrials = 9'),
    "worst": ("search", "rational", 'degree = [3]\nmethods = ["direct"]\ntrials = 5\nbudget = 5'),
    "derivative": ("derivative", "bernstein", "degree = [3]\norder = [1]\ntrials = 5"),
    "length": ("arc_length", "bernstein", "degree = [3]\ntolerance = [1e-3]\ntrials = 2"),
    "at-length": ("inverse_arc_length", "bernstein", "degree = [3]\ntolerance = [1e-3]\ntrials = 2"),
    "projection": ("projection", "bernstein", "degree = [3, 4]\ntrials = 2"),
    "spline": ("interpolation", "bernstein", "points = [3]\ntrials = 2"),
    "fit": ("fitting", "bernstein", "degree = [3]\npoints = [5]\ntolerance = [1e-2]\ntrials = 2"),
    "split": ("subdivision", "bernstein", "degree = [3]\ntrials = 2"),
    "split-weights": ("subdivision", "rational", 'degree = [3]\ngenerator = ["weights_mild"]\ntrials = 2'),
    "bspline": ("bspline", "bernstein", "degree = [3]\ntrials = 2"),
    "grid": ("grid", "bernstein", "degree = [3]\npoints = [5]\ntrials = 2"),
    "flatten": ("flattening", "bernstein", "degree = [3, 5]\ntolerance = [1e-2]\ntrials = 3"),
    "boxes": ("bounds", "bernstein", "degree = [3]\ntrials = 2"),
    "roots": ("roots", "bernstein", "degree = [3]\ntrials = 2"),
    "easing": ("easing", "bernstein", "degree = [3]\ntrials = 2"),
    "easing-every": ("easing_floats", "bernstein", 'curves = ["named#css_ease"]\nmethods = ["easing_halley"]\nt_interval = [[0.5, 0.5001]]'),
    "hard": ("hard_cases", "power", 'scalar = ["double", "float"]\ntrials = 200\nkept = 2'),
    "keeps": ("guarantees", "bernstein", 'degree = [1]\nmethods = ["de_casteljau*", "direct_pow"]\ntrials = 20\nbudget = 200'),
    "every": ("exhaustive", "bernstein", 'curves = ["named#css_ease", "named#wilkinson_3"]\nmethods = ["de_casteljau"]\nt_interval = [[0.5, 0.5001]]'),
    "2.4-bezier": ("timing", "bernstein", 'degree = [2, 3, 4]\nmethods = ["direct", "de_casteljau"]\nmodes = ["one_shot"]\n' + REPORT),
}


def suite():
    studies = (f'[[study]]\nid = "{name}"\nkind = "{kind}"\ncurve = "{curve}"\n{rest}\n' for name, (kind, curve, rest) in STUDIES.items())
    return 'schema_version = 1\n[suite]\nid = "s"\ntitle = "A little of everything"\n' + "".join(studies)


def resolved(schema):
    """The schema that a $ref names, with the keywords beside the $ref added to it."""
    while "$ref" in schema:
        *path, last = schema["$ref"].removeprefix("#/").split("/")
        place = functools.reduce(dict.__getitem__, path, SCHEMA)
        schema = {**place[last], **{key: value for key, value in schema.items() if key != "$ref"}}
    return schema


def columns(file):
    return resolved(SCHEMA["properties"][file])["items"]["properties"]


@functools.cache
def judge(file, column):
    return jsonschema.Draft202012Validator({**columns(file)[column], "$defs": SCHEMA["$defs"]})


def readings(text):
    """Yields the values that a field may stand for. A number with superfluous digits is text, which no column of
    numbers admits."""
    if not text:
        yield None
    if INTEGER.fullmatch(text):
        yield int(text)
    if DECIMAL.fullmatch(text) and Decimal(text) == Decimal(repr(float(text))):
        yield float(text)
    yield text


@functools.cache
def typed(file, column, text):
    """The first reading that the column admits; the text itself where it admits none, and for unknown columns."""
    if file not in SCHEMA["properties"] or column not in columns(file):
        return text
    return next((value for value in readings(text) if judge(file, column).is_valid(value)), text)


class Table:
    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as text:
            self.header, *self.rows = csv.reader(text, strict=True)
        self.file = path.name

    def typed_rows(self):
        return [{column: typed(self.file, column, text) for column, text in zip(self.header, row, strict=True)} for row in self.rows]


def tables(bundle):
    return {path.name: Table(path) for path in sorted(bundle.glob("*.csv"))}


def typed_tables(bundle):
    return {file: table.typed_rows() for file, table in tables(bundle).items()}


class Bundles(unittest.TestCase):
    """A run with every kind of study, which all tests look at."""

    fresh = None
    uncounted = set()

    @classmethod
    def setUpClass(cls):
        if Bundles.fresh:
            return
        folder = tempfile.TemporaryDirectory(prefix="bezierbench-tables-")
        unittest.addModuleCleanup(folder.cleanup)
        place = Path(folder.name)
        (place / "s.toml").write_text(suite(), encoding="utf-8")
        ended = subprocess.run([PROGRAM, "run", "s.toml", "--counts", "--quiet", "--out", "bundle"], cwd=place, check=False,
                               stderr=subprocess.PIPE, text=True)
        assert ended.returncode == 0, ended.stderr
        if "no counts: " in ended.stderr:
            Bundles.uncounted = {"cost.csv"}
        Bundles.fresh = place / "bundle"


class TableSchema(Bundles):
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    whole = jsonschema.Draft202012Validator(SCHEMA)

    def test_the_run_has_every_kind_of_study_and_every_table(self):
        listed = subprocess.run([PROGRAM, "list", "studies", "--format", "csv"], capture_output=True, text=True, check=True)
        kinds = {study["kind"] for study in csv.DictReader(listed.stdout.splitlines())}
        self.assertEqual(kinds, {kind for kind, _, _ in STUDIES.values()})
        self.assertEqual(set(tables(self.fresh)), set(SCHEMA["properties"]) - OF_OTHERS - self.uncounted)

    def test_lists_of_the_program_travel_in_a_bundle(self):
        for topic in ("methods", "generators"):
            listed = subprocess.run([PROGRAM, "list", topic, "--format", "csv"], capture_output=True, check=True).stdout
            self.assertEqual((self.fresh / f"{topic}.csv").read_bytes(), listed)

    def test_bundles_follow_it(self):
        self.assertTrue(COMMITTED)
        for bundle in [self.fresh, *COMMITTED]:
            for error in self.whole.iter_errors(typed_tables(bundle)):
                with self.subTest(bundle=bundle, place=error.json_path):
                    self.fail(error.message)

    def test_columns_are_in_its_order(self):
        """A new run has all columns; earlier bundles may lack some."""
        for bundle in [self.fresh, *COMMITTED]:
            for file, table in tables(bundle).items():
                with self.subTest(bundle=bundle, file=file):
                    expected = [name for name in columns(file) if bundle == self.fresh or name in table.header]
                    self.assertEqual(table.header, expected)

    def test_every_column_is_explained(self):
        for file, table in SCHEMA["properties"].items():
            self.assertTrue(table["description"], file)
            for name, column in columns(file).items():
                self.assertTrue(resolved(column).get("description"), f"{file} {name}")

    def test_units_follow_from_names(self):
        units = {"_ns": ("ns/point", "ns/step"), "_u": ("u p~", "u max|b|"), "_ulp": ("ulp",), "gflops": ("flop/ns",),
                 "_error": ("coordinate unit", None)}
        for file in SCHEMA["properties"]:
            for name, column in columns(file).items():
                for end in filter(name.endswith, units):
                    self.assertIn(resolved(column).get("unit"), units[end], f"{file} {name}")

    def test_it_asks_for_every_column_and_knows_no_other(self):
        good = {file: rows[:1] for file, rows in typed_tables(self.fresh).items()}
        self.assertFalse(self.whole.is_valid({**good, "other.csv": []}))
        for file, [row] in good.items():
            required = resolved(SCHEMA["properties"][file])["items"]["required"]
            self.assertEqual(required, [name for name in row if name in required])
            for name in row:
                with self.subTest(file=file, column=name):
                    less = copy.deepcopy(good)
                    del less[file][0][name]
                    self.assertEqual(self.whole.is_valid(less), name not in required)
            self.assertFalse(self.whole.is_valid({**good, file: [{**row, "new_column": 1}]}), file)

    def test_it_refuses_other_fields(self):
        for file in SCHEMA["properties"]:
            for name, column in columns(file).items():
                with self.subTest(file=file, column=name):
                    free = resolved(column).get("anyOf") == resolved({"$ref": "#/$defs/optional_text"})["anyOf"]
                    wrong = [text for text in ("", "?!", "1e+02") if not judge(file, name).is_valid(typed(file, name, text))]
                    self.assertEqual(bool(wrong), not free)


def validator(file):
    schema = json.loads((SCHEMAS / file.replace(".json", ".schema.json")).read_text(encoding="utf-8"))
    jsonschema.Draft7Validator.check_schema(schema)
    return jsonschema.Draft7Validator(schema)


def read(bundle, file):
    return json.loads((bundle / file).read_text(encoding="utf-8"))


def leaves(value, place=()):
    """Yields the path of every value that is not an object."""
    if not isinstance(value, dict):
        return [place]
    return [leaf for key, inner in value.items() for leaf in leaves(inner, (*place, key))]


def holder(value, place):
    for key in place[:-1]:
        value = value[key]
    return value


class Documents(Bundles):
    """bundle.json and machine.json."""

    def test_bundles_follow_them(self):
        self.assertTrue(COMMITTED)
        for bundle in [self.fresh, *COMMITTED]:
            for file in ("bundle.json", "machine.json"):
                with self.subTest(bundle=bundle, file=file):
                    validator(file).validate(read(bundle, file))

    def test_they_ask_for_every_key_and_know_no_other(self):
        for file in ("bundle.json", "machine.json"):
            good, judge = read(self.fresh, file), validator(file)
            good.pop("peers", None)  # its keys are the libraries that a build has
            for place in leaves(good):
                with self.subTest(file=file, place=place):
                    less = copy.deepcopy(good)
                    del holder(less, place)[place[-1]]
                    self.assertFalse(judge.is_valid(less))
                    other = copy.deepcopy(good)
                    holder(other, place)["new_" + place[-1]] = "x"
                    self.assertFalse(judge.is_valid(other))
                    for wrong in (None, "", -1, {}):
                        holder(less, place)[place[-1]] = wrong
                        self.assertFalse(judge.is_valid(less), wrong)

    def test_libraries_have_versions_if_there_are_any(self):
        machine, judge = read(self.fresh, "machine.json"), validator("machine.json")
        for peers, valid in (({"gsl": "2.7.1"}, True), ({"gsl": "unknown"}, True), ({"gsl": ""}, False), ({}, False), ("gsl", False)):
            with self.subTest(peers=peers):
                self.assertEqual(judge.is_valid({**machine, "peers": peers}), valid)

    def test_what_cannot_be_read_may_be_unknown(self):
        machine, judge = read(self.fresh, "machine.json"), validator("machine.json")
        for place in leaves(machine):
            holder(machine, place)[place[-1]] = "unknown"
        judge.validate(machine)

    def test_host_name_only_where_asked_for(self):
        for bundle in [self.fresh, *COMMITTED]:
            self.assertNotIn("host_name", read(bundle, "machine.json")["system"])
        with tempfile.TemporaryDirectory() as place:
            Path(place, "s.toml").write_text('schema_version = 1\n[suite]\nid = "s"\ntitle = "S"\n[[study]]\nid = "a"\nkind = "accuracy"\n'
                                             'degree = [3]\ntrials = 2\nmethods = ["direct"]\n', encoding="utf-8")
            subprocess.run([PROGRAM, "run", "s.toml", "--quiet", "--out", "named", "--host-name"], cwd=place, check=True)
            machine = read(Path(place, "named"), "machine.json")
        validator("machine.json").validate(machine)
        self.assertTrue(machine["system"]["host_name"])


if __name__ == "__main__":
    unittest.main()
