#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Checks the JSON Schema of suites and the descriptions of the kinds against the program and the suites.

suite_schema_test.py PROGRAM
"""
import json
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

import jsonschema

ROOT = Path(__file__).resolve().parent.parent
SUITES = sorted((ROOT / "experiments/suites").glob("*.toml"))
COMMITTED = ROOT / "experiments/suites/suite.schema.json"
RESOLVED = sorted(path for path in ROOT.glob("results/*/suite.toml"))
PROGRAM = Path(sys.argv.pop(1)).resolve()
HEAD = 'schema_version = 1\n[suite]\nid = "s"\n'
USAGE = 2


def output(*words):
    return subprocess.run([PROGRAM, *words], stdout=subprocess.PIPE, check=True, text=True).stdout


class SuiteSchema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.text = output("list", "kinds", "--json-schema")
        cls.schema = json.loads(cls.text)
        jsonschema.Draft7Validator.check_schema(cls.schema)
        cls.validator = jsonschema.Draft7Validator(cls.schema)
        cls.kinds = {name: schema for name, schema in cls.schema["definitions"].items() if not name.startswith("key_")}

    def is_valid(self, text):
        return self.validator.is_valid(tomllib.loads(text))

    def planned(self, text, options=("--trials", "1")):
        """(the program's output for a suite, exit code)."""
        with tempfile.TemporaryDirectory(prefix="bezierbench-suite-") as folder:
            Path(folder, "s.toml").write_text(text, encoding="utf-8")
            done = subprocess.run([PROGRAM, "run", "s.toml", "--out", "b", *options, "--dry-run"], cwd=folder,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
            return done.returncode, done.stderr

    def test_the_committed_schema_is_that_of_the_program(self):
        self.assertEqual(COMMITTED.read_text(encoding="utf-8"), self.text,
                         f"write it by: bezierbench list kinds --json-schema > {COMMITTED.relative_to(ROOT)}")

    def test_suites_follow_it_and_tell_editors_where_it_is(self):
        for path in SUITES:
            text = path.read_text(encoding="utf-8")
            errors = [error.message for error in self.validator.iter_errors(tomllib.loads(text))]
            self.assertEqual(errors, [], path.name)
            self.assertEqual(text.splitlines()[0], f"#:schema ./{COMMITTED.name}", path.name)

    def test_resolved_suites_follow_it(self):
        self.assertGreater(len(RESOLVED), 1)
        for path in RESOLVED:
            document = tomllib.loads(path.read_text(encoding="utf-8"))
            if "suites" not in document:  # several are never written by people
                self.assertEqual([error.message for error in self.validator.iter_errors(document)], [], path)

    def test_examples_follow_it_and_can_be_run(self):
        for kind in self.kinds:
            described = output("list", "kinds", kind)
            example = HEAD + described.split("Example:\n")[1]
            self.assertTrue(self.is_valid(example), example)
            code, said = self.planned(example, ("--trials", "1") if "\n  trials: " in described else ())
            self.assertEqual(code, 0, said)

    def test_what_it_refuses_the_program_refuses(self):
        example = HEAD + output("list", "kinds", "derivative").split("Example:\n")[1]
        line = len(example.splitlines()) + 1
        for more, place in (("budget = 5\n", 1), ("degre = [3]\n", 1), ('curve = "bezeir"\n', 9),
                            ('scalar = ["doubel"]\n', 11), ("dimension = 2\n", 13), ("title = 2\n", 9)):
            self.assertFalse(self.is_valid(example + more), more)
            code, said = self.planned(example + more)
            self.assertEqual(code, USAGE, more)
            self.assertTrue(said.startswith(f"bezierbench: s.toml:{line}:{place}: "), said)
            self.assertEqual(len(said.splitlines()), 1, said)
        for missing in ("id", "kind", "degree", "order"):
            without = re.sub(rf"(?<=\n){missing} = .*\n(?!\[\[)", "", example)
            self.assertFalse(self.is_valid(without), missing)
            code, said = self.planned(without)
            self.assertEqual(code, USAGE, missing)
            self.assertIn("bezierbench: s.toml:4:1: ", said)

    def test_errors_of_planning_name_the_place_of_the_key(self):
        timing = HEAD + '[[study]]\nid = "a"\nkind = "timing"\ndegree = [3]\n'
        study = '[[study]]\nid = "a"\nkind = "{}"\ndegree = [3]\n'
        for text, place in (
                (timing + 'methods = ["differences_horner"]\nmodes = ["one_shot"]\n', "4:1"),  # no order
                (timing + 'methods = ["schneider"]\norder = [1]\nmodes = ["one_shot"]\npoints = [5]\ntolerance = [1]\n', "9:1"),
                (timing + 'methods = ["quintic_isolate"]\nmodes = ["point"]\n', "9:10"),
                (timing + 'methods = ["quintic_isolate"]\nmodes = ["one_shot"]\ncurve = "rational"\n', "8:12"),
                (timing + 'methods = ["direct"]\nbaseline = "de_casteljau"\n', "9:12"),
                (timing + 'methods = ["direct", "horner"]\n', "8:22"),
                (HEAD + study.format("accuracy") + 'methods = ["direct", "horner"]\n', "8:22"),
                (HEAD + study.format("accuracy") + 'baseline = ["direct", "horner"]\n', "8:23"),
                (HEAD + study.format("projection") + 'methods = ["quintic_isolate", "direct"]\n', "8:31"),
                (HEAD + study.format("derivative") + 'order = [1]\nmethods = ["power_derivative"]\n', "9:12"),
                (HEAD + study.format("derivative") + 'order = [1]\ncurve = "power"\nmethods = ["differences_horner"]\n',
                 "10:12"),
                (HEAD + study.format("conversion") + 'methods = ["factorial+factorial"]\n', "8:12")):
            code, said = self.planned(text)
            self.assertEqual(code, USAGE, text)
            self.assertTrue(said.startswith(f"bezierbench: s.toml:{place}: study \"a\": "), said + text)
            self.assertEqual(len(said.splitlines()), 1, said)

    def test_descriptions_have_every_key_in_80_columns(self):
        everything = output("list", "kinds")
        footer = output("run", "--help")
        self.assertIn(everything.strip(), footer)
        for text in [everything, *(output("list", "kinds", kind) for kind in self.kinds)]:
            self.assertLessEqual(max(map(len, text.splitlines())), 80)
        for kind, schema in self.kinds.items():
            described = output("list", "kinds", kind)
            for key in schema["properties"]:
                self.assertRegex(described, rf"\n  {key}: .*(\n      .*)*\n      {key} = ", kind)
        self.assertEqual(subprocess.run([PROGRAM, "list", "kinds", "acuracy"], stderr=subprocess.PIPE, text=True,
                                        check=False).stderr,
                         'bezierbench: acuracy: unknown kind; did you mean "accuracy"?\n')


if __name__ == "__main__":
    unittest.main()
