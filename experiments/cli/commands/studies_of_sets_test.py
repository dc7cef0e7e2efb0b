#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Studies over curve sets, and `choose --curves`, from outside. Usage: studies_of_sets_test.py BEZIERBENCH"""
import shutil
import sys
import unittest
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import FINE, INPUT_OUTPUT, USAGE, Case, rows  # noqa: E402

SVG = ('<svg xmlns="http://www.w3.org/2000/svg"><path id="a" d="M604.3 1010.7c0 .5 18.1 3.3 36.4-1.2S700 990 700.25 1000z"/>'
       '<path d="M10 20Q30.5 40.25 50 20T90 21"/><circle cx="5" cy="6" r="2"/></svg>')
COUNT = 9  # parameters of each curve
STUDY = {"id": '"real"', "kind": '"accuracy"', "curves": '["logo.svg"]', "parameters": str(COUNT), "parameters_from": '"grid"',
         "methods": '["de_casteljau", "correctly_rounded", "direct"]', "degree": "[3]"}

TIMES = {"id": '"split"', "kind": '"timing"', "methods": '["de_casteljau_split"]', "modes": '["one_shot"]', "degree": "[3]"}


def de_casteljau(points, t, one_minus_t):
    while len(points) > 1:
        points = [[one_minus_t * a + t * b for a, b in zip(p, q)] for p, q in zip(points, points[1:])]
    return points[0]


