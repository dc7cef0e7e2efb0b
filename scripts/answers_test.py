#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The table at the top of README.md follows the bundle: what changes there turns an answer over."""
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report.bundle import Bundle  # noqa: E402
from scripts.pages.answers import DEGREES, NEEDS, answers, winner  # noqa: E402

BUNDLE = ROOT / "results/answers"
WORSE = {"accuracy.csv": {"bound_u": 1e9, "max_error_ulp": 0.75}, "arc_length.csv": {"broken_promises": 1.0},
         "projection.csv": {"missed": 1.0}}


def winners(bundle):
    return {need.name: (winner(bundle, need) or [None])[0] for need in NEEDS}


class Answers(unittest.TestCase):
    def setUp(self):
        self.bundle = Bundle(BUNDLE)

    def rows(self, need, method):
        found = winner(self.bundle, need)
        self.assertEqual(found[0], method)
        return [row for rows in found[1].values() for row in rows], list(found[2].values())

    def test_every_need_has_an_answer(self):
        self.assertNotIn(None, winners(self.bundle).values())

    def test_a_slower_method_wins_no_longer(self):
        for need in NEEDS:
            method = winner(self.bundle, need)[0]
            _, times = self.rows(need, method)
            others = {row["method"] for row in self.bundle["timing.csv"].select(study=need.times, mode=need.mode)} - {method}
            for row in times:
                row.values["median_ns"] *= 1e9
            after = winner(self.bundle, need)[0]
            meets_alone = after == method  # the only one that fulfils the need
            with self.subTest(need=need.name):
                self.assertTrue(meets_alone or after in others)
                if need.name in ("Fast and safe, t in [0, 1]", "Many t on one curve", "Data in power form"):
                    self.assertFalse(meets_alone)

    def test_a_method_that_fails_the_demand_at_one_degree_wins_no_longer(self):
        for need in NEEDS:
            method = winner(self.bundle, need)[0]
            errors, _ = self.rows(need, method)
            last = [row for row in errors if row["degree"] == DEGREES[-1]][-1]
            kept = dict(last.values)
            last.values.update(WORSE[need.table])
            with self.subTest(need=need.name):
                self.assertNotEqual((winner(self.bundle, need) or [None])[0], method)
            last.values.update(kept)

    def test_a_degree_that_is_missing_is_no_answer(self):
        need = NEEDS[0]
        method = winner(self.bundle, need)[0]
        _, times = self.rows(need, method)
        times[1].values["degree"] = 13.0
        self.assertNotEqual(winner(self.bundle, need)[0], method)

    def test_numbers_in_words_are_those_of_the_rows(self):
        self.assertIn("the tolerance of 1e-9 kept", answers(self.bundle))
        self.assertIn("for t in [-100, 100]", answers(self.bundle))
        for row in self.bundle["arc_length.csv"].rows:
            row.values.update(tolerance=1e-6, trials=7.0)
        for row in self.bundle["accuracy.csv"].select(study="answers-outside"):
            row.values.update(t_min=-3.0)
        self.assertIn("the tolerance of 1e-6 kept", answers(self.bundle))
        self.assertIn("for t in [-3, 100]", answers(self.bundle))
        self.assertIn("arc length 7,", answers(self.bundle).replace("\n", " "))

    def test_a_noisy_time_is_marked(self):
        rows = self.bundle["timing.csv"].rows
        for row in rows:
            row.values["quality"] = "noisy"
        self.assertEqual(answers(self.bundle).count("~"), len(NEEDS) * len(DEGREES) + answers(self.bundle).count("p~"))


if __name__ == "__main__":
    unittest.main()
