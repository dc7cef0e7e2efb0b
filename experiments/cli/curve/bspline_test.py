#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`curve bspline` from outside. Usage: bspline_test.py BEZIERBENCH"""
import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import EVAL_COLUMNS, FINDING, INPUT_OUTPUT, USAGE, Case, rows  # noqa: E402

CLAMPED = "0,0,0,1,2,2,2"


class Bspline(Case):
    def made(self, *arguments):
        """The points and knots of the curve that the arguments make; p.csv and k.txt are its files."""
        points = self.fine("curve", "bspline", *arguments, "--knots-out", "k.txt")
        self.write("p.csv", points)
        return [tuple(map(float, row.values())) for row in rows(points)], list(map(float, (self.folder / "k.txt").read_text().split()))

    def value(self, *arguments):
        """The exact coordinates of a point."""
        found = rows(self.fine("curve", "bspline", *arguments, "--method", "de_boor"))
        return [float(row["exact"]) for row in found]

    def test_points(self):
        self.write("d.csv", "x,y\n0,8\n3,4\n4,-4\n0,0\n")
        curve = ["curve", "bspline", "--points", "d.csv", "--knots"]
        found = rows(self.fine(*curve, "0,1,2,3,4,5,6", "--t", "2.5", "--t", "4"))
        self.assertEqual(list(found[0]), EVAL_COLUMNS[:2] + ["index"] + EVAL_COLUMNS[2:])
        for row in found:
            self.assertEqual(row["bound_u"] == "", row["method"] == "chudy_wozny_span")
        methods = {row["method"]: [r["index"] for r in found if r["method"] == row["method"]] for row in found}
        for method, indices in methods.items():
            self.assertEqual(set(indices), {"", "0", "1", "2"} if method.endswith("_span") else {""}, method)
        self.assertEqual(len(methods), 4)
        for knots, t, *needles in [
                ("0,1,2,1.5,4,5,6", "2", "1.5 follows on 2", "must not descend"), ("0,1,2", "1", "3 knots for the 4 points", "6 to 8"),
                ("0,1,2,3,4,5,6,7,8", "4", "9 knots for the 4 points"), ("0,0,1,1,1,2,2", "1", "begins and ends at 1"),
                ("0,1,2,3,4,5,6", "1.5", "defined from 2 to 4"), ("0,1,2,x,4,5,6", "3", "--knots x"),
                ("0,1,2,3,4,5,inf", "3", "--knots inf")]:
            with self.subTest(knots=knots):
                self.refused(USAGE, [*curve, knots, "--t", t], *needles)
        self.write("knots.txt", "0 1\n2, 3,4\t5\r\n6\n")
        self.assertEqual(rows(self.fine(*curve, "knots.txt", "--t", "2.5", "--t", "4")), found)
        self.write("knots.txt", "0 1\n2 x 4 5 6\n")
        self.refused(USAGE, [*curve, "knots.txt", "--t", "3"], "--knots knots.txt", "x")
        said = self.run_program(*curve, "0,0,0,0,1,1,1", "--t", "0.5").stderr.decode()
        self.assertIn("0 stands 4 times; above degree + 1 = 3 a control point has no influence", said)
        for weights, *needles in [("1,2", "2 for the 4 points in d.csv", "one for each"), ("1,2,0,1", "0 is not above 0, as every weight must be"), ("1,x,1,1", "--weights x")]:
            with self.subTest(weights=weights):
                self.refused(USAGE, [*curve, "0,1,2,3,4,5,6", "--t", "3", "--weights", weights], *needles)

    def test_closed_curves(self):
        """Over uniform knots a closed quadratic begins and ends in the middle between two points; a square's has four alike spans."""
        self.write("s.csv", "x,y\n0,0\n2,0\n2,2\n0,2\n")
        closed = ["curve", "bspline", "--points", "s.csv", "--closed", "2", "--knots"]
        found = rows(self.fine(*closed, "0,1,2,3,4", "--method", "de_boor", *(f"--t={t}" for t in range(5))))
        self.assertEqual([float(row["value"]) for row in found], [1, 0, 2, 1, 1, 2, 0, 1, 1, 0])
        spans = rows(self.fine(*closed, "0,1,2,3,4", "--control-points"))
        self.assertEqual([(float(row["x"]), float(row["y"])) for row in spans][:4], [(1, 0), (2, 0), (2, 1), (2, 1)])
        self.refused(USAGE, [*closed, "0,1,2,3", "--t", "1"], "4 knots for the 4 points in s.csv", "write 5 knots")
        self.refused(USAGE, [*closed, "4,3,2,1,0", "--t", "1"], "--knots: 3 follows on 4")
        for knots in ("-1e308,0,1,2,1e308", "1.2e308,1.3e308,1.4e308,1.5e308,1.7e308", "-1e-17,0.1,0.2,1,1"):
            self.refused(USAGE, [*closed, knots, "--control-points"], "--closed 2", "exceed the largest double, or do not ascend", "nearer to 0")
        self.assertEqual(self.run_program(*closed, "0,1,2,3,4", "--t", "1").stderr, b"")
        said = self.run_program(*closed, "0,0.1,0.2,0.3,0.7", "--t", "0")
        self.assertEqual((said.returncode, said.stderr.count(b"\n")), (0, 1))
        self.assertIn(b"--closed 2: the knots of other periods are rounded", said.stderr)

    def test_no_default_is_shown_that_is_refused(self):
        self.assertNotIn("default 0", self.fine("curve", "bspline", "--help"))

    def test_nurbs_circle(self):
        """[Piegl and Tiller 1997], section 7.5: a circle of four quadratic spans, of nine points. The weights 1, 1, 2 of one span are exact."""
        self.write("c.csv", "x,y\n1,0\n1,1\n0,1\n-1,1\n-1,0\n-1,-1\n0,-1\n1,-1\n1,0\n")
        circle = ["curve", "bspline", "--points", "c.csv", "--knots", "0,0,0,1,1,2,2,3,3,4,4,4", "--weights", ",".join(["1", repr(math.sqrt(0.5))] * 4 + ["1"])]
        for t in ("0.3", "1", "3.75"):
            found = rows(self.fine(*circle, "--t", t))
            for method in {row["method"] for row in found}:
                x, y = (float(row["value"]) for row in found if row["method"] == method and row["index"] == "")
                self.assertAlmostEqual(math.hypot(x, y), 1, delta=1e-15)
        self.assertEqual({row["axis"] for row in found}, {"x", "y", "w"})
        spans = self.fine(*circle, "--control-points")
        self.write("spans.csv", spans)
        self.assertEqual(len(rows(spans)), 12)
        box = [row for row in rows(self.fine("curve", "box", "--curve", "spans.csv#1", "--method", "exact_box"))]
        self.assertTrue(box)

    def test_other_curves_are_read_again(self):
        """[Piegl and Tiller 1997], example 5.1, in one coordinate; then what is made is the same curve, in points and knots."""
        self.write("book.csv", "x\n6\n0\n12\n18\n-6\n24\n30\n3\n")
        book = ["--points", "book.csv", "--knots", "0,0,0,0,1,2,3,4,5,5,5,5"]
        self.assertEqual(self.made(*book, "--insert", "2.5"),
                         ([(x,) for x in (6, 0, 12, 17, 6, -1, 24, 30, 3)], [0, 0, 0, 0, 1, 2, 2.5, 3, 4, 5, 5, 5, 5]))
        self.assertEqual(self.made("--points", "p.csv", "--knots", "k.txt", "--remove", "2.5")[0], [(x,) for x in (6, 0, 12, 18, -6, 24, 30, 3)])
        self.write("d.csv", "x,y,w\n0,8,1\n3,4,2\n4,-4,0.5\n0,0,1\n")
        curve = ["--points", "d.csv", "--knots", CLAMPED]
        self.write("weights.csv", "x,y\n0,8\n3,4\n4,-4\n0,0\n")
        self.assertEqual(self.value(*curve, "--t", "1.25"), self.value("--points", "weights.csv", "--knots", CLAMPED, "--weights", "1,2,0.5,1", "--t", "1.25"))
        for made, ts in ((["--insert", "0.5", "--insert", "1"], (0, 0.75, 1.5, 2)), (["--elevate-to", "4"], (0, 0.75, 1, 2)),
                         (["--from", "0.5", "--to", "1.75"], (0.5, 1, 1.75)), (["--to", "1.25"], (0, 1.25)), (["--from", "1.25"], (1.25, 2))):
            points, knots = self.made(*curve, *made)
            self.assertTrue(all(len(point) == 3 for point in points))
            for t in ts:
                with self.subTest(made=made, t=t):
                    for a, b in zip(self.value(*curve, f"--t={t}"), self.value("--points", "p.csv", "--knots", "k.txt", f"--t={t}"), strict=True):
                        self.assertAlmostEqual(a, b, delta=1e-14)
            self.assertEqual((knots[0], knots[-1]), (ts[0], ts[-1]))

    def test_derivative(self):
        """[Piegl and Tiller 1997], (3.8), over knots 0,0,0,1,2,2,2: 2 (d1 - d0) / 1, 2 (d2 - d1) / 2, 2 (d3 - d2) / 1."""
        self.write("d.csv", "x,y\n0,8\n3,4\n4,-4\n0,0\n")
        self.assertEqual(self.made("--points", "d.csv", "--knots", CLAMPED, "--derivative", "1"), ([(6, -8), (1, -8), (-8, 8)], [0, 0, 1, 2, 2]))

    def test_other_curves_that_are_refused(self):
        self.write("d.csv", "x,y\n0,8\n3,4\n4,-4\n0,0\n")
        self.write("w.csv", "x,y,w\n0,8,1\n3,4,2\n4,-4,0.5\n0,0,1\n")
        curve = ["curve", "bspline", "--knots", CLAMPED, "--points"]
        for arguments, *needles in (
                (["--insert", "1"], "--knots-out is required"), (["--insert", "1", "--insert", "1"], "stand 3 times", "leave 1 of them out"),
                (["--insert", "0"], "stand 4 times"), (["--insert", "3"], "defined from 0 to 2"), (["--remove", "0"], "stands 0 times"),
                (["--remove", "1", "--remove", "1"], "stands 1 times"), (["--derivative", "2"], "degree 2", "lower"),
                (["--elevate-to", "1"], "degree 2", "higher"), (["--elevate-to", "65"], "from 1 to 64"), (["--from", "2"], "--from 2", "ends at 2"), (["--to", "0"], "--to 0", "begins there"), (["--insert", "1", "--to", "1"], "write one of them"),
                (["--to", "1", "--t", "1"], "write one of them"), (["--t", "1", "--tolerance", "1"], "goes with --remove"),
                (["--insert", "1", "--tolerance", "1"], "--tolerance goes with --remove"), (["--to", "1", "--tolerance", "1"], "--tolerance goes with --remove"),
                (["--remove", "1", "--tolerance", "-1"], "--tolerance -1", "0 or more")):
            with self.subTest(arguments=arguments):
                knots_out = [] if needles[0].startswith("--knots-out") else ["--knots-out", "k.txt"]
                self.refused(USAGE, [*curve, "d.csv", *arguments, *knots_out], *needles)
        self.write("l.csv", "x\n1\n2\n3\n4\n")
        self.refused(USAGE, ["curve", "bspline", "--points", "l.csv", "--knots", "0,0,1,1,2,2", "--insert", "1", "--knots-out", "k.txt"],
                     "would stand 3 times", "leave 1 of them out")
        self.write("far.csv", "x,y\n1e308,1e308\n-1.7e308,-1.7e308\n1e308,1e308\n")
        self.refused(INPUT_OUTPUT, ["curve", "bspline", "--points", "far.csv", "--knots", "0,0,1,2,2", "--remove", "1", "--knots-out", "k.txt"],
                     "exceeds the largest double", "scale the coordinates down")
        for name in ("/absent/k.txt", ""):
            self.refused(INPUT_OUTPUT, [*curve, "d.csv", "--insert", "0.5", "--knots-out", name], (name or '""') + ": cannot be written", "another --knots-out")
        self.refused(USAGE, ["curve", "bspline", "--points", "d.csv", "--knots", "missing.txt", "--t", "1"],
                     "--knots missing.txt", "neither a file nor numbers separated by commas")
        self.write("high.csv", "x\n" + "1\n" * 66)
        self.refused(USAGE, ["curve", "bspline", "--points", "high.csv", "--knots", ",".join("0" * 66 + "1" * 66), "--elevate-to", "64",
                             "--knots-out", "k.txt"], "degree 65", "64 and less")
        self.refused(USAGE, [*curve, "w.csv", "--derivative", "1", "--knots-out", "k.txt"], "rational")
        self.refused(USAGE, [*curve, "w.csv", "--weights", "1,1,1,1", "--t", "1"], "column w")
        self.write("w.csv", "x,y,w\n0,8,1\n3,4,0\n4,-4,0.5\n0,0,1\n")
        self.refused(USAGE, [*curve, "w.csv", "--t", "1"], "w.csv, column w: 0 is not above 0")

    def test_a_knot_that_stays(self):
        """A corner (0,0), (3,4), (0,0) is 5 from the chord that is left; exit 1 says so, and the tolerance allows it."""
        self.write("d.csv", "x,y\n0,0\n3,4\n0,0\n")
        corner = ["curve", "bspline", "--points", "d.csv", "--knots", "0,0,1,2,2", "--remove", "1", "--knots-out", "k.txt"]
        self.refused(FINDING, corner, "move by 5", "--tolerance 5")
        self.refused(FINDING, [*corner, "--tolerance", "4.9"], "move by 5")
        result = self.run_program(*corner, "--tolerance", "5")
        self.assertEqual((result.returncode, result.stdout.decode()), (0, "x,y\n0,0\n0,0\n"))
        self.assertIn("no point of the curve moves farther than 5", result.stderr.decode())

    def test_no_span_is_missed(self):
        """The closed quadratic about a square of side 2 goes through the middles of its sides at its knots, where it is level or
        upright. Its first span is the parabola (1, 0), (2, 0), (2, 1), whose length is (sqrt(2) + asinh(1)) / sqrt(2)."""
        self.write("s.csv", "x,y\n0,0\n2,0\n2,2\n0,2\n")
        self.write("spans.csv", self.fine("curve", "bspline", "--points", "s.csv", "--closed", "2", "--knots", "0,1,2,3,4", "--control-points"))
        path = ["--curve", "spans.csv", "--whole-path"]
        length, = rows(self.fine("curve", "length", *path, "--method", "gauss_legendre_24"))
        self.assertAlmostEqual(float(length["exact"]), 4 * (1 + math.asinh(1) / math.sqrt(2)), delta=1e-14)
        for x, y in ((2, 1), (1, 2), (0, 1), (1, 0)):
            foot, = rows(self.fine("curve", "project", *path, "--method", "subdivide_hull", f"--point={2 * x - 1},{2 * y - 1}"))
            self.assertEqual([float(foot[column]) for column in ("x", "y", "distance", "exact_distance")], [x, y, 1, 1])
        extrema = rows(self.fine("curve", "roots", "--curve", "spans.csv", "--of", "extrema"))
        self.assertEqual([(row["curve"], row["axis"]) for row in extrema], [(str(k), axis) for k in range(4) for axis in "xy"])
        self.assertEqual({(row["x"], row["y"]) for row in extrema}, {("2", "1"), ("1", "2"), ("0", "1"), ("1", "0")})
        boxes = rows(self.fine("curve", "box", "--curve", "spans.csv", "--method", "exact_box"))
        self.assertEqual({(row["curve"], row["axis"], row["low"]) for row in boxes if row["low"] == "0"}, {("0", "y", "0"), ("2", "x", "0"), ("3", "x", "0"), ("3", "y", "0")})
        chords = rows(self.fine("curve", "flatten", "--curve", "spans.csv", "--tolerance", "1e-3", "--method", "equal_errors", "--control-points"))
        ends = [(row["x"], row["y"]) for row in chords]
        self.assertEqual((ends[0], ends[1:-1:2]), (ends[-1], ends[2::2]))


if __name__ == "__main__":
    unittest.main()
