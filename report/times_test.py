# SPDX-License-Identifier: MIT
"""Times stand in the chapter of the problem that was solved, with the limits of the processor and predicted cycles beside them."""

import unittest

from . import fixture
from .bundle import Row
from .chapters.parts import ROSTER
from .chapters.speed import timing
from .findings.conclusions import time_order
from .findings.roster import find_all
from .fixture import changed, of_kind
from .fixture.evaluators import DEGREES
from .fixture.times import COMPANIONS
from .predictions import predictions, rank_correlation, worst_miss
from .rows import Table
from .time_tables import nearness, orders, reading_limits, reading_load

CHAPTERS = {**{one.suite: one for one in ROSTER}, "evaluation": next(one for one in ROSTER if one.id == "timing")}
PROBLEMS = ("derivative", "arc_length", "inverse_arc_length", "projection", "interpolation", "fitting", "subdivision", "grid", "bspline", "bounds", "roots", "evaluation")


def _blocks(change=None, problems=PROBLEMS):
    """({problem: blocks of its chapter}, findings)"""
    bundle = fixture.bundle(change)
    found = find_all(bundle)
    return {problem: list(CHAPTERS[problem].blocks(bundle, found)) for problem in problems}, found[0]


def _tables(blocks):
    return {id: table for id, table in of_kind(blocks, "table").items() if id.startswith("timing-")}


def _words(blocks):
    return [block.text for block in blocks if block.kind == "text"]


class Chapters(unittest.TestCase):
    def test_stand_in_the_chapter_of_their_problem(self):
        fixture.without_figures(self)
        blocks, found = _blocks()
        tables = {problem: _tables(own) for problem, own in blocks.items()}
        for problem, study, methods, _ in COMPANIONS:
            self.assertEqual({g.key for g in tables[problem][f"timing-{study}"].groups}, set(methods), study)
        self.assertEqual(set(tables["evaluation"]), {"timing-2.4-bezier", "timing-2.4-polynomial", "timing-peers-speed"})
        captions = [table.caption for own in tables.values() for table in own.values()]
        self.assertEqual((len(captions), len(set(captions))), (len(COMPANIONS) + 3, len(COMPANIONS) + 3))
        for f in found:
            if f.suite.startswith("companion_"):
                shown = [problem for problem, own in blocks.items() for b in own if b.kind == "finding" and b.id == f.id]
                self.assertEqual(shown, [f.id.split("_time")[0]], f.id)
        derivatives = tables["derivative"]["timing-companion_speed-derivative"]
        self.assertEqual([label for label, _ in derivatives.groups[0].rows], ["order 1", "order 2"])
        table = tables["fitting"]["timing-companion_speed-fitting"]
        self.assertEqual(table.caption, 'Time over that of `schneider`, and about how many microseconds per fit: Fits to "points" (double, 2 axes)')
        lines = fixture.texts(table)
        self.assertEqual(set(lines), {(m, data) for m in ("schneider", "gauss_newton") for data in ("samples", "noisy")})
        self.assertEqual((table.axis, table.head), ("tolerance", ("1e-6", "0.01")))
        self.assertEqual(lines["schneider", "noisy"], ["1, 20"] * 2)
        self.assertRegex(lines["gauss_newton", "noisy"][0], r"^\S+ \[\S+ – \S+\], \S+$")

    def test_are_shown_without_errors_whose_lack_is_said(self):
        def times_only(at, row):
            return at != "fitting.csv" or not row["study"].startswith("fitting-")
        blocks = _blocks(times_only, ("fitting",))[0]["fitting"]
        self.assertIn("The errors are left out: `fitting.csv` has no study", blocks[0].text)
        self.assertEqual([b.kind for b in blocks[1:]], ["heading", "finding", "figure", "table", "text"])

    def test_wrong_answers_are_marked(self):
        blocks = _blocks(changed("timing.csv", {"checked": "no"}, method="seed_000", order=2), ("derivative",))[0]["derivative"]
        table, = _tables(blocks).values()
        self.assertEqual({label: cells[0].mark for label, cells in table.groups[-1].rows}, {"order 1": "", "order 2": "outside"})
        self.assertIn("✗ marks times of `seed_000`", blocks[-1].text)


