#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Checks bundle.json and machine.json against their schemas.

schema_test.py PROGRAM    checks a run of PROGRAM and the committed bundles
"""
import copy
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import jsonschema

ROOT = Path(__file__).resolve().parent.parent
SCHEMAS = ROOT / "experiments/bundle/schema"
COMMITTED = sorted(path.parent for path in ROOT.glob("results/*/bundle.json"))
SUITE = ('schema_version = 1\n[suite]\nid = "s"\ntitle = "S"\n[[study]]\nid = "a"\nkind = "accuracy"\ncurve = "bernstein"\n'
         'degree = [3]\ntrials = 2\nmethods = ["direct"]\n')
PROGRAM = Path(sys.argv.pop(1)).resolve()


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


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="bezierbench-schema-")
        cls.addClassCleanup(cls.folder.cleanup)
        place = Path(cls.folder.name)
        (place / "s.toml").write_text(SUITE, encoding="utf-8")
        for name, options in (("plain", []), ("named", ["--host-name"])):
            subprocess.run([PROGRAM, "run", "s.toml", "--quiet", "--out", name, *options], cwd=place, check=True)
        cls.plain, cls.named = place / "plain", place / "named"

    def test_bundles_follow_them(self):
        self.assertTrue(COMMITTED)
        for bundle in [self.plain, self.named, *COMMITTED]:
            for file in ("bundle.json", "machine.json"):
                with self.subTest(bundle=bundle, file=file):
                    validator(file).validate(read(bundle, file))

    def test_they_ask_for_every_key_and_know_no_other(self):
        for file in ("bundle.json", "machine.json"):
            good, judge = read(self.plain, file), validator(file)
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
        machine, judge = read(self.plain, "machine.json"), validator("machine.json")
        for peers, valid in (({"gsl": "2.7.1"}, True), ({"gsl": "unknown"}, True), ({"gsl": ""}, False), ({}, False), ("gsl", False)):
            with self.subTest(peers=peers):
                self.assertEqual(judge.is_valid({**machine, "peers": peers}), valid)

    def test_what_cannot_be_read_may_be_unknown(self):
        machine, judge = read(self.plain, "machine.json"), validator("machine.json")
        for place in leaves(machine):
            holder(machine, place)[place[-1]] = "unknown"
        judge.validate(machine)

    def test_host_name_only_where_asked_for(self):
        self.assertNotIn("host_name", read(self.plain, "machine.json")["system"])
        self.assertTrue(read(self.named, "machine.json")["system"]["host_name"])
        for bundle in COMMITTED:
            self.assertNotIn("host_name", read(bundle, "machine.json")["system"])


if __name__ == "__main__":
    unittest.main()
