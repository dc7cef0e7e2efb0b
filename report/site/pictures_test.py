# SPDX-License-Identifier: MIT
"""The committed pictures of docs/introduction.md are those that are drawn today, by their labels, and show what the page says."""
import unittest

from . import pictures


class Pictures(unittest.TestCase):
    def test_labels(self):
        for name in pictures.PICTURES:
            committed = (pictures.FOLDER / f"{name}.svg").read_text(encoding="utf-8")
            self.assertEqual(pictures.labels(pictures.drawn(name)), pictures.labels(committed), f"{name}: run scripts/site --pictures")

    def test_both_sums_are_the_curve(self):
        coefficients, n = pictures.power_coefficients(pictures.POINTS), len(pictures.POINTS) - 1
        for t in (0, 0.25, 1):
            in_bernstein = sum(point * pictures.bernstein(n, i, t) for i, point in enumerate(pictures.POINTS))
            self.assertAlmostEqual(sum(q * t ** j for j, q in enumerate(coefficients)), in_bernstein, 12)

    def test_no_error_above_the_bound(self):
        k = 3 * (len(pictures.POINTS) - 1)
        shares = [error / (pictures.ROUNDOFF * size) for _, error, size in pictures.errors()]
        self.assertLessEqual(max(shares), k)
        self.assertGreater(max(shares), 1)


if __name__ == "__main__":
    unittest.main()
