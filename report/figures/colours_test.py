# SPDX-License-Identifier: MIT
"""Which methods a figure shows, and in which colours."""

import re
import unittest
from pathlib import Path

from .. import fixture
from .colours import FRONT, MOST, OTHERS as WHEEL, PALETTE, WELL_KNOWN, chosen, colours, leading

OTHERS = [f"other_{at}" for at in range(20)]


def contrast(*colours):
    """WCAG 2.2: the relative luminances of two colours, each with 0.05 added, the larger over the smaller."""
    def luminance(colour):
        parts = [int(colour[at:at + 2], 16) / 255 for at in (1, 3, 5)]
        return sum(weight * (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4) for weight, c in zip((0.2126, 0.7152, 0.0722), parts))
    low, high = sorted(map(luminance, colours))
    return (high + 0.05) / (low + 0.05)


class Colours(unittest.TestCase):
    def test_the_front_comes_first_then_the_best_known_then_the_least_values(self):
        """The fixture's front: horner_bernstein and compensated_de_casteljau, of which each has a small proved bound."""
        methods = [*OTHERS, "wozny_chudy", "de_casteljau", "compensated_de_casteljau", "horner_bernstein"]
        shown = leading(fixture.bundle(), methods, lambda method: -methods.index(method))
        self.assertEqual(set(shown[:2]), {"horner_bernstein", "compensated_de_casteljau"})
        self.assertEqual(shown[2:4], ["de_casteljau", "wozny_chudy"])
        self.assertEqual(shown[4:], OTHERS[:-5:-1])
        self.assertEqual((len(shown), FRONT < MOST), (MOST, True))
        self.assertIn("8 of 24 methods", chosen(shown, methods))
        self.assertEqual(chosen(shown, shown), "")

    def test_a_method_keeps_its_colour_and_eight_differ(self):
        bundle = fixture.bundle()
        for others in (OTHERS[:6], OTHERS[6:12], OTHERS[12:18]):
            found = colours(bundle, [*others, "de_casteljau", "direct"])
            self.assertEqual((found["de_casteljau"], found["direct"]), (WELL_KNOWN["de_casteljau"], WELL_KNOWN["direct"]))
            self.assertEqual(len(set(found.values())), MOST)

    def test_each_stands_out_from_light_and_dark_paper(self):
        self.assertAlmostEqual(contrast("#ffffff", "#000000"), 21)
        css = Path(__file__).parent.parent.joinpath("templates/page.css").read_text(encoding="utf-8")
        papers = re.findall(r"--paper: (#\w{6})", css)
        self.assertGreater(len(set(papers)), 1)
        for paper in papers:
            self.assertEqual([c for c in (*PALETTE, *WHEEL) if contrast(c, paper) < 3], [], paper)


if __name__ == "__main__":
    unittest.main()
