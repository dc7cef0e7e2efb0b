# SPDX-License-Identifier: MIT
"""A chapter for each suite: there where the bundle has its studies, said to be left out where not, readable without new columns."""

import unittest

from . import fixture, summary
from .bundle import BundleError, Missing
from .chapters.parts import ROSTER
from .chapters.printed import MARK, scorecard
from .chapters.roster import build_all
from .error_tables import search_tables, swept
from .findings.roster import find_all
from .fixture import changed, evaluators, of_kind, only, texts

# by suite: the chapters that have findings
CHAPTERS = {one.suite: one for one in ROSTER if one.suite not in ("", "report", "guarantees")}
SEARCHED = dict(search_id="s1")


def _blocks(suite, change=None):
    bundle = fixture.bundle(change)
    return list(CHAPTERS[suite].blocks(bundle, find_all(bundle)))


class Shown(unittest.TestCase):
    """With their figures."""

    def test_conclusion_then_figure_then_tables_then_notes(self):
        bundle = fixture.bundle()
        found = find_all(bundle)
        for suite, chapter in CHAPTERS.items():
            with self.subTest(suite):
                kinds = [b.kind for b in chapter.blocks(bundle, found) if b.kind != "heading"]
                self.assertEqual(kinds[0], "finding")
                self.assertLess(kinds.index("figure"), kinds.index("table"))
                self.assertEqual(kinds[-1], "text")

    def test_old_bundles_without_the_new_columns_stay_readable(self):
        bundle = fixture.bundle(lambda at, row: at != "accuracy.csv" or row["study"].startswith(tuple(CHAPTERS)), without=("search.csv", "worst.csv"),
                                left_out={"accuracy.csv": evaluators.SOMETIMES, "conversion.csv": ("form", "dimension", "status", "non_finite")})
        bundle = bundle.only({study.id for study in bundle.studies.values() if study.suite in ("ladder", "regimes", "conversion", "rational", "conditioning")})
        chapters, left_out = build_all(bundle, find_all(bundle))
        self.assertIn("p50_condition", dict(left_out)[CHAPTERS["conditioning"].title])
        self.assertLessEqual({"ladder", "regimes", "conversion", "rational"}, {c.id for c in chapters})
        figures = {b.id for c in chapters for b in c.blocks if b.kind == "figure"}
        self.assertIn("conversion-interval", figures)
        self.assertFalse(figures & {"conversion-sources", "conversion-coefficients", "error-against-condition"})

    def test_maxima_beyond_the_axis_share_a_line_of_text(self):
        blocks = _blocks("worst", changed("search.csv", dict(sampled_error_u=2e5, searched_error_u=5e9), **SEARCHED))
        drawn = next(b for b in blocks if b.kind == "figure")
        self.assertIn(">sampled 200000, searched 5.00e9 →<", drawn.drawing.svg)


