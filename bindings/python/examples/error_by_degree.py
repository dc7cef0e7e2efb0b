#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the error of methods against the degree, for one curve whose degree is raised: error_by_degree.py [FIGURE]."""
import sys
from fractions import Fraction

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import bezierbench

CURVE = [[0.0, 0.0], [1.0, 2.0], [3.0, -1.0], [4.0, 0.5]]  # yours
METHODS = ["de_casteljau", "horner_bernstein", "differences:horner", "compensated_de_casteljau"]
DEGREES = range(3, 31)
T = np.linspace(0, 1, 101)


def raised(points):
    """The same curve with one control point more."""
    n = len(points)
    first, last = [points[0]], [points[-1]]
    return first + [[Fraction(i, n) * a + (1 - Fraction(i, n)) * b for a, b in zip(points[i - 1], points[i])]
                    for i in range(1, n)] + last


def largest_errors():
    """{method: [largest error over T at each degree]}; the truth is that of the rounded control points."""
    errors = {method: [] for method in METHODS}
    points = [[Fraction(x) for x in point] for point in CURVE]
    for _ in DEGREES:
        rounded = np.array(points, dtype=float)
        for method in METHODS:
            values = bezierbench.evaluate(rounded, T, method)
            errors[method].append(bezierbench.error(rounded, T, values).error.max())
        points = raised(points)
    return errors


def main():
    for method, errors in largest_errors().items():
        plt.semilogy(list(DEGREES), errors, label=method)
        print(f"{method:24} {errors[0]:.1e} at degree {DEGREES[0]}, {errors[-1]:.1e} at degree {DEGREES[-1]}")
    plt.xlabel("degree")
    plt.ylabel("largest error in coordinate units")
    plt.legend()
    plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "error_by_degree.svg")


if __name__ == "__main__":
    main()
