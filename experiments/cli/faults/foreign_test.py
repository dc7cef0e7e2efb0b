#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Bundles from strangers: links in them are not followed, and rows with correct checksums that violate the schema are found.
Usage: foreign_test.py BEZIERBENCH"""
import os
import re
import shutil
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import INPUT_OUTPUT, ROOT, STUDY, Case  # noqa: E402

sys.path.append(str(ROOT))
from scripts.hostile_bundle import sign  # noqa: E402

SMALL = {**STUDY, "trials": "20", "replicates": "3"}


class Foreign(Case):
    def setUp(self):
        super().setUp()
        self.bundle()

    def test_links_are_replaced_and_not_written_through(self):
        self.write("mine.csv", "mine")
        self.suite(SMALL, name="t.toml")
        self.fine("run", "t.toml", "--quiet", "--out", "p", "--shard", "1/2")
        (self.folder / "p/accuracy.csv").symlink_to("../mine.csv")
        self.fine("run", "t.toml", "--quiet", "--out", "p")
        self.assertFalse((self.folder / "p/accuracy.csv").is_symlink())
        self.assertEqual((self.folder / "mine.csv").read_text(), "mine")
        self.assert_complete("p")

    def test_locks_are_made_in_the_bundle_only(self):
        self.write("away/kept", "mine")
        (self.folder / "p").mkdir()
        self.write("p/suite.toml", "x")
        (self.folder / "p/blocks").symlink_to("../away")
        self.refused(INPUT_OUTPUT, ["run", "s.toml", "--out", "p"], "p/blocks: is not a folder")
        self.assertEqual(os.listdir(self.folder / "away"), ["kept"])

    def test_schema_and_required_tables(self):
        """With checksums that are right."""
        for name, change, needle in [
                ("accuracy.csv", lambda text: re.sub(",exact,ok,", ",exact,fine,", text, count=1), "status is"),
                ("accuracy.csv", lambda text: text.replace("p50_error", "median"), "column 'median'"),
                ("machine.json", lambda text: text.replace('"caches"', '"caches_"'), "caches"),
                ("bundle.json", lambda text: text.replace('"seed": 1', '"seed": 7'), "seed is 7, in suite.toml 1"),
                ("bundle.json", lambda text: text.replace('"git_clean"', '"git_clear"'), "git_clean"),
                ("suite.toml", lambda text: text.replace("seed = 1", "seed = 2"), "seed is 1, in suite.toml 2"),
                ("suite.toml", lambda text: text.replace('id = "a"', 'id = "z"'), "its study is not one of those"),
                ("accuracy.csv", None, "accuracy.csv: is missing, a study"),
                ("reference.csv", None, "reference.csv: is missing, a study")]:
            with self.subTest(name=name, needle=needle):
                shutil.rmtree(self.folder / "c", ignore_errors=True)
                shutil.copytree(self.folder / "b", self.folder / "c")
                path = self.folder / "c" / name
                if change is None:
                    path.unlink()
                else:
                    text = change(path.read_text())
                    self.assertNotEqual(text, path.read_text())
                    path.write_text(text)
                sign(self.folder / "c")
                result = self.run_program("verify", "c")
                self.assertEqual((result.returncode, result.stdout), (1, b""), result)
                self.assertIn(needle, result.stderr.decode())

    def test_a_foreign_folder_is_one_line(self):
        for number in range(5):
            self.write(f"thesis/{number}.tex", "x")
        result = self.run_program("verify", "thesis")
        self.assertEqual(result.returncode, 1)
        self.assert_one_line(result, "thesis: is not a bundle")


if __name__ == "__main__":
    unittest.main()
