#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Curves of STEP and IGES models, or how to have them. Usage: models_test.py BEZIERBENCH"""
import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import INPUT_OUTPUT, Case, rows  # noqa: E402

ABSENT = "Open CASCADE, which is not in this build"
# A B-spline with the knots 0, 1, 2; the same from 1/2 to 1; a rational quadratic; one of equal weights; a circle; a line; a hyperbola.
STEP = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','2026-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('');
#2=PRODUCT_CONTEXT('',#1,'mechanical');
#3=PRODUCT('','','',(#2));
#4=PRODUCT_DEFINITION_FORMATION('','',#3);
#5=PRODUCT_DEFINITION_CONTEXT('',#1,'design');
#6=PRODUCT_DEFINITION('','',#4,#5);
#7=PRODUCT_DEFINITION_SHAPE('','',#6);
#8=SHAPE_DEFINITION_REPRESENTATION(#7,#9);
#9=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#14,#15),#10);
#10=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#11,#12,#13))REPRESENTATION_CONTEXT('',''));
#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#12=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#13=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#14=AXIS2_PLACEMENT_3D('',#20,#16,#17);
#15=GEOMETRIC_CURVE_SET('',(#31,#32,#33,#35,#37,#39,#41));
#16=DIRECTION('',(0.,0.,1.));
#17=DIRECTION('',(1.,0.,0.));
#18=VECTOR('',#17,1.);
#20=CARTESIAN_POINT('',(0.,0.,0.));
#21=CARTESIAN_POINT('',(4.,0.,0.));
#22=CARTESIAN_POINT('',(8.,4.,0.));
#23=CARTESIAN_POINT('',(8.,8.,8.));
#24=CARTESIAN_POINT('',(0.1,8.,16.));
#30=B_SPLINE_CURVE_WITH_KNOTS('',3,(#20,#21,#22,#23,#24),.UNSPECIFIED.,.F.,.F.,(4,1,4),(0.,1.,2.),.UNSPECIFIED.);
#31=TRIMMED_CURVE('',#30,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(2.)),.T.,.PARAMETER.);
#32=TRIMMED_CURVE('',#30,(PARAMETER_VALUE(0.5)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);
#33=TRIMMED_CURVE('',#34,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);
#34=(BOUNDED_CURVE()B_SPLINE_CURVE(2,(#20,#21,#22),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)
CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,0.5,1.))REPRESENTATION_ITEM(''));
#35=TRIMMED_CURVE('',#36,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);
#36=(BOUNDED_CURVE()B_SPLINE_CURVE(2,(#20,#21,#22),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)
CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((2.,2.,2.))REPRESENTATION_ITEM(''));
#37=TRIMMED_CURVE('',#38,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(6.28318530717958648)),.T.,.PARAMETER.);
#38=CIRCLE('',#14,2.);
#39=TRIMMED_CURVE('',#40,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(3.)),.T.,.PARAMETER.);
#40=LINE('',#21,#18);
#41=TRIMMED_CURVE('',#42,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);
#42=HYPERBOLA('',#14,1.,1.);
ENDSEC;
END-ISO-10303-21;
"""
POLES = [(0, 0, 0), (4, 0, 0), (8, 4, 0), (8, 8, 8), (0.1, 8, 16)]


def iges():
    """The B-spline and the line by IGES 5.3, entities 126 and 110, in lines of 80 columns."""
    poles = ",".join(f"{x}" for pole in POLES for x in pole)
    parameters = [f"126,4,3,0,0,1,0,0.,0.,0.,0.,1.,2.,2.,2.,2.,1.,1.,1.,1.,1.,{poles},0.,2.,0.,0.,1.;", "110,4.,0.,0.,7.,0.,0.;"]
    world = "1H,,1H;,1Hb,1Hb,1Hb,1Hb,32,38,6,308,15,1Hb,1.,2,2HMM,1,1.,15H20260101.000000,1E-7,20.,1Hb,1Hb,11,0,15H20260101.000000;"
    lines, directory, data = [f"{'b':72}S{1:7}"], [], []
    lines += [f"{world[k:k + 72]:72}G{1 + k // 72:7}" for k in range(0, len(world), 72)]
    for text in parameters:
        pieces, kind, entry = [text[k:k + 64] for k in range(0, len(text), 64)], int(text[:3]), 1 + len(directory)
        numbers = ([kind, 1 + len(data), 0, 0, 0, 0, 0, 0, "00000000"], [kind, 0, 0, len(pieces), 0, "", "", "", 0])
        directory += ["".join(f"{n:>8}" for n in fields) + f"D{entry + k:7}" for k, fields in enumerate(numbers)]
        data += [f"{piece:64}{entry:8}P{1 + len(data) + k:7}" for k, piece in enumerate(pieces)]
    end = f"S{1:7}G{len(lines) - 1:7}D{len(directory):7}P{len(data):7}"
    return "\n".join([*lines, *directory, *data, f"{end:72}T{1:7}", ""])


def mean(*points):
    return tuple(sum(x) / len(points) for x in zip(*points))


# Knots 0, 1, 2: the junction of the spans is (P1 + 2 P2 + P3) / 4, its neighbours are the middles of P1 P2 and P2 P3.
JUNCTION = mean(POLES[1], POLES[2], POLES[2], POLES[3])
SPANS = [[POLES[0], POLES[1], mean(*POLES[1:3]), JUNCTION], [JUNCTION, mean(*POLES[2:4]), POLES[3], POLES[4]]]


def right_half(points):
    """By de Casteljau at 1/2, whose triangle has it on its last diagonal; exact for these points."""
    half = [points[-1]]
    while len(points) > 1:
        points = [mean(a, b) for a, b in zip(points, points[1:])]
        half.insert(0, points[-1])
    return half


class Models(Case):
    def setUp(self):
        super().setUp()
        self.write("part.stp", STEP)
        self.write("part.igs", iges())
        if ABSENT in self.run_program("curves", "part.stp").stderr.decode():
            for file in ("part.stp", "part.igs"):
                self.refused(INPUT_OUTPUT, ["curves", file], file, ABSENT, "scripts/build peers")
            self.skipTest("this build has no Open CASCADE")

    def curves(self, file, *files):
        """{id: (form, points, weights)}, and what is printed."""
        printed = self.fine("curves", file, *files, "--out", "set.csv")
        found = {}
        for row in rows((self.folder / "set.csv").read_text()):
            _, points, weights = found.setdefault(row["curve"], (row.get("form", "bernstein"), [], []))
            points.append(tuple(float.fromhex(row[axis]) for axis in "xyz"))
            weights += [float.fromhex(row["w"])] if row.get("w") else []
        return found, printed

    def test_each_edge_of_step_as_bezier_curves(self):
        found, printed = self.curves("part.stp")
        self.assertIn("left out: edges of the type Geom_Hyperbola (1)", printed)
        self.assertEqual([found.pop(f"0:{k}")[1] for k in range(2)], SPANS)
        self.assertEqual(found.pop("1:0")[1], right_half(SPANS[0]))
        self.assertEqual(found.pop("2:0")[1:], (POLES[:3], [1, 0.5, 1]))
        self.assertEqual(found.pop("3:0")[1:], (POLES[:3], []))
        for k, (x, y) in enumerate([(1, 1), (-1, 1), (-1, -1), (1, -1)]):
            _, points, weights = found.pop(f"4:{k}")
            self.assertEqual((weights[0], weights[2]), (1, 1))
            self.assertAlmostEqual(weights[1], math.sqrt(0.5), delta=1e-15)
            for got, wanted in zip(points[1], (2 * x, 2 * y, 0)):
                self.assertAlmostEqual(got, wanted, delta=4e-15)
        self.assertEqual(found.pop("5:0")[1], [(4, 0, 0), (7, 0, 0)])
        self.assertEqual(found, {})
        self.assertIn("10 curves in 6 paths", printed)

    def test_iges_and_contents_without_an_extension(self):
        found, _ = self.curves("part.igs")
        self.assertEqual(sorted((points for _, points, _ in found.values()), key=len), [[(4, 0, 0), (7, 0, 0)], *SPANS])
        for file, other in (("part.stp", "step"), ("part.igs", "iges")):
            self.write(other, (self.folder / file).read_text())
            self.assertEqual(self.fine("curves", other), self.fine("curves", file))

    def test_suites_and_commands_take_models(self):
        lengths = rows(self.fine("curve", "length", "--curve", "part.stp#5:0", "--method", "gauss_legendre_24"))
        self.assertEqual(float(lengths[0]["exact"]), 3)

    def test_what_is_broken_ends_with_one_line(self):
        for whole, name in ((STEP, "a.step"), (iges(), "a.iges")):
            broken = [whole[:len(whole) * k // 12] for k in range(12)]
            broken += [whole.replace("(4,1,4)", "(4,100000,4)"), whole.replace("(0.,1.,2.)", "(0.,1.,1e400)"), whole.replace("#20,#21", "#30,#30"),
                       whole.replace("(0.1,8.", "(1e999,8."), whole.replace("126,4,3", "126,400000000,3"), "\0" * 500, whole.replace(",3,", ",-3,")]
            for contents in broken:
                self.write(name, contents)
                result = self.run_program("curves", name)
                if result.returncode:
                    self.assertEqual(result.returncode, INPUT_OUTPUT, result.stderr)
                    self.assert_one_line(result, name)
        for name in ("a.step", "a.iges"):
            for contents in ("", "\0" * 500, STEP[:300]):
                self.write(name, contents)
                self.refused(INPUT_OUTPUT, ["curves", name], f"{name}: Open CASCADE cannot read it")
        self.write("a.step", STEP.replace("(0.1,8.", "(1e999,8."))
        self.refused(INPUT_OUTPUT, ["curves", "a.step"], "a.step: its curves cannot be made")


if __name__ == "__main__":
    unittest.main()
