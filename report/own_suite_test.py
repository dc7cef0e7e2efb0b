# SPDX-License-Identifier: MIT
"""A page is about the suites of its bundle: a user's own studies of every kind are shown, and no other suite is spoken of."""

import re
import unittest

from . import fixture, schema
from .chapters.roster import UNNAMED, build_all
from .figures.study import study_lines
from .findings.roster import find_all
from .inline import to_plain

# One study of each kind, and one whose id looks like that of a known suite.
STUDIES = ("truth-bezier", "conversion-bezier", "worst-bezier", "peers-speed", "derivative-order", "subdivision-degree",
           "arc_length-tolerance", "inverse_arc_length-tolerance", "projection-cubics", "interpolation-points", "fitting-cubics",
           "grid-points", "bspline-degree", "flattening-cubics", "bounds-degree", "roots-degree", "guarantees-few")
# Those of kinds that the fixture has no rows of.
MORE = {"every-float": "exhaustive", "every-x": "easing_floats", "easing-few": "easing", "hard-few": "hard_cases"}
TITLE = "Degree 20 on my machine"
# Distances from a rounding boundary by search: on it, and nearer than the smallest double.
DISTANCES = {"tie": ("0",), "nearest": ("1.5e-700", "2e-4"), "cancelled": ("0.25",)}


def _exhaustive():
    """Two methods on two curves at every float."""
    return [dict(study="every-float", curve_id=curve, method=method, scalar="float", degree=degree, t_min=0, t_max=1, points=1065353217,
                 max_error_ulp=degree + at / 2, worst_t="0x1p-2", misrounded=at, non_monotone=0, out_of_hull=0)
            for curve, degree in (("css_ease", 3), ("circle", 2)) for at, method in enumerate(("direct", "de_casteljau"))]


def _easing():
    """Two methods on random easing curves."""
    return [dict.fromkeys(schema.columns("easing.csv"), at)
            | dict(study="easing-few", form="bernstein", method=method, scalar="double", dimension=2, degree=3, coordinate_range=1, t_min=0,
                   t_max=1, generator="continuous", trials=9, status="ok", curves="", max_error_ulp=0.5 + at, float_max_error_ulp=0.5 + at)
            for at, method in enumerate(("easing_correctly_rounded", "easing_halley"))]


def _easing_floats():
    """The same at every float on two of them."""
    return [dict(study="every-x", curve_id=curve, method=method, scalar="float", t_min="0.5", t_max="1", points=8388609,
                 max_error_ulp=0.5 + at, worst_x="0x1p-1", misrounded=at, non_monotone=at, max_steps=4, not_converged=0)
            for curve in ("css_ease", "easing_1_0_0_1") for at, method in enumerate(("easing_correctly_rounded", "easing_halley"))]


def _hard_cases():
    """The cases of DISTANCES in each scalar type."""
    return [dict(study="hard-few", family="beside_a_tie", search=search, drawn=1000, form="bernstein", scalar=scalar,
                 degree=1, dimension=1, t="0x1p-1", coefficients="0x1p+0 0x1p+0", exact="1", rounded="0x1p+0",
                 rounded_double="0x1p+0", rounded_float="0x1p+0", distance_ulp=distance)
            for scalar in ("double", "float") for search, distances in DISTANCES.items() for distance in distances]


def _own():
    """A bundle of these studies, all of one suite that nobody knows."""
    makers = {file: make for file, make in fixture.FILES.items() if not file.startswith("scorecard")}
    makers |= {"exhaustive.csv": _exhaustive, "easing.csv": _easing, "easing_floats.csv": _easing_floats, "hard_cases.csv": _hard_cases}
    known = [part for part in re.split(r"(?=\[\[suites)", fixture.suite_toml()) if any(f'\nid = "{study}"\n' in part for study in STUDIES)]
    more = [f'[[study]]\nid = "{study}"\ntitle = "{study}"\nkind = "{kind}"\n' for study, kind in MORE.items()]
    suite = f'[suite]\nid = "mine"\ntitle = "{TITLE}"\n' + "".join(known + more).replace("[[suites.study]]", "[[study]]")
    return fixture.bundle(lambda at, row: row.get("study") in (None, *STUDIES, *MORE), makers=makers, suite=suite)


