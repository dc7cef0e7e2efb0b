#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Inputs of public threads on which the program once failed, each with its right answer and where that comes from:
reference/published/public_reports.json. Every case has a test named after its id. Usage: public_reports_test.py BEZIERBENCH"""
import fractions
import json
import math
import os
import re
import shlex
import subprocess
import sys
import unittest
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import FINDING, INPUT_OUTPUT, ROOT, USAGE, Case, rows  # noqa: E402

CASES = {case["id"]: case for case in json.loads((ROOT / "reference/published/public_reports.json").read_text())}
PATIENCE = 60  # seconds; the answers once took longer or never came


def csv_of(points, weights=None):
    lines = [list(point) + ([] if weights is None else [weights[i]]) for i, point in enumerate(points)]
    header = list("xyz"[:len(points[0])]) + ([] if weights is None else ["w"])
    return "\n".join(",".join(map(str, line)) for line in [header, *lines]) + "\n"


def samples(segments, count=2001):
    """Points of cubics (m, 4, d) at equal steps of the parameter."""
    t = numpy.linspace(0, 1, count)[:, None]
    b0, b1, b2, b3 = (1 - t)**3, 3 * t * (1 - t)**2, 3 * t**2 * (1 - t), t**3
    return numpy.concatenate([b0 * c[0] + b1 * c[1] + b2 * c[2] + b3 * c[3] for c in segments])


def distances(points, polyline):
    """The distance of each point from the nearest edge of the polyline."""
    nearest = numpy.full(len(points), numpy.inf)
    for a, b in zip(polyline[:-1], polyline[1:]):
        along = b - a
        square = along @ along
        share = numpy.clip((points - a) @ along / square, 0, 1) if square else numpy.zeros(len(points))
        nearest = numpy.minimum(nearest, numpy.linalg.norm(points - a - share[:, None] * along, axis=1))
    return nearest


def segments_of(text):
    found = rows(text)
    axes = [name for name in found[0] if name in ("x", "y", "z")]
    return numpy.array([[float(row[axis]) for axis in axes] for row in found]).reshape(-1, 4, len(axes))


class PublicReports(Case):
    def curve(self, case, key="points"):
        return self.write("c.csv", csv_of(case["input"][key], case["input"].get("weights")))

    def lines(self, *arguments):
        """The rows that a command prints. It may say something on standard error, but ends with 0."""
        result = self.run_program(*arguments, timeout=PATIENCE)
        self.assertEqual(result.returncode, 0, result.stderr)
        return rows(result.stdout.decode())

    def fit(self, case):
        """No farther from the polyline of the data than 5 tolerances or a tenth of their box, by the method of the report and by
        the one that is left out; and no datum farther from the curve than the tolerance."""
        data, tolerance = numpy.array(case["input"]["points"], float), case["input"]["tolerance"]
        self.curve(case)
        for method in ([], ["--method", case["input"]["method"]]):
            result = self.run_program("curve", "fit", "--points", "c.csv", "--tolerance", tolerance, *method)
            self.assertEqual(result.returncode, 0, result.stderr)
            curve = samples(segments_of(result.stdout.decode()))
            self.assertLess(distances(curve, data).max(), max(5 * tolerance, 0.1 * numpy.ptp(data, axis=0).max()), method)
            self.assertLess(distances(data, curve).max(), tolerance * (1 + 1e-9), method)

    def length(self, case, points="control_points"):
        """What `length` prints is a length that `at-length` takes, and the end of the curve is there."""
        self.curve(case, points)
        printed = {row["length"] for row in self.lines("curve", "length", "--curve", "c.csv") if row["converged"] == "yes"}
        for length in sorted(printed | {case["input"]["length"]}):
            for row in self.lines("curve", "at-length", "--curve", "c.csv", "--length", length):
                if row["converged"] == "yes":
                    self.assertAlmostEqual(float(row["t"]), case["right"]["t"] if points == "control_points" else 1, delta=1e-8)

    def case_at_length_own_length(self, case):
        self.length(case, "points")

    def case_G_TIE_1(self, case):
        self.curve(case, "control_points")
        for row in self.lines("curve", "project", "--curve", "c.csv", "--point=-1,0"):
            self.assertEqual(float(row["exact_t"]), case["right"]["exact_t"])

    def interpolated(self, case):
        self.curve(case)
        return self.run_program("curve", "interpolate", "--points", "c.csv")

    def case_G_INT_1(self, case):
        x = samples(segments_of(self.interpolated(case).stdout.decode()))[:, 0]
        self.assertGreater(numpy.diff(x).min(), -1e-12)

    def case_G_INT_3(self, case):
        result = self.interpolated(case)
        if result.returncode == 0:  # the curve stays where two data are equal
            self.assertEqual(numpy.abs(segments_of(result.stdout.decode())[0]).max(), 0)
        else:
            self.assertEqual(result.returncode, INPUT_OUTPUT, result.stderr)
            self.assert_one_line(result, "c.csv:3", "repeat")

    def projected(self, points, point, *method):
        self.write("c.csv", csv_of(points))
        found = self.lines("curve", "project", "--curve", "c.csv", f"--point={point}", *method)
        for row in found:
            self.assertTrue(0 <= float(row["t"]) <= 1 and float(row["distance"]) >= 0, row)
        return found

    def case_G_HI_1(self, case):
        chance = numpy.random.default_rng(1)
        for degree in case["input"]["degree"]:
            walk = numpy.cumsum(chance.integers(-9, 10, (degree + 1, 2)), axis=0).tolist()
            self.assertEqual(len(self.projected(walk, "200,150", "--method", "subdivide_hull")), 1)

    def case_project_high_degree(self, case):
        points = [[float(10 * numpy.cos(i)), float(10 * numpy.sin(2 * i))] for i in range(101)]
        self.assertGreater(len(self.projected(points, ",".join(map(str, case["input"]["point"])))), 1)

    def case_project_default_t(self, case):
        right = float(case["right"].split()[0])
        for row in self.projected(case["input"]["points"], "300,340"):
            if "seed_" not in row["method"]:  # as printed, wrong
                self.assertAlmostEqual(float(row["t"]), right, delta=1e-14, msg=row["method"])

    def case_G_MSG_1(self, _case):
        self.write("c.csv", "x,y,w\n1,0,1\n1,1,1\n0,1,2\n")
        for row in rows(self.fine("curve", "length", "--curve", "c.csv")):
            self.assertTrue(row["exact"].startswith("1.5707963267948966192313216916"), row)

    def case_hint_convert(self, case):
        self.curve(case)
        self.fine("curve", "grid", "--curve", "c.csv", "--points", "3")
        result = self.refused(USAGE, ["curve", "convert", "--curve", "c.csv", "--method", "differences"], "rational")
        self.assertNotRegex(result.stderr.decode(), "see `curve convert`|leave.*out")

    def case_G_MSG_2(self, case):
        self.refused(USAGE, shlex.split(case["command"]), 'did you mean "length"?')

    def case_G_CSV_1(self, case):
        self.write("c.csv", case["input"]["csv"].replace("\\n", "\n"))
        self.refused(INPUT_OUTPUT, ["curve", "length", "--curve", "c.csv"], "c.csv:1", "header", "x,y")

    def case_G_OUT_1(self, _case):
        self.write("p.csv", "x,y\n0,0\n3,1\n4,4\n")
        self.write("s.csv", self.fine("curve", "interpolate", "--points", "p.csv"))
        found = self.lines("curve", "length", "--curve", "s.csv", "--method", "gauss_legendre_24")
        self.assertEqual([row["curve"] for row in found], ["0", "1"])
        for row, chord in zip(found, (10**0.5, 10**0.5)):
            self.assertGreater(float(row["length"]), chord)
        for command in (["project", "--point", "1,1"], ["split", "--t", "0.5"], ["eval", "--t", "0.5"], ["at-length", "--fraction", "0.5"]):
            self.assertEqual({row["curve"] for row in self.lines("curve", command[0], "--curve", "s.csv", *command[1:])}, {"0", "1"})

    def case_G_CHORD_1(self, case):
        self.curve(case, "control_points")
        errors = []
        for tolerance in ("1e-9", "1e-12"):
            row, = self.lines("curve", "length", "--curve", "c.csv", "--tolerance", tolerance, "--method", "chord_sum")
            errors.append(abs(fractions.Fraction(float(row["length"])) - fractions.Fraction(269, 81)))
        self.assertLessEqual(errors[1], errors[0])

    def case_G_PROG_1(self, _case):
        self.suite(id='"lens"', kind='"arc_length"', methods='["chord_sum"]', tolerance="[1e-3]", trials="5")
        program = f"{sys.executable} {ROOT / 'experiments/examples/program/mine.py'}"
        result = self.run_program("run", "s.toml", "--out", "b", "--program", program)
        self.assertNotEqual(result.returncode, 0, result.stderr)
        self.assert_one_line(result, "program_mine")

    def evaluated(self, path, *arguments):
        """The value of a method and its bound in units; None where the method says that it does not take the curve."""
        result = self.run_program("curve", "eval", "--curve", "c.csv", "--t", "0.5", "--method", path, *arguments)
        if result.returncode == USAGE:
            self.assert_one_line(result, "degree")
            return None
        self.assertEqual(result.returncode, 0, result.stderr)
        row, = rows(result.stdout.decode())
        return float(row["value"]), float(row["bound_u"] or "inf")

    def holds(self, found, right):
        """Right, or not taken, or nothing is claimed of it."""
        if found is not None and found[1] < float("inf"):
            self.assertAlmostEqual(found[0] / right, 1, delta=1e-12)

    def case_positive_sum_constant(self, _case):
        self.write("c.csv", "x\n1\n" + "0\n" * 1021)
        self.holds(self.evaluated("positive_sum:de_casteljau", "--form", "power"), 1)

    def case_centered_differences(self, _case):
        self.write("c.csv", "x\n" + "".join("1\n" if i == 344 else "0\n" for i in range(689)))
        self.holds(self.evaluated("differences_centered:horner_centered"), math.comb(688, 344) / 2**688)

    def case_compensated_vs_huge(self, case):
        self.curve(case)
        self.holds(self.evaluated("compensated_volk_schumaker"), float(case["right"]))

    @unittest.skipUnless("BEZIERBENCH_LIBRARY" in os.environ, "the C library is not there")
    def case_float_volk_schumaker(self, _case):
        sys.path.insert(0, str(ROOT / "bindings/python"))
        import bezierbench
        ones, half = numpy.ones((129, 1), numpy.float32), numpy.float32(0.5)
        for method in ("volk_schumaker", "compensated_volk_schumaker"):
            try:
                self.assertEqual(bezierbench.evaluate(ones, half, method)[0], 1)
            except ValueError as error:
                self.assertIn("degree", str(error))

    def case_bspline_knots(self, case):
        self.write("d.csv", csv_of(case["input"]["points"]))
        knots = ",".join(map(repr, case["input"]["knots"]))
        result = self.run_program("curve", "bspline", "--points", "d.csv", f"--knots={knots}", "--t", repr(case["input"]["t"]))
        self.assertEqual(result.returncode, 0, result.stderr)
        for row in rows(result.stdout.decode()):
            if row["index"] == "" and row["bound_u"]:
                self.assertAlmostEqual(float(row["value"]), {"x": 3.90625, "y": 2.75}[row["axis"]], delta=1e-12)

    def case_exact_t_tiny(self, case):
        self.curve(case)
        for row in self.lines("curve", "at-length", "--curve", "c.csv", "--fraction", case["input"]["fraction"]):
            if row["exact_t"]:
                self.assertAlmostEqual(float(row["exact_t"]) / float(case["right"]), 1, delta=1e-15)

    def case_hint_choose(self, case):
        degree = case["input"]["degree"]
        result = self.run_program("choose", ROOT / "results/answers", "--degree", degree, "--tolerance", "1")
        hint = re.search(r"bezierbench (run [^`]*?)(`|$)", (result.stdout + result.stderr).decode())
        if hint:  # a run that is named can be asked what it costs
            arguments = [word for word in shlex.split(hint[1]) if word != "--dry-run"]
            run = self.run_program(*arguments, "--dry-run", timeout=PATIENCE)
            self.assertEqual(run.returncode, 0, run.stderr)

    def case_judge_changed_input(self, case):
        suite = self.suite(trials="3", methods='["de_casteljau"]', dimension="[1]")
        self.fine("inputs", suite, "--out", "questions.csv")
        script = ROOT / "experiments/examples/answers/answer.py"
        answers = subprocess.run([sys.executable, script, self.folder / "questions.csv"], check=True, capture_output=True, text=True)
        answered = [line.split(",") for line in answers.stdout.splitlines()]
        answered[-1][answered[0].index("t")] = "0x1p-3"
        self.write("mine.csv", "\n".join(",".join(line) for line in answered) + "\n")
        result = self.run_program("judge", "mine.csv")
        self.assertEqual(result.returncode, FINDING, result.stderr)
        self.assertIn(case["right"].split('"')[1], result.stderr.decode())


def test_of(case):
    kind = {"G-FIT": "fit", "G-LEN": "length"}.get(case["id"][:5], f"case_{case['id'].replace('-', '_')}")
    return lambda self: getattr(self, kind)(case)


for one in CASES.values():
    setattr(PublicReports, f"test_{one['id'].replace('-', '_')}", test_of(one))

if __name__ == "__main__":
    unittest.main()
