#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Judges a study of every float t by brute force: methods and truth are written here a second time, in plain Python.

Results of floats are computed as results of doubles, rounded: for one sum, difference or product that is the same. Truths are
fractions. All rows of exhaustive.csv of some curves and short intervals are compared field by field.

check_exhaustive.py PROGRAM    exits 1 with the first mismatches
"""
import csv
import math
import struct
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import exact  # noqa: E402
from check_hard_cases import FORMATS  # noqa: E402

CURVES = Path(__file__).resolve().parents[2] / "reference/curves/sets/named.csv"
CHOSEN = ("css_ease", "circle_tangent", "glyph_hook", "hermite_slope_1", "wilkinson_5")
FLOAT = FORMATS["float"]
COUNT = 300  # floats of an interval
# Where they begin: subnormal numbers, tiny ones, on both sides of 2^-8 and of 1/2, below 1.
BEGINS = (0.0, 2.0**-127, 1.3 * 2.0**-90, 2.0**-8 * (1 - 2.0**-16), 0.5 * (1 - 2.0**-17), 1 - 200 * 2.0**-24)
COLUMNS = ("study,curve_id,method,scalar,degree,t_min,t_max,points,max_error_ulp,worst_t,misrounded,non_monotone,"
           "out_of_hull").split(",")


def to_float(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


def next_float(x):
    return struct.unpack("<f", struct.pack("<I", struct.unpack("<I", struct.pack("<f", x))[0] + 1))[0]


def triangle(points, step):
    while len(points) > 1:
        points = [step(a, b) for a, b in zip(points, points[1:])]
    return points[0]


def de_casteljau(points, t):
    s = to_float(1 - t)
    return triangle(points, lambda a, b: to_float(to_float(s * a) + to_float(t * b)))


def de_casteljau_lerp(points, t):
    return triangle(points, lambda a, b: to_float(a + to_float(t * to_float(b - a))))


def de_casteljau_two_sided(points, t):
    r, seen = (t, points) if 2 * t <= 1 else (to_float(1 - t), points[::-1])
    return triangle(seen, lambda a, b: to_float(a + to_float(r * to_float(b - a))))


def horner_bernstein(points, t):
    n, s, power = len(points) - 1, to_float(1 - t), 1.0
    p = points[0]
    for i in range(1, n + 1):
        power = to_float(power * t)
        p = to_float(to_float(p * s) + to_float(to_float(points[i] * math.comb(n, i)) * power))
    return p


def correctly_rounded(points, t):
    return FLOAT.nearest(truth(points, t))


METHODS = {one.__name__: one for one in (de_casteljau, de_casteljau_lerp, de_casteljau_two_sided, horner_bernstein,
                                         correctly_rounded)}


def truth(points, t):
    return Fraction(*exact.value(exact.bernstein_terms(len(points) - 1, t), points))


def ulp(x):
    """The spacing of floats at x."""
    return Fraction(2) ** (max(exact.floor_log2((abs(x).numerator, x.denominator)), -126) - 23) if x else Fraction(2) ** -149


def named():
    """{id: control coordinates of each axis}, as floats."""
    with open(CURVES, encoding="utf-8", newline="") as lines:
        rows = [row for row in csv.DictReader(lines) if row["curve"] in CHOSEN]
    axes = {curve: [[to_float(float(row[axis])) for row in rows if row["curve"] == curve and row[axis]] for axis in "xy"]
            for curve in CHOSEN}
    return {curve: [axis for axis in of_curve if axis] for curve, of_curve in axes.items()}


def expected(axes, method, all_t):
    """The fields of a row that follow from the values."""
    worst = (Fraction(-1), 0.0)
    misrounded = outside = back = 0
    rises = [points == sorted(points) for points in axes]
    falls = [points == sorted(points, reverse=True) for points in axes]
    before = None
    for t in all_t:
        values = [METHODS[method](points, t) for points in axes]
        truths = [truth(points, t) for points in axes]
        error = max(abs(Fraction(value) - p) / ulp(p) for value, p in zip(values, truths))
        if error > worst[0]:
            worst = error, t
        misrounded += any(value != FLOAT.nearest(p) for value, p in zip(values, truths))
        outside += any(not min(points) <= value <= max(points) for value, points in zip(values, axes))
        if before is not None:
            back += any(up and new < old or down and new > old for up, down, new, old in zip(rises, falls, values, before))
        before = values
    return {"degree": str(len(axes[0]) - 1), "points": str(len(all_t)), "misrounded": str(misrounded), "out_of_hull": str(outside),
            "non_monotone": str(back) if any(rises) or any(falls) else "", "worst": worst}


def table_of(program, intervals):
    lists = ", ".join(f"[{first!r}, {last!r}]" for first, last in intervals)
    suite = ('schema_version = 1\n[suite]\nid = "s"\ntitle = "Short intervals"\nseed = 1\n[[study]]\nid = "every"\nkind = "exhaustive"\n'
             f"curves = {[f'named#{curve}' for curve in CHOSEN]}\nmethods = {list(METHODS)}\nt_interval = [{lists}]\n")
    with tempfile.TemporaryDirectory(prefix="bezierbench-exhaustive-") as place:
        file = Path(place) / "s.toml"
        file.write_text(suite, encoding="utf-8")
        subprocess.run([program, "run", file, "--out", Path(place) / "b", "--quiet"], check=True)
        with open(Path(place) / "b" / "exhaustive.csv", encoding="utf-8", newline="") as lines:
            return list(csv.DictReader(lines))


def mismatches(row, curves, parameters):
    all_t = parameters[float(row["t_min"])]
    claims = expected(curves[row["curve_id"]], row["method"], all_t)
    error, t = claims.pop("worst")
    wrong = [f"{column} is {row[column]}, not {claim}" for column, claim in claims.items() if row[column] != claim]
    if float(row["t_max"]) != all_t[-1]:
        wrong.append(f"t_max is {row['t_max']}, not {all_t[-1].hex()}")
    if abs(Fraction(row["max_error_ulp"]) - error) > error * Fraction(2) ** -20 + Fraction(2) ** -18:
        wrong.append(f"max_error_ulp is {row['max_error_ulp']}, not {float(error)} (at {t.hex()})")
    return wrong


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    curves, parameters = named(), {}
    for begin in map(to_float, BEGINS):
        all_t = [begin]
        while len(all_t) < COUNT and all_t[-1] < 1:
            all_t.append(next_float(all_t[-1]))
        parameters[begin] = all_t
    rows = table_of(sys.argv[1], [(all_t[0], all_t[-1]) for all_t in parameters.values()])
    wrong = [f"{row['curve_id']}, {row['method']}, t from {row['t_min']}: {what}" for row in rows
             for what in mismatches(row, curves, parameters)]
    for line in wrong[:12]:
        print(line)
    print(f"{len(rows)} rows, {len(wrong)} mismatches")
    return 1 if wrong or len(rows) != len(CHOSEN) * len(METHODS) * len(parameters) else 0


if __name__ == "__main__":
    sys.exit(main())
