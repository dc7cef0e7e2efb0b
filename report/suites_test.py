# SPDX-License-Identifier: MIT
"""A chapter for each suite: there where the bundle has its studies, said to be left out where not, readable without new columns."""

import csv
import tempfile
import unittest
from pathlib import Path

from . import fixture
from .bundle import Bundle, BundleError, Missing
from .chapters.parts import ROSTER
from .chapters.roster import build_all
from .error_tables import search_tables, swept
from .findings.roster import find_all
from .fixture import evaluators

# by suite: the chapters that have findings
CHAPTERS = {one.suite: one for one in ROSTER if one.suite not in ("", "report", "guarantees")}


def _only(*suites):
    """A change that keeps the rows of some suites."""
    def change(_, row):
        return not row.get("study") or row["study"].startswith(tuple(f"{s}-" for s in suites))
    return change


def _without(path, columns):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, [c for c in rows[0] if c not in columns], extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


class Suites(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def bundle(self, change=None):
        return Bundle(fixture.write(self.place / "b", change))

    def blocks(self, suite, bundle):
        return list(CHAPTERS[suite].blocks(bundle, find_all(bundle)))

    def test_a_bundle_of_one_suite_has_its_chapter_and_names_the_others(self):
        for suite in CHAPTERS:
            with self.subTest(suite):
                bundle = self.bundle(_only(suite))
                found = find_all(bundle)
                self.assertEqual({f.suite for f in found[0]} - {""}, {suite})
                absent = {}
                for other, module in CHAPTERS.items():
                    try:
                        list(module.blocks(bundle, found))
                    except Missing as lack:
                        absent[other] = str(lack)
                self.assertEqual(set(absent), set(CHAPTERS) - {suite})
                for other, lack in absent.items():
                    self.assertTrue(f"`{other}`" in lack or "the bundle has no" in lack, lack)

    def test_conclusion_then_figure_then_tables_then_notes(self):
        bundle = self.bundle()
        for suite in CHAPTERS:
            with self.subTest(suite):
                kinds = [b.kind for b in self.blocks(suite, bundle) if b.kind != "heading"]
                self.assertEqual(kinds[0], "finding")
                self.assertLess(kinds.index("figure"), kinds.index("table"))
                self.assertEqual(kinds[-1], "text")

    def test_errors_of_evaluators_on_knot_spans(self):
        blocks = self.blocks("bspline", self.bundle())
        at = next(k for k, block in enumerate(blocks) if block.kind == "heading" and block.text == "Evaluators on knot spans")
        self.assertIn("bspline-evaluators", [block.id.rsplit("-", 1)[0] for block in blocks[at:] if block.kind == "table"])

    def test_old_bundles_without_the_new_columns_stay_readable(self):
        fixture.write(self.place / "b")
        _without(self.place / "b" / "accuracy.csv", evaluators.SOMETIMES)
        _without(self.place / "b" / "conversion.csv", ("form", "dimension", "status", "non_finite"))
        for file in ("search.csv", "worst.csv"):
            (self.place / "b" / file).unlink()
        fixture.seal(self.place / "b")
        bundle = Bundle(self.place / "b")
        chapters, left_out = build_all(bundle, find_all(bundle))
        self.assertIn(CHAPTERS["conditioning"].title, dict(left_out))
        self.assertIn("p50_condition", dict(left_out)[CHAPTERS["conditioning"].title])
        self.assertLessEqual({"ladder", "regimes", "conversion", "rational"}, {c.id for c in chapters})
        figures = {b.id for c in chapters for b in c.blocks if b.kind == "figure"}
        self.assertIn("conversion-interval", figures)
        self.assertFalse(figures & {"conversion-sources", "conversion-coefficients", "error-against-condition"})

    def test_inputs_of_worst_cases_stay_text(self):
        bundle = self.bundle()
        row = bundle["search.csv"].rows[0]
        self.assertEqual((row["t"], row["coefficients"]), ("0x1p-2", "0x1p+0 -0x1p-1 0.25 1"))
        self.assertEqual(bundle["worst.csv"].rows[0]["worst_id"], "w1")

    def test_malformed_search_is_an_error(self):
        path = fixture.write(self.place / "b") / "search.csv"
        path.write_text(path.read_text().replace("s1,", ",", 1))
        fixture.seal(self.place / "b")
        with self.assertRaisesRegex(BundleError, "search_id"):
            Bundle(self.place / "b")

    def test_search_table_holds_every_cell_with_its_gain_and_id(self):
        table, = search_tables(self.bundle(), "worst")
        lines = {(g.key, label): cells for g in table.groups for label, cells in g.rows}
        self.assertEqual([c.text for c in lines["direct", "degree 4"]], ["4", "8", "17", "2", "reached", "`s1`"])
        self.assertEqual(lines["de_casteljau_lerp", "degree 20"][2].text, "")
        self.assertEqual(sum(len(g.rows) for g in table.groups), 6)
        self.assertFalse(any(c.mark for cells in lines.values() for c in cells))

        def exceed(at, row):
            if at == "search.csv" and row["search_id"] == "s1":
                row["searched_error_u"] = 17.5
        table, = search_tables(self.bundle(exceed), "worst")
        self.assertEqual(table.groups[0].rows[0][1][1].mark, "outside")

    def test_a_search_without_a_finite_value_is_shown(self):
        def lose(at, row):
            if at == "search.csv" and row["search_id"] == "s1":
                row.update(status="non_finite", sampled_error_u="inf", searched_error_u="")
        table, = search_tables(self.bundle(lose), "worst")
        cells = table.groups[0].rows[0][1]
        self.assertEqual([c.text for c in cells], ["inf", "", "17", "", "non_finite", "`s1`"])
        self.assertEqual(cells[4].mark, "outside")

    def test_an_axis_is_found_from_what_a_study_varies(self):
        table = self.bundle().exact("regimes")
        axes = {s.removeprefix("regimes-"): swept(table.select(study=s)) for s in table.distinct("study")}
        self.assertEqual(axes, {"parameter": ("interval", "generator"), "range": ("coordinate_range", "generator"),
                                "degree": ("degree", "generator"), "float": ("degree", "scalar"), "dimension": ("degree", "dimension")})

    def test_a_table_explains_an_error_above_the_bound(self):
        def outside(at, row):
            if at == "accuracy.csv" and row["study"] == "regimes-parameter" and row["method"] == "wozny_chudy" and row["t_max"] == 2:
                row["max_error_u"] = 1e20

        def notes(bundle):
            return [b.text for b in self.blocks("regimes", bundle) if b.kind == "text" and "to which the proof does not apply" in b.text]
        self.assertEqual(notes(self.bundle()), [])
        self.assertEqual(len(notes(self.bundle(outside))), 1)

    def test_maxima_beyond_the_axis_share_a_line_of_text(self):
        def ruin(at, row):
            if at == "search.csv" and row["search_id"] == "s1":
                row.update(sampled_error_u=2e5, searched_error_u=5e9)
        drawn = next(b for b in self.blocks("worst", self.bundle(ruin)) if b.kind == "figure")
        self.assertIn(">sampled 200000, searched 5.00e9 →<", drawn.drawing.svg)

    def test_columns_of_a_conditioning_table_rise_with_the_condition_number(self):
        table = next(b for b in self.blocks("conditioning", self.bundle()) if b.kind == "table")
        medians = [float(c.raw) for c in table.groups[0].rows[0][1]]
        self.assertEqual(medians, [1.0, 1e10, 1e20, 1e36])
        head, rows = table.csv()
        self.assertEqual(head[1:3], ["t_min", "t_max"])
        self.assertEqual(len(rows), 8)

    def test_peers_have_errors_and_times_in_one_table(self):
        table = next(b for b in self.blocks("peers", self.bundle()) if b.kind == "table")
        lines = {(g.key, label): [c.text for c in cells] for g in table.groups for label, cells in g.rows}
        self.assertEqual(lines["peer_gsl", "mean error / (u p~)"], ["0.500", "0.500"])
        self.assertEqual(lines["peer_gsl", "ns per point, prepared"], ["32", "160"])
        self.assertIn(("de_casteljau", "mean error / (u p~)"), lines)

    def test_other_libraries_stand_in_the_chapter_of_their_problem(self):
        blocks = self.blocks("arc_length", self.bundle(_only("companion_peers")))
        tables = [b for b in blocks if b.kind == "table" and b.id.startswith("companion_peers-length-")]
        self.assertEqual([[g.key for g in t.groups] for t in tables], [["gauss_legendre_adaptive", "peer_2geom_length"]] * 2)

    def test_halves_that_do_not_fit_together_are_counted_and_marked(self):
        def table(change=None):
            bundle = self.bundle(change)
            found = next(b for b in CHAPTERS["subdivision"].blocks(bundle, find_all(bundle)) if b.kind == "table" and b.id.endswith("-kept"))
            return {(g.key, label): [(c.text, c.mark) for c in cells] for g in found.groups for label, cells in g.rows}

        def apart(at, row):
            if at == "subdivision.csv" and row["method"] == "lerp_split" and row["degree"] == 20:
                row["junctions_apart"] = 3
        self.assertEqual(table()["lerp_split", "junctions apart"], [("0", "")] * 2)
        self.assertEqual(table(apart)["lerp_split", "junctions apart"], [("0", ""), ("3", "outside")])
        self.assertIn(("de_casteljau_split", "points off"), table())
        self.assertNotIn(("lerp_split", "points off"), table())

    def test_malformed_suite_is_an_error(self):
        path = fixture.write(self.place / "b") / "suite.toml"
        path.write_text("[[suites]")
        fixture.seal(self.place / "b")
        with self.assertRaisesRegex(BundleError, "suite.toml"):
            Bundle(self.place / "b")

    def test_peers_without_times_keep_their_errors(self):
        def no_times(at, row):
            return at != "timing.csv" or row["study"] != "peers-speed"
        table = next(b for b in self.blocks("peers", self.bundle(no_times)) if b.kind == "table")
        self.assertEqual({label for g in table.groups for label, _ in g.rows},
                         {"mean error / (u p~)", "largest error / (u p~)", "largest error"})

    def test_a_bundle_without_peers_says_so(self):
        def ours_only(at, row):
            return at != "unstable.csv"
        with self.assertRaisesRegex(Missing, "unstable.csv"):
            self.blocks("peers", self.bundle(ours_only))

    def test_replay_names_the_largest_kept_trial(self):
        def heavy(at, row):
            if at == "worst.csv" and row["study"] == "ladder-bezier" and row["method"] == "de_casteljau" and row["degree"] == 20:
                row["error_u"] = 1e30
        bundle = self.bundle(heavy)
        heaviest = max((r for r in bundle["worst.csv"].rows), key=lambda r: r["error_u"])
        note = self.blocks("ladder", bundle)[-1].text
        self.assertIn(f"`bezierbench replay BUNDLE {heaviest['worst_id']}`", note)
        self.assertIn("`de_casteljau`", note)


if __name__ == "__main__":
    unittest.main()
