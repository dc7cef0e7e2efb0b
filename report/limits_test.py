# SPDX-License-Identifier: MIT
"""The sentences below a table of times, about the limits of the processor."""

import csv
import tempfile
import unittest

from . import fixture
from .bundle import Bundle, Row
from .chapters.speed import timing
from .findings.conclusions import time_order
from .time_tables import nearness, orders, reading_limits, reading_load


def _row(method, ns, limit, mode="point", degree=5, call=2.0, chain=None, **more):
    """A time that is known to a percent."""
    values = dict(study="s", method=method, scalar="double", dimension=2.0, degree=float(degree), mode=mode, median_ns=float(ns), low_ns=0.99 * ns,
                  high_ns=1.01 * ns, call_ns=call, limit_ns=limit and float(limit), share_of_limit=limit and limit / (ns - call), chain_ns=chain, **more)
    return Row("timing.csv", 2, values, {})


def _said(rows):
    return " ".join(line for block in nearness(rows) for line in (block.items if block.kind == "bullets" else (block.text,)))


class Nearness(unittest.TestCase):
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
        kept, turned = orders(rows)
        self.assertEqual(kept, {("fast", "slow"): 1})
        self.assertEqual(turned, {("fast", "badly_coded"): 1, ("slow", "badly_coded"): 1})
        self.assertIn("Of 3 orders of two methods of a race 1 would hold at the limits and 2 would not: `fast` before `badly_coded` in 1 race "
                      "and `slow` before `badly_coded` in 1 race.", _said(rows))
        self.assertIn("All 1 order of two methods of a race would hold", _said(rows[:2]))

    def test_compares_within_a_race_and_only_what_is_apart(self):
        for other in (_row("b", 10.1, 2), _row("b", 20, 2, degree=6), _row("b", 20, 2, mode="latency"), _row("b", 20, 2, generator="integer")):
            self.assertEqual(orders([_row("a", 10, 1), other]), ({}, {}))
        self.assertIn("No two methods of a race differ in time.", _said([_row("a", 10, 1)]))

    def test_methods_of_equal_limits_have_no_order_there(self):
        self.assertEqual(set(orders([_row("a", 10, 1), _row("b", 20, 1)])[1]), {("a", "b")})

    def test_says_how_many_have_no_limit(self):
        self.assertIn("1 time has no limit", _said([_row("a", 12, 5), _row("direct_pow", 100, None)]))
        self.assertEqual(_said([_row("direct_pow", 100, None)]), "")
        self.assertIsNone(reading_limits([_row("direct_pow", 100, None)]))


class Page(unittest.TestCase):
    def blocks(self, left_out=(), machine=None):
        with tempfile.TemporaryDirectory() as place:
            folder = fixture.write(f"{place}/b")
            with open(folder / "timing.csv", newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            with open(folder / "timing.csv", "w", newline="", encoding="utf-8") as file:
                writer = csv.DictWriter(file, [c for c in rows[0] if c not in left_out], lineterminator="\n", extrasaction="ignore")
                writer.writeheader()
                writer.writerows(rows)
            bundle = Bundle(fixture.seal(folder))
            if machine is not None:
                bundle.machine = machine
            return [b.text for b in timing(bundle, None) if b.kind == "text"], time_order(bundle)

    def test_says_it_of_each_table(self):
        texts, _ = self.blocks()
        self.assertEqual(sum("**Distance to the limit.**" in t for t in texts), 1, "of the one table that has limits")
        self.assertTrue(any(t.startswith("The limit of a time (`limit_ns` of the file)") for t in texts))

    def test_accepts_bundles_without_limits(self):
        texts, found = self.blocks("call_ns limit_ns share_of_limit chain_ns max_error_u allowed_error_u".split())
        self.assertFalse(any("limit" in t for t in texts))
        self.assertTrue(any("a lenient one" in t for t in texts))
        self.assertNotIn("At the limits", " ".join(found.detail))

    def test_says_the_load(self):
        texts, _ = self.blocks(machine={"load_average": [0.5, 1, 12.25], "cpu": {"logical_cores_available": 2}})
        self.assertIn("Load of the machine when the run began, over 1, 5 and 15 minutes: 0.500, 1 and 12.2, on 2 processors.", texts)
        for unknown in ({}, {"load_average": "unknown"}, {"load_average": [1]}, {"load_average": ["a", 1, 2]}, None):
            with tempfile.TemporaryDirectory() as place:
                bundle = Bundle(fixture.write(f"{place}/b"))
                bundle.machine = unknown
                self.assertIsNone(reading_load(bundle), unknown)

    def test_says_whether_the_orders_of_the_report_hold_at_the_limits(self):
        def limits(at, row):
            if at == "timing.csv" and row["study"] == "2.4-bezier" and row["degree"]:
                row["limit_ns"] = 1.0
        with tempfile.TemporaryDirectory() as place:
            bundle = Bundle(fixture.write(f"{place}/b", limits))
            base = bundle["timing.csv"].select(study="2.4-bezier", degree=4)[0]
            for method, ns in (("de_casteljau", 2.0), ("factorial:power_sum", 1.5)):
                bundle["timing.csv"].rows.append(Row("timing.csv", 2, {**base.values, "method": method, "limit_ns": ns}, {}))
            self.assertIn("At the limits of this processor it would hold at 0 of 1 when prepared once.", " ".join(time_order(bundle).detail))
            bundle["timing.csv"].rows[-1].values["limit_ns"] = 3.0
            self.assertIn("At the limits of this processor it would hold at 1 of 1 when prepared once.", " ".join(time_order(bundle).detail))


if __name__ == "__main__":
    unittest.main()
