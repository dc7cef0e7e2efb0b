#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`curves`, and `curve` on files of any kind and on paths. Usage: curve_files_test.py BEZIERBENCH"""
import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import INPUT_OUTPUT, USAGE, Case, rows  # noqa: E402

# A square of 10 with a quarter of a circle of radius 5 beside it, in an element that is moved by (100, 0).
LOGO = """<svg xmlns="http://www.w3.org/2000/svg"><defs><path id="unused" d="M0,0 L1,1"/></defs>
<g transform="translate(100)"><path id="square" d="M0,0 h10 v10 h-10 z"/><path d="M20,0 C20,3 22,5 25,5"/></g>
<circle id="dot" r="2"/><text>A</text></svg>
"""


class CurveFiles(Case):
    def setUp(self):
        super().setUp()
        self.write("logo.svg", LOGO)

    def test_what_a_file_holds(self):
        text = self.fine("curves", "logo.svg")
        self.assertIn("9 curves in 3 paths", text)
        self.assertIn("left out: elements text (1)", text)
        result = self.run_program("curves", "logo.svg", "--format", "csv")
        self.assertIn("left out: elements defs (1)", result.stderr.decode())
        found = rows(result.stdout.decode())
        self.assertEqual([(row["form"], row["degree"], row["curves"]) for row in found],
                         [("bernstein", "1", "4"), ("rational", "2", "4"), ("bernstein", "3", "1")])
        lines, quarters, cubic = found
        self.assertEqual((lines["low"], lines["high"], lines["size_median"], lines["distance_largest"]), ("0", "110", "10", "11"))
        self.assertEqual((quarters["distance_median"], quarters["monotone"]), ("1", "4"))
        self.assertEqual((cubic["size_largest"], cubic["distance_median"], cubic["points"]), ("5", "25", "0"))

    def test_a_set_is_written_and_read_back(self):
        self.write("one.csv", "x,y\n0,0\n0.1,-0\n")
        self.write("more.json", "[[[0,0],[1,2],[3,4]],[[1,1,1],[2,2,2]]]")
        self.fine("curves", "logo.svg", "one.csv", "more.json", "--out", "set.csv")
        again = self.fine("curves", "set.csv", "--out", "again.csv")
        self.assertIn("12 curves", again)
        text = (self.folder / "set.csv").read_text()
        self.assertEqual((self.folder / "again.csv").read_text(), text)
        self.assertIn("one,1,0x1.999999999999ap-4,-0x0p+0,,\n", text)
        self.assertIn("logo:square:0:0,0,", text)

    def test_files_of_any_kind(self):
        length = ["curve", "length", "--method", "gauss_legendre_adaptive"]
        self.write("square.txt", "M0,0 h10 v10 h-10 z")
        for arguments in (["--curve", "logo.svg#square"], ["--curve", "square.txt"], ["--path", "M0,0 h10 v10 h-10 z"]):
            found = rows(self.fine(*length, *arguments))
            self.assertEqual([row["exact"] for row in found], ["10"] * 4, arguments)
        self.assertEqual([row["curve"] for row in rows(self.fine(*length, "--curve", "logo.svg#square"))],
                         [f"square:0:{k}" for k in range(4)])
        alone = self.fine(*length, "--curve", "logo.svg#square:0:1")
        self.assertEqual(alone, self.fine(*length, "--curve", "logo.svg#1"))
        self.assertNotIn("curve", alone)
        with open(self.folder / "logo.svg", "rb") as stdin:
            self.assertEqual(self.fine(*length, "--curve", "-#1", stdin=stdin), alone)
        with open(self.folder / self.write("c", "[[0,0],[1,2]]"), "rb") as stdin:
            evaluated = self.fine("curve", "eval", "--curve", "-", "--t", "0.5", "--method", "de_casteljau", stdin=stdin)
        self.assertIn("de_casteljau,0.5,y,1,1,0,", evaluated)
        # The circle is rational, which this method does not take: the others are answered, and a line says so.
        self.assertEqual(len(rows(self.fine(*length, "--curve", "logo.svg"))), 9)
        grid = ["curve", "grid", "--points", "3", "--method", "forward_differencing", "--curve"]
        result = self.run_program(*grid, "logo.svg")
        self.assertEqual(result.returncode, 0)
        self.assertIn("logo.svg: 4 of 9 left out", result.stderr.decode())
        self.refused(USAGE, [*grid, "logo.svg#dot"], "column w", "rational")
        for row in rows(self.fine("curve", "eval", "--curve", "logo.svg#dot", "--t", "0.5")):
            self.assertAlmostEqual(abs(float(row["exact"])), math.sqrt(2), 15)
        for arguments, *needles in [(["--curve", "logo.svg#none"], "logo.svg#none", "it has 9"), (["--curve", "a", "--path", "M0,0"], "--path"),
                                    ([], "--curve is required")]:
            self.refused(USAGE, [*length, *arguments], *needles)
        for arguments, *needles in [(["--path", "M0,0 L1"], "--path:1:8: "), (["--path", "M0,0"], "--path: no curves"),
                                    (["--curve", "absent.svg"], "absent.svg: ")]:
            self.refused(INPUT_OUTPUT, [*length, *arguments], *needles)
        self.write("bad.svg", "<svg>\n<path d='M0,0 L1,x'/></svg>")
        self.refused(INPUT_OUTPUT, ["curves", "bad.svg"], "bad.svg:2:18: ")

    def test_several_questions(self):
        project = ["curve", "project", "--path", "M0,0 L10,0", "--method", "subdivide_hull"]
        self.write("p.csv", "y,x\n3,4\n-2,20\n")
        found = rows(self.fine(*project, "--point", "1,1", "--point=-5,0", "--points", "p.csv"))
        self.assertEqual([(row["question"], float(row["x"]), float(row["y"]), float(row["distance"])) for row in found],
                         [("0", 1, 0, 1), ("1", 0, 0, 5), ("2", 4, 0, 3), ("3", 10, 0, math.hypot(10, 2))])
        self.assertNotIn("question", rows(self.fine(*project, "--point", "1,1"))[0])
        self.refused(USAGE, project, "--point is required")
        self.write("p.csv", "x\n3\n")
        self.refused(USAGE, [*project, "--points", "p.csv"], "--points p.csv: 1 coordinates", "has 2")
        at_length = ["curve", "at-length", "--path", "M0,0 L10,0", "--method", "bracketed_newton"]
        found = rows(self.fine(*at_length, "--length", "2.5", "--length", "5"))
        self.assertEqual([(row["question"], row["exact_t"], float(row["x"])) for row in found], [("0", "0.25", 2.5), ("1", "0.5", 5)])
        found = rows(self.fine("curve", "split", "--path", "M0,0 L8,0", "--t", "0.25", "--t", "0.5", "--method", "blossom_split"))
        self.assertEqual([(row["question"], row["index"], row["value"]) for row in found if row["half"] == "left" and row["axis"] == "x"],
                         [("0", "0", "0"), ("0", "1", "2"), ("1", "0", "0"), ("1", "1", "4")])

    def test_a_path_is_one_thing(self):
        """The square, whose lengths are known."""
        square = ["--curve", "logo.svg#square", "--whole-path"]
        row, = rows(self.fine("curve", "length", *square, "--method", "gauss_legendre_24"))
        self.assertEqual((row["exact"], float(row["length"]), row["error"]), ("40", 40, "0"))
        self.assertNotIn("curve", row)
        found = rows(self.fine("curve", "at-length", *square, "--fraction", "0.375", "--fraction", "1", "--fraction", "0.25",
                               "--method", "halley"))
        self.assertEqual([(row["segment"], row["exact_t"], float(row["x"]), float(row["y"])) for row in found],
                         [("1", "0.5", 110, 5), ("3", "1", 100, 0), ("0", "1", 110, 0)])
        row, = rows(self.fine("curve", "project", *square, "--point", "112,7", "--method", "quintic_isolate"))
        self.assertEqual((row["segment"], row["exact_segment"], row["exact_distance"], float(row["x"]), float(row["y"])),
                         ("1", "1", "2", 110, 7))
        found = rows(self.fine("curve", "spaced", *square, "--count", "9"))
        self.assertEqual(list(found[0]), ["curve", "index", "segment", "t", "length", "x", "y"])
        self.assertEqual([(row["length"], float(row["x"]), float(row["y"])) for row in found][2:6],
                         [("10", 110, 0), ("15", 110, 5), ("20", 110, 10), ("25", 105, 10)])
        self.refused(USAGE, ["curve", "length", *square, "--to", "0.5"], "--whole-path")

    def test_control_points_as_a_set(self):
        halves = self.fine("curve", "split", "--path", "M0,0 L8,4", "--t", "0.25", "--control-points")
        self.assertEqual(halves, "curve,index,x,y\nleft,0,0,0\nleft,1,2,1\nright,0,2,1\nright,1,8,4\n")
        self.write("h.csv", halves)
        self.assertIn("2 curves", self.fine("curves", "h.csv"))
        square = ["curve", "split", "--curve", "logo.svg#square", "--whole-path", "--t", "0.5"]
        self.write("h.csv", self.fine(*square, "--segment", "1", "--control-points"))
        self.assertIn("5 curves in 2 paths", self.fine("curves", "h.csv"))
        row, = rows(self.fine("curve", "length", "--curve", "h.csv#left", "--whole-path", "--method", "gauss_legendre_24"))
        self.assertEqual(row["exact"], "15")
        judged = rows(self.fine(*square, "--segment", "1", "--method", "lerp_split"))
        self.assertEqual({row["segment"] for row in judged}, {"1"})
        for arguments, needle in (([], "--segment"), (["--segment", "4"], "0 to 3")):
            self.refused(USAGE, [*square, *arguments], needle)
        self.write("d.csv", "x,y\n0,8\n3,4\n4,-4\n0,0\n")  # the mean of 3,4 and 4,-4 is where the spans meet
        spans = self.fine("curve", "bspline", "--points", "d.csv", "--knots", "0,0,0,1,2,2,2", "--control-points")
        self.assertEqual(spans, "curve,index,x,y\n0,0,0,8\n0,1,3,4\n0,2,3.5,0\n1,0,3.5,0\n1,1,4,-4\n1,2,0,0\n")

    def test_equal_spacing_of_one_curve(self):
        found = rows(self.fine("curve", "spaced", "--path", "M0,0 L3,4", "--count", "3"))
        self.assertEqual([list(row.values()) for row in found], [["0:0:0", "0", "0", "0", "0", "0"], ["0:0:0", "1", "0.5", "2.5", "1.5", "2"],
                                                                 ["0:0:0", "2", "1", "5", "3", "4"]])
        spaced = rows(self.fine("curve", "spaced", "--curve", "logo.svg#dot", "--count", "3", "--whole-path"))
        self.assertEqual([(row["x"], row["y"]) for row in spaced], [("2", "0"), ("-2", "0"), ("2", "0")])
        self.refused(USAGE, ["curve", "spaced", "--path", "M0,0 L3,4", "--count", "1"], "--count")


if __name__ == "__main__":
    unittest.main()
