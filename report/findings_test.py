# SPDX-License-Identifier: MIT
"""Every finding says what the data say, and the opposite where the data are the opposite."""

import tempfile
import unittest

from . import fixture
from .bundle import Bundle, Row
from .findings.conclusions import range_bend
from .findings.finding import ROSTER
from .findings.roster import GROUPS, find_all, grouped
from .fixture import scorecards

ON_DRAWN = [(find, suite) for find, suite in ROSTER if not find.__name__.endswith("_on_sets")]  # real_curves_test.py has the others


def _scale(column, factor, file="accuracy.csv", **key):
    """A change that multiplies a column of the rows that fit."""
    def change(at, row):
        if at == file and all(row[c] in v if isinstance(v, tuple) else row[c] == v for c, v in key.items()):
            for c in (column if isinstance(column, tuple) else (column,)):
                row[c] = row[c] * factor
    return change


def _set(column, value, file, **key):
    def change(at, row):
        if at == file and all(row[c] == v for c, v in key.items()):
            row[column] = value
    return change


def _worse_explained(at, row):
    if at == "scorecard.csv" and row["verdict"] == "explained":
        row["published"] *= 7


def _flat_range(at, row):
    if at == "scorecard.csv" and row["table"] == "2.3.2" and row["method"] == "factorial:power_sum":
        row["ours_median"] = row["continuous_median"]


def _steady(at, row):
    if at == "accuracy.csv" and row["method"] == "de_casteljau" and row["study"] in ("2.3.1-bezier", "2.3.3-bezier"):
        row["mean_error"], row["mean_error_u"] = 1e-10, 1.0


def _exponential_positive(at, row):
    if at == "accuracy.csv" and row["method"].startswith("positive_sum") and row["degree"] == 20:
        row["mean_error"] = 1e-3


def _overflow(at, row):
    if at == "accuracy.csv" and row["degree"] == 21:
        row.update(status="degree_unsupported", mean_error="", max_error="", mean_error_u="", max_error_u="", bound_u="")


def _tame(at, row):
    if at == "scorecard.csv" and row["table"] == "2.3.1" and row["method"] == "factorial:power_sum":
        for c in ("published", "ours_median", "continuous_median", "against_exact"):
            row[c] = 1e-9


def _all_outside(at, row):
    if at == "scorecard.csv" and row["verdict"] == "inside":
        row["verdict"] = "outside"


def _fractions_of_ms(at, row):
    if at == "scorecard_timing.csv":
        row["published"] = 2.5


def _raise(column, value, **key):
    return _set(column, value, "accuracy.csv", **key)


def _milder_paths(at, row):
    if at == "accuracy.csv" and row["study"].startswith("ladder-") and row["degree"] == 20:
        row["mean_error_u"] = min(row["mean_error_u"], 2.0)


def _more_short(at, row):
    if at == "search.csv":
        row.update(status="short", searched_error_u=row["sampled_error_u"] * 1.1)


