#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs some studies of the report suite anew and compares them, row by row and byte by byte, with results/baseline.

baseline_test.py PROGRAM

Inputs depend on nothing but seed, study, cell and trial, so a study run alone must give the rows that it gave in the
whole suite. `scripts/check golden` compares everything; this is what fits into the tests.
"""
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STUDIES = ("2.2", "2.3.3-bezier", "truth-polynomial")
FILES = ("accuracy.csv", "conversion.csv")


def lines_of(path, study):
    if not path.exists():
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return [row for row in csv.reader(file) if row[0] in ("study", study)]


def main(program):
    differing = 0
    compared = 0
    with tempfile.TemporaryDirectory() as place:
        for study in STUDIES:
            bundle = Path(place) / study
            subprocess.run([program, "run", ROOT / "experiments/suites/report.toml", "--only", study, "--quiet",
                            "--out", bundle], check=True)
            for name in FILES:
                ours, theirs = lines_of(bundle / name, study), lines_of(ROOT / "results/baseline" / name, study)
                if (bundle / name).exists():
                    compared += len(ours) - 1
                    for a, b in zip(ours, theirs):
                        if a != b:
                            print(f"{name}: now {a}\n{name}: was {b}")
                            differing += 1
                    if len(ours) != len(theirs):
                        print(f"{name}, study {study}: {len(ours) - 1} rows now, {len(theirs) - 1} in the baseline")
                        differing += 1
    print(f"{compared} rows compared, {differing} differ")
    return 1 if differing or compared == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
