#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""De Casteljau's algorithm as a program: bezierbench run SUITE --program 'python3 mine.py' --out BUNDLE"""
import sys


def point(t, points):
    while len(points) > 1:
        points = [[(1 - t) * x + t * y for x, y in zip(a, b)] for a, b in zip(points, points[1:])]
    return points[0]


_, _, form, dimension, degree, count = sys.stdin.readline().split()
dimension = int(dimension)
print("program_mine bernstein")
for line in sys.stdin:
    t, *coefficients = map(float.fromhex, line.split())
    points = [coefficients[i:i + dimension] for i in range(0, len(coefficients), dimension)]
    print(*(x.hex() for x in point(t, points)))
