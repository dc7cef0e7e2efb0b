#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""promises.py PROGRAM boxes|easing|flattening [--small] [SEED...]: judges random curves by methods that promise something.

Exact arithmetic judges, for each seed (a fresh one if none is given; it is printed), a thousandth of the curves with --small.
Prints how many curves there were. Exit 1 where a promise is broken, and where equal_errors takes more than 1.10 times the least
number of chords for random cubics, in the mean at a tolerance, without --small.
"""
import argparse
import csv
import random
import subprocess
import sys
import tempfile
from pathlib import Path

MOST_CHORDS, LEAST_CURVES = 1.10, 1000  # in the mean of at least so many


def boxes(study, rows):
    curves = sum(int(row["trials"]) for row in rows if row["method"] == "exact_box" and row["status"] == "ok")
    print(f"{study}: {curves} curves, no promise broken")


def easing(_study, rows):
    for row in rows:
        print("{study}: {trials} trials, {misrounded} misrounded, {non_monotone} with a step back; "
              "in float {float_misrounded} and {float_non_monotone}".format(**row))


def flattening(study, rows):
    for row in rows:
        print("{study}, {generator}, tolerance {tolerance}: {trials} curves, {broken} broken, {undecided} undecided"
              "; {mean:.3f} times the least number of chords in the mean".format(**row, mean=float(row["mean_over_least"])))
    if study == "flattening-cubics" and any(float(row["mean_over_least"]) > MOST_CHORDS and int(row["trials"]) >= LEAST_CURVES for row in rows):
        sys.exit(1)


# {name: (suite, methods, [(study, thousands of trials, None for curves of a file; other options)], what prints its rows)}
CHECKS = {
    "boxes": ("bounds", "control_box,split_box,exact_box", [
        ("bounds-degree", 1500, "--set", "degree=2,3"), ("bounds-kinds", 150), ("bounds-rational", 50), ("bounds-*sets", None)], boxes),
    "easing": ("easing", "easing_correctly_rounded", [
        ("easing-random", 255), ("easing-corners", 255), ("easing-overshoot", 255), ("easing-begin", 255), ("easing-real", None)], easing),
    "flattening": ("flattening", "equal_errors", [("flattening-cubics", 20), ("flattening-cusps", 20), ("flattening-thin", 20)], flattening)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("check", choices=CHECKS)
    parser.add_argument("--small", action="store_true")
    parser.add_argument("seeds", nargs="*", default=[random.getrandbits(30)])
    options = parser.parse_intermixed_args()
    suite, methods, studies, print_rows = CHECKS[options.check]
    for seed in options.seeds:
        print(f"{options.check}: seed {seed}", flush=True)
        for study, thousands, *more in studies:
            trials = ["--trials", str(thousands * (1 if options.small else 1000))] if thousands else []
            with tempfile.TemporaryDirectory(prefix="bezierbench-promises-") as out:
                done = subprocess.run([options.program, "run", suite, "--only", study, "--seed", str(seed), "--quiet", "--no-timing", "--out", out,
                                       "--set", f"methods={methods}", *more, *trials], check=False)
                if done.returncode:
                    return done.returncode
                with open(Path(out) / f"{suite}.csv", newline="", encoding="utf-8") as file:
                    print_rows(study, list(csv.DictReader(file)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
