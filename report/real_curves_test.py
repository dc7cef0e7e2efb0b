# SPDX-License-Identifier: MIT
"""Pages about curve sets: their words, what is not mixed up, and the chapter that opens them."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

from . import fixture, render
from .answer import candidates
from .bundle import Bundle
from .chapters.roster import build_all
from .figures import curve_sets
from .findings.roster import find_all
from .fixture import changed, of_kind, texts

ERRORS = "accuracy.csv"


def _bundle(change=None, suite=fixture.real.SUITE):
    return fixture.bundle(change, **{**fixture.REAL, "suite": suite})


def _chapters(change=None, **more):
    bundle = _bundle(change, **more)
    return {chapter.id: chapter for chapter in build_all(bundle, find_all(bundle))[0]}


def _table(name, change=None):
    return of_kind(_chapters(change)["real-curves"].blocks, "table")[f"real-{name}-bernstein-3-2"]


class RealCurves(unittest.TestCase):
    def setUp(self):
        fixture.without_figures(self)

    def test_no_row_of_a_set_is_said_to_have_a_range(self):
        bundle = _bundle()
        page = render.files(bundle, *build_all(bundle, find_all(bundle)))["report.md"].decode()
        self.assertNotRegex(page, r"R = [,)\n]|t in \\\[, ")
        self.assertNotIn("stored inputs", page)
        self.assertIn("degree 2, 2 axes, curves of sets, as stored", page)
        self.assertIn("R = 1, t in \\[0, 1\\], continuous inputs", page)

    def test_one_set_is_named_in_captions_and_random_curves_are_not_needed(self):
        chapters = _chapters(lambda _, row: row["curves"] == "icons" or row["study"] == "real-local")
        self.assertIn("curves of the set icons, as stored", of_kind(chapters["suite-real"].blocks, "table")["real-sets-1-mean"].caption)
        self.assertNotIn("real-reversed-bernstein-3-2", of_kind(chapters["real-curves"].blocks, "table"))

    def test_sets_run_across_and_every_cell_is_of_one_row(self):
        """Errors that name their row: a table of degree 3 has a column for each set with its own."""
        def change(file, row):
            if row["study"] == "real-sets":
                row["mean_error_u"] = ("outlines", "icons", "few").index(row["curves"]) + row["degree"] / 10 + (0.01 if row["generator"] == "stored" else 0.02)
        tables = of_kind(_chapters(change)["suite-real"].blocks, "table")
        tables = [table for id, table in tables.items() if id.startswith("real-sets") and id.endswith("-mean")]
        self.assertEqual(len(tables), 4)  # two degrees, two placements
        for table in tables:
            degree, placed = (2 if "degree 2" in table.caption else 3), (0.01 if "as stored" in table.caption else 0.02)
            wanted = [("outlines", "icons", "few").index(name) + degree / 10 + placed for name in table.head]
            for group in table.groups:
                for _, cells in group.rows:
                    self.assertEqual([float(cell.raw) for cell in cells], wanted)

    def test_a_shipped_suite_on_sets_is_shown_as_a_users_own(self):
        """Its chapter and its findings are about drawn curves."""
        chapters = _chapters(suite=fixture.real.SUITE.replace('id = "real"', 'id = "regimes"'))
        self.assertIn("real-sets-1-mean", of_kind(chapters["suite-regimes"].blocks, "table"))
        drawn = of_kind(chapters["regimes"].blocks, "table")
        self.assertEqual({id.split("-")[1] for id in drawn}, {"random", "local"})
        self.assertEqual(dict(drawn["real-random-mean"].groups[0].rows[0][1][0].units)["size"], "6.00e-7")

    def test_the_picker_has_a_cell_for_each_set_and_placement(self):
        places = {cell.where for cell in candidates(_bundle()) if (cell.degree, cell.scalar) == (3, "float")}
        self.assertLessEqual({"curves of the set icons, as stored", "curves of the set icons, translated on a page", "curves of the set outlines, as stored",
                              "R = 1, t in [0, 1]"}, places)

    def test_it_follows_the_first_glance_where_there_are_sets(self):
        self.assertEqual(list(_chapters())[:3], ["opening", "real-curves", "answer"])
        self.assertNotIn("real-curves", _chapters(lambda _, row: row["curves"] == ""))

    def test_shares_by_set_without_sets_of_too_few_trials(self):
        table = _table("misrounded")
        self.assertEqual(table.head, ("outlines", "icons"))
        self.assertEqual(texts(table)["differences:horner", "float, as stored"], ["4 %", "4 %"])
        self.assertEqual(texts(table)["differences:horner", "double, translated on a page"], ["0.50 %", "0.50 %"])

    def test_errors_are_the_largest_over_the_sets(self):
        table = _table("errors", changed(ERRORS, {"max_error_size": 0.25}, curves="icons", method="direct", degree=3, generator="stored"))
        self.assertEqual(texts(table)["direct", "float"][list(table.head).index("largest / size, as stored")], "0.250")

    def test_what_reverses(self):
        table = _table("reversed")
        self.assertEqual([group.key for group in table.groups], ["differences:horner"])
        self.assertEqual(texts(table)["differences:horner", "share misrounded"], ["70 %", "0.50 % to 4 %", "`direct` and `de_casteljau`", ""])
        # on icons de Casteljau stays ahead
        table = _table("reversed", changed(ERRORS, {"misrounded": 0.001}, curves="icons", method="de_casteljau"))
        self.assertEqual(texts(table)["differences:horner", "share misrounded"][2:], ["`direct`", "`de_casteljau`"])
        with self.assertRaises(KeyError):  # where random curves agree
            _table("reversed", changed(ERRORS, dict(misrounded=0.01, mean_error_u=0.01), study="real-random", method="differences:horner"))

    def test_the_conclusion_is_judged_by_the_rows(self):
        for change, holds in ((None, False), (changed(ERRORS, dict(misrounded=0.001, mean_error_u=0.001, max_error_u=0.001), method="de_casteljau"), True)):
            said = next(f for f in find_all(_bundle(change))[0] if f.id == "via_power_worse_on_sets")
            self.assertEqual((said.holds, "in none of 12 comparisons" in said.headline), (holds, not holds))


class Figure(unittest.TestCase):
    def test_it_has_both_local_curves_and_sets(self):
        figure = next(block for block in _chapters()["real-curves"].blocks if block.kind == "figure")
        points = {series.name: len(series.points) for series in figure.drawing.series}
        self.assertEqual(points["differences:horner"], 2 * 3 + 2 + 4)  # degrees by distances, then sets by placements

    def test_sets_that_the_bundle_keeps_are_drawn(self):
        """Curves of size 4 and 1 at distances 4 and 5, a quarter of a circle, a point, and a curve in power form."""
        self.assertNotIn("curves-of-sets", of_kind(_chapters()["real-curves"].blocks, "figure"))
        with tempfile.TemporaryDirectory() as place:
            fixture.write(place, **fixture.REAL)
            Path(place, "curves_few.csv").write_text(
                "curve,index,form,x,y,w\na,0,bernstein,0,0,\na,1,bernstein,2,2,\na,2,bernstein,2,4,\nb,0,bernstein,0x1.4p+2,0,\nb,1,bernstein,4,0.5,\n"
                "c,0,rational,1,0,1\nc,1,rational,1,1,0.7071067811865476\nc,2,rational,0,1,1\nd,0,bernstein,1,1,\nd,1,bernstein,1,1,\n"
                "e,0,power,1,1,\ne,1,power,1,7,\n", encoding="utf-8")
            bundle = Bundle(fixture.seal(place))
        figure = of_kind({chapter.id: chapter for chapter in build_all(bundle, find_all(bundle))[0]}["real-curves"].blocks, "figure")["curves-of-sets"]
        self.assertIn("few: half of the curves are nearer than 1 times", figure.alt)
        self.assertIn("few: 3 curves", figure.drawing.svg)
        found = list(curve_sets._curves(bundle["curves_few.csv"]))
        self.assertEqual([curve_sets._distance(points) for points, _ in found], [1, 5, 1])
        outline = curve_sets._outline(*found[0])  # the middle of the curve is (1.5, 2), its box 2 by 4 about (1, 2)
        np.testing.assert_allclose(outline[:, curve_sets.STEPS // 2], (0.125, 0))
        circle = curve_sets._outline(*found[2]) + 0.5
        np.testing.assert_allclose(np.hypot(*circle), 1, rtol=1e-15)


if __name__ == "__main__":
    unittest.main()
