#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Answers the inputs of a file elsewhere: bezierbench inputs SUITE --out F; answer.py F > G; bezierbench judge G"""
import csv
import sys


def value(t, b):
    while len(b) > 1:
        b = [(1 - t) * x + t * y for x, y in zip(b, b[1:])]
    return b[0]


with open(sys.argv[1], newline="") as file:
    rows = csv.DictReader(file)
    out = csv.DictWriter(sys.stdout, rows.fieldnames, lineterminator="\n")
    out.writeheader()
    for row in rows:
        t = float.fromhex(row["t"])
        coefficients = [float.fromhex(c) for c in row["coefficients"].split()]
        count = int(row["degree"]) + 1
        for axis, name in zip(range(int(row["dimension"])), "xyz"):
            row[name] = value(t, coefficients[axis * count:(axis + 1) * count]).hex()
        out.writerow(row)
