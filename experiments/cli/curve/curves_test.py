#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`curve` from outside: files, parameters, methods, and what comes out. Usage: curves_test.py BEZIERBENCH"""
import fractions
import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import EVAL_COLUMNS, INPUT_OUTPUT, PROJECT_COLUMNS, USAGE, Case, rows  # noqa: E402


class Curves(Case):
    def setUp(self):
        super().setUp()
        self.curve = self.write("c.csv", "x,y\n0,0\n1,2\n3,1\n")

    def test_flatten(self):
        """The parabola (0,0), (1,2), (2,0) is 1 from one chord; two chords are 1/4 / sqrt(2) away."""
        self.write("p.csv", "x,y\n0,0\n1,2\n2,0\n")
        found = {row["method"]: row for row in rows(self.fine("curve", "flatten", "--curve", "p.csv", "--tolerance", "0.25"))}
        self.assertEqual({(row["least_low"], row["least_high"]) for row in found.values()}, {("2", "2")})
        for method in ("equal_errors", "wang_count"):
            self.assertEqual((found[method]["chords"], found[method]["kept"], found[method]["complete"]), ("2", "yes", "yes"), method)
            self.assertAlmostEqual(float(found[method]["distance_high"]), 0.25 / math.sqrt(2), delta=1e-3)
        self.write("turn.csv", "x,y\n0,10\n-10,10\n180,10\n60,10\n")  # linebender/kurbo#426
        self.assertEqual([row["kept"] for row in rows(self.fine("curve", "flatten", "--curve", "turn.csv", "--tolerance", "0.25",
                                                                "--method", "levien", "--method", "equal_errors"))], ["no", "yes"])
        chords = self.fine("curve", "flatten", "--curve", "p.csv", "--tolerance", "0.25", "--method", "wang_count", "--control-points")
        self.assertEqual(chords, "curve,index,x,y\n0,0,0,0\n0,1,1,1\n1,0,1,1\n1,1,2,0\n")
        for tolerance in ("0", "-1", "nan", "x"):
            self.refused(USAGE, ["curve", "flatten", "--curve", "p.csv", "--tolerance", tolerance], "--tolerance")

    def test_ease(self):
        """x1 = x2 = 0 gives x = t^3, so that y(1/8) is (3 y1 + 3 y2 + 1) / 8; beyond 1 the tangent is level."""
        found = rows(self.fine("curve", "ease", "--bezier", "0,1,0,1", "--x", "0.125", "--x", "2"))
        self.assertEqual(list(found[0]), ["method", "x", "t", "y", "exact", "error", "error_ulp"])
        self.assertEqual({row["exact"] for row in found}, {"0.875", "1"})
        rounded = [row for row in found if row["method"] == "easing_correctly_rounded"]
        self.assertEqual([(row["t"], row["y"], row["error"]) for row in rounded], [("0.5", "0.875", "0"), ("1", "1", "0")])
        self.write("e.csv", "curve,index,x,y\na,0,0,0\na,1,0,1\na,2,0,1\na,3,1,1\nb,0,0,0\nb,1,1,0\nb,2,0,1\nb,3,1,1\n")
        found = rows(self.fine("curve", "ease", "--curve", "e.csv", "--x", "0.5", "--method", "easing_halley"))
        self.assertEqual([(row["curve"], row["method"]) for row in found], [("a", "easing_halley"), ("b", "easing_halley")])
        self.assertEqual(found[1]["exact"], "0.5")
        for arguments, *needles in [
                (["--x", "0.5"], "--bezier is required"), (["--bezier", "2,0,1,1", "--x", "0.5"], "--bezier 2,0,1,1", "[0, 1]"),
                (["--bezier", "0,0,1", "--x", "0.5"], "3 numbers"), (["--bezier", "0,0,1,1", "--x", "nan"], "--x nan"),
                (["--bezier", "0,0,1,1", "--x", "0", "--method", "halley_"], "halley_"),
                (["--curve", "c.csv", "--x", "0.5"], "c.csv", "from (0, 0) to (1, 1)")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, ["curve", "ease", *arguments], *needles)

    def test_several_curves_in_a_file(self):
        """What `interpolate` and `fit` print is read; each curve has its rows, and FILE#ID names one."""
        self.write("p.csv", "x,y\n0,0\n3,4\n6,8\n")
        self.write("s.csv", self.fine("curve", "interpolate", "--points", "p.csv"))
        found = rows(self.fine("curve", "length", "--curve", "s.csv", "--method", "gauss_legendre_24"))
        self.assertEqual([(row["curve"], row["exact"]) for row in found], [("0", "5"), ("1", "5")])
        commands = [["eval", "--t", "0.5"], ["derivative", "--t", "0.5", "--order", "1"], ["grid", "--points", "3"], ["length"],
                    ["at-length", "--fraction", "0.5"], ["project", "--point", "1,1"], ["split", "--t", "0.5"], ["flatten", "--tolerance", "0.1"]]
        self.write("s.csv", "curve,index,form,x,w\na,0,bernstein,1,\na,1,bernstein,2,\n7,0,power,0,\n7,1,power,0x1p1,\n7,2,power,4,\n"
                            '"b,",0,bernstein,1,\n"b,",1,bernstein,0,\nr,0,rational,1,1\nr,1,rational,3,3\n')
        for name, at_half in (("a", 1.5), ("7", 2), ("1", 2), ("2", 0.5), ("b,", 0.5), ("r", 2.5), ("3", 2.5)):
            found = rows(self.fine("curve", "eval", "--curve", f"s.csv#{name}", "--t", "0.5"))
            self.assertEqual({float(row["exact"]) for row in found}, {at_half}, name)
            self.assertNotIn("curve", found[0])
        found = rows(self.fine("curve", "eval", "--curve", "s.csv", "--t", "0.5"))
        self.assertEqual(list(found[0]), ["curve"] + EVAL_COLUMNS)
        self.assertEqual(list(dict.fromkeys((row["curve"], row["exact"]) for row in found)),
                         [("a", "1.5"), ("7", "2"), ("b,", "0.5"), ("r", "2.5")])
        self.write("whole#0", "x\n5\n")
        self.assertIn(",5,5,", self.fine("curve", "eval", "--curve", "whole#0", "--t", "0.5", "--method", "de_casteljau"))
        self.assertIn(",5,5,", self.fine("curve", "eval", "--curve", "whole#0#0", "--t", "0.5", "--method", "de_casteljau"))
        several = "segment,index,x,y\n0,0,0,0\n0,1,1,2\n0,2,2,0\n1,0,2,0\n1,1,3,5\n1,2,4,4\n"
        for command, *arguments in commands:  # several curves are each one by itself, one after the other
            self.write("s.csv", several)
            self.write("one.csv", "x,y\n0,0\n1,2\n2,0\n")
            both = rows(self.fine("curve", command, "--curve", "s.csv", *arguments))
            alone = rows(self.fine("curve", command, "--curve", "s.csv#1", *arguments))
            first = rows(self.fine("curve", command, "--curve", "one.csv", *arguments))
            self.assertEqual(both, [{"curve": "0", **row} for row in first] + [{"curve": "1", **row} for row in alone], command)
        converted = self.fine("curve", "convert", "--curve", "s.csv", "--method", "exact")
        self.assertEqual(converted, "curve,index,x,y\n0,0,0,0\n0,1,2,4\n0,2,0,-4\n1,0,2,0\n1,1,2,10\n1,2,0,-6\n")
        self.refused(USAGE, ["curve", "length", "--curve", "s.csv#2"], "s.csv#2", "has 2")
        self.refused(USAGE, ["curve", "length", "--curve", "s.csv", "--form", "power"], "s.csv#0: ")  # the one it is about

    def test_data_as_people_have_them(self):
        """What else is not a file of curves is in the tests of the reader."""
        for content, *needles in [
                ("0,0\n1,2\n3,-1\n4,0.5\n", ":1: header is missing", "x,y"), ("(0, 0)\n(1, 2)\n", ":1: header is missing", "brackets"),
                ("0 0\n1 2\n", ":1: header is missing", "commas"), ("0;0\n", ":1: header is missing"), ("[[0,1],[2,3]]", ":1: header"),
                ("x,y\n(1,2)\n(3,4)\n", ":2: ", '"(1"', "without brackets"), ("x\n1e-400\n1\n", ":2: ", "too small for a double"),
                ("x\n-1e400\n1\n", ":2: ", "too large for a double"), ("x\n0x1p-1100\n1\n", ":2: ", "too small")]:
            with self.subTest(content=content):
                self.write("d.csv", content)
                self.refused(INPUT_OUTPUT, ["curve", "length", "--curve", "d.csv"], "d.csv" + needles[0], *needles[1:])
                self.refused(INPUT_OUTPUT, ["curve", "fit", "--points", "d.csv", "--tolerance", "1"], "d.csv" + needles[0], *needles[1:])
        for command in (["eval", "--t", "1e-400"], ["length", "--tolerance", "1e-400"]):
            self.refused(USAGE, ["curve", *command, "--curve", "c.csv"], " ".join(command[1:]), "too small for a double")

    def test_files_that_cannot_be_read(self):
        for name in ("absent.csv", ".", "c.csv/c.csv"):
            with self.subTest(name=name):
                self.refused(INPUT_OUTPUT, ["curve", "eval", "--curve", name, "--t", "0"], f"bezierbench: {name}: ")

    def test_parameters(self):
        for t in ("nan", "inf", "-inf", "1e999", "half", "", "0.5x", "0,5"):
            with self.subTest(t=t):
                self.refused(USAGE, ["curve", "eval", "--curve", "c.csv", f"--t={t}"], "--t")

    def test_methods_that_do_not_apply(self):
        evaluate = ["curve", "eval", "--curve", "c.csv", "--t", "0.5"]
        convert = ["curve", "convert", "--curve", "c.csv"]
        for arguments, *needles in [
                (evaluate + ["--method", "hroner"], 'did you mean "horner"?'), (evaluate + ["--method", "zzz"], "zzz"),
                (evaluate + ["--method", "horner"], "horner", "bernstein form"),
                (evaluate + ["--form", "power", "--method", "direct"], "direct", "power form"),
                (evaluate + ["--method", "direct", "--method", "horner"], "horner"),
                (evaluate + ["--method", "factorial"], "factorial"), (convert + ["--method", "exat"], '"exact"'),
                (convert + ["--method", "direct"], "direct"), (convert + ["--method", "triangle"], "bernstein form"),
                (convert + ["--form", "power", "--method", "differences"], "power form")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, arguments, *needles)

    def test_conversions_to_what_no_file_holds(self):
        self.write("c.csv", "x\n1\n2\n3\n")
        for method, path, what in (("exact_dd", "exact_dd:horner_dd", "pairs of doubles"),
                                   ("exact_centered", "exact_centered:horner_centered", "powers of t - 1/2")):
            with self.subTest(method=method):
                self.refused(USAGE, ["curve", "convert", "--curve", "c.csv", "--method", method], method, what, path)
                self.fine("curve", "eval", "--curve", "c.csv", "--t", "0.25", "--method", path)  # as the message says

    def test_degree_beyond_a_method(self):
        self.write("c.csv", "x\n" + "1\n" * 172)
        evaluate = ["curve", "eval", "--curve", "c.csv", "--t", "0.5"]
        self.refused(USAGE, evaluate + ["--method", "direct"], "direct", "170", "171")
        self.refused(USAGE, ["curve", "convert", "--curve", "c.csv", "--method", "factorial"], "170", "171")
        found = [row["method"] for row in rows(self.fine(*evaluate))]  # without --method: all that apply
        self.assertIn("de_casteljau", found)
        self.assertNotIn("direct", found)
        self.write("c.csv", "x\n" + "1\n" * 171)
        self.assertEqual(rows(self.fine(*evaluate, "--method", "direct"))[0]["exact"], "1")

    def test_parameters_beyond_a_method(self):
        evaluate = ["curve", "eval", "--curve", "c.csv", "--t", "0.5"]
        for t in ("2", "-5e-324"):
            self.refused(USAGE, evaluate + ["--t", t, "--method", "correctly_rounded"], "correctly_rounded", "[0,1]", t)
            found = [row["method"] for row in rows(self.fine(*evaluate, "--t", t))]  # without --method: all that apply
            self.assertIn("de_casteljau", found)
            self.assertNotIn("correctly_rounded", found)
        for form in ("bernstein", "power"):
            found = rows(self.fine(*evaluate, "--t", "0", "--t", "1", "--form", form, "--method", "correctly_rounded"))
            self.assertEqual([row["value"] for row in found], [row["exact"] for row in found])

    def test_output(self):
        text = self.fine("curve", "eval", "--curve", "c.csv", "--t", "-0.5", "0x1p-1", "--t", "1e-3", "--method",
                         "direct", "--method", "de_casteljau")
        found = rows(text)
        self.assertEqual(list(found[0]), EVAL_COLUMNS)
        self.assertEqual([(row["method"], float(row["t"]), row["axis"]) for row in found],
                         [(method, t, axis) for method in ("direct", "de_casteljau") for t in (-0.5, 0.5, 1e-3)
                          for axis in "xy"])
        for row in found:
            for column in EVAL_COLUMNS[3:8]:
                self.assertEqual(repr(float(row[column])), repr(float(row[column]) + 0.0))
        self.assertEqual([float(row["value"]) for row in found[2:4]], [1.25, 1.25])

    def test_control_points_of_hodographs(self):
        """Example 6.2 of document 000, as printed there: (6,0) (3,3) (6,3), then (-6,6) (6,0)."""
        self.write("e.csv", "x,y\n1,1\n3,1\n4,2\n6,3\n")
        hodograph = ["curve", "derivative", "--curve", "e.csv", "--order"]
        for order, points in ((1, [("6", "0"), ("3", "3"), ("6", "3")]), (2, [("-6", "6"), ("6", "0")]), (4, [("0", "0")])):
            found = self.fine(*hodograph, str(order), "--control-points")
            self.assertEqual([(row["x"], row["y"]) for row in rows(found)], points)
        self.write("h.csv", self.fine(*hodograph, "1", "--control-points"))
        tangent = rows(self.fine("curve", "eval", "--curve", "h.csv", "--t", "0.5", "--method", "de_casteljau"))
        self.assertEqual([row["value"] for row in tangent], ["4.5", "2.25"])
        self.refused(USAGE, hodograph + ["1"], "--t is required")
        self.refused(USAGE, hodograph + ["1", "--control-points", "--t", "0"], "takes no --t")

    def test_derivative(self):
        self.write("w.csv", "x,y\n1,1\n3,1\n4,2\n6,3\n")
        found = rows(self.fine("curve", "derivative", "--curve", "w.csv", "--order", "2", "--t", "0"))
        self.assertEqual(list(found[0]), EVAL_COLUMNS[:2] + ["order"] + EVAL_COLUMNS[2:])
        self.assertEqual({row["order"] for row in found}, {"2"})
        self.write("r.csv", "x,w\n0,1\n1,2\n")  # 2t / (1 + t)
        for row in rows(self.fine("curve", "derivative", "--curve", "r.csv", "--order", "2", "--t", "0.25")):
            self.assertAlmostEqual(float(row["value"]), -4 / 1.25**3, delta=1e-14)
        self.refused(USAGE, ["curve", "derivative", "--curve", "r.csv", "--order", "1", "--control-points"], "rational", "--t")
        self.write("p.csv", "x,w\n0,1\n1,-1\n")
        derivative = ["curve", "derivative", "--t", "0.5", "--curve"]
        for arguments, *needles in [
                (["w.csv", "--order", "-1"], "--order"), (["w.csv", "--order", "1.5"], "--order"), (["w.csv"], "--order"),
                (["r.csv", "--order", "1", "--method", "differences_de_casteljau"], "column w"),
                (["p.csv", "--order", "1"], "--t 0.5", "sum to zero"),
                (["w.csv", "--order", "1", "--method", "seed_00"], 'did you mean "seed_000"?'),
                (["w.csv", "--order", "1", "--method", "power_derivative"], "bernstein form")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, derivative + arguments, *needles)

    def test_grid(self):
        self.write("w.csv", "x,y\n1,1\n3,1\n4,2\n6,3\n")
        found = rows(self.fine("curve", "grid", "--curve", "w.csv", "--points", "3"))
        self.assertEqual(list(found[0]), ["method", "index"] + EVAL_COLUMNS[1:])
        for row in found:  # nothing rounds
            truth = {("0", "x"): 1, ("0", "y"): 1, ("1", "x"): 3.5, ("1", "y"): 1.625, ("2", "x"): 6, ("2", "y"): 3}
            self.assertEqual((float(row["value"]), float(row["exact"])), (truth[row["index"], row["axis"]],) * 2)
            self.assertEqual(float(row["t"]), int(row["index"]) / 2)
        self.assertEqual(len({row["method"] for row in found}) * 6, len(found))
        self.write("m.csv", "x,y\n-1,-1\n-3,-1\n-4,-2\n-6,-3\n")  # p~ has no sign, and neither has a bound in its units
        self.assertEqual([row["bound_u"] for row in rows(self.fine("curve", "grid", "--curve", "m.csv", "--points", "3"))],
                         [row["bound_u"] for row in found])
        self.write("r.csv", "x,w\n0,1\n1,2\n")
        self.assertEqual({row["value"] for row in rows(self.fine("curve", "grid", "--curve", "r.csv", "--points", "3"))},
                         {"0", "0.6666666666666666", "1"})
        self.write("r.csv", "x,w\n0,1\n1,-2\n")
        for arguments, *needles in [(["w.csv", "--points", "4"], "--points 4", "power of two and one"), (["w.csv"], "--points"),
                                    (["r.csv", "--points", "3"], "r.csv", "pole")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, ["curve", "grid", "--curve", *arguments], *needles)

    def test_box_of_a_curve(self):
        """A CSS timing function with overshoot: extrema by the quadratic formula lose points of it."""
        self.write("ease.csv", "x,y\n0,0\n0.5,-0.9\n0.1,1.5\n1,1\n")
        for row in rows(self.fine("curve", "box", "--curve", "ease.csv")):
            with self.subTest(row=row):
                self.assertEqual(row["contains"], "yes" if float(row["low_ulp"]) >= 0 <= float(row["high_ulp"]) else "no")
                self.assertEqual(row["contains"] == "yes", float(row["low"]) <= float(row["tightest_low"])
                                 and float(row["high"]) >= float(row["tightest_high"]))
                if row["method"] == "exact_box":
                    self.assertIn(row["low_ulp"] + row["high_ulp"], {"00", "01", "10", "11"})
        lost = {row["method"]: row["contains"] for row in rows(self.fine("curve", "box", "--curve", "ease.csv")) if row["axis"] == "y"}
        self.assertEqual((lost["quadratic_formula_box"], lost["exact_box"], lost["split_box"]), ("no", "yes", "yes"))
        circle = self.write("circle.csv", "x,y,w\n1,0,1\n1,1,1\n0,1,2\n")
        for row in rows(self.fine("curve", "box", "--curve", circle, "--method", "exact_box")):
            self.assertEqual((row["low"], row["high"], row["contains"]), ("0", "1", "yes"))
        self.write("signs.csv", "x,w\n1,1\n2,-3\n")
        for row in rows(self.fine("curve", "box", "--curve", "signs.csv")):
            self.assertEqual((row["low"], row["high"], row["contains"]), ("-inf", "inf", ""))
        self.refused(USAGE, ["curve", "box", "--curve", "ease.csv", "--method", "exact_bix"], 'did you mean "exact_box"?')

    def test_roots_of_a_curve(self):
        """An S has an inflection, a cusp counts twice, a line is straight everywhere; y of the quarter circle is stationary at its end."""
        self.write("shapes.csv", "curve,index,x,y\ns,0,0,0\ns,1,1,1\ns,2,2,-1\ns,3,3,0\ncusp,0,0,0\ncusp,1,1,1\ncusp,2,0,1\ncusp,3,1,0\n"
                   "line,0,0,0\nline,1,2,1\n")
        found = rows(self.fine("curve", "roots", "--curve", "shapes.csv", "--of", "inflections"))
        self.assertEqual([(row["curve"], row["t"], row["multiplicity"], row["x"], row["y"]) for row in found],
                         [("s", "0.5", "1", "1.5", "0"), ("cusp", "0.5", "2", "0.5", "0.75"), ("line", "", "inf", "", "")])
        circle = self.write("circle.csv", "x,y,w\n1,0,1\n1,1,1\n0,1,2\n")
        found = rows(self.fine("curve", "roots", "--curve", circle, "--of", "extrema"))
        self.assertEqual([(row["axis"], row["t"]) for row in found], [("x", "0"), ("y", "1")])
        found = rows(self.fine("curve", "roots", "--curve", circle, "--value", "1"))
        self.assertEqual([(row["axis"], row["t"], row["multiplicity"]) for row in found], [("x", "0", "2"), ("y", "1", "2")])
        self.refused(USAGE, ["curve", "roots", "--curve", circle, "--of", "extrema", "--value", "1"], "goes with --of value")
        space = self.write("space.csv", "x,y,z\n1,0,1\n1,1,1\n0,1,2\n")
        self.refused(USAGE, ["curve", "roots", "--curve", space, "--of", "inflections"], "must be a curve in the plane")
        signs = self.write("signs.csv", "x,w\n1,1\n2,-3\n")
        self.refused(USAGE, ["curve", "roots", "--curve", signs], "pole")

    def test_roots_by_a_method(self):
        """(3t - 1)^2 has a double root, which the quadratic formula finds and samples miss; t - 1/4 has a simple one."""
        square = self.write("square.csv", "curve,index,x\na,0,1\na,1,-2\na,2,4\nb,0,-0.25\nb,1,0.75\n")
        command = ["curve", "roots", "--curve", square, "--method", "closed_form", "--method", "sampled_newton"]
        self.assertEqual([tuple(row.values()) for row in rows(self.fine(*command))],
                         [("a", "closed_form", "x", str(1 / 3), str(1 / 3), "2", "0"), ("a", "sampled_newton", "x", "", str(1 / 3), "2", ""),
                          ("b", "closed_form", "x", "0.25", "0.25", "1", "0"), ("b", "sampled_newton", "x", "0.25", "0.25", "1", "0")])
        self.refused(USAGE, [*command, "--of", "extrema"], "methods take --of value")
        self.refused(USAGE, ["curve", "roots", "--curve", square, "--method", "closed_from"], 'did you mean "closed_form"?')

    def test_part_and_elevation_of_a_curve(self):
        """t = 0.2 of the part of a circle from 0.25 to 0.75, and of that part in degree 4, is 0.35 of the circle."""
        circle = self.write("circle.csv", "x,y,w\n1,0,1\n1,1,1\n0,1,2\n")
        self.write("part.csv", self.fine("curve", "part", "--curve", circle, "--from", "0.25", "--to", "0.75"))
        self.write("elevated.csv", self.fine("curve", "elevate", "--curve", "part.csv", "--degree", "4"))
        for file, count in (("part.csv", 3), ("elevated.csv", 5)):
            self.assertEqual(len(rows((self.folder / file).read_text(encoding="utf-8"))), count)
            for row in rows(self.fine("curve", "eval", "--curve", file, "--t", "0.2", "--method", "de_casteljau")):
                self.assertAlmostEqual(float(row["exact"]), {"x": (1 - 0.35**2) / (1 + 0.35**2), "y": 0.7 / (1 + 0.35**2)}[row["axis"]], delta=1e-14)
        self.refused(USAGE, ["curve", "elevate", "--curve", circle, "--degree", "1"], "write that or a higher one")
        self.refused(USAGE, ["curve", "part", "--curve", circle, "--from", "0.5", "--to", "inf"], "is not a finite number")
        power = self.write("power.csv", "x\n1\n2\n")
        self.refused(USAGE, ["curve", "part", "--curve", power, "--form", "power", "--from", "0", "--to", "1"], "power form")

    def split_rows(self, *arguments):
        """Rows of `curve split`, in the order of methods, halves, control points and axes."""
        found = rows(self.fine("curve", "split", *arguments))
        self.assertEqual(list(found[0]), ["method", "half", "index", "axis", "value", "exact", "error", "error_u", "bound_u"])
        self.assertEqual([row["method"] for row in found], sorted((row["method"] for row in found), key=[
            row["id"] for row in self.our_methods() if row["problem"] == "subdivision"].index))
        return found

    def test_split_of_a_rational_curve(self):
        circle = self.write("circle.csv", "x,y,w\n1,0,1\n1,1,1\n0,1,2\n")
        found = self.split_rows("--curve", circle, "--t", "0.5")
        self.assertEqual([row["axis"] for row in found[:6]], ["x", "y", "w"] * 2)
        self.assertEqual(len(found), 5 * 2 * 3 * 3)
        for row in found:
            self.assertLessEqual(float(row["error_u"]), float(row["bound_u"] or 0))
        self.write("signs.csv", "x,w\n1,1\n2,-3\n")  # 1 - 4t
        self.assertEqual({row["bound_u"] for row in self.split_rows("--curve", "signs.csv", "--t", "0.5")}, {""})
        split = ["curve", "split", "--curve"]
        for arguments, *needles in [
                (["signs.csv", "--t", "0.25"], "--t 0.25", "signs.csv", "column w"), (["c.csv", "--t", "nan"], "--t"), (["c.csv"], "--t"),
                (["c.csv", "--t", "0.5", "--form", "power"], "c.csv", "power form", "curve convert"),
                (["c.csv", "--t", "0.5", "--method", "lerp_spilt"], 'did you mean "lerp_split"?'),
                (["c.csv", "--t", "0.5", "--method", "de_casteljau"], "de_casteljau")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, split + arguments, *needles)
        self.refused(INPUT_OUTPUT, split + ["absent.csv", "--t", "0.5"], "absent.csv")

    def test_length(self):
        columns = ["method", "length", "error_estimate", "evaluations", "converged", "exact", "error"]
        self.write("far.csv", "x,y,w\n0,0,1e308\n1,1,1\n2,0,1e-20\n")  # weights beyond what one double holds
        self.refused(INPUT_OUTPUT, ["curve", "at-length", "--curve", "far.csv", "--length", "5"], "not certain to 30 digits, nor to one")
        self.assertIn("subdivide_hull gave up", self.run_program("curve", "project", "--curve", "far.csv", "--point", "2,0").stderr.decode())
        self.write("cusp.csv", "x,y\n3,-3\n-1,3\n-1,-3\n3,3\n")  # 3 (u^2, u^3), u = 2t - 1
        length = ["curve", "length", "--curve", "cusp.csv"]
        found = rows(self.fine(*length, "--tolerance", "1e-6"))
        self.assertEqual(list(found[0]), columns)
        self.assertEqual([row["converged"] for row in found], ["yes", "no", "yes", "yes", "no", "no"])
        for row in found:
            if row["converged"] == "yes":
                self.assertLessEqual(float(row["error"]), float(row["error_estimate"]))
                self.assertLessEqual(float(row["error"]), 1e-6 * float(row["exact"]))
        half = rows(self.fine(*length, "--to", "0.5", "--method", "gauss_legendre_adaptive"))
        self.assertAlmostEqual(2 * float(half[0]["exact"]), float(found[0]["exact"]), 14)
        for arguments, *needles in [
                (["--from", "0.6", "--to", "0.5"], "--from 0.6"), (["--to", "1.5"], "--to 1.5"), (["--tolerance", "0"], "--tolerance"),
                (["--form", "power"], "power form", "curve convert"),
                (["--method", "chord_sums"], 'did you mean "chord_sum"?')]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, length + arguments, *needles)

    def test_length_of_rational_curves(self):
        """A quarter circle of exact weights and one of rounded ones, parts on either side of a pole, and a path with a line."""
        self.write("q.csv", "x,y,w\n1,0,1\n1,1,1\n0,1,2\n")
        for row in rows(self.fine("curve", "length", "--curve", "q.csv")):
            self.assertEqual(row["exact"], "1.57079632679489661923132169164")
            self.assertEqual(row["converged"], "yes" if row["method"].startswith("adaptive") or "adaptive" in row["method"] else "no")
            self.assertLess(float(row["error"]), 1e-2 if row["method"] == "simpson38" else 1e-9)
        self.write("r.csv", "x,y,w\n1,0,1\n1,1,0.7071067811865476\n0,1,1\n")
        exact = rows(self.fine("curve", "length", "--curve", "r.csv"))[0]["exact"]
        self.assertEqual((exact[:15], float(exact)), ("1.5707963267948", math.pi / 2))
        self.assertNotEqual(exact, "1.57079632679489661923132169164")  # the weight is rounded
        self.write("p.csv", "x,y,w\n1,0,1\n1,1,-1\n0,1,1\n")
        self.refused(USAGE, ["curve", "length", "--curve", "p.csv"], "p.csv", "pole", "t = 0.5")
        for row in rows(self.fine("curve", "at-length", "--curve", "q.csv", "--fraction", "0.5")):
            self.assertAlmostEqual(float(row["exact_t"]), math.sqrt(2) - 1, 15)  # tan(pi / 8)
        spaced = rows(self.fine("curve", "spaced", "--curve", "q.csv", "--count", "4"))
        self.assertAlmostEqual(float(spaced[1]["y"]), 0.5, 15)  # a third of the way is at 30 degrees
        for question in (["at-length", "--fraction", "0.5"], ["spaced", "--count", "3"]):
            self.refused(USAGE, ["curve", question[0], "--curve", "p.csv", *question[1:]], "p.csv", "pole", "t = 0.5")
        for part in (["--to", "0.25"], ["--from", "0.75"]):
            self.assertTrue(rows(self.fine("curve", "length", "--curve", "p.csv", *part))[0]["exact"])

    def test_project_on_rational_curves(self):
        self.write("q.csv", "x,y,w\n1,0,1\n1,1,1\n0,1,2\n")
        for row in rows(self.fine("curve", "project", "--curve", "q.csv", "--point", "3,4")):
            self.assertEqual((row["exact_t"], row["exact_distance"]), ("0.5", "4"))
            self.assertLess(float(row["error"]), 1e-14, row)
        self.write("p.csv", "x,y,w\n1,0,1\n1,1,-1\n0,1,1\n")
        self.refused(USAGE, ["curve", "project", "--curve", "p.csv", "--point", "3,4"], "p.csv", "pole", "t = 0.5")

    def test_lengths_of_any_finite_curve(self):
        """What is certain is printed; one line states what is not. The results of the methods are printed in any case."""
        line = rows(self.fine("curve", "length", "--curve", self.write("line.csv", "x\n1\n2\n")))
        self.assertEqual({(row["exact"], row["error"]) for row in line}, {("1", "0")})
        # 969 times the Bernstein coefficients of T_20, which goes 20 times from -1 to 1 or back
        t_20 = [round((-1)**i * 969 * fractions.Fraction(math.comb(40, 2 * i), math.comb(20, i))) for i in range(21)]
        self.write("t.csv", "x\n" + "\n".join(map(str, t_20)) + "\n")
        for row in rows(self.fine("curve", "length", "--curve", "t.csv")):
            self.assertEqual(row["exact"], "38760")
        for question in (["--length", "19380"], ["--fraction", "0.5"]):
            found = rows(self.fine("curve", "at-length", "--curve", "t.csv", *question, "--method", "halley", "--tolerance",
                                   "1e-6"))
            self.assertEqual((found[0]["exact_t"], found[0]["converged"]), ("0.5", "yes"))
        # (3t - 1)^9 next to where it stops, over one step of doubles: (1e-16)^9 is nothing to 70 digits
        self.write("rest.csv", "x\n" + "\n".join(str((-1)**(9 - i) * 2**i) for i in range(10)) + "\n")
        third = 1 / 3
        result = self.run_program("curve", "length", "--curve", "rest.csv", "--from", third.hex(), "--to",
                                  math.nextafter(third, 1).hex())
        self.assertEqual(result.returncode, 0)
        self.assert_one_line(result, "rest.csv", "not certain to 30 digits", "left empty")
        found = rows(result.stdout.decode())
        self.assertEqual([row["method"] for row in found],
                         [row["id"] for row in self.our_methods() if (row["problem"], row["form"]) == ("arc_length", "bernstein")])
        self.assertEqual({(row["exact"], row["error"], row["converged"]) for row in found}, {("", "", "no")})
        # T_200, whose coefficients reach 1e60, ends
        coefficients = [(-1)**i * math.comb(400, 2 * i) / math.comb(200, i) for i in range(201)]
        self.write("t.csv", "x\n" + "\n".join(map(repr, coefficients)) + "\n")
        self.assertEqual(self.run_program("curve", "length", "--curve", "t.csv", "--method", "gauss_legendre_24").returncode, 0)

    def test_at_length(self):
        columns = ["method", "t", "iterations", "converged", "exact_t", "error", "error_estimate", "length_error"]
        self.write("half.csv", "x\n0\n2\n-1\n")  # 4t - 5t^2 turns at 2/5: 4/5 up, 9/5 down; a length of 1 at 3/5
        at_length = ["curve", "at-length", "--curve", "half.csv"]
        for question in (["--length", "1"], ["--length", "1", "--tolerance", "1e-12"]):
            found = rows(self.fine(*at_length, *question))
            self.assertEqual(list(found[0]), columns + ["x"])
            for row in found:
                if row["converged"] == "yes":
                    self.assertLessEqual(float(row["length_error"]), float(row["error_estimate"]))
            self.assertEqual([row["converged"] for row in found if row["method"] in ("bracketed_newton", "halley")], ["yes"] * 2)
        beyond = rows(self.fine(*at_length, "--fraction", "1", "--tolerance", "1e-18", "--method", "halley"))
        self.assertEqual((beyond[0]["exact_t"], beyond[0]["converged"]), ("1", "no"))
        self.write("point.csv", "x,y\n1,2\n1,2\n")
        point = rows(self.fine("curve", "at-length", "--curve", "point.csv", "--length", "0"))
        self.assertEqual({(row["t"], row["converged"], row["error"]) for row in point}, {("0", "yes", "0")})
        for arguments, *needles in [
                (["--length", "2.7"], "--length 2.7", "2.6", "half.csv"), (["--length=-0.1"], "--length -0.1"),
                (["--length", "2.60000001"], "--length 2.60000001"), (["--fraction", "1.5"], "--fraction 1.5"),
                (["--length", "nan"], "--length"), ([], "--length"),
                (["--length", "1", "--fraction", "0.5"], "--fraction"), (["--length", "1", "--tolerance", "0"], "--tolerance"),
                (["--length", "1", "--form", "power"], "power form", "curve convert"),
                (["--length", "1", "--method", "newton"], "--method newton")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, at_length + arguments, *needles)

    def test_at_length_takes_what_length_prints(self):
        """The control points of public reports. The length of the last one is printed 3.5e-15 too large."""
        for points in ("0.2,0.73 0.35,1.08 0.85,1.08 1,0.73", "10,14 11,14 11,13 11,13",
                       "12.964844,0 12.964844,0 11.996094,1 11.996094,2", "0,0 3,0 3,4 0,4"):
            self.write("own.csv", "x,y\n" + points.replace(" ", "\n") + "\n")
            for printed in rows(self.fine("curve", "length", "--curve", "own.csv")):
                if float(printed["error"]) > 1e-9 * float(printed["exact"]):
                    continue  # it may be longer than the curve
                for row in rows(self.fine("curve", "at-length", "--curve", "own.csv", "--length", printed["length"])):
                    if printed["converged"] == row["converged"] == "yes":
                        self.assertLessEqual(float(row["length_error"]), 1e-9 * float(printed["exact"]), (points, row))
        for question in (["--fraction", "1.0000000001"], ["--length", "2.6000000001"]):
            self.write("half.csv", "x\n0\n2\n-1\n")
            found = rows(self.fine("curve", "at-length", "--curve", "half.csv", *question))
            self.assertEqual({row["exact_t"] for row in found}, {"1"})
        line = rows(self.fine("curve", "length", "--curve", "half.csv", "--from=-1e-10", "--to", "1.0000000001"))
        self.assertEqual({row["exact"] for row in line}, {"2.6"})

    def test_at_length_prints_no_parameter_that_it_does_not_know(self):
        self.write("rests.csv", "x,y\n0,0\n0,0\n0,0\n1,0\n")  # s(t) = t^3
        for row in rows(self.fine("curve", "at-length", "--curve", "rests.csv", "--fraction", "1e-30")):
            self.assertIn(row["exact_t"], ("", "1e-10"))
            self.assertEqual(row["error"] == "", row["exact_t"] == "")
            self.assertNotEqual(row["length_error"], "")

    def test_every_listed_method_evaluates(self):
        for form in ("bernstein", "power"):
            found = rows(self.fine("curve", "eval", "--curve", "c.csv", "--form", form, "--t", "0.25"))
            listed = self.our_methods()
            self.assertEqual(list(dict.fromkeys(row["method"] for row in found)),
                             [row["id"] for row in listed if row["problem"] == "evaluation" and row["form"] == form])
            for row in found:
                self.assertLessEqual(float(row["error_ulp"]), 4, row)

    def test_rational(self):
        """The quarter circle ((1-t^2)/(1+t^2), 2t/(1+t^2)): at 1/2 it is 3-4-5."""
        self.write("c.csv", "x,y,w\n1,0,1\n1,1,1\n0,1,2\n")
        evaluate = ["curve", "eval", "--curve", "c.csv", "--t", "0.5"]
        text = self.fine(*evaluate)
        found = rows(text)
        listed = rows(self.fine("list", "methods", "--format", "csv"))
        self.assertEqual(list(dict.fromkeys(row["method"] for row in found)),
                         [row["id"] for row in listed if row["form"] == "rational" and row["problem"] == "evaluation"])
        for row in found:
            self.assertEqual(row["exact"], {"x": "0.6", "y": "0.8"}[row["axis"]])
            self.assertLessEqual(float(row["error_ulp"]), 4, row)
        self.assertTrue(any(row["bound_u"] for row in found))
        self.write("c.csv", "w,y,x\n1,0,1\n1,1,1\n2,1,0\n")  # columns are found by name
        self.assertEqual(self.fine(*evaluate), text)
        for method in ("horner", "compensated_de_casteljau"):
            self.refused(USAGE, evaluate + ["--method", method], method, "column w")
        self.refused(USAGE, evaluate + ["--form", "power"], "--form power", "column w")
        self.refused(USAGE, ["curve", "convert", "--curve", "c.csv", "--method", "exact"], "exact", "column w")
        self.refused(USAGE, ["curve", "eval", "--curve", self.write("p.csv", "x\n1\n"), "--t", "0", "--method",
                             "de_casteljau_farin"], "de_casteljau_farin", "column w")

    def test_rational_with_weights_of_both_signs(self):
        self.write("c.csv", "x,w\n1,1\n2,-3\n")  # the weights sum to 1 - 4t
        found = rows(self.fine("curve", "eval", "--curve", "c.csv", "--t", "0.5", "--method", "de_casteljau"))
        self.assertEqual([(row["exact"], row["value"], row["bound_u"]) for row in found], [("2.5", "2.5", "")])
        self.refused(USAGE, ["curve", "eval", "--curve", "c.csv", "--t", "0.5", "--t", "0.25"], "--t 0.25", "c.csv")

    def test_same_numbers_however_written(self):
        values = [(0.1, -1e-310), (1e308, 5e-324), (-3.25, 7.0)]
        evaluate = ["curve", "eval", "--curve", "c.csv", "--t", "0.1"]
        texts = []
        for write, end in ((repr, "\n"), (float.hex, "\n"), (repr, "\r\n"), (lambda x: f'"{x!r}"', "\r\n")):
            self.write("c.csv", end.join(["x,y"] + [",".join(map(write, row)) for row in values]) + end)
            texts.append(self.fine(*evaluate))
            texts.append(self.fine(*evaluate[:-1], float.hex(0.1)))
        self.assertEqual(len(set(texts)), 1)
        self.write("c.csv", "\ufeffx,y\n" + "\n".join(f"{x!r},{y!r}" for x, y in values))  # no line end at the end
        self.assertEqual(self.fine(*evaluate), texts[0])

    def test_projection(self):
        self.write("c.csv", "x,y\n8,5\n-4,0\n6,3\n9,7\n")
        project = ["curve", "project", "--curve", "c.csv"]
        found = rows(self.fine(*project, "--point", "6,4"))
        self.assertEqual(list(found[0]), PROJECT_COLUMNS + ["x", "y"])
        self.assertEqual([row["method"] for row in found],
                         [row["id"] for row in self.our_methods() if (row["problem"], row["form"]) == ("projection", "bernstein")])
        for arguments, *needles in [
                (["--point", "6"], "--point 6", "2"), (["--point", "6,4,1"], "3 coordinates"), (["--point", "6,nan"], "--point"),
                (["--point", ""], "--point"), (["--point", "6,"], "--point"), (["--point", "6,4", "--method", "direct"], "direct"),
                (["--point", "6,4", "--method", "scan_bisec"], '"scan_bisect"'),
                (["--point", "6,4", "--form", "power"], "power form")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, project + arguments, *needles)
        self.write("c.csv", "x,y,z\n8,5,1\n-4,0,2\n")
        self.refused(USAGE, project + ["--point", "1,2,3", "--method", "quintic_seed_002"], "quintic_seed_002", "degree 1")
        self.assertEqual(len(rows(self.fine(*project, "--point", "1,2,-3"))), 10)
        self.write("c.csv", "x,y,w\n8,5,1\n-4,0,2\n")
        self.refused(USAGE, project + ["--point", "1,2", "--method", "quintic_isolate"], "rational", "column w")
        self.refused(INPUT_OUTPUT, ["curve", "project", "--curve", "absent.csv", "--point", "1,2"], "absent.csv")

    def test_answers_do_not_wait_for_truths_of_high_degrees(self):
        """Many seconds at degree 1000."""
        def write(degree):
            self.write("c.csv", "x,y\n" + "\n".join(f"{10 * math.cos(i)!r},{10 * math.sin(2 * i)!r}" for i in range(degree + 1)))

        write(1000)
        for command, exact in (("project --point 1,2 --method scan_refine", ["exact_t", "exact_distance", "error"]),
                               ("length --method gauss_legendre_24", ["exact", "error"])):
            with self.subTest(command=command):
                words = command.split()
                result = self.run_program("curve", words[0], "--curve", "c.csv", *words[1:])
                self.assertEqual(result.returncode, 0, result)
                self.assert_one_line(result, "c.csv: ", "degree 1000", "--truth")
                row, = rows(result.stdout.decode())
                self.assertEqual({row[column] for column in exact}, {""})
        write(40)
        row, = rows(self.fine("curve", "project", "--curve", "c.csv", "--point", "1,2", "--method", "quintic_isolate", "--truth"))
        self.assertAlmostEqual(float(row["t"]), float(row["exact_t"]), 14)

    def test_interpolation(self):
        self.write("p.csv", "y,x\n-1,0\n-1,1\n-1,0\n-1,1\n")  # columns are found by name
        interpolate = ["curve", "interpolate", "--points", "p.csv"]
        for arguments in ([], ["--method", "c2_natural_handles"]):
            found = rows(self.fine(*interpolate, *arguments))
            self.assertEqual([list(row.values())[:2] for row in found], [[str(k // 4), str(k % 4)] for k in range(12)])
            self.assertEqual(list(found[0]), ["segment", "index", "x", "y"])
            for row in found:
                self.assertAlmostEqual(float(row["y"]), -1, 15)
        self.assertEqual(self.fine("curve", "interpolate", "--points", self.write("p.csv", "x\n0x1p0\n4\n")),
                         "segment,index,x\n0,0,1\n0,1,2\n0,2,3\n0,3,4\n")
        for content, *needles in [
                ("x,y\n1,2\n", "p.csv: 1 point;", "2 or more"), ("x,y\n1,2\n1,nan\n", "p.csv:3: ", "row 2, column y"),
                ("x,w\n1,2\n3,4\n", "p.csv:1: ", "x,w"),
                ("x\n1e308\n1.7e308\n-1.7e308\n1e308\n", "p.csv: ", "largest double")]:
            with self.subTest(content=content):
                self.write("p.csv", content)
                self.refused(INPUT_OUTPUT, interpolate, *needles)
        self.refused(INPUT_OUTPUT, ["curve", "interpolate", "--points", "absent.csv"], "absent.csv")
        self.refused(USAGE, interpolate + ["--method", "c2_naturl"], 'did you mean "c2_natural"?')
        self.refused(USAGE, ["curve", "interpolate"], "--points")

    def test_interpolation_of_uneven_points(self):
        """Which option is which; tests of the libraries have the numbers."""
        def controls(*arguments):
            return [float(row["x"]) for row in rows(self.fine("curve", "interpolate", "--points", "p.csv", *arguments))]
        self.write("p.csv", "x,y\n0,0\n1,0\n100,0\n")
        self.assertAlmostEqual(controls("--parameters", "uniform")[1], -23.5 / 3, 12)  # as in the report: x = -23.5 t + 24.5 t^3
        self.assertEqual(controls("--parameters", "uniform"), controls("--method", "c2_natural"))
        self.assertAlmostEqual(controls("--parameters", "chord")[1], 1 / 3, 12)  # the line at constant speed
        self.assertEqual(controls(), controls("--parameters", "centripetal"))
        self.write("p.csv", "x\n0\n1\n4\n")  # t^2 at 0, 1, 2
        for ends in (["not-a-knot"], ["clamped", "--start-derivative", "0", "--end-derivative", "4"]):
            self.assertAlmostEqual(controls("--parameters", "uniform", "--ends", *ends)[2], 1 / 3, 14)
        self.write("p.csv", "x,y\n0,0\n1,0\n1,1\n0,1\n")
        self.assertAlmostEqual(controls("--closed")[14], -0.25, 14)
        self.write("p.csv", "x\n0\n1\n1.1\n9\n9\n")
        monotone = controls("--parameters", "uniform", "--monotone")
        self.assertEqual(monotone, sorted(monotone))

    def test_interpolation_of_what_is_refused(self):
        interpolate = ["curve", "interpolate", "--points", "p.csv"]
        self.write("p.csv", "x,y,z\n0,0,0\n0,0,0\n1,1,1\n")
        for parameters in ([], ["--parameters", "chord"]):
            self.refused(INPUT_OUTPUT, interpolate + parameters, "p.csv:3: repeats the point before it", "uniform")
        self.assertEqual(len(rows(self.fine(*interpolate, "--parameters", "uniform"))), 8)
        self.write("p.csv", "x\n0\n1\n0\n0\n")  # the last is the first, and what is before it as well
        self.refused(INPUT_OUTPUT, interpolate + ["--closed"], "p.csv:2: repeats")
        self.write("p.csv", "x,y\n0,0\n1,0\n")
        for arguments, *needles in [
                (["--parameters", "arc"], "--parameters"), (["--ends", "free"], "--ends"), (["--ends", "clamped"], "--start-derivative"),
                (["--ends", "clamped", "--start-derivative", "1,1"], "--end-derivative"), (["--start-derivative", "1,1"], "--ends"),
                (["--ends", "clamped", "--start-derivative", "1", "--end-derivative", "1,1"], "--start-derivative 1", "the points have 2"),
                (["--ends", "clamped", "--start-derivative", "1,nan", "--end-derivative", "1,1"], "--start-derivative"),
                (["--closed", "--ends", "not-a-knot"], "no ends"), (["--method", "c2_natural", "--closed"], "--method c2_natural"),
                (["--method", "c2_natural", "--parameters", "chord"], "uniform parameters")]:
            with self.subTest(arguments=arguments):
                self.refused(USAGE, interpolate + arguments, *needles)

    def fitted(self, segments, *arguments):
        """The standard output of a fit that says that it has so many segments."""
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, 0, result)
        self.assertRegex(result.stderr.decode(), rf"^bezierbench: {segments} segments?, maximum error [0-9.e-]+\n$")
        return result.stdout.decode()

    def test_fitting(self):
        """Samples of the parabola (2t, 4t(1-t)), whose cubic is (0,0) (2/3,4/3) (4/3,4/3) (2,0)."""
        fit = ["curve", "fit", "--points", "p.csv"]
        self.write("p.csv", "y,x\n0,0\n0.75,0.5\n1,1\n1,1\n0.75,1.5\n0,2\n")
        for arguments in ([], ["--method", "gauss_newton"]):
            found = rows(self.fitted(1, *fit, "--tolerance", "1e-9", *arguments))
            self.assertEqual(list(found[0]), ["segment", "index", "x", "y"])
            for row, x, y in zip(found, (0, 2, 4, 6), (0, 4, 4, 0), strict=True):
                self.assertAlmostEqual(float(row["x"]), x / 3, 9)
                self.assertAlmostEqual(float(row["y"]), y / 3, 9)
        for tolerance, segments in (("0.5", 1), ("0", 4)):
            found = self.fitted(segments, *fit, "--tolerance", tolerance, "--method", "schneider")
            self.assertEqual(len(rows(found)), 4 * segments)
        found = rows(self.fitted(1, *fit, "--tolerance", "0.5", "--start-direction", "0,2", "--end-direction", "1,0"))
        self.assertEqual((found[1]["x"], found[2]["y"]), ("0", "0"))
        self.assertGreater(float(found[1]["y"]), 0)
        self.assertLess(float(found[2]["x"]), 2)
        found = rows(self.fitted("[0-9]+", *fit, "--tolerance", "0.01", "--closed"))
        self.assertEqual([found[-1][axis] for axis in "xy"], [found[0][axis] for axis in "xy"])
        for direction, needle in (("1", "1 coordinate, but the points have 2"), ("0,0", "zero vector"), ("1,x", "x: is not a finite number")):
            with self.subTest(direction=direction):
                self.refused(USAGE, fit + ["--tolerance", "1", f"--end-direction={direction}"], "--end-direction", needle)
        self.write("p.csv", "x\n0x1p0\n4\n")
        self.assertEqual(self.fitted(1, *fit, "--tolerance", "0"), "segment,index,x\n0,0,1\n0,1,2\n0,2,3\n0,3,4\n")
        for tolerance in ("-1", "nan", "inf", "", "x"):
            with self.subTest(tolerance=tolerance):
                self.refused(USAGE, fit + [f"--tolerance={tolerance}"], "--tolerance")
        self.refused(USAGE, fit, "--tolerance")
        self.refused(USAGE, fit + ["--tolerance", "1", "--method", "schneidr"], 'did you mean "schneider"?')
        self.write("p.csv", "x,y\n1,2\n")
        self.refused(INPUT_OUTPUT, fit + ["--tolerance", "1"], "p.csv: 1 point;", "2 or more")


if __name__ == "__main__":
    unittest.main()
