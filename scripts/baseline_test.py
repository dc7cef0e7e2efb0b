#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs some studies of the report suite again and compares them, method by method and bit for bit, with results/baseline.

baseline_test.py PROGRAM

Inputs depend only on seed, study, cell and trial, so a study run alone must give the rows that it gave in the whole
suite. A method that the baseline does not have yet is named, but is not a failure. `scripts/check golden` compares all
studies; this test takes those that are quick enough for every run.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from scripts.digests import Agreement  # noqa: E402

STUDIES = ("2.2", "2.3.3-bezier", "truth-polynomial")


def holds(program, study):
    with tempfile.TemporaryDirectory() as place:
        bundle = Path(place) / "bundle"
        subprocess.run([program, "run", ROOT / "experiments/suites/report.toml", "--only", study, "--quiet", "--out", bundle], check=True)
        found = Agreement(ROOT / "results/baseline", bundle, {study})
    print(f"study {study}", found.counts(), *found.named(), sep="\n")
    return found.holds()


def main(program):
    return 0 if all([holds(program, study) for study in STUDIES]) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
