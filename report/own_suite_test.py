# SPDX-License-Identifier: MIT
"""A page is about the suites of its bundle: a user's own studies of every kind are shown, and no other suite is spoken of."""

import csv
import re
import tempfile
import unittest
from pathlib import Path

from . import fixture, render, schema
from .bundle import Bundle
from .chapters.roster import UNNAMED, build_all
from .findings.roster import find_all

# One study of each kind, and one whose id looks like that of a known suite.
STUDIES = ("truth-bezier", "conversion-bezier", "worst-bezier", "peers-speed", "derivative-order", "subdivision-degree",
           "arc_length-tolerance", "inverse_arc_length-tolerance", "projection-cubics", "interpolation-points", "fitting-cubics",
           "grid-points", "bspline-degree", "flattening-cubics", "bounds-degree", "guarantees-few", "every-float", "every-x", "easing-few",
           "hard-few")
TITLE = "Degree 20 on my machine"
# Distances from a rounding boundary by search: on it, and nearer than the smallest double.
DISTANCES = {"tie": ("0",), "nearest": ("1.5e-700", "2e-4"), "cancelled": ("0.25",)}


def _write(path, name, rows):
    """A table that the fixture has not."""
    with open(path / name, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(schema.columns(name)), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def _write_exhaustive(path):
    """Two methods on two curves at every float."""
    _write(path, "exhaustive.csv", (dict(study="every-float", curve_id=curve, method=method, scalar="float", degree=degree, t_min="0",
                                         t_max="1", points=1065353217, max_error_ulp=degree + at / 2, worst_t="0x1p-2", misrounded=at,
                                         non_monotone=0, out_of_hull=0)
                                    for curve, degree in (("css_ease", 3), ("circle", 2))
                                    for at, method in enumerate(("direct", "de_casteljau"))))


def _write_easing(path):
    """Two methods on random easing curves, and at every float on two of them."""
    rows = []
    for at, method in enumerate(("easing_correctly_rounded", "easing_halley")):
        row = dict.fromkeys(schema.columns("easing.csv"), at)
        row.update(study="easing-few", form="bernstein", method=method, scalar="double", dimension=2, degree=3, coordinate_range=1, t_min=0,
                   t_max=1, generator="continuous", trials=9, status="ok", curves="", max_error_ulp=0.5 + at, float_max_error_ulp=0.5 + at)
        rows.append(row)
    _write(path, "easing.csv", rows)
    _write(path, "easing_floats.csv", (dict(study="every-x", curve_id=curve, method=method, scalar="float", t_min="0.5", t_max="1",
                                            points=8388609, max_error_ulp=0.5 + at, worst_x="0x1p-1", misrounded=at, non_monotone=at,
                                            max_steps=4, not_converged=0)
                                       for curve in ("css_ease", "easing_1_0_0_1")
                                       for at, method in enumerate(("easing_correctly_rounded", "easing_halley"))))


def _write_hard_cases(path):
    """The cases of DISTANCES in each scalar type."""
    _write(path, "hard_cases.csv", (dict(study="hard-few", family="beside_a_tie", search=search, drawn=1000, form="bernstein", scalar=scalar,
                                         degree=1, dimension=1, t="0x1p-1", coefficients="0x1p+0 0x1p+0", exact="1", rounded="0x1p+0",
                                         rounded_double="0x1p+0", rounded_float="0x1p+0", distance_ulp=distance)
                                    for scalar in ("double", "float") for search, distances in DISTANCES.items() for distance in distances))


def _own(place, title=TITLE, printed=False):
    """A bundle of these studies, all of one suite that nobody knows."""
    path = fixture.write(place, lambda at, row: row.get("study") is None or row.get("study") in STUDIES,
                         () if printed else ("scorecard.csv", "scorecard_timing.csv"))
    parts = re.split(r"(?=\[\[suites)", fixture.suite_toml())
    own = [part for part in parts if any(f'\nid = "{study}"\n' in part for study in STUDIES)]
    own.append('[[study]]\nid = "every-float"\ntitle = "Every float"\nkind = "exhaustive"\n'
               '[[study]]\nid = "every-x"\ntitle = "Every x"\nkind = "easing_floats"\n'
               '[[study]]\nid = "easing-few"\ntitle = "Easing"\nkind = "easing"\n'
               '[[study]]\nid = "hard-few"\ntitle = "Hard cases"\nkind = "hard_cases"\n')
    (path / "suite.toml").write_text(f'[suite]\nid = "mine"\ntitle = "{title}"\n' + "".join(own).replace("[[suites.study]]", "[[study]]"))
    _write_exhaustive(path)
    _write_easing(path)
    _write_hard_cases(path)
    return Bundle(fixture.seal(path))


class OwnSuite(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.bundle = _own(Path(place.name) / "b")
        cls.chapters, cls.left_out = build_all(cls.bundle, find_all(cls.bundle))
        cls.html = render.files(cls.bundle, cls.chapters, cls.left_out)["report.html"].decode()

    def test_every_kind_with_a_figure_is_tried(self):
        self.assertEqual({self.bundle.studies[study].kind for study in STUDIES},
                         set(schema.kinds()))

    def test_every_study_has_its_figure_and_its_table(self):
        own = next(chapter for chapter in self.chapters if chapter.id == "suite-mine")
        shown = {}
        for block in own.blocks:
            if block.kind == "heading":
                kinds = shown.setdefault(block.text, set())
            kinds.add(block.kind)
        self.assertEqual({self.bundle.title(study) for study in STUDIES}, set(shown))
        for study, kinds in shown.items():
            self.assertLessEqual({"figure", "table"}, kinds, study)

    def figures(self):
        return [block for chapter in self.chapters for block in chapter.blocks if block.kind == "figure"]

    def test_a_method_has_one_colour_in_all_panels_of_a_figure(self):
        compared = 0
        for figure in self.figures():
            colours = {}
            for series, colour in re.findall(r'<g id="(s\d+)-\d+">\s*<path d="[^"]*"[^>]*style="[^"]*stroke: (#\w+)', figure.drawing.svg):
                colours.setdefault(series, []).append(colour)
            for series, found in colours.items():
                compared += len(found) > 1
                self.assertEqual(len(set(found)), 1, f"{figure.id}: {series} has {found}")
        self.assertGreater(compared, 10)

    def test_a_figure_says_over_what_its_points_are_the_largest(self):
        captions = {figure.id: figure.caption for figure in self.figures()}
        rows = self.bundle["accuracy.csv"].select(study="truth-bezier", baseline="exact")
        self.assertGreater(len({row["generator"] for row in rows}), 1)
        self.assertIn("against degree n; each point is the largest value over", captions["truth-bezier-figure"])
        self.assertIn("generator", captions["truth-bezier-figure"])

    def test_a_hard_case_stands_at_its_distance(self):
        figure = next(one for one in self.figures() if one.id == "hard-few-figure")
        points = {series.name: [point[2] for point in series.points] for series in figure.drawing.series}
        self.assertEqual(points, {name: [f"beside_a_tie, degree 1: {distance} ulp ({scalar})" for scalar in ("double", "float")
                                         for distance in distances]
                                  for name, distances in (("next to a boundary", ("1.50e-700", "2.00e-4")), ("cancelled most", ("2.50e-1",)))})
        self.assertIn("2 cases on a boundary, of beside_a_tie,", figure.caption)

    def test_the_title_is_that_of_the_suite(self):
        self.assertIn(f"<h1>{TITLE}</h1>", self.html)
        self.assertIn(f"<title>{TITLE} ", self.html)

    def test_nothing_is_said_of_suites_that_are_not_there(self):
        self.assertEqual(self.left_out, [])
        for word in ("The report", "the report's", "source report", "原报告", "regimes", "Scorecard", "Left out"):
            self.assertNotIn(word, self.html, word)

    def test_a_study_without_a_suite_is_shown(self):
        with tempfile.TemporaryDirectory() as place:
            path = fixture.write(Path(place) / "b", lambda at, row: row.get("study") in (None, "truth-bezier"), ("scorecard.csv",))
            (path / "suite.toml").unlink()
            bundle = Bundle(fixture.seal(path))
            chapters, _ = build_all(bundle, find_all(bundle))
            unnamed = next(chapter for chapter in chapters if chapter.title == UNNAMED)
            self.assertEqual([b.text for b in unnamed.blocks if b.kind == "heading"], ["truth-bezier"])

    def test_what_no_chapter_of_a_known_suite_shows_has_its_own(self):
        with tempfile.TemporaryDirectory() as place:
            bundle = Bundle(fixture.write(Path(place) / "b"))
            bundle = bundle.only({"companion_speed-fitting_errors", "companion_speed-fitting"})
            chapters, _ = build_all(bundle, find_all(bundle))
            left = next(chapter for chapter in chapters if chapter.id == "suite-companion_speed")
            self.assertEqual([b.text for b in left.blocks if b.kind == "heading"], ["companion_speed-fitting_errors"])


if __name__ == "__main__":
    unittest.main()
