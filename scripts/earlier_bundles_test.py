#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Bundles that earlier programs wrote are still read by everything that reads bundles.

earlier_bundles_test.py PROGRAM

experiments/bundle/fixtures has one bundle per schema version. They are never remade, since the test is about bundles
of earlier programs.
"""
import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUNDLES = sorted((ROOT / "experiments/bundle/fixtures").iterdir())
PROGRAM = Path(sys.argv.pop(1)).resolve()


class EarlierBundles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="bezierbench-earlier-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def output(self, *command):
        result = subprocess.run([*map(str, command)], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result)
        return result.stdout

    def test_there_are_some(self):
        self.assertTrue(BUNDLES)

    def rows(self, bundle, file):
        with open(bundle / file, newline="", encoding="utf-8") as text:
            return list(csv.DictReader(text))

    def test_verify(self):
        for bundle in BUNDLES:
            self.assertEqual(self.output(PROGRAM, "verify", bundle).splitlines()[0], f"{bundle}: fine")

    def test_compare_with_a_bundle_of_today(self):
        """Every row's inputs are found in a new run of the same suite. `scripts/check golden` compares the results."""
        for bundle in BUNDLES:
            now = self.folder / bundle.name
            self.output(PROGRAM, "run", bundle / "suite.toml", "--quiet", "--no-timing", "--out", now)
            table = csv.DictReader(subprocess.run([PROGRAM, "compare", bundle, now, "--format", "csv"], check=False,
                                                  capture_output=True, text=True).stdout.splitlines())
            compared = [row for row in table if row["kind"] == "accuracy"]
            self.assertGreaterEqual(len(compared), len(self.rows(bundle, "accuracy.csv")))
            self.assertIn("same", self.output(PROGRAM, "compare", bundle, bundle))

    def test_methods_agree_whatever_the_schema_version(self):
        for bundle in BUNDLES[1:]:
            compared = self.output(PROGRAM, "compare", BUNDLES[0], bundle)
            self.assertRegex(compared, r"accuracy: identical in all \d+ common rows\n  by table, study and method: [1-9]\d* agree\n\n")

    def test_replay_and_trials(self):
        for bundle in BUNDLES:
            worst = self.rows(bundle, "worst.csv")[0]
            self.output(PROGRAM, "replay", bundle, worst["worst_id"])
            trials = self.output(PROGRAM, "trials", bundle, "--study", worst["study"], "--method", worst["method"],
                                 "--set", f"degree={worst['degree']}")
            self.assertIn(worst["coefficients"], trials.splitlines()[1 + int(worst["trial"])])

    def test_report(self):
        for bundle in BUNDLES:
            out = self.folder / "pages"
            subprocess.run([ROOT / "scripts/report", bundle, "--out", out], check=True, capture_output=True)
            self.assertIn(f"timing-{self.rows(bundle, 'timing.csv')[0]['study']}.csv",
                          {path.name for path in (out / "tables").iterdir()})


if __name__ == "__main__":
    unittest.main()
