# SPDX-License-Identifier: MIT
"""The shipped sets of curves are what their README says, and what make_sets.py makes.

sets_test.py PROGRAM [--packages FOLDER]    PROGRAM is bezierbench

The script is run for the smallest set whose packages are installed, and for all that are unpacked in FOLDER.
"""
import argparse
import csv
import importlib.util
import io
import itertools
import sys
import unittest
from collections import Counter
from fractions import Fraction
from pathlib import Path

HERE = Path(__file__).resolve().parent
SETS = HERE / "sets"
OPTIONS = argparse.Namespace(program=None, packages=None)


def module(name):
    spec = importlib.util.spec_from_file_location(name, HERE / f"{name}.py")
    loaded = sys.modules[name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


make_sets = module("make_sets")


def curves_of(name):
    """{id: rows of fields, without id and index} of a set, and its header."""
    with open(SETS / f"{name}.csv", newline="", encoding="utf-8") as file:
        rows = csv.reader(file)
        header = next(rows)
        groups = [(id_, [row[2:] for row in group]) for id_, group in itertools.groupby(rows, lambda row: row[0])]
    return header, groups


class Shipped(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sets = {name: curves_of(name) for name in make_sets.SOURCES}

    def test_every_set_has_its_source_and_licence(self):
        self.assertEqual({file.stem for file in SETS.glob("*.csv")}, {*make_sets.SOURCES, "named"})
        for name, source in make_sets.SOURCES.items():
            first = (SETS / f"{name}.csv.license").read_text(encoding="utf-8").split("\n")[0]
            self.assertEqual(first, f"SPDX-License-Identifier: {source.licence}")

    def test_there_are_enough_curves_and_none_weighs_too_much(self):
        counts = {name: len(groups) for name, (_, groups) in self.sets.items()}
        self.assertGreaterEqual(len(counts), 6)
        self.assertGreaterEqual(sum(counts.values()), 20000)
        self.assertLessEqual(2 * max(counts.values()), sum(counts.values()))
        for name, (_, groups) in self.sets.items():
            files = Counter(id_.split(":")[0] for id_, _ in groups)
            self.assertLessEqual(max(files.values()), min(2000, make_sets.SOURCES[name].per_file), name)
        self.assertLessEqual(sum(file.stat().st_size for file in SETS.iterdir()), 6_000_000)

    def test_ids_are_different(self):
        for name, (_, groups) in self.sets.items():
            self.assertEqual(len({id_ for id_, _ in groups}), len(groups), name)

    def test_no_curve_is_a_point_or_a_translation_of_another(self):
        different = 0
        for name, (header, groups) in self.sets.items():
            axes = len(header) - 2 - ("w" in header)
            shapes = set()
            for id_, rows in groups:
                points = [[Fraction(x) for x in row[:axes] if x] for row in rows]
                steps = tuple(x - first for point in points for x, first in zip(point, points[0]))
                self.assertTrue(any(steps), f"{name}: {id_} is a point")
                shapes.add((steps, *(row[axes:][0] if row[axes:] else "" for row in rows)))
            self.assertEqual(len(shapes), len(groups), name)
            different += len(shapes)
        self.assertGreaterEqual(different, 20000)

    def test_numbers_are_the_shortest_of_their_doubles(self):
        for name, (_, groups) in self.sets.items():
            for id_, rows in groups:
                for field in filter(None, itertools.chain(*rows)):
                    self.assertLessEqual(len(field), len(repr(float(field))), f"{name}: {id_}: {field}")

    def test_readme_has_the_numbers_of_the_sets(self):
        readme = (SETS / "README.md").read_text(encoding="utf-8")
        tables = make_sets.tables(OPTIONS.program, SETS)
        for table in tables.values():
            self.assertIn(f"\n{table}\n\n", readme)
        # The program's counts by degree are those of the rows.
        figures = next(table for head, table in tables.items() if " degree " in head)
        told = Counter()
        for line in figures.split("\n")[2:]:
            name, form, _, degree, curves = (field.strip() for field in line.split("|")[1:6])
            told[name, form, int(degree)] += int(curves)
        counted = Counter((name, "rational" if "w" in header and rows[0][-1] else "bernstein", len(rows) - 1)
                          for name, (header, groups) in self.sets.items() for _, rows in groups)
        self.assertEqual(told, counted)
        for name in make_sets.SOURCES:
            self.assertIn(f"\n## {name}\n", readme)


class Made(unittest.TestCase):
    def test_the_script_makes_the_same_bytes(self):
        found = {}
        for name, source in make_sets.SOURCES.items():
            folders = [make_sets.folder_of(package, OPTIONS.packages) for package in source.packages]
            if None not in folders:
                found[name] = folders
        if not found:
            self.skipTest("no package of SOURCES is installed; apt-get install fonts-roboto-unhinted")
        if OPTIONS.packages is None:
            smallest = min(found, key=lambda name: (SETS / f"{name}.csv").stat().st_size)
            found = {smallest: found[smallest]}
        for name, folders in found.items():
            with self.subTest(name):
                for file, text in make_sets.make(name, OPTIONS.program, folders)[0].items():
                    self.assertTrue(text == (SETS / file).read_text(encoding="utf-8"), f"{file}: not what make_sets.py makes")

    def test_spans_of_a_spline_are_those_of_its_definition(self):
        """The quadratic B-spline with knots 0, 1, 2, 3 at its ends: (Piegl and Tiller 1997, chapter 2) its middle points are
        half-way between the poles where the spacing is even."""
        knots = [Fraction(u) for u in (0, 0, 0, 1, 2, 3, 3, 3)]
        poles = [[Fraction(x)] for x in (0, 4, 2, 6, 8)]
        spans = [[point[0] for point in span] for span in make_sets.bezier_spans(2, knots, poles)]
        self.assertEqual(spans, [[0, 4, 3], [3, 2, 4], [4, 6, 8]])

    def test_a_bezier_curve_is_its_own_span(self):
        poles = [[Fraction(x)] for x in (3, -1, 7, 5)]
        self.assertEqual(list(make_sets.bezier_spans(3, [Fraction(k) for k in (2, 2, 2, 2, 9, 9, 9, 9)], poles)), [poles])


class Outlines(unittest.TestCase):
    def test_glyph_outlines_are_those_of_the_fonts(self):
        outlines = module("glyph_outlines")
        if importlib.util.find_spec("fontTools") is None:
            self.skipTest("python3-fonttools is not installed")
        missing = [name for name in outlines.OUTLINED if not (outlines.FOLDER / f"{name}.ttf").is_file()]
        if missing:
            self.skipTest(f"{', '.join(missing)} not in {outlines.FOLDER}; install fonts-dejavu-core and fonts-dejavu-extra")
        made = io.StringIO()
        outlines.write_outlines(made)
        self.assertTrue(made.getvalue() == (HERE / "glyph_outlines.csv").read_text(encoding="utf-8"),
                        "not what glyph_outlines.py makes; run it, or install fonts-dejavu 2.37-6")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=Path)
    parser.add_argument("--packages", type=Path)
    parser.parse_known_args(namespace=OPTIONS)
    unittest.main(argv=sys.argv[:1])
