# SPDX-License-Identifier: MIT
"""The tiles and the answer: what they count, whom they rank, and whom they leave out as useless."""

import unittest

from . import fixture
from .answer import NO_TIME, ROUNDOFF, USELESS, candidates, default_cell, is_proved_small, lost, useful
from .bundle import Missing
from .chapters import choice, first_glance, speed
from .findings.roster import find_all
from .fixture import changed


def _horner(**new):
    return changed("pareto.csv", new, method="horner_bernstein")


class Answer(unittest.TestCase):
    def setUp(self):
        fixture.without_figures(self)

    def answer(self, bundle):
        """The sentence, and the groups of the table."""
        block = next(b for b in choice.answer(bundle, None) if b.kind == "answer")
        return block.sentence, block.table.groups

    def chosen(self, bundle):
        """{method: its cells} of the tables of time against error."""
        return {g.key: [c for _, row in g.rows for c in row if c.text] for b in speed.choosing(bundle, find_all(bundle)) if b.kind == "table"
                for g in b.groups}

    def test_methods_are_ranked_by_time(self):
        cells = candidates(fixture.bundle())
        cell = default_cell(cells)
        self.assertEqual((cell.form, cell.mode, cell.scalar, cell.dimension), ("bernstein", "point", "double", 2))
        times = [one.ns for one in cells[cell]]
        self.assertEqual(times, sorted(times))
        sentence, groups = self.answer(fixture.bundle())
        self.assertEqual([g.key for g in groups], ["horner_bernstein", "direct", "de_casteljau", "compensated_de_casteljau"])
        self.assertIn("`horner_bernstein`", sentence)
        self.assertNotIn("`direct`", sentence)  # dominated

    def test_a_method_without_a_small_proved_bound_is_not_recommended(self):
        """The default is the README's need; the fastest method here loses log10(8219) = 3.9 digits."""
        bundle = fixture.bundle(_horner(observed_max_u=8219, bound_u=1.97e6))
        sentence, groups = self.answer(bundle)
        self.assertNotIn("horner_bernstein", sentence)
        self.assertIn("with a proved bound of at most 20 u p~, fastest first: `compensated_de_casteljau`", sentence)
        self.assertEqual(groups[-1].key, "horner_bernstein")
        cells = groups[-1].rows[0][1]
        self.assertIn("8219, loses 4 digits", [cell.text for cell in cells])
        self.assertFalse(any(cell.mark == "inside" for cell in cells))
        cells = self.chosen(bundle)["horner_bernstein"]
        self.assertTrue(all("8219 u, loses 4 digits" in c.text and c.mark == "" for c in cells), [c.text for c in cells])

    def test_what_is_lost_is_said_beyond_100(self):
        self.assertEqual([lost(u) for u in (None, 1.0, 100.0, 101.0, 999.0, 3e5, float("inf"))],
                         ["", "", "", "loses 2 digits", "loses 3 digits", "loses 5 digits", ""])

    def test_a_small_bound_is_that_of_the_form(self):
        for bound, form, small in ((15.0, "bernstein", True), (15.1, "bernstein", False), (30.0, "rational", True), (None, "bernstein", False),
                                   (float("nan"), "bernstein", False)):
            self.assertEqual(is_proved_small(bound, 3, form), small)

    def test_a_useless_method_is_not_worth_choosing(self):
        edge = USELESS / ROUNDOFF["double"]
        bundle = fixture.bundle(_horner(observed_max_u=1.01 * edge))
        self.assertNotIn("horner_bernstein", [g.key for g in self.answer(bundle)[1]])
        self.assertIn("compensated_de_casteljau", self.chosen(bundle))
        self.assertNotIn("horner_bernstein", self.chosen(bundle))
        for error, scalar, fine in ((0.99 * edge, "double", True), (0.99 * edge, "float", False), (None, "double", False), (float("nan"), "double", False)):
            self.assertEqual(useful(error, scalar), fine)

    def test_without_times_the_least_error_comes_first(self):
        cells = candidates(fixture.bundle(without=("pareto.csv", "timing.csv")))
        self.assertEqual({cell.mode for cell in cells}, {NO_TIME})
        errors = [one.error_u for one in cells[default_cell(cells)]]
        self.assertEqual(errors, sorted(errors))
        with self.assertRaises(Missing):
            self.answer(fixture.bundle(without=("pareto.csv", "accuracy.csv", "unstable.csv")))


class Tiles(unittest.TestCase):
    def tiles(self, bundle):
        return {tile.label: tile for block in first_glance.opening(bundle, None) if block.kind == "tiles" for tile in block.items}

    def test_violations_are_counted_and_the_width_of_intervals_said(self):
        calm = self.tiles(fixture.bundle())
        self.assertEqual((calm["violations"].value, calm["violations"].mark), ("0", "inside"))
        self.assertEqual((calm["machine"].value, calm["digest"].value), ("test", "ab"))
        changes = (changed("accuracy.csv", {"bound_violations": 2}, study="regimes-degree", degree=100),
                   changed("arc_length.csv", {"broken_promises": 1}, method="adaptive_simpson38", generator="integer", tolerance=1e-3))

        def trouble(at, row):
            for change in changes:
                change(at, row)
            if at == "timing.csv" and row["ratio"] and row["relative_to"] != row["method"]:
                row.update(ratio=2, ratio_low=1.9, ratio_high=2.2)
        tiles = self.tiles(fixture.bundle(trouble))
        self.assertEqual((tiles["violations"].value, tiles["violations"].mark), ("3", "outside"))
        self.assertIn("1 broken promise", tiles["violations"].note)
        self.assertNotIn("promises", tiles["violations"].note)
        self.assertEqual(tiles["times"].value, "15 %")
        self.assertEqual(self.tiles(fixture.bundle(without=("timing.csv",)))["times"].value, "none")

    def test_a_machine_that_is_not_known(self):
        bundle = fixture.bundle()
        for bundle.machine in (None, {}, {"cpu": "x", "build": []}, {"cpu": {"model_name": "unknown", "virtualised": "yes"}}):
            self.assertEqual(self.tiles(bundle)["machine"].value, "unknown")


if __name__ == "__main__":
    unittest.main()