class Suites(unittest.TestCase):
    def setUp(self):
        fixture.without_figures(self)

    def table(self, suite, change=None, end=""):
        return next(b for b in _blocks(suite, change) if b.kind == "table" and b.id.endswith(end))

    def test_a_bundle_of_one_suite_has_its_chapter_and_names_the_others(self):
        for suite in CHAPTERS:
            with self.subTest(suite):
                bundle = fixture.bundle(only([suite]))
                found = find_all(bundle)
                self.assertEqual({f.suite for f in found[0]} - {""}, {suite})
                absent = {}
                for other, chapter in CHAPTERS.items():
                    try:
                        list(chapter.blocks(bundle, found))
                    except Missing as lack:
                        absent[other] = str(lack)
                self.assertEqual(set(absent), set(CHAPTERS) - {suite})
                for other, lack in absent.items():
                    self.assertTrue(f"`{other}`" in lack or "the bundle has no" in lack, lack)

    def test_errors_of_evaluators_on_knot_spans(self):
        blocks = _blocks("bspline")
        at = next(k for k, block in enumerate(blocks) if block.kind == "heading" and block.text == "Evaluators on knot spans")
        self.assertIn("bspline-evaluators-mean", of_kind(blocks[at:], "table"))

    def test_inputs_of_worst_cases_stay_text(self):
        bundle = fixture.bundle()
        row = bundle["search.csv"].rows[0]
        self.assertEqual((row["t"], row["coefficients"]), ("0x1p-2", "0x1p+0 -0x1p-1 0.25 1"))
        self.assertEqual(bundle["worst.csv"].rows[0]["worst_id"], "w1")

    def test_search_table_holds_every_cell_with_its_gain_and_id(self):
        table, = search_tables(fixture.bundle(), "worst")
        lines = texts(table)
        self.assertEqual(lines["direct", "degree 4"], ["4", "8", "17", "2", "reached", "`s1`"])
        self.assertEqual(lines["de_casteljau_lerp", "degree 20"][2], "")
        self.assertEqual(len(lines), 6)
        self.assertFalse(any(c.mark for g in table.groups for _, cells in g.rows for c in cells))
        for change, at, cells in ((dict(searched_error_u=17.5), 1, ["4", "17.5", "17", "4.4", "reached", "`s1`"]),
                                  (dict(status="non_finite", sampled_error_u="inf", searched_error_u=""), 4, ["inf", "", "17", "", "non_finite", "`s1`"])):
            table, = search_tables(fixture.bundle(changed("search.csv", change, **SEARCHED)), "worst")
            found = table.groups[0].rows[0][1]
            self.assertEqual(([c.text for c in found], found[at].mark), (cells, "outside"))

    def test_an_axis_is_found_from_what_a_study_varies(self):
        table = fixture.bundle().exact("regimes")
        axes = {s.removeprefix("regimes-"): swept(table.select(study=s)) for s in table.distinct("study")}
        self.assertEqual(axes, {"parameter": ("interval", "generator"), "range": ("coordinate_range", "generator"),
                                "degree": ("degree", "generator"), "float": ("degree", "scalar"), "dimension": ("degree", "dimension")})

    def test_a_table_explains_an_error_above_the_bound(self):
        for change, times in ((None, 0), (changed("accuracy.csv", {"max_error_u": 1e20}, study="regimes-parameter", method="wozny_chudy", t_max=2), 1)):
            self.assertEqual(sum(b.kind == "text" and "to which the proof does not apply" in b.text for b in _blocks("regimes", change)), times)

    def test_columns_of_a_conditioning_table_rise_with_the_condition_number(self):
        table = self.table("conditioning")
        self.assertEqual([float(c.raw) for c in table.groups[0].rows[0][1]], [1.0, 1e10, 1e20, 1e36])
        head, rows = table.csv()
        self.assertEqual(head[1:3], ["t_min", "t_max"])
        self.assertEqual(len(rows), 8)

    def test_peers_have_errors_and_times_in_one_table(self):
        errors = {"mean error / (u p~)", "largest error / (u p~)", "largest error"}
        lines = texts(self.table("peers"))
        self.assertEqual(lines["peer_gsl", "mean error / (u p~)"], ["0.500", "0.500"])
        self.assertEqual(lines["peer_gsl", "ns per point, prepared"], ["32", "160"])
        self.assertIn(("de_casteljau", "mean error / (u p~)"), lines)
        untimed = texts(self.table("peers", lambda at, row: at != "timing.csv" or row["study"] != "peers-speed"))
        self.assertEqual({label for _, label in untimed}, errors)
        with self.assertRaisesRegex(Missing, "unstable.csv"):
            _blocks("peers", lambda at, row: at != "unstable.csv")

    def test_other_libraries_stand_in_the_chapter_of_their_problem(self):
        tables = of_kind(_blocks("arc_length", only(["companion_peers"])), "table")
        self.assertEqual([[g.key for g in t.groups] for id, t in tables.items() if id.startswith("companion_peers-length-")],
                         [["gauss_legendre_adaptive", "peer_2geom_length"]] * 2)

    def test_halves_that_do_not_fit_together_are_counted_and_marked(self):
        apart = self.table("subdivision", changed("subdivision.csv", {"junctions_apart": 3}, method="lerp_split", degree=20), "-kept")
        self.assertEqual([(c.text, c.mark) for g in apart.groups if g.key == "lerp_split" for label, cells in g.rows if label == "junctions apart"
                          for c in cells], [("0", ""), ("3", "outside")])
        self.assertIn(("de_casteljau_split", "points off"), texts(apart))
        self.assertNotIn(("lerp_split", "points off"), texts(apart))

    def test_a_malformed_suite_or_search_is_an_error(self):
        with self.assertRaisesRegex(BundleError, "suite.toml"):
            fixture.bundle(makers=fixture.FILES, suite="[[suites]")
        with self.assertRaisesRegex(BundleError, "search.csv:2: `search_id`"):
            fixture.bundle(changed("search.csv", {"search_id": ""}, **SEARCHED))

    def test_replay_names_the_largest_kept_trial(self):
        note = _blocks("ladder", changed("worst.csv", {"error_u": 1e30}, study="ladder-bezier", method="de_casteljau", degree=20, generator="integer"))[-1].text
        worst = next(r for r in evaluators.worst() if (r["study"], r["method"], r["degree"], r["generator"]) == ("ladder-bezier", "de_casteljau", 20, "integer"))
        self.assertIn(f"`bezierbench replay BUNDLE {worst['worst_id']}`", note)
        self.assertIn("`de_casteljau`", note)

    def test_times_are_counted_as_ratios(self):
        """Of each degree: 1 over 1 may be anything; 7 over 1 is at least 3, which ours is, and 7 over 7 at most 4/3; 50 over 15 is."""
        bundle = fixture.bundle()
        head, counted = next(block for block in scorecard(bundle, ((), ())) if block.kind == "table").csv()
        found = {row[0]: dict(zip(head, row)) for row in counted}
        times = found["Table 2.4"]
        self.assertEqual([times[column] for column in ("✓ inside", "– untestable", "✗ outside", "cells")], ["10", "2", "0", "12"])
        self.assertEqual(found["Table 2.3.1"]["– untestable"], "0")
        head, *lines = summary.text(bundle, find_all(bundle)).splitlines()[1:6]
        self.assertEqual(head.split(), ["table", *MARK, "cells"])
        for line in lines:
            number, *numbers, cells = line.split()
            self.assertEqual(sum(map(int, numbers)), int(cells), number)


if __name__ == "__main__":
    unittest.main()
