# SPDX-License-Identifier: MIT
"""How predicted cycles are compared with times."""

import unittest

from .predictions import predictions, rank_correlation, worst_miss
from .rows import Row, Table

TIMES = {"a": 10.0, "b": 20.0, "c": 30.0, "d": 40.0, "e": 500.0}
CYCLES = {"a": 30.0, "b": 60.0, "c": 180.0, "d": 120.0, "e": 1500.0}


def _row(file, method, mode="point", **values):
    return Row(file, 2, dict(study="s", form="bernstein", method=method, scalar="double", dimension=2.0, degree=3.0, mode=mode, **values), {})


def _said(times=TIMES, cycles=CYCLES, mode="point", **more):
    counted = [_row("cost.csv", m, mode, target="AVX2", cycles_zen4=c, latency_zen4=c and 1000 - c, **more) for m, c in cycles.items()]
    found = list(predictions({"cost.csv": Table("cost.csv", [], counted)}, [_row("timing.csv", m, mode, median_ns=ns) for m, ns in times.items()]))
    return found[-1].items if found else ()


class Predictions(unittest.TestCase):
    def test_ranks_by_spearman(self):
        self.assertAlmostEqual(rank_correlation([1, 2, 3, 4, 5], [1, 4, 9, 16, 1e9]), 1)
        self.assertAlmostEqual(rank_correlation([1, 2, 3], [3, 2, 1]), -1)
        # Kendall, Rank correlation methods (1948), chapter 3: 1 - 6 sum d^2 / (n^3 - n), with d^2 = 0, 0, 1, 1, 0
        self.assertAlmostEqual(rank_correlation(list(TIMES.values()), list(CYCLES.values())), 1 - 6 * 2 / (5**3 - 5))
        self.assertAlmostEqual(rank_correlation([1, 1, 2, 3], [1, 2, 3, 4]), 0.9**0.5, msg="equal values share their mean rank")
        self.assertIsNone(rank_correlation([1, 1], [1, 2]))

    def test_the_worst_miss_is_relative_to_the_median(self):
        found = [(_row("timing.csv", m, median_ns=TIMES[m]), {"x": CYCLES[m]}) for m in TIMES]
        row, miss = worst_miss(found, "x")
        self.assertEqual((row["method"], miss), ("c", 0.5))

    def test_says_both_of_every_mode(self):
        self.assertEqual(_said(), ("`point`: coefficient of `cycles_zen4` 0.900 over 5 kernels; the worst miss is `c` at degree 3, 0.50 times.",))
        self.assertIn("coefficient of `latency_zen4` -0.900 over", _said(mode="latency", cycles={**CYCLES, "e": 500.0})[0])
        self.assertIn("over 5 kernels, without 1 unpredicted one;", _said({**TIMES, "f": 1.0}, {**CYCLES, "f": None})[0])

    def test_is_silent_without_both(self):
        self.assertEqual(_said(cycles={**CYCLES, "e": None}), ())
        self.assertEqual(_said(coordinate_range=7.0), (), "other inputs")
        self.assertEqual(list(predictions({}, [])), [])


if __name__ == "__main__":
    unittest.main()
