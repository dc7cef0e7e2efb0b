# SPDX-License-Identifier: MIT
"""Pages about curve sets: their words, what is not mixed up, and the chapter that opens them."""

import functools
import tempfile
import unittest

from . import fixture, render
from .answer import candidates
from .bundle import Bundle
from .chapters.roster import build_all
from .findings.roster import find_all


def _bundle(change=None):
    with tempfile.TemporaryDirectory() as place:
        return Bundle(fixture.write_real(f"{place}/b", change))


def _chapters(change=None):
    bundle = _bundle(change)
    return {chapter.id: chapter for chapter in build_all(bundle, find_all(bundle))[0]}


_as_it_is = functools.cache(_chapters)


def _tables(chapter):
    return {block.id: block for block in chapter.blocks if block.kind == "table"}


def _finding(bundle):
    return next(f for f in find_all(bundle)[0] if f.id == "via_power_worse_on_sets")


class Words(unittest.TestCase):
    def test_no_row_of_a_set_is_said_to_have_a_range(self):
        bundle = _bundle()
        page = render.files(bundle, *build_all(bundle, find_all(bundle)))["report.md"].decode()
        self.assertNotRegex(page, r"R = [,)\n]|t in \\\[, ")
        self.assertNotIn("stored inputs", page)
        self.assertIn("degree 2, 2 axes, curves of sets, as stored", page)
        self.assertIn("R = 1, t in \\[0, 1\\], continuous inputs", page)

    def test_one_set_is_named_in_captions(self):
        tables = _tables(_chapters(lambda _, row: row["curves"] in ("", "icons"))["suite-real"])
        self.assertIn("curves of the set icons, as stored", tables["real-sets-1-mean"].caption)


class NotMixed(unittest.TestCase):
    def test_sets_run_across_and_every_cell_is_of_one_row(self):
        """Errors that name their row: a table of degree 3 has a column for each set with its own."""
        def change(file, row):
            if row["study"] == "real-sets":
                row["mean_error_u"] = ("outlines", "icons", "few").index(row["curves"]) + row["degree"] / 10 + (0.01 if row["generator"] == "stored" else 0.02)
        tables = [t for id, t in _tables(_chapters(change)["suite-real"]).items() if id.startswith("real-sets") and id.endswith("-mean")]
        self.assertEqual(len(tables), 4)  # two degrees, two placements
        for table in tables:
            degree, placed = (2 if "degree 2" in table.caption else 3), (0.01 if "as stored" in table.caption else 0.02)
            wanted = [("outlines", "icons", "few").index(name) + degree / 10 + placed for name in table.head]
            for group in table.groups:
                for _, cells in group.rows:
                    self.assertEqual([float(cell.raw) for cell in cells], wanted)

    def test_a_shipped_suite_on_sets_is_shown_as_a_users_own(self):
        """Its chapter and its findings are about drawn curves."""
        with tempfile.TemporaryDirectory() as place:
            path = fixture.write_real(f"{place}/b")
            (path / "suite.toml").write_text(fixture.real.SUITE.replace('id = "real"', 'id = "regimes"'))
            bundle = Bundle(fixture.seal(path))
        chapters = {chapter.id: chapter for chapter in build_all(bundle, find_all(bundle))[0]}
        self.assertIn("real-sets-1-mean", _tables(chapters["suite-regimes"]))
        self.assertEqual({id.split("-")[1] for id in _tables(chapters["regimes"])}, {"random", "local"})

    def test_the_picker_has_a_cell_for_each_set_and_placement(self):
        cells = candidates(_bundle())
        places = {cell.where for cell in cells if (cell.degree, cell.scalar) == (3, "float")}
        self.assertLessEqual({"curves of the set icons, as stored", "curves of the set icons, translated on a page", "curves of the set outlines, as stored",
                              "R = 1, t in [0, 1]"}, places)

    def test_errors_have_the_size_as_a_unit(self):
        cell = _tables(_as_it_is()["suite-real"])["real-random-mean"].groups[0].rows[0][1][0]
        self.assertEqual(dict(cell.units)["size"], "6.00e-7")


class Chapter(unittest.TestCase):
    def test_it_follows_the_first_glance_where_there_are_sets(self):
        self.assertEqual(list(_as_it_is())[:3], ["opening", "real-curves", "answer"])
        self.assertNotIn("real-curves", _chapters(lambda _, row: row["curves"] == ""))

    def test_shares_by_set_without_sets_of_too_few_trials(self):
        table = _tables(_as_it_is()["real-curves"])["real-misrounded-bernstein-3-2"]
        self.assertEqual(table.head, ("outlines", "icons"))
        rows = {(group.key, label): [cell.text for cell in cells] for group in table.groups for label, cells in group.rows}
        self.assertEqual(rows["differences:horner", "float, as stored"], ["4 %", "4 %"])
        self.assertEqual(rows["differences:horner", "double, translated on a page"], ["0.50 %", "0.50 %"])

    def test_errors_are_the_largest_over_the_sets(self):
        def change(file, row):
            if (row["curves"], row["method"], row["degree"], row["generator"]) == ("icons", "direct", 3, "stored"):
                row["max_error_size"] = 0.25
        table = _tables(_chapters(change)["real-curves"])["real-errors-bernstein-3-2"]
        cells = next(group for group in table.groups if group.key == "direct").rows[0][1]
        self.assertEqual(cells[list(table.head).index("largest / size, as stored")].text, "0.250")

    def test_what_reverses(self):
        table = _tables(_as_it_is()["real-curves"])["real-reversed-bernstein-3-2"]
        (group,) = table.groups
        self.assertEqual(group.key, "differences:horner")
        self.assertEqual([cell.text for cell in group.rows[0][1]], ["70 %", "0.50 % to 4 %", "`direct` and `de_casteljau`", ""])

        def one_set(file, row):  # on icons de Casteljau stays ahead
            if (row["curves"], row["method"]) == ("icons", "de_casteljau"):
                row["misrounded"] = 0.001
        cells = _tables(_chapters(one_set)["real-curves"])["real-reversed-bernstein-3-2"].groups[0].rows[0][1]
        self.assertEqual([cell.text for cell in cells[2:]], ["`direct`", "`de_casteljau`"])

    def test_nothing_reverses_where_random_curves_agree_or_are_missing(self):
        def agree(file, row):
            if row["study"] == "real-random" and row["method"] == "differences:horner":
                row.update(misrounded=0.01, mean_error_u=0.01)
        for change in (agree, lambda file, row: row["study"] != "real-random"):
            self.assertNotIn("real-reversed-bernstein-3-2", _tables(_chapters(change)["real-curves"]))

    def test_the_figure_has_both_local_curves_and_sets(self):
        figure = next(block for block in _as_it_is()["real-curves"].blocks if block.kind == "figure")
        points = {series.name: len(series.points) for series in figure.drawing.series}
        self.assertEqual(points["differences:horner"], 2 * 3 + 2 + 4)  # degrees by distances, then sets by placements

    def test_the_conclusion_is_judged_by_the_rows(self):
        said = _finding(_bundle())
        self.assertFalse(said.holds)
        self.assertIn("in none of 12 comparisons", said.headline)

        def better(file, row):
            if row["method"] == "de_casteljau":
                row.update(misrounded=0.001, mean_error_u=0.001, max_error_u=0.001)
        self.assertTrue(_finding(_bundle(better)).holds)


if __name__ == "__main__":
    unittest.main()