def _row(method, ns, limit, mode="point", degree=5, call=2.0, chain=None, **more):
    """A time that is known to a percent."""
    values = dict(study="s", method=method, scalar="double", dimension=2.0, degree=float(degree), mode=mode, median_ns=float(ns), low_ns=0.99 * ns,
                  high_ns=1.01 * ns, call_ns=call, limit_ns=limit and float(limit), share_of_limit=limit and limit / (ns - call), chain_ns=chain, **more)
    return Row("timing.csv", 2, values, {})


def _said(rows):
    return " ".join(line for block in nearness(rows) for line in (block.items if block.kind == "bullets" else (block.text,)))


class Limits(unittest.TestCase):
    def setUp(self):
        fixture.without_figures(self)

    def test_names_what_is_below_one_half_and_how_long_its_chain_is(self):
        text = _said([_row("a", 12, 5), _row("b", 12, 4.9, chain=9.8), _row("b", 42, 4, degree=20, chain=40), _row("c", 3, 1.5)])
        self.assertIn("`point`: shares from 10 % to more than 100 %, one half or more at 2 of 4 times; an empty kernel takes 2 ns.", text)
        self.assertIn("Below one half of the limit: `b`: `point` at degree 5, 20 (its chain of dependent operations takes 2 to 10 times the limit)", text)

    def test_takes_modes_apart(self):
        text = _said([_row("a", 12, 10), _row("a", 12, 1, mode="batch", call=0.0)])
        self.assertIn("`point`: shares from 100 % to 100 %, one half or more at 1 of 1 time;", text)
        self.assertIn("`batch`: shares from 8 % to 8 %, one half or more at 0 of 1 time;", text)
        self.assertIn("Below one half of the limit: `a`: `batch` at degree 5", text)
        self.assertIn("None is below one half of the limit.", _said([_row("a", 12, 10)]))

    def test_says_which_orders_would_hold(self):
        rows = [_row("fast", 10, 1), _row("slow", 20, 2), _row("badly_coded", 30, 0.5)]
        self.assertEqual(orders(rows), ({("fast", "slow"): 1}, {("fast", "badly_coded"): 1, ("slow", "badly_coded"): 1}))
        self.assertIn("Of 3 orders of two methods of a race 1 would hold at the limits and 2 would not: `fast` before `badly_coded` in 1 race "
                      "and `slow` before `badly_coded` in 1 race.", _said(rows))
        self.assertIn("All 1 order of two methods of a race would hold", _said(rows[:2]))
        self.assertEqual(set(orders([_row("a", 10, 1), _row("b", 20, 1)])[1]), {("a", "b")}, "equal limits have no order")

    def test_compares_within_a_race_and_only_what_is_apart(self):
        for other in (_row("b", 10.1, 2), _row("b", 20, 2, degree=6), _row("b", 20, 2, mode="latency"), _row("b", 20, 2, generator="integer")):
            self.assertEqual(orders([_row("a", 10, 1), other]), ({}, {}))
        self.assertIn("No two methods of a race differ in time.", _said([_row("a", 10, 1)]))

    def test_says_how_many_have_no_limit(self):
        self.assertIn("1 time has no limit", _said([_row("a", 12, 5), _row("direct_pow", 100, None)]))
        self.assertEqual(_said([_row("direct_pow", 100, None)]), "")
        self.assertIsNone(reading_limits([_row("direct_pow", 100, None)]))

    def test_says_it_of_each_table(self):
        texts = _words(timing(fixture.bundle(), None))
        self.assertEqual(sum("**Distance to the limit.**" in t for t in texts), 1, "of the one table that has limits")
        self.assertTrue(any(t.startswith("The limit of a time (`limit_ns` of the file)") for t in texts))

    def test_accepts_bundles_without_limits(self):
        later = "call_ns limit_ns share_of_limit chain_ns max_error_u allowed_error_u".split()
        bundle = fixture.bundle(left_out={"timing.csv": later})
        texts = _words(timing(bundle, None))
        self.assertFalse(any("limit" in t for t in texts))
        self.assertTrue(any("a lenient one" in t for t in texts))
        self.assertNotIn("At the limits", " ".join(time_order(bundle).detail))

    def test_says_the_load(self):
        bundle = fixture.bundle()
        bundle.machine = {"load_average": [0.5, 1, 12.25], "cpu": {"logical_cores_available": 2}}
        self.assertIn("Load of the machine when the run began, over 1, 5 and 15 minutes: 0.500, 1 and 12.2, on 2 processors.", _words(timing(bundle, None)))
        for bundle.machine in ({}, {"load_average": "unknown"}, {"load_average": [1]}, {"load_average": ["a", 1, 2]}, None):
            self.assertIsNone(reading_load(bundle), bundle.machine)

    def test_says_whether_the_orders_of_the_report_hold_at_the_limits(self):
        bundle = fixture.bundle(changed("timing.csv", {"limit_ns": 1.0}, study="2.4-bezier", degree=DEGREES, mode="point"))
        base = bundle["timing.csv"].select(study="2.4-bezier", degree=4, mode="point")[0]
        for method, ns in (("de_casteljau", 2.0), ("factorial:power_sum", 1.5)):
            bundle["timing.csv"].rows.append(Row("timing.csv", 2, {**base.values, "method": method, "limit_ns": ns}, {}))
        for ns, held in ((1.5, 0), (3.0, 1)):
            bundle["timing.csv"].rows[-1].values["limit_ns"] = ns
            self.assertIn(f"At the limits of this processor it would hold at {held} of 1 when prepared once.", " ".join(time_order(bundle).detail))


