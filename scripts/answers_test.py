#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The table at the top of README.md follows the bundle: what changes there turns an answer over."""
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report import fixture  # noqa: E402
from report.bundle import Bundle  # noqa: E402
from scripts.pages.answers import NEEDS, REAL, answers, degrees, winner  # noqa: E402

BUNDLE = ROOT / "results/answers"
WORSE = {"accuracy.csv": {"bound_u": 1e9, "max_error_ulp": 0.75}, "arc_length.csv": {"broken_promises": 1.0},
         "projection.csv": {"missed": 1.0}, "flattening.csv": {"broken": 1.0}, "easing.csv": {"non_monotone": 1.0},
         "bounds.csv": {"too_small": 1.0}}


def winners(bundle):
    return {need.name: method_of(bundle, need) for need in NEEDS}


def method_of(bundle, need):
    found = winner(bundle, need)
    return found.method if found else None


class Answers(unittest.TestCase):
    def setUp(self):
        self.bundle = Bundle(BUNDLE)

    def rows(self, need, method):
        found = winner(self.bundle, need)
        self.assertEqual(found.method, method)
        return [row for rows in found.errors.values() for row in rows], list(found.times.values())

    def test_every_need_has_an_answer(self):
        self.assertNotIn(None, winners(self.bundle).values())

    def test_a_slower_method_wins_no_longer(self):
        for need in NEEDS:
            method = method_of(self.bundle, need)
            _, times = self.rows(need, method)
            others = {row["method"] for row in self.bundle["timing.csv"].select(study=need.times, mode=need.mode)} - {method}
            for row in times:
                for column in ("ratio", "ratio_low", "ratio_high"):
                    row.values[column] *= 1e9
            after = method_of(self.bundle, need)
            meets_alone = after == method  # the only one that fulfils the need
            with self.subTest(need=need.name):
                self.assertTrue(meets_alone or after in others)
                if need.name in ("Fast and safe, t in [0, 1]", "Many t on one curve", "Data in power form"):
                    self.assertFalse(meets_alone)

    def test_a_method_that_fails_the_demand_at_one_degree_wins_no_longer(self):
        for need in NEEDS:
            method = method_of(self.bundle, need)
            errors, _ = self.rows(need, method)
            last = [row for row in errors if row["degree"] == degrees(self.bundle, need)[-1]][-1]
            kept = dict(last.values)
            last.values.update(WORSE[need.table])
            with self.subTest(need=need.name):
                self.assertNotEqual(method_of(self.bundle, need), method)
            last.values.update(kept)

    def test_of_methods_that_are_as_fast_the_one_with_the_smaller_bound_wins(self):
        """Many t, where the plain method is faster by 1 % at every degree; the bound 2n + 2 of the fused one is below 3n + 1."""
        need = next(need for need in NEEDS if need.mode == "batch")
        fused, plain = (self.bundle["timing.csv"].select(study=need.times, mode=need.mode, method=method, degree=degrees(self.bundle, need))
                        for method in ("horner_bernstein_fma", "horner_bernstein"))
        for one, other in zip(fused, plain):
            one.values.update(ratio=other["ratio"] * 1.01, ratio_low=other["ratio_low"], ratio_high=other["ratio_high"] * 1.02)
        found = winner(self.bundle, need)
        self.assertEqual((found.method, "horner_bernstein" in found.tied), ("horner_bernstein_fma", True))
        self.assertIn("| `horner_bernstein_fma` (", answers(self.bundle))
        fused[0].values["ratio_low"] = plain[0].values["ratio_high"] * 1.01  # certainly slower at one degree
        found = winner(self.bundle, need)
        self.assertEqual((found.method, "horner_bernstein_fma" in found.tied), ("horner_bernstein", False))

    def test_a_degree_that_is_missing_is_no_answer(self):
        need = NEEDS[0]
        method = method_of(self.bundle, need)
        _, times = self.rows(need, method)
        times[1].values["degree"] = 13.0
        self.assertNotEqual(method_of(self.bundle, need), method)


class RealCurves(unittest.TestCase):
    def bundle(self, change=None):
        return fixture.bundle(change, **fixture.REAL)

    def test_they_come_first_and_have_their_own_degrees(self):
        lines = answers(Bundle(BUNDLE), self.bundle()).splitlines()
        self.assertEqual(lines[0], "| need | method | × of | n = 2 | n = 3 | n = 5 | n = 12 | n = 30 |")
        self.assertTrue(lines[2].startswith("| **Real curves, float**"))
        self.assertRegex(lines[2], r"\| `differences:horner` \| `\w+` \| 4 % misrounded<br>\S+ to \S+ ×<br>about 4 ns \| [^|]* \|  \|  \|  \|$")
        first = next(line for line in lines if line.startswith("| **Fast and safe"))
        self.assertEqual([cell == "" for cell in map(str.strip, first.split("|")[4:-1])], [False] * 5)
        self.assertIn("sets outlines and icons (5,000 points)", " ".join(lines))
        self.assertNotIn("few (", " ".join(lines))

    def test_the_fastest_that_misrounds_little_on_every_set(self):
        self.assertEqual([method_of(self.bundle(), need) for need in REAL],
                         ["differences:horner", "correctly_rounded", "differences:horner", "differences:horner"])

        def one_set(file, row):
            if row["method"] == "differences:horner" and row.get("curves") == "icons" and row["generator"] == "stored":
                row["misrounded"] = 0.06
        self.assertEqual(method_of(self.bundle(one_set), REAL[0]), "correctly_rounded")

    def test_a_method_that_a_set_does_not_judge_is_no_answer(self):
        bundle = self.bundle(lambda file, row: (row["method"], row.get("curves"), row["scalar"]) != ("differences:horner", "icons", "float"))
        self.assertEqual([method_of(bundle, REAL[0]), method_of(bundle, REAL[3])], ["correctly_rounded", "differences:horner"])

    def test_a_broken_bound_is_no_answer(self):
        def broken(file, row):
            if row["method"] == "differences:horner" and row.get("curves") == "outlines" and row["degree"] == 2:
                row["bound_violations"] = 1
        self.assertEqual(method_of(self.bundle(broken), REAL[0]), "correctly_rounded")


if __name__ == "__main__":
    unittest.main()