# finding: a change of the data that must turn it over
FLIPS = {
    "cells_inside_band": _all_outside,
    "bounds_hold": _set("bound_violations", 3, "accuracy.csv", method="direct", study="truth-bezier", degree=4),
    "yardstick_ranking": _scale("mean_error", 2, method="de_casteljau", study="2.3.1-bezier", baseline="exact"),
    "common_rounding": _scale("mean_error", 4, method="de_casteljau", baseline="direct", study="2.3.1-bezier"),
    "forward_substitution": _exponential_positive,
    "range_bend": _flat_range,
    "round_trip_grid": _set("within_1e-5", 95, "conversion.csv", generator="continuous"),
    "de_casteljau_flat": _steady,
    "factorial_overflow": _overflow,
    "timings_quantised": _fractions_of_ms,
    "printed_slip": _worse_explained,
    "via_power_worse": _scale("against_exact", 1e9, "scorecard.csv", method="de_casteljau"),
    "growth_with_degree": _tame,
    "growth_with_t": _scale("against_exact", 1e9, "scorecard.csv", table="2.3.3", t_min=0),
    "recommended": _scale("mean_error", 2, method="de_casteljau", study="2.3.1-bezier", baseline="exact"),
    "conversion_dominates": _scale("ours_median", 2, "scorecard.csv", method="forward_substitution:direct", degree=20),
    "time_order": _scale("ours_median", 100, "scorecard_timing.csv", method="direct"),
    "ladder_best": _raise("mean_error_u", 9.0, study="ladder-bezier", method="compensated_de_casteljau", degree=20),
    "ladder_growth": _milder_paths,
    "regimes_parameter": _raise("mean_error_u", 1e7, study="regimes-parameter", method="wozny_chudy", t_max=2),
    "regimes_range": _raise("mean_error_u", 9.0, study="regimes-range", method="de_casteljau", coordinate_range=1e300),
    "regimes_degree": _raise("non_finite", 7, study="regimes-degree", degree=1023),
    "regimes_float": _raise("mean_error_u", 9.0, study="regimes-float", scalar="float", degree=20),
    "regimes_dimension": _raise("mean_error_u", 9.0, study="regimes-dimension", dimension=3),
    "conditioning_digits": _raise("p50_relative", 1e-10, study="conditioning-bernstein", method="compensated_de_casteljau", t_max=0.78),
    "conversion_norm": _set("max_error", 1.0, "conversion.csv", conversion="positive_sum", degree=20),
    "conversion_parts": _raise("mean_conversion_error", 0, study="conversion-paths-to-power", method="factorial:horner", t_max=1),
    "conversion_growth": _raise("mean_error", 1e9, study="conversion-paths-to-power", method="factorial:horner", t_max=1),
    "worst_bounds": _set("searched_error_u", 18, "search.csv", search_id="s1"),
    "worst_gain": _more_short,
    "rational_weights": _raise("mean_error_u", 1e3, study="rational-ladder", method="direct", degree=20, generator="weights_wild"),
    "projection_isolate": _set("missed", 1, "projection.csv", method="quintic_isolate", placement="cusp"),
    "interpolation_residuals": _set("max_c2_u", 9.5, "interpolation.csv", method="c2_natural", points=100),
    "projection_printed": _set("missed", 0, "projection_unstable.csv", method="quintic_seed_002"),
    "choosing": _set("pareto", "yes", "pareto.csv", method="direct"),
    "peers_accuracy": _scale("mean_error", 100, "unstable.csv", study="peers-bezier", degree=20),
    "peers_cache": _scale("mean_error", 1e-6, "unstable.csv", study="peers-bezier", method="peer_occt_cached"),
    "arc_length_promise": _set("broken_promises", 1, "arc_length.csv", method="adaptive_simpson38", tolerance=1e-9),
    "arc_length_as_printed": _set("max_relative", 0, "arc_length.csv", method="seed_000_simpson38"),
    "arc_length_cost": _set("mean_evaluations", 20, "arc_length.csv", method="adaptive_simpson38", tolerance=1e-9),
    "fitting_promise": _set("broken_promises", 1, "fitting.csv", method="schneider", data="noisy", tolerance=1e-6),
    "fitting_source": _set("one_segment", 0, "fitting.csv", method="gauss_newton", data="samples", tolerance=1e-6),
    "interpolation_time": _set("verdict", "unresolved", "complexity.csv", method="c2_natural_handles"),
    "fitting_time": _set("ratio_low", 0.9, "timing.csv", method="gauss_newton", data="noisy", tolerance=1e-2),
    "derivative_time": _set("ratio_low", 0.99, "timing.csv", method="triangle_derivatives", order=2),
    "arc_length_time_fastest": _set("ratio_low", 0.99, "timing.csv", study="companion_speed-length", method="adaptive_simpson38"),
    "inverse_arc_length_time": _set("ratio_low", 0.99, "timing.csv", method="bracketed_newton", tolerance=1e-10),
    "projection_time_fastest": _set("ratio_low", 0.99, "timing.csv", method="scan_refine"),
    "arc_length_time": _scale(("median_ns", "low_ns", "high_ns"), 9.9, "timing.csv", study="companion_peers-length_speed",
                              method="gauss_legendre_adaptive"),
    "projection_time": _set("checked", "no", "timing.csv", study="companion_peers-projection_speed", method="quintic_isolate"),
    "inverse_arc_length_brackets": _set("non_converged", 1, "inverse_arc_length.csv", method="halley", tolerance=1e-9),
    "inverse_arc_length_unguarded": _set("non_converged", 0, "inverse_arc_length.csv", method="seed_000_newton"),
    "inverse_arc_length_spacing": _set("gap", 1.0, "spacing.csv", spacing="parameter"),
    "derivative_as_printed": _set("mean_error", 1e-16, "derivative.csv", method="seed_000", order=2),
    "derivative_distant": _set("mean_error_u", 0.5, "derivative.csv", method="triangle_derivatives", degree=20, order=1),
    "derivative_bounds": _set("bound_violations", 1, "derivative.csv", method="triangle_derivatives", degree=4, order=2),
    "subdivision_halves": _set("junctions_apart", 1, "subdivision.csv", method="lerp_split", degree=4),
    "boxes_contain": _set("too_small", 1, "bounds.csv", method="exact_box", degree=4),
    "grid_growth": _set("mean_error_u", 0.5, "grid.csv", method="forward_differencing", points=257),
    "bspline_recurrence": _set("max_control_error_u", 1e6, "bspline.csv", method="chudy_wozny_span"),
    "flattening_kept": _set("broken", 1, "flattening.csv", method="wang_count", tolerance=1e-2),
    "subdivision_best": _set("mean_error_u", 0.1, "subdivision.csv", method="lerp_split", degree=20),
    "sample_maximum": _scale("max_error", 0.5, generator="report", study=("2.3.1-bezier", "2.3.1-polynomial")),
}


