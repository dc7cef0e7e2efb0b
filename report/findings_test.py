# SPDX-License-Identifier: MIT
"""Every finding says what the data say, and the opposite where the data are the opposite."""

from pathlib import Path
import tempfile
import unittest
from unittest import mock

from . import fixture
from .bundle import Row
from .findings import printed_tables
from .findings.conclusions import range_bend
from .findings.finding import ROSTER
from .findings.printed_times import ratios
from .findings.roster import GROUPS, find_all, grouped
from .fixture import changed, evaluators

ON_DRAWN = {find.__name__: (find, suite) for find, suite in ROSTER if not find.__name__.endswith("_on_sets")}  # real_curves_test.py has the others
ERROR, SCORE = "accuracy.csv", "scorecard.csv"


def _times(factor):
    return lambda value: value * factor


# finding: a change of the data that must turn it over, of the rows of a file that have these values
FLIPS = {
    "cells_inside_band": changed(SCORE, {"verdict": "outside"}, verdict="inside"),
    "bounds_hold": changed(ERROR, {"bound_violations": 3}, method="direct", study="truth-bezier", degree=4),
    "yardstick_ranking": changed(ERROR, {"mean_error": _times(2)}, method="de_casteljau", study="2.3.1-bezier", baseline="exact"),
    "common_rounding": changed(ERROR, {"mean_error": _times(4)}, method="de_casteljau", baseline="direct", study="2.3.1-bezier"),
    "forward_substitution": changed(ERROR, {"mean_error": 1e-3}, method="positive_sum:de_casteljau", degree=20),
    "range_bend": changed(SCORE, {"ours_median": 1e-9}, table="2.3.2", method="factorial:power_sum"),
    "round_trip_grid": changed("conversion.csv", {"within_1e-5": 95}, generator="continuous"),
    "worked_conversions": changed("conversion.csv", {"max_error": 1e-9}, generator="integer"),
    "times_as_ratios": changed("timing.csv", dict(ratio=0.5, ratio_low=0.4, ratio_high=0.6), study="2.4-polynomial", method="forward_substitution:direct"),
    "de_casteljau_flat": changed(ERROR, {"mean_error": 1e-10, "mean_error_u": 1.0}, method="de_casteljau", study=("2.3.1-bezier", "2.3.3-bezier")),
    "factorial_overflow": changed(ERROR, dict(status="degree_unsupported", mean_error="", max_error="", mean_error_u="", max_error_u="", bound_u=""),
                                  degree=21),
    "timings_quantised": changed("scorecard_timing.csv", {"published": 2.5}),
    "printed_slip": changed(SCORE, {"published": _times(7)}, verdict="explained"),
    "via_power_worse": changed(SCORE, {"against_exact": _times(1e9)}, method="de_casteljau"),
    "growth_with_degree": changed(SCORE, dict.fromkeys(("published", "ours_median", "continuous_median", "against_exact"), 1e-9), table="2.3.1",
                                  method="factorial:power_sum"),
    "growth_with_t": changed(SCORE, {"against_exact": _times(1e9)}, table="2.3.3", t_min=0),
    "recommended": changed(ERROR, {"mean_error": _times(2)}, method="de_casteljau", study="2.3.1-bezier", baseline="exact"),
    "conversion_dominates": changed(SCORE, {"ours_median": _times(2)}, method="forward_substitution:direct", degree=20),
    "time_order": changed("scorecard_timing.csv", {"ours_median": _times(100)}, method="direct"),
    "ladder_best": changed(ERROR, {"mean_error_u": 9.0}, study="ladder-bezier", method="compensated_de_casteljau", degree=20),
    "ladder_growth": changed(ERROR, {"mean_error_u": lambda value: min(value, 2.0)}, study=("ladder-bezier", "ladder-polynomial"), degree=20),
    "regimes_parameter": changed(ERROR, {"mean_error_u": 1e7}, study="regimes-parameter", method="wozny_chudy", t_max=2),
    "regimes_range": changed(ERROR, {"mean_error_u": 9.0}, study="regimes-range", method="de_casteljau", coordinate_range=1e300),
    "regimes_degree": changed(ERROR, {"non_finite": 7}, study="regimes-degree", degree=1023),
    "regimes_float": changed(ERROR, {"mean_error_u": 9.0}, study="regimes-float", scalar="float", degree=20),
    "regimes_dimension": changed(ERROR, {"mean_error_u": 9.0}, study="regimes-dimension", dimension=3),
    "conditioning_digits": changed(ERROR, {"p50_relative": 1e-10}, study="conditioning-bernstein", method="compensated_de_casteljau", t_max=0.78),
    "conversion_norm": changed("conversion.csv", {"max_error": 1.0}, conversion="positive_sum", degree=20),
    "conversion_parts": changed(ERROR, {"mean_conversion_error": 0}, study="conversion-paths-to-power", method="factorial:horner", t_max=1),
    "conversion_growth": changed(ERROR, {"mean_error": 1e9}, study="conversion-paths-to-power", method="factorial:horner", t_max=1),
    "worst_bounds": changed("search.csv", {"searched_error_u": 18}, search_id="s1"),
    "worst_gain": changed("search.csv", {"status": "short"}),
    "rational_weights": changed(ERROR, {"mean_error_u": 1e3}, study="rational-ladder", method="direct", degree=20, generator="weights_wild"),
    "projection_isolate": changed("projection.csv", {"missed": 1}, method="quintic_isolate", placement="cusp"),
    "interpolation_residuals": changed("interpolation.csv", {"max_c2_u": 9.5}, method="c2_natural", points=100),
    "projection_printed": changed("projection_unstable.csv", {"missed": 0}, method="quintic_seed_002"),
    "choosing": changed("pareto.csv", {"pareto": "yes"}, method="direct"),
    "peers_accuracy": changed("unstable.csv", {"mean_error": _times(100)}, study="peers-bezier", degree=20),
    "peers_cache": changed("unstable.csv", {"mean_error": _times(1e-6)}, study="peers-bezier", method="peer_occt_cached"),
    "arc_length_promise": changed("arc_length.csv", {"broken_promises": 1}, method="adaptive_simpson38", tolerance=1e-9),
    "arc_length_as_printed": changed("arc_length.csv", {"max_relative": 0}, method="seed_000_simpson38"),
    "arc_length_cost": changed("arc_length.csv", {"mean_evaluations": 20}, method="adaptive_simpson38", tolerance=1e-9),
    "fitting_promise": changed("fitting.csv", {"broken_promises": 1}, method="schneider", data="noisy", tolerance=1e-6),
    "fitting_source": changed("fitting.csv", {"one_segment": 0}, method="gauss_newton", data="samples", tolerance=1e-6),
    "interpolation_time": changed("complexity.csv", {"verdict": "unresolved"}, method="c2_natural_handles"),
    "fitting_time": changed("timing.csv", {"ratio_low": 0.9}, method="gauss_newton", data="noisy", tolerance=1e-2),
    "derivative_time": changed("timing.csv", {"ratio_low": 0.99}, method="triangle_derivatives", order=2),
    "arc_length_time_fastest": changed("timing.csv", {"ratio_low": 0.99}, study="companion_speed-length", method="adaptive_simpson38"),
    "inverse_arc_length_time": changed("timing.csv", {"ratio_low": 0.99}, method="bracketed_newton", tolerance=1e-10),
    "projection_time_fastest": changed("timing.csv", {"ratio_low": 0.99}, method="scan_refine"),
    "arc_length_time": changed("timing.csv", dict.fromkeys(("median_ns", "low_ns", "high_ns"), _times(9.9)), study="companion_peers-length_speed",
                               method="gauss_legendre_adaptive"),
    "projection_time": changed("timing.csv", {"checked": "no"}, study="companion_peers-projection_speed", method="quintic_isolate"),
    "inverse_arc_length_brackets": changed("inverse_arc_length.csv", {"non_converged": 1}, method="halley", tolerance=1e-9),
    "inverse_arc_length_unguarded": changed("inverse_arc_length.csv", {"non_converged": 0}, method="seed_000_newton"),
    "inverse_arc_length_spacing": changed("spacing.csv", {"gap": 1.0}, spacing="parameter"),
    "derivative_as_printed": changed("derivative.csv", {"mean_error": 1e-16}, method="seed_000", order=2),
    "derivative_distant": changed("derivative.csv", {"mean_error_u": 0.5}, method="triangle_derivatives", degree=20, order=1),
    "derivative_bounds": changed("derivative.csv", {"bound_violations": 1}, method="triangle_derivatives", degree=4, order=2),
    "subdivision_halves": changed("subdivision.csv", {"junctions_apart": 1}, method="lerp_split", degree=4),
    "boxes_contain": changed("bounds.csv", {"too_small": 1}, method="exact_box", degree=4),
    "roots_enclosed": changed("roots.csv", {"broken_promises": 1}, method="certified", degree=4),
    "grid_growth": changed("grid.csv", {"mean_error_u": 0.5}, method="forward_differencing", points=257),
    "bspline_recurrence": changed("bspline.csv", {"max_control_error_u": 1e6}, method="chudy_wozny_span"),
    "flattening_kept": changed("flattening.csv", {"broken": 1}, method="wang_count", tolerance=1e-2),
    "subdivision_best": changed("subdivision.csv", {"mean_error_u": 0.1}, method="lerp_split", degree=20),
    "sample_maximum": changed(ERROR, {"max_error": _times(0.5)}, generator="report", study=("2.3.1-bezier", "2.3.1-polynomial")),
}


