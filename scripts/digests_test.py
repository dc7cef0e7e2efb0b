#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""digests.py and digests.csv for a bundle to whose tables rows are added, or whose rows change or are lost."""
import csv
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report import schema
from scripts import digests  # noqa: E402

BASELINE = ROOT / "results/baseline"
METHOD = {"accuracy.csv": "method", "worst.csv": "method", "scorecard.csv": "method", "conversion.csv": "conversion"}


class Agreement(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory(prefix="bezierbench-agreement-")
        self.addCleanup(place.cleanup)
        self.copy = Path(place.name) / "b"
        shutil.copytree(BASELINE, self.copy)

    def change(self, change):
        """Replaces the rows of each deterministic table by `change(table, rows)` and numbers the worst inputs again."""
        for table in METHOD:
            with open(self.copy / table, newline="", encoding="utf-8") as file:
                header, *rows = csv.reader(file)
            rows = change(table, [dict(zip(header, row)) for row in rows])
            for number, row in enumerate(rows, 1):
                row.update({"worst_id": f"w{number}"} if "worst_id" in row else {})
            with open(self.copy / table, "w", newline="", encoding="utf-8") as file:
                csv.writer(file, lineterminator="\n").writerows([header, *([row[column] for column in header] for row in rows)])
        (self.copy / "digests.csv").write_text(digests.of_bundle(self.copy), encoding="utf-8")

    def said(self):
        done = subprocess.run([ROOT / "scripts/digests.py", BASELINE, self.copy], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout

    def test_a_method_that_is_added_changes_no_line(self):
        before = digests.of_bundle(BASELINE).splitlines()
        self.change(lambda table, rows: [{**row, METHOD[table]: name} for row in rows
                                         for name in (["new", row[METHOD[table]]] if "direct" in row[METHOD[table]] else [row[METHOD[table]]])])
        after = digests.of_bundle(self.copy).splitlines()
        self.assertEqual([line for line in after if ",new," not in line], before)
        self.assertGreater(len(after), len(before) + 10)
        code, text = self.said()
        self.assertEqual(code, 0, text)
        self.assertRegex(text, r"\Aby table, study and method: \d+ agree, \d+ are new\nis new: accuracy.csv, study [^,]*, method new\n")

    def test_a_row_that_differs_or_is_gone(self):
        def change(table, rows):
            if table == "accuracy.csv":
                next(row for row in rows if row["method"] == "direct")["max_error"] += "1"
            return [row for row in rows if table != "conversion.csv" or row["conversion"] == "none"]
        self.change(change)
        code, text = self.said()
        self.assertEqual(code, 1)
        self.assertRegex(text, r"1 differ, [1-9]\d* are missing\ndiffers: accuracy.csv, study [^,]*, method direct\nis missing: conversion.csv, ")

    def test_every_committed_table_of_the_kind_is_changed_here(self):
        self.assertEqual(sorted(METHOD), [file for file in schema.deterministic() if (BASELINE / file).exists()])


if __name__ == "__main__":
    unittest.main()
