# SPDX-License-Identifier: MIT
"""What axes are labelled with: no two labels alike, no notation of TeX, values as they are."""

import re
import unittest

from .canvas import finish, panels, styled
from .lines import degree_axis


@styled
def _figure(x, y, across=None):
    """A line of these points in double logarithmic axes, or with `across` on the axis of x."""
    canvas, axes = panels(1, 1)
    ax = axes[0][0]
    ax.plot(x, y, label="one")
    ax.set_yscale("log")
    if across:
        across(ax, x)
    else:
        ax.set_xscale("log")
    return finish(canvas, "tried", "Tried", "Tried.")


def _texts(figure):
    return re.findall(r"<text [^>]*>([^<]*)</text>", figure.drawing.svg)


class Labels(unittest.TestCase):
    def test_a_narrow_axis_has_labels_that_differ(self):
        for y in ([0.9965, 0.9995], [0.99965, 0.99995], [57.5, 58.4]):
            texts = _texts(_figure([1, 10], y))
            self.assertEqual(len(set(texts)), len(texts), texts)
            self.assertTrue(all(min(y) * 0.99 < float(text) < max(y) * 1.01 for text in texts if text not in ("1", "2", "5", "10")), texts)

    def test_a_logarithmic_axis_is_written_as_tables_are(self):
        texts = _texts(_figure([2.5, 6.5], [1e-9, 1e12]))
        self.assertLessEqual({"5", "0.01", "1e4"}, set(texts))
        self.assertEqual([text for text in texts if not re.fullmatch(r"\d+(\.\d+)?|1e-?[1-9]\d*", text)], [])

    def test_numbers_of_points_are_not_rounded(self):
        texts = _texts(_figure([17.0, 1023.0, 4097.0], [1, 2, 3], degree_axis))
        self.assertLessEqual({"17", "1023", "4097"}, set(texts))

    def test_the_last_place_is_named(self):
        self.assertLessEqual({"4", "8", "12", "16", "20"}, set(_texts(_figure([4.0, 8.0, 12.0, 16.0, 20.0], [1, 2, 3, 4, 5], degree_axis))))
        texts = set(_texts(_figure([float(n) for n in range(1, 101)], list(range(1, 101)), degree_axis)))
        self.assertLessEqual({"1", "2", "100"}, texts)
        self.assertNotIn("99", texts)

    def test_order_zero_is_on_the_axis(self):
        figure = _figure([0.0, 1.0, 2.0], [1.0, 2.0, 3.0], degree_axis)
        self.assertIn("0", _texts(figure))
        self.assertEqual(len(figure.drawing.series[0].points), 3)


if __name__ == "__main__":
    unittest.main()
