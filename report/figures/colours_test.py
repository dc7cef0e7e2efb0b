# SPDX-License-Identifier: MIT
"""Which methods a figure shows, and in which colours."""

import unittest

from .. import fixture
from .colours import FRONT, MOST, WELL_KNOWN, chosen, colours, leading

OTHERS = [f"other_{at}" for at in range(20)]


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


if __name__ == "__main__":
    unittest.main()
