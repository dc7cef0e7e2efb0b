# SPDX-License-Identifier: MIT
"""The tiles and the answer: what they count, whom they rank, and whom they leave out as useless."""

import tempfile
import unittest
from pathlib import Path

from . import fixture
from .answer import NO_TIME, USELESS, candidates, default_cell, is_proved_small, lost, useful
from .bundle import Bundle, Missing
from .chapters import choice, first_glance, speed
from .findings.roster import find_all

U = 2.0 ** -53


class Answer(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place, self.made = Path(place.name), 0

    def bundle(self, change=None, without=()):
        self.made += 1
        return Bundle(fixture.write(self.place / f"b{self.made}", change, without))

    def tiles(self, bundle):
        return {tile.label: tile for block in first_glance.opening(bundle, None) if block.kind == "tiles" for tile in block.items}

    def test_methods_are_ranked_by_time(self):
        cells = candidates(self.bundle())
        cell = default_cell(cells)
        self.assertEqual((cell.form, cell.mode, cell.scalar, cell.dimension), ("bernstein", "point", "double", 2))
        times = [one.ns for one in cells[cell]]
        self.assertEqual(times, sorted(times))
        block = next(b for b in choice.answer(self.bundle(), None) if b.kind == "answer")
        self.assertEqual([g.key for g in block.table.groups], ["horner_bernstein", "direct", "de_casteljau", "compensated_de_casteljau"])
        self.assertIn("`horner_bernstein`", block.sentence)
        self.assertNotIn("`direct`", block.sentence)  # dominated

    def test_a_method_without_a_small_proved_bound_is_not_recommended(self):
        """The default is the README's need; the fastest method here loses log10(8219) = 3.9 digits."""
        def loses_digits(at, row):
            if at == "pareto.csv" and row["method"] == "horner_bernstein":
                row.update(observed_max_u=8219, bound_u=1.97e6)
        bundle = self.bundle(loses_digits)
        block = next(b for b in choice.answer(bundle, None) if b.kind == "answer")
        self.assertNotIn("horner_bernstein", block.sentence)
        self.assertIn("with a proved bound of at most 20 u p~, fastest first: `compensated_de_casteljau`", block.sentence)
        last = block.table.groups[-1]
        self.assertEqual(last.key, "horner_bernstein")
        texts = [cell.text for cell in last.rows[0][1]]
        self.assertIn("8219, loses 4 digits", texts)
        self.assertFalse(any(cell.mark == "inside" for cell in last.rows[0][1]))
        tables = [b for b in speed.choosing(bundle, find_all(bundle)) if b.kind == "table"]
        cells = [c for t in tables for g in t.groups if g.key == "horner_bernstein" for _, row in g.rows for c in row if c.text]
        self.assertTrue(cells)
        self.assertTrue(all("8219 u, loses 4 digits" in c.text and c.mark == "" for c in cells), [c.text for c in cells])

    def test_what_is_lost_is_said_beyond_100(self):
        self.assertEqual([lost(u) for u in (None, 1.0, 100.0, 101.0, 999.0, 3e5, float("inf"))],
                         ["", "", "", "loses 2 digits", "loses 3 digits", "loses 5 digits", ""])

    def test_a_small_bound_is_that_of_the_form(self):
        self.assertTrue(is_proved_small(15.0, 3, "bernstein"))
        self.assertFalse(is_proved_small(15.1, 3, "bernstein"))
        self.assertTrue(is_proved_small(30.0, 3, "rational"))
        self.assertFalse(is_proved_small(None, 3, "bernstein"))
        self.assertFalse(is_proved_small(float("nan"), 3, "bernstein"))

    def test_a_useless_method_is_not_worth_choosing(self):
        def ruin(at, row):
            if at == "pareto.csv" and row["method"] == "horner_bernstein":
                row["observed_max_u"] = 1.01 * USELESS / U
        bundle = self.bundle(ruin)
        block = next(b for b in choice.answer(bundle, None) if b.kind == "answer")
        self.assertNotIn("horner_bernstein", [g.key for g in block.table.groups])
        tables = [b for b in speed.choosing(bundle, find_all(bundle)) if b.kind == "table"]
        self.assertTrue(tables)
        self.assertFalse(any(g.key == "horner_bernstein" for table in tables for g in table.groups))
        self.assertTrue(useful(0.99 * USELESS / U, "double"))
        self.assertFalse(useful(0.99 * USELESS / U, "float"))
        self.assertFalse(useful(None, "double"))
        self.assertFalse(useful(float("nan"), "double"))

    def test_without_times_the_least_error_comes_first(self):
        bundle = self.bundle(without=("pareto.csv", "timing.csv"))
        cells = candidates(bundle)
        self.assertEqual({cell.mode for cell in cells}, {NO_TIME})
        errors = [one.error_u for one in cells[default_cell(cells)]]
        self.assertEqual(errors, sorted(errors))

    def test_nothing_to_rank_is_no_answer(self):
        bundle = self.bundle(without=("pareto.csv", "accuracy.csv", "unstable.csv"))
        with self.assertRaises(Missing):
            list(choice.answer(bundle, None))

    def test_tiles_count_violations_and_say_how_wide_intervals_are(self):
        calm = self.tiles(self.bundle())
        self.assertEqual((calm["violations"].value, calm["violations"].mark), ("0", "inside"))
        self.assertEqual((calm["machine"].value, calm["digest"].value), ("test", "ab"))

        def trouble(at, row):
            if at == "accuracy.csv" and row["study"] == "regimes-degree" and row["degree"] == 100:
                row["bound_violations"] = 2
            if at == "arc_length.csv" and row["method"] == "adaptive_simpson38" and row["generator"] == "integer" and row["tolerance"] == 1e-3:
                row["broken_promises"] = 1
            if at == "timing.csv" and row["ratio"] and row["relative_to"] != row["method"]:
                row.update(ratio=2, ratio_low=1.9, ratio_high=2.2)
        tiles = self.tiles(self.bundle(trouble))
        self.assertEqual((tiles["violations"].value, tiles["violations"].mark), ("3", "outside"))
        self.assertIn("1 broken promise", tiles["violations"].note)
        self.assertNotIn("promises", tiles["violations"].note)
        self.assertEqual(tiles["times"].value, "15 %")
        self.assertEqual(self.tiles(self.bundle(without=("timing.csv",)))["times"].value, "none")

    def test_a_machine_that_is_not_known(self):
        bundle = self.bundle()
        for machine in (None, {}, {"cpu": "x", "build": []}, {"cpu": {"model_name": "unknown", "virtualised": "yes"}}):
            bundle.machine = machine
            self.assertEqual(self.tiles(bundle)["machine"].value, "unknown")


if __name__ == "__main__":
    unittest.main()