class CurveSets(Case):
    def setUp(self):
        super().setUp()
        self.write("logo.svg", SVG)

    def curves(self, bundle):
        """The control points of each cubic curve of the set that a bundle has a copy of."""
        points = {}
        for row in self.table(f"{bundle}/curves_logo.csv"):
            points.setdefault(row["curve"], []).append([float.fromhex(row["x"]), float.fromhex(row["y"])])
        return [p for p in points.values() if len(p) == 4]

    def test_errors_are_those_of_rational_arithmetic(self):
        self.bundle(self.suite(STUDY))
        curves = self.curves("b")
        self.assertEqual(len(curves), 2)
        wrong, largest, over_size = 0, Fraction(0), Fraction(0)
        for curve in curves:
            size = max(max(axis) - min(axis) for axis in zip(*curve))
            for k in range(COUNT):
                t = k / (COUNT - 1)
                value = de_casteljau(curve, t, 1 - t)
                truth = de_casteljau([[Fraction(x) for x in p] for p in curve], Fraction(t), 1 - Fraction(t))
                wrong += sum(v != float(x) for v, x in zip(value, truth))
                square = sum((Fraction(v) - x) ** 2 for v, x in zip(value, truth))
                largest, over_size = max(largest, square), max(over_size, square / Fraction(size) ** 2)
        row = next(row for row in self.table("b/accuracy.csv") if row["method"] == "de_casteljau")
        self.assertEqual((row["curves"], row["coordinate_range"], row["t_min"], row["generator"], row["trials"]),
                         ("logo", "", "", "stored", str(2 * COUNT)))
        self.assertGreater(wrong, 0)
        self.assertEqual(float(row["misrounded"]), wrong / (2 * 2 * COUNT))
        self.assertAlmostEqual(float(row["max_error"]) ** 2 / float(largest), 1, places=6)
        self.assertAlmostEqual(float(row["max_error_size"]) ** 2 / float(over_size), 1, places=6)
        exact = next(row for row in self.table("b/accuracy.csv") if row["method"] == "correctly_rounded")
        self.assertEqual(float(exact["misrounded"]), 0)

    def test_a_bundle_has_its_curves_and_needs_no_other_file(self):
        self.bundle(self.suite({**STUDY, "parameters_from": '"drawn"', "placement": '["stored", "translated"]', "degree": None}))
        (self.folder / "logo.svg").unlink()
        self.assertTrue(self.fine("verify", "b").startswith("b: fine"))
        worst = self.table("b/worst.csv")[0]["worst_id"]
        self.assertIn("u p~: the same", self.fine("replay", "b", worst))
        shutil.copy(self.folder / "b/curves_logo.csv", self.folder / "logo.csv")
        self.bundle(self.suite({**STUDY, "curves": '["logo.csv"]', "parameters_from": '"drawn"',
                                "placement": '["stored", "translated"]', "degree": None}), name="again")
        self.assertEqual(self.manifest("b")["accuracy_digest"], self.manifest("again")["accuracy_digest"])

    def test_shards_make_the_same_bundle(self):
        suite = self.suite({**STUDY, "degree": None})
        self.bundle(suite)
        for shard in (1, 2):
            self.fine("run", suite, "--quiet", "--out", f"part{shard}", "--shard", f"{shard}/2")
        self.fine("merge", "part1", "part2", "--out", "merged", "--quiet")
        for name in ("accuracy.csv", "worst.csv", "digests.csv", "suite.toml", "curves_logo.csv"):
            self.assertEqual((self.folder / "b" / name).read_bytes(), (self.folder / "merged" / name).read_bytes(), name)

    def test_another_set_is_another_run(self):
        suite = self.suite(STUDY)
        self.bundle(suite)
        self.write("logo.svg", SVG.replace("604.3", "604.5"))
        self.refused(USAGE, ["run", suite, "--out", "b"], "resolved suite")
        sha = next(line for line in (self.folder / "b/suite.toml").read_text().splitlines() if line.startswith("curves_sha256"))
        changed = self.suite({**STUDY, "curves_sha256": sha.split(" = ")[1]}, name="pinned.toml")
        self.refused(USAGE, ["run", changed, "--out", "other"], "pinned.toml:", "have the SHA-256", "restore the set")

    def test_a_suite_of_drawn_curves_takes_a_file(self):
        self.fine("run", "quick", "--curves", "logo.svg", "--no-timing", "--quiet", "--out", "b")
        self.assertTrue(self.fine("verify", "b").startswith("b: fine"))
        found = {(row["study"], row["form"]) for row in self.table("b/accuracy.csv")}
        self.assertEqual(found, {("quick-bezier", "bernstein"), ("quick-rational", "rational")})
        self.assertEqual({row["curves"] for row in self.table("b/projection.csv")}, {"logo"})

    def test_times_are_of_the_curves_of_the_file(self):
        """A problem that takes no curves, as interpolation, is left out."""
        suite = self.suite(TIMES, {**TIMES, "id": '"spline"', "methods": '["c2_natural"]', "degree": None, "points": "[10]"})
        self.fine("run", suite, "--curves", "logo.svg", "--quiet", "--out", "b")
        timed = [row for row in self.table("b/timing.csv") if row["method"] == "de_casteljau_split"]
        self.assertEqual(sorted((row["study"], row["curves"], row["degree"], row["checked"]) for row in timed),
                         [("split", "logo", degree, "yes") for degree in "123"])

    def test_one_path_of_a_file_whatever_the_case_of_its_name(self):
        shutil.move(self.folder / "logo.svg", self.folder / "LOGO.SVG")
        self.fine("run", self.suite({**STUDY, "curves": None, "parameters": None, "parameters_from": None}), "--curves", "LOGO.SVG#a:*",
                  "--quiet", "--out", "b")
        kept, = (self.folder / "b").glob("curves_*.csv")
        self.assertEqual({row["curve"].split(":")[0] for row in rows(kept.read_text())}, {"a"})

    def test_answers_from_elsewhere_are_judged(self):
        """Answers of de Casteljau's algorithm in Python, to the inputs as they were written, have the errors of ours."""
        suite = self.suite({**STUDY, "methods": '["de_casteljau"]'})
        self.bundle(suite)
        self.fine("inputs", suite, "--out", "inputs.csv")
        table = self.table("inputs.csv")
        for row in table:
            numbers = [float.fromhex(x) for x in row["coefficients"].split()]
            t = float.fromhex(row["t"])
            point = de_casteljau(list(zip(numbers[:4], numbers[4:])), t, 1 - t)
            row.update(zip("xy", map(float.hex, point)))
        self.write_rows("mine.csv", table)
        judged = rows(self.fine("judge", "mine.csv"))
        self.assertEqual([row["curves"] for row in judged], ["logo"])
        for column in ("mean_error", "max_error_u", "misrounded", "p99_error_size", "trials"):
            self.assertEqual(judged[0][column], self.table("b/accuracy.csv")[0][column], column)
        self.fine("judge", "mine.csv", "--out", "judged")
        self.assertTrue(self.fine("verify", "judged").startswith("judged: fine"))

    def test_what_is_not_a_set(self):
        for curves, code, *needles in (
                ('["nowhere.svg"]', INPUT_OUTPUT, "nowhere.svg: cannot be read"),
                ('["namd"]', USAGE, 's.toml:9:11: study "real": unknown curve set "namd"; did you mean "named"?'),
                ('["named#no_such_*"]', USAGE, "has no such curve"),
                ('["named#wilkinson_10"]', USAGE, "no curve of the sets has a form and degree")):
            with self.subTest(curves=curves):
                self.refused(code, ["run", self.suite({**STUDY, "curves": curves}), "--out", "b"], *needles)
        self.refused(USAGE, ["run", "interpolation", "--curves", "logo.svg", "--out", "b"], "no study of the suite takes curves")

    def test_choose_ranks_the_methods_on_a_file(self):
        table = rows(self.fine("choose", "--curves", "logo.svg", "--scalar", "float", "--format", "csv"))
        self.assertEqual(list(table[0])[:3], ["form", "degree", "curves"])
        groups = list(dict.fromkeys((row["form"], row["degree"], row["curves"]) for row in table))
        self.assertEqual(groups, [("rational", "2", "4"), ("bernstein", "3", "2"), ("bernstein", "2", "2"), ("bernstein", "1", "1")])
        shares = {row["method"]: float(row["misrounded"]) for row in table if row["form"] == "bernstein" and row["degree"] == "3"}
        self.assertEqual(shares["correctly_rounded"], 0)
        self.assertGreater(shares["horner_bernstein_fma"], shares["differences:horner_fma"])
        text = self.fine("choose", "--curves", "logo.svg", "--degree", "3", "--tolerance", "1", "--unit", "ulp")
        self.assertIn("the fastest within 1 ulp", " ".join(text.split()))
        self.assertNotIn("degree 2", text)

    def test_choose_says_what_it_lacks(self):
        self.refused(USAGE, ["choose"], "BUNDLE is required; or name files of curves by --curves")
        self.refused(USAGE, ["choose", "b", "--curves", "logo.svg"], "cannot be combined with the bundle b")
        self.refused(USAGE, ["choose", "--curves", "logo.svg", "--degree", "7"], "no curve of the sets")
        result = self.run_program("choose", "--curves", "logo.svg", "--tolerance", "0", "--degree", "3")
        self.assertIn("no method stays within 0 u p~ on the 2 curves of degree 3", result.stderr.decode())
        self.assertNotEqual(result.returncode, FINE)


if __name__ == "__main__":
    unittest.main()