TIMES = {"a": 10.0, "b": 20.0, "c": 30.0, "d": 40.0, "e": 500.0}
CYCLES = {"a": 30.0, "b": 60.0, "c": 180.0, "d": 120.0, "e": 1500.0}


def _kernel(file, method, mode="point", **values):
    return Row(file, 2, dict(study="s", form="bernstein", method=method, scalar="double", dimension=2.0, degree=3.0, mode=mode, **values), {})


def _predicted(times=TIMES, cycles=CYCLES, mode="point", **more):
    counted = [_kernel("cost.csv", m, mode, target="AVX2", cycles_zen4=c, latency_zen4=c and 1000 - c, **more) for m, c in cycles.items()]
    found = list(predictions({"cost.csv": Table("cost.csv", [], counted)}, [_kernel("timing.csv", m, mode, median_ns=ns) for m, ns in times.items()]))
    return found[-1].items if found else ()


class Predictions(unittest.TestCase):
    def test_ranks_by_spearman(self):
        self.assertAlmostEqual(rank_correlation([1, 2, 3, 4, 5], [1, 4, 9, 16, 1e9]), 1)
        self.assertAlmostEqual(rank_correlation([1, 2, 3], [3, 2, 1]), -1)
        # Kendall, Rank correlation methods (1948), chapter 3: 1 - 6 sum d^2 / (n^3 - n), with d^2 = 0, 0, 1, 1, 0
        self.assertAlmostEqual(rank_correlation(list(TIMES.values()), list(CYCLES.values())), 1 - 6 * 2 / (5**3 - 5))
        self.assertAlmostEqual(rank_correlation([1, 1, 2, 3], [1, 2, 3, 4]), 0.9**0.5, msg="equal values share their mean rank")
        self.assertIsNone(rank_correlation([1, 1], [1, 2]))

    def test_the_worst_miss_is_relative_to_the_median(self):
        found = [(_kernel("timing.csv", m, median_ns=TIMES[m]), {"x": CYCLES[m]}) for m in TIMES]
        row, miss = worst_miss(found, "x")
        self.assertEqual((row["method"], miss), ("c", 0.5))

    def test_says_both_of_every_mode(self):
        self.assertEqual(_predicted(), ("`point`: coefficient of `cycles_zen4` 0.900 over 5 kernels; the worst miss is `c` at degree 3, 0.50 times.",))
        self.assertIn("coefficient of `latency_zen4` -0.900 over", _predicted(mode="latency", cycles={**CYCLES, "e": 500.0})[0])
        self.assertIn("over 5 kernels, without 1 unpredicted one;", _predicted({**TIMES, "f": 1.0}, {**CYCLES, "f": None})[0])

    def test_is_silent_without_both(self):
        self.assertEqual(_predicted(cycles={**CYCLES, "e": None}), ())
        self.assertEqual(_predicted(coordinate_range=7.0), (), "other inputs")
        self.assertEqual(list(predictions({}, [])), [])


if __name__ == "__main__":
    unittest.main()