def _findings(change=None, without=()):
    with tempfile.TemporaryDirectory() as place:
        return find_all(Bundle(fixture.write(f"{place}/b", change, without)))


class Findings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found, cls.undecided = _findings()
        cls.by_id = {f.id: f for f in cls.found}

    def test_all_hold_on_the_fixture(self):
        self.assertEqual(self.undecided, [])
        self.assertEqual([f.id for f in self.found if not f.holds], [])

    def test_every_finding_has_a_flip(self):
        self.assertEqual(set(self.by_id), set(FLIPS))
        self.assertEqual(len(self.found), len(ON_DRAWN))

    def test_flips(self):
        for name, change in FLIPS.items():
            with self.subTest(name):
                found, _ = _findings(change)
                flipped = next(f for f in found if f.id == name)
                self.assertFalse(flipped.holds)
                self.assertNotEqual(flipped.headline, self.by_id[name].headline)

    def test_flipped_finding_changes_its_heading(self):
        def heading(found, name):
            return next(h for h, members in grouped(found) if any(f.id == name for f in members))
        for name in ("forward_substitution", "via_power_worse", "factorial_overflow"):
            with self.subTest(name):
                self.assertNotEqual(heading(self.found, name), heading(_findings(FLIPS[name])[0], name))

    def test_every_finding_stands_under_one_heading(self):
        for found in (self.found, _findings(_all_outside)[0]):
            for f in found:
                self.assertEqual(sum(belongs(f) for _, belongs in GROUPS), 1, f.id)

    def test_numbers_follow_the_data(self):
        self.assertIn("7.50e-4", " ".join(self.by_id["forward_substitution"].detail))
        found, _ = _findings(_scale("mean_error", 2, study="truth-polynomial", method="forward_substitution:de_casteljau"))
        self.assertIn("1.50e-3", " ".join(next(f for f in found if f.id == "forward_substitution").detail))

    def test_repeated_cells_count_once(self):
        cells = scorecards.scorecard()
        distinct = {(r["form"], r["statistic"], r["degree"], r["coordinate_range"], r["t_min"], r["t_max"], r["published"]) for r in cells}
        self.assertLess(len(distinct), len(cells) - 8)  # of two methods and of two tables
        self.assertIn(f"Of the {len(distinct)} distinct", self.by_id["cells_inside_band"].headline)
        self.assertIn(f"{len(cells)} errors and counts, of which {len(cells) - len(distinct)} repeat",
                      self.by_id["cells_inside_band"].detail[2])

    def test_cells_of_one_printed_value_are_one_event(self):
        """The last degree of 2.3.1 and the last range of 2.3.2, by two methods that agree in print: four cells, one event."""
        def last(at, row):
            return at == "scorecard.csv" and row["form"] == "power" and row["statistic"] == "max_error" \
                and row["degree"] == 20 and row["coordinate_range"] == 1000000
        def all_outside(at, row):
            if last(at, row):
                row.update(verdict="outside", published=0.054)
        def one_inside(at, row):
            if last(at, row):
                row.update(verdict="inside" if row["table"] == "2.3.1" else "outside", published=0.054)
        for change, (edge, outside) in ((all_outside, (0, 1)), (one_inside, (1, 0))):
            found = next(f for f in _findings(change)[0] if f.id == "cells_inside_band")
            self.assertIn(f"{edge} on its edge, 1 outside for a stated cause and {outside} outside", found.headline)
            self.assertEqual(len(found.rows) - 2, 4)  # two cells are explained

    def test_chance_is_that_of_the_bundle(self):
        def rarely(at, row):
            if at == "scorecard.csv":
                row["chance_outside"] = 0.001
                if row["form"] == "bernstein" and row["degree"] == 4:
                    row["verdict"] = "outside"
        found = next(f for f in _findings(rarely)[0] if f.id == "cells_inside_band")
        self.assertFalse(found.holds)  # four where 0.048 are expected
        self.assertIn("more than chance leaves outside, which are 0.048 of 48 on average", found.headline)

    def test_a_quantity_has_one_mean_on_the_page(self):
        """The larger sample: 2.3.1-bezier, which the smaller of truth-bezier does not agree with."""
        found, _ = _findings(_scale("mean_error", 1.25, study="truth-bezier", generator="continuous"))
        for one in found:
            if one.id in ("yardstick_ranking", "common_rounding", "de_casteljau_flat"):
                self.assertEqual(one.detail, self.by_id[one.id].detail, one.id)

    def test_what_the_report_says_has_its_place(self):
        for one in self.by_id.values():
            if one.claim and one.id != "printed_slip":  # which names its table
                self.assertRegex(one.place, r"^sections? \d\.\d", one.id)

    def test_cells_that_share_their_trials_are_one_experiment(self):
        """2 degrees of each form, 2 more ranges and 3 intervals."""
        self.assertIn("of 14 independent experiments", self.by_id["cells_inside_band"].detail[1])
        self.assertIn("Experiments with a cell outside: 0.", self.by_id["cells_inside_band"].detail[1])

        def two(at, row):
            if at == "scorecard.csv" and row["table"] == "2.3.1" and row["form"] == "bernstein" and row["degree"] == 4:
                row["verdict"] = "outside"
        found = next(f for f in _findings(two)[0] if f.id == "cells_inside_band")
        self.assertIn("and 4 outside", found.headline)
        self.assertIn("0 lie below the band and 4 above", found.detail[0])
        self.assertIn("Experiments with a cell outside: 1.", found.detail[1])

    def test_a_cause_is_said_where_trials_were_taken_apart(self):
        """The grid's error at R = 100 is 3e-7 and 1e-3 at 1e6; an eighth is the conversion's and half the evaluation's."""
        self.assertEqual(len(self.by_id["range_bend"].detail), 2)
        with tempfile.TemporaryDirectory() as place:
            bundle = Bundle(fixture.write(f"{place}/b"))
        table = bundle["accuracy.csv"]
        for row in [r for r in table.rows if r["study"] == "2.3.2-bezier" and r["generator"] == "report"]:
            error = row["mean_error"]
            table.rows.append(Row(row.file, row.line, {**row.values, "baseline": "exact", "mean_conversion_error": error / 8,
                                                       "mean_evaluation_error": error / 2}, row.texts))
        self.assertIn("makes a mean error of 3.75e-8 and the evaluation one of 1.50e-7 at R = 100; at R = 1e6 they make 1.25e-4 and 5.00e-4",
                      range_bend(bundle).detail[2])

    def test_printed_errors_are_compared_at_their_own_degrees(self):
        def beyond(at, row):
            if at == "accuracy.csv" and row["study"] == "truth-bezier" and row["method"] == "direct" and row["degree"] == 21:
                row.update(method="de_casteljau", degree=50, mean_error=1.0, mean_error_u=1e9)
        flat = next(f for f in _findings(beyond)[0] if f.id == "de_casteljau_flat")
        self.assertEqual(flat.detail, self.by_id["de_casteljau_flat"].detail)

    def test_an_error_without_a_bound_is_not_held_against_one(self):
        def outside(at, row):
            if at == "accuracy.csv" and row["study"] == "regimes-parameter" and row["method"] == "wozny_chudy" and row["t_max"] == 2:
                row["max_error_u"] = 1e20
        bounds = next(f for f in _findings(outside)[0] if f.id == "bounds_hold")
        whole = self.by_id["bounds_hold"]
        self.assertTrue(bounds.holds)
        self.assertEqual(bounds.detail[0], whole.detail[0])
        self.assertEqual(len(whole.detail), 1)
        self.assertIn("In 1 cell of `regimes-parameter` the proof does not apply to some trials", bounds.detail[1])

    def test_the_fastest_is_computed(self):
        """Another method that is faster everywhere is named; one that is wrong is not, however fast."""
        def faster(at, row):
            if at == "timing.csv" and row["study"] == "companion_speed-length" and row["method"] == "adaptive_simpson38":
                row.update(ratio=0.5, ratio_low=0.4, ratio_high=0.6)

        def faster_and_wrong(at, row):
            faster(at, row)
            if at == "timing.csv" and row["method"] == "bracketed_newton":
                row.update(ratio=0.5, ratio_low=0.4, ratio_high=0.6, checked="no" if row["tolerance"] == 1e-10 else "yes")
        by_id = {f.id: f for f in _findings(faster_and_wrong)[0]}
        self.assertTrue(by_id["arc_length_time_fastest"].holds)
        self.assertIn("`adaptive_simpson38` is the fastest of the correct methods", by_id["arc_length_time_fastest"].headline)
        self.assertFalse(by_id["inverse_arc_length_time"].holds)
        self.assertIn("`halley`, the fastest in 1 of 2 races", by_id["inverse_arc_length_time"].headline)

    def test_the_best_of_ours_is_computed(self):
        def another(at, row):
            if at == "timing.csv" and row["study"] == "companion_peers-projection_speed" and row["method"] == "peer_sisl_closest":
                row.update(method="subdivide_hull", median_ns=200, low_ns=190, high_ns=210)
        found = next(f for f in _findings(another)[0] if f.id == "projection_time")
        self.assertTrue(found.holds)
        self.assertIn("`subdivide_hull` computes the nearest point of a cubic in less time", found.headline)

    def test_evidence_names_lines(self):
        for f in self.found:
            self.assertTrue(f.evidence, f.id)

    def test_missing_file_leaves_undecided(self):
        found, undecided = _findings(without=("conversion.csv", "scorecard_timing.csv"))
        self.assertEqual({name for name, _ in undecided}, {"round_trip_grid", "timings_quantised", "time_order", "conversion_norm", "recommended"})
        self.assertIn("the bundle has no `conversion.csv`", dict(undecided)["round_trip_grid"])
        self.assertEqual(len(found), len(ON_DRAWN) - 5)

    def test_nothing_but_bundle_json(self):
        found, undecided = _findings(without=tuple(fixture.FILES))
        self.assertEqual(found, [])
        self.assertEqual(undecided, [])  # what is about any bundle is left out where it cannot be decided

    def test_overflow_is_said_and_not_compared(self):
        def overflow(at, row):
            if at == "accuracy.csv" and row["study"] == "regimes-range" and row["coordinate_range"] == 1e300 and ":" in row["method"]:
                row.update(non_finite=400, mean_error_u=1.0)
        range_found = next(f for f in _findings(overflow)[0] if f.id == "regimes_range")
        self.assertTrue(range_found.holds)
        self.assertIn("1 method overflows at R = 1e300, degree 20", range_found.headline)
        self.assertIn("400 trials", range_found.detail[1])

    def test_a_finding_of_a_suite_names_it(self):
        self.assertEqual([f.suite for f in self.found], ["" if suite in (None, "report") else suite for _, suite in ON_DRAWN])
        for f in self.found:
            self.assertEqual(f.about == "suite", bool(f.suite), f.id)


if __name__ == "__main__":
    unittest.main()
