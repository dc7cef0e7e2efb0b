#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""usage: scripts/ranges.py PROGRAM [--few]

Runs every kind of study at the ends of the coordinate ranges that suites take: 0, the smallest subnormal and 2^1020 in
double, and the largest float where a kind judges float. Fails where the program ends by a signal or accuses a method: at
these ends nothing is wrong with any. `--few` runs one degree and one dimension.

Studies are those of the shipped suites, one for each kind and form of curve, so that a kind has its keys from there.
"""
import pathlib
import subprocess
import sys
import tempfile
import tomllib

SUITES = pathlib.Path(__file__).resolve().parent.parent / "experiments" / "suites"
LARGEST = 2.0**1020
LARGEST_FLOAT = 2.0**128 - 2.0**104
SMALLEST = 5e-324
SWEPT_ELSEWHERE = ("t_interval", "replicates", "baseline", "published", "generator", "decomposed_trials")


def templates():
    """A study for each kind and form of curve; all without times."""
    found = {}
    for path in sorted(SUITES.glob("*.toml"), key=lambda path: (path.stem != "quick", path.stem)):
        for study in tomllib.loads(path.read_text(encoding="utf-8")).get("study", []):
            if study["kind"] != "timing" and "curves" not in study:
                found.setdefault((study["kind"], study.get("curve", "")), study)
    return list(found.values())


def value(x):
    if isinstance(x, list):
        return "[" + ", ".join(map(value, x)) + "]"
    return f'"{x}"' if isinstance(x, str) else repr(x)


def suite(study, ranges, few):
    keys = {key: x for key, x in study.items() if key not in SWEPT_ELSEWHERE}
    keys.update(id="s", coordinate_range=ranges, dimension=[2] if few else [1, 2, 3], trials=5 if few else 20)
    if "degree" in keys:
        keys["degree"] = [3] if few else [1, 3, 12]
    if "budget" in keys:
        keys["budget"] = 50
    return ("schema_version = 1\n[suite]\nid = \"s\"\ntitle = \"ends of ranges\"\nseed = 1\n[[study]]\n"
            + "".join(f"{key} = {value(x)}\n" for key, x in keys.items()))


def run(program, folder, text, *options):
    path = folder / "s.toml"
    path.write_text(text, encoding="utf-8")
    return subprocess.run([program, "run", path, "--quiet", "--no-timing", *options], capture_output=True, text=True)


def fault(program, text):
    """What is wrong with a run of this suite; None where nothing is."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        done = run(program, folder, text, "--out", folder / "b")
    if done.returncode == 0:
        return None
    return f"exit {done.returncode}: {(done.stderr or done.stdout).strip() or 'no message'}"


def takes_ranges(program, study):
    """Whether the kind draws coordinates; kinds that do refuse a range beyond the largest, and name the key."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        done = run(program, folder, suite(study, [2 * LARGEST], True), "--out", folder / "b", "--dry-run")
    assert done.returncode == 2, f"kind {study['kind']} takes a range of 2^1021"
    return "does not have the key coordinate_range" not in done.stderr


def main():
    program, few = pathlib.Path(sys.argv[1]).resolve(), "--few" in sys.argv[2:]
    faults = runs = 0
    for study in templates():
        if not takes_ranges(program, study):
            continue
        cases = [("double", r) for r in (0.0, SMALLEST, LARGEST)]
        if "scalar" in study:
            cases += [("float", r) for r in (SMALLEST, LARGEST_FLOAT)]
        for scalar, r in cases:
            keys = study | ({"scalar": [scalar]} if "scalar" in study else {})
            found = fault(program, suite(keys, [r], few))
            runs += 1
            if found:
                faults += 1
                print(f"{study['kind']} ({study.get('curve', 'bezier')}, {scalar}) at coordinate_range {r}: {found}")
    print(f"ranges: {runs} runs, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