def _decided(name, change):
    """One finding on changed data."""
    find, suite = ON_DRAWN[name]
    bundle = fixture.bundle(change)
    return find(bundle.drawn() if suite else bundle)


class Findings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found, cls.undecided = find_all(fixture.bundle())
        cls.by_id = {f.id: f for f in cls.found}

    def test_all_hold_on_the_fixture_and_name_lines_and_places(self):
        self.assertEqual(self.undecided, [])
        self.assertEqual([f.id for f in self.found if not f.holds], [])
        self.assertEqual([f.id for f in self.found if not f.evidence], [])
        self.assertEqual([f.suite for f in self.found], ["" if suite in (None, "report") else suite for _, suite in ON_DRAWN.values()])
        for f in self.found:
            self.assertEqual(f.about == "suite", bool(f.suite), f.id)
            if f.claim and f.id != "printed_slip":  # which names its table
                self.assertRegex(f.place, r"^sections? \d\.\d", f.id)

    def test_flips(self):
        self.assertEqual(list(self.by_id), list(ON_DRAWN))
        self.assertEqual(set(FLIPS), set(ON_DRAWN))
        for name, change in FLIPS.items():
            with self.subTest(name):
                flipped = _decided(name, change)
                self.assertFalse(flipped.holds)
                self.assertNotEqual(flipped.headline, self.by_id[name].headline)
                self.assertEqual(sum(belongs(flipped) for _, belongs in GROUPS), 1)

    def test_a_flipped_finding_changes_its_heading(self):
        for name in ("forward_substitution", "via_power_worse", "factorial_overflow"):
            (before, _), = grouped([self.by_id[name]])
            (after, _), = grouped([_decided(name, FLIPS[name])])
            self.assertNotEqual(before, after, name)

    def test_numbers_follow_the_data(self):
        self.assertIn("7.50e-4", " ".join(self.by_id["forward_substitution"].detail))
        found = _decided("forward_substitution", changed(ERROR, {"mean_error": _times(2)}, study="truth-polynomial", method="forward_substitution:de_casteljau"))
        self.assertIn("1.50e-3", " ".join(found.detail))

    def test_repeated_cells_count_once(self):
        cells = evaluators.scorecard()
        distinct = {(r["form"], r["statistic"], r["degree"], r["coordinate_range"], r["t_min"], r["t_max"], r["published"]) for r in cells}
        self.assertLess(len(distinct), len(cells) - 8)  # of two methods and of two tables
        self.assertIn(f"Of the {len(distinct)} distinct", self.by_id["cells_inside_band"].headline)
        self.assertIn(f"{len(cells)} errors and counts, of which {len(cells) - len(distinct)} repeat",
                      self.by_id["cells_inside_band"].detail[2])

    def test_cells_of_one_printed_value_are_one_event(self):
        """The last degree of 2.3.1 and the last range of 2.3.2, by two methods that agree in print: four cells, one event."""
        for verdict, (edge, outside) in (("outside", (0, 1)), ("inside", (1, 0))):  # of the cells of 2.3.1
            def last(at, row, verdict=verdict):
                if at == SCORE and (row["form"], row["statistic"], row["degree"], row["coordinate_range"]) == ("power", "max_error", 20, 1000000):
                    row.update(verdict=verdict if row["table"] == "2.3.1" else "outside", published=0.054)
            found = _decided("cells_inside_band", last)
            self.assertIn(f"{edge} on its edge, 1 outside for a stated cause and {outside} outside", found.headline)
            self.assertEqual(len(found.rows) - 2, 4)  # two cells are explained

    def test_cells_that_share_their_trials_are_one_experiment(self):
        """2 degrees of each form, 2 more ranges and 3 intervals. Chance would leave 0.048 cells outside."""
        self.assertIn("of 14 independent experiments", self.by_id["cells_inside_band"].detail[1])
        self.assertIn("Experiments with a cell outside: 0.", self.by_id["cells_inside_band"].detail[1])

        def four(at, row):
            if at == SCORE:
                row["chance_outside"] = 0.001
                if row["table"] == "2.3.1" and row["form"] == "bernstein" and row["degree"] == 4:
                    row["verdict"] = "outside"
        found = _decided("cells_inside_band", four)
        self.assertFalse(found.holds)
        self.assertIn("and 4 outside, more than chance leaves outside, which are 0.048 of 48 on average", found.headline)
        self.assertIn("0 lie below the band and 4 above", found.detail[0])
        self.assertIn("Experiments with a cell outside: 1.", found.detail[1])

    def test_a_quantity_has_one_mean_on_the_page(self):
        """The larger sample: 2.3.1-bezier, which the smaller of truth-bezier does not agree with."""
        for name in ("yardstick_ranking", "common_rounding", "de_casteljau_flat"):
            found = _decided(name, changed(ERROR, {"mean_error": _times(1.25)}, study="truth-bezier", generator="continuous"))
            self.assertEqual(found.detail, self.by_id[name].detail, name)

    def test_a_cause_is_said_where_trials_were_taken_apart(self):
        """The grid's error at R = 100 is 3e-7 and 1e-3 at 1e6; an eighth is the conversion's and half the evaluation's."""
        self.assertEqual(len(self.by_id["range_bend"].detail), 2)
        bundle = fixture.bundle()
        table = bundle[ERROR]
        for row in table.select(study="2.3.2-bezier", generator="report"):
            error = row["mean_error"]
            table.rows.append(Row(row.file, row.line, {**row.values, "baseline": "exact", "mean_conversion_error": error / 8,
                                                       "mean_evaluation_error": error / 2}, row.texts))
        self.assertIn("makes a mean error of 3.75e-8 and the evaluation one of 1.50e-7 at R = 100; at R = 1e6 they make 1.25e-4 and 5.00e-4",
                      range_bend(bundle).detail[2])

    def test_a_wrong_worked_conversion_is_seen(self):
        with tempfile.TemporaryDirectory() as place, mock.patch.object(printed_tables, "WORKED", Path(place, "worked_conversions.csv")):
            whole = Path(__file__).parent.parent.joinpath("reference/published/worked_conversions.csv").read_text(encoding="utf-8")
            printed_tables.WORKED.write_text(whole.replace("0 3 -3 0", "0 3 3 0"), encoding="utf-8")
            found = _decided("worked_conversions", None)
        self.assertFalse(found.holds)
        self.assertIn("4 of the 5 worked conversions are exact", found.headline)

    def test_every_verdict_of_a_ratio_of_printed_times(self):
        """Table 2.4 prints whole steps of a clock: 7 over 1 may have been 3 times and more, 7 over 7 from 3/4 to 4/3. Above it, ours."""
        def verdicts(printed, ours, slower="forward_substitution:direct", faster="power_sum"):
            def change(at, row):
                if at == "scorecard_timing.csv" and row["method"] in (slower, faster):
                    row["published"] = printed[row["method"] == faster]
                if at == "timing.csv" and row["study"] == "2.4-polynomial" and row["method"] == slower:
                    row.update(ratio=ours, ratio_low=0.99 * ours, ratio_high=1.01 * ours)
            return {one.verdict for one in ratios(fixture.bundle(change)) if (one.slower["method"], one.faster["method"]) == (slower, faster)}
        for printed, ours, wanted in (((7, 1), 5, "agrees"), ((7, 1), 2.9, "close"), ((7, 1), 1.2, "kept"), ((7, 1), 0.5, "reversed"), ((1, 1), 5, "untestable"),
                                      ((7, 7), 0.7, "close"), ((7, 7), 3, "apart"), ((13, 7), 1.9, "agrees"), ((13, 7), 5, "kept"), ((0, 0), 1, "untestable"),
                                      ((0, 3), 0.7, "close"), ((0, 5), 2, "reversed"),
                                      ((2, 0), 1, "agrees"), ((0, 2), 1.5, "reversed"), ((2, 0), 0.698, "reversed")):
            self.assertEqual(verdicts(printed, ours), {wanted}, (printed, ours))

    def test_the_lines_of_both_sides_of_a_ratio_of_times_are_named(self):
        self.assertEqual([file for file, _ in self.by_id["times_as_ratios"].evidence], ["scorecard_timing.csv", "timing.csv"])

    def test_printed_errors_are_compared_at_their_own_degrees(self):
        found = _decided("de_casteljau_flat", changed(ERROR, dict(method="de_casteljau", degree=50, mean_error=1.0, mean_error_u=1e9),
                                                      study="truth-bezier", method="direct", degree=21))
        self.assertEqual(found.detail, self.by_id["de_casteljau_flat"].detail)

    def test_an_error_without_a_bound_is_not_held_against_one(self):
        bounds = _decided("bounds_hold", changed(ERROR, {"max_error_u": 1e20}, study="regimes-parameter", method="wozny_chudy", t_max=2))
        whole = self.by_id["bounds_hold"]
        self.assertTrue(bounds.holds)
        self.assertEqual(whole.detail, bounds.detail[:1])
        self.assertIn("In 1 cell of `regimes-parameter` the proof does not apply to some trials", bounds.detail[1])

    def test_the_fastest_is_computed(self):
        """Another method that is faster everywhere is named; one that is wrong is not, however fast."""
        faster = dict(ratio=0.5, ratio_low=0.4, ratio_high=0.6)
        found = _decided("arc_length_time_fastest", changed("timing.csv", faster, study="companion_speed-length", method="adaptive_simpson38"))
        self.assertTrue(found.holds)
        self.assertIn("`adaptive_simpson38` is the fastest of the correct methods", found.headline)

        def wrong(at, row):
            if at == "timing.csv" and row["method"] == "bracketed_newton":
                row.update(faster, checked="no" if row["tolerance"] == 1e-10 else "yes")
        found = _decided("inverse_arc_length_time", wrong)
        self.assertFalse(found.holds)
        self.assertIn("`halley`, the fastest in 1 of 2 races", found.headline)
        found = _decided("projection_time", changed("timing.csv", dict(method="subdivide_hull", median_ns=200, low_ns=190, high_ns=210),
                                                    study="companion_peers-projection_speed", method="peer_sisl_closest"))
        self.assertTrue(found.holds)
        self.assertIn("`subdivide_hull` computes the nearest point of a cubic in less time", found.headline)

    def test_a_missing_file_leaves_undecided(self):
        found, undecided = find_all(fixture.bundle(without=("conversion.csv", "scorecard_timing.csv")))
        self.assertEqual({name for name, _ in undecided}, {"round_trip_grid", "timings_quantised", "time_order", "conversion_norm", "recommended",
                                                          "worked_conversions", "times_as_ratios"})
        self.assertIn("the bundle has no `conversion.csv`", dict(undecided)["round_trip_grid"])
        self.assertEqual(len(found), len(ON_DRAWN) - 7)
        # what is about any bundle is left out where it cannot be decided
        self.assertEqual(find_all(fixture.bundle(without=tuple(fixture.FILES))), ([], []))

    def test_overflow_is_said_and_not_compared(self):
        found = _decided("regimes_range", changed(ERROR, dict(non_finite=400, mean_error_u=1.0), study="regimes-range", coordinate_range=1e300,
                                                  method="factorial:power_sum"))
        self.assertTrue(found.holds)
        self.assertIn("1 method overflows at R = 1e300, degree 20", found.headline)
        self.assertIn("400 trials", found.detail[1])


if __name__ == "__main__":
    unittest.main()
