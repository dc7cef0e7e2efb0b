#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""results/hard_cases: the suite gives the committed table, the oracle agrees with it, and the README's example works.

hard_cases_test.py PROGRAM
"""
import csv
import math
import re
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts/oracle"))
import check_hard_cases  # noqa: E402  (found beside the oracles)

FOLDER = ROOT / "results/hard_cases"
TABLE = FOLDER / "hard_cases.csv"
PROGRAM = Path(sys.argv.pop(1)).resolve()
LARGEST_TABLE = 1_000_000  # bytes


def rows():
    with open(TABLE, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(lines))


def correctly_rounded(coefficients, t):
    t, n = Fraction(t), len(coefficients) - 1
    value = sum(Fraction(b) * math.comb(n, i) * t**i * (1 - t) ** (n - i) for i, b in enumerate(coefficients))
    return float(value)


def de_casteljau(points, t):
    while len(points) > 1:
        points = [(1 - t) * a + t * b for a, b in zip(points, points[1:])]
    return points[0]


class HardCases(unittest.TestCase):
    def test_the_suite_gives_the_committed_table(self):
        with tempfile.TemporaryDirectory() as place:
            bundle = Path(place) / "bundle"
            subprocess.run([PROGRAM, "run", ROOT / "experiments/suites/hard_cases.toml", "--out", bundle, "--quiet"], check=True)
            self.assertEqual((bundle / "hard_cases.csv").read_bytes(), TABLE.read_bytes())
            subprocess.run([PROGRAM, "verify", bundle], check=True, stdout=subprocess.DEVNULL)
            subprocess.run([ROOT / "scripts/report", bundle, "--out", f"{place}/report"], check=True, stdout=subprocess.DEVNULL)
            kept = [0, 0]
            for k, study in enumerate(("hard_cases-bezier", "hard_cases-polynomial")):
                with open(f"{place}/report/tables/{study}-families.csv", encoding="utf-8") as table:
                    kept[k] = sum(int(row["cases"]) for row in csv.DictReader(table))
            self.assertEqual(sum(kept), len(rows()))  # the page counts every case
        self.assertLess(TABLE.stat().st_size, LARGEST_TABLE)

    def test_the_oracle_agrees(self):
        count, wrong = check_hard_cases.judged(TABLE)
        self.assertGreater(count, 0)
        self.assertEqual(wrong, [])

    def test_the_oracle_notices_what_is_wrong(self):
        case = next(row for row in rows() if row["search"] == "nearest" and row["scalar"] == "double")
        up = math.nextafter(float.fromhex(case["rounded"]), math.inf).hex()
        changes = {"t": "0x1.2p-1", "exact": case["exact"][:-1] + str((int(case["exact"][-1]) + 1) % 10), "rounded": up,
                   "rounded_double": up, "rounded_float": "inf", "distance_ulp": "2.5e-1", "search": "tie", "dimension": "2",
                   "degree": str(int(case["degree"]) + 1)}
        self.assertEqual(check_hard_cases.mismatches(case), [])
        for column, value in changes.items():
            with self.subTest(column):
                self.assertNotEqual(check_hard_cases.mismatches({**case, column: value}), [])

    def test_the_example_finds_what_is_misrounded(self):
        example, = re.findall(r"```python\n(.*?)```", (FOLDER / "README.md").read_text(encoding="utf-8"), re.DOTALL)
        self.assertLessEqual(len(example.splitlines()), 10)
        names = {}
        exec(example, names)  # pylint: disable=exec-used
        misrounded = names["misrounded"]
        self.assertEqual(list(misrounded(correctly_rounded, TABLE)), [])
        self.assertGreater(len(list(misrounded(de_casteljau, TABLE))), 10)


if __name__ == "__main__":
    unittest.main()