class OwnSuite(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bundle = _own()
        cls.chapters, cls.left_out = build_all(cls.bundle, find_all(cls.bundle))
        cls.html = fixture.rendered(cls.bundle, cls.chapters, cls.left_out)["report.html"].decode()
        cls.figures = {block.id: block for chapter in cls.chapters for block in chapter.blocks if block.kind == "figure"}

    def test_every_study_of_every_kind_has_its_figure_and_its_table(self):
        self.assertEqual({self.bundle.studies[study].kind for study in (*STUDIES, *MORE)}, set(schema.kinds()))
        own = next(chapter for chapter in self.chapters if chapter.id == "suite-mine")
        shown = {}
        for block in own.blocks:
            if block.kind == "heading":
                kinds = shown.setdefault(block.text, set())
            kinds.add(block.kind)
        self.assertEqual({self.bundle.title(study) for study in (*STUDIES, *MORE)}, set(shown))
        for study, kinds in shown.items():
            self.assertLessEqual({"figure", "table"}, kinds, study)

    def test_a_method_has_one_colour_in_all_panels_of_a_figure(self):
        compared = 0
        for figure in self.figures.values():
            colours = {}
            for series, colour in re.findall(r'<g id="(s\d+)-\d+">\s*<path d="[^"]*"[^>]*style="[^"]*stroke: (#\w+)', figure.drawing.svg):
                colours.setdefault(series, []).append(colour)
            for series, found in colours.items():
                compared += len(found) > 1
                self.assertEqual(len(set(found)), 1, f"{figure.id}: {series} has {found}")
        self.assertGreater(compared, 10)

    def test_a_figure_says_over_what_its_points_are_the_largest(self):
        rows = self.bundle["accuracy.csv"].select(study="truth-bezier", baseline="exact")
        self.assertGreater(len({row["generator"] for row in rows}), 1)
        self.assertRegex(self.figures["truth-bezier-figure"].caption, "against degree n; each point is the largest value over .*generator")

    def test_a_figure_names_what_its_logarithmic_axis_does_not_show(self):
        """Roots missed: by one method none, by the other none at the lower degree and 7 at the higher."""
        for lost, drawn, hidden in (((0, 0, 0, 7), "at the end sampled_newton has 7", "certified, and at some places sampled_newton"),
                                    ((0, 0, 2, 7), "at the end sampled_newton has 7", "certified"),
                                    ((3, 3, 2, 7), "at the end certified has the least that is drawn, 3, and sampled_newton the largest, 7", "")):
            left = iter(lost)
            figure = study_lines(fixture.bundle(lambda at, row, left=left: at != "roots.csv" or row.update(missed=next(left)) or True), "roots-degree")
            self.assertIn(f"roots missed: {drawn}", to_plain(figure.alt))
            for text in (figure.caption, figure.alt):
                self.assertEqual(f"0, not drawn: of roots missed {hidden}" in to_plain(text), bool(hidden), text)

    def test_a_hard_case_stands_at_its_distance(self):
        figure = self.figures["hard-few-figure"]
        points = {series.name: [point[2] for point in series.points] for series in figure.drawing.series}
        self.assertEqual(points, {name: [f"beside_a_tie, degree 1: {distance} ulp ({scalar})" for scalar in ("double", "float")
                                         for distance in distances]
                                  for name, distances in (("next to a boundary", ("1.50e-700", "2.00e-4")), ("cancelled most", ("2.50e-1",)))})
        self.assertIn("2 cases on a boundary, of beside_a_tie,", figure.caption)

    def test_it_has_the_title_of_the_suite_and_nothing_of_suites_that_are_not_there(self):
        self.assertIn(f"<h1>{TITLE}</h1>", self.html)
        self.assertIn(f"<title>{TITLE} ", self.html)
        self.assertEqual(self.left_out, [])
        self.assertNotIn('lang="zh', self.html)  # captions in Chinese are those of the source report's tables
        for word in ("The report", "the report's", "source report", "原报告", "regimes", "Scorecard", "Left out"):
            self.assertNotIn(word, self.html, word)


class NoChapter(unittest.TestCase):
    def headings(self, bundle, title):
        fixture.without_figures(self)
        chapters, _ = build_all(bundle, find_all(bundle))
        return [b.text for chapter in chapters if title in (chapter.id, chapter.title) for b in chapter.blocks if b.kind == "heading"]

    def test_a_study_without_a_suite_is_shown(self):
        bundle = fixture.bundle(lambda at, row: row.get("study") in (None, "truth-bezier"), ("scorecard.csv",), suite="")
        self.assertEqual(self.headings(bundle, UNNAMED), ["truth-bezier"])

    def test_what_no_chapter_of_a_known_suite_shows_has_its_own(self):
        bundle = fixture.bundle().only({"companion_speed-fitting_errors", "companion_speed-fitting"})
        self.assertEqual(self.headings(bundle, "suite-companion_speed"), ["companion_speed-fitting_errors"])


if __name__ == "__main__":
    unittest.main()
