# SPDX-License-Identifier: MIT
"""What is written: whole or not at all, into its own directory, under names that nobody else chose."""

import tempfile
import unittest
from pathlib import Path
from unittest import mock

from . import fixture, output
from .bundle import BundleError
from .chapters.roster import build_all
from .document import SAFE, Chapter, Table, unique, with_unique_ids
from .fixture import changed, of_kind


def names(folder):
    return sorted(path.name for path in Path(folder).iterdir())


class Output(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def test_failure_leaves_the_old_files_and_makes_no_directory(self):
        output.write(self.place, {"a/x": b"old", "y": b"old"})
        for folder in (self.place, self.place / "out"):
            with self.assertRaises(TypeError):
                output.write(folder, {"a/x": b"new", "y": None})
        self.assertEqual((self.place / "a/x").read_bytes(), b"old")
        self.assertEqual(names(self.place), ["a", "y"])

    def test_the_pages_come_last(self):
        output.write(self.place, {"report.html": b"old"})
        moved = []
        with mock.patch.object(output.os, "replace", lambda source, target: moved.append(target.name)):
            output.write(self.place, {"report.html": b"", "tables/a.csv": b"", "report.md": b"", "figures/a.svg": b""})
        self.assertEqual(set(moved[:2]), {"a.csv", "a.svg"})
        self.assertEqual(set(moved[2:]), {"report.html", "report.md"})

    def test_a_name_that_leads_elsewhere_is_refused(self):
        for name in ("../x", "/x", "a/../x", "a/b/x", ".x", "a/.x", "", "a\nb", "tables/"):
            with self.assertRaises(ValueError, msg=name):
                output.write(self.place / "out", {name: b""})
        self.assertEqual(names(self.place), [])


class Names(unittest.TestCase):
    def test_are_safe_and_unique(self):
        taken = set()
        given = ["a", "a", "A", "a-2", "../a", "/a", "", "...", "a b", "a_b", "é" * 300, "é" * 301, "x" * 500]
        found = [unique(name, taken) for name in given]
        self.assertEqual(len({name.casefold() for name in found}), len(given))
        for name in found:
            self.assertTrue(SAFE.fullmatch(name) and len(name) < 200, name)
        self.assertEqual(found[0], "a")

    def test_tables_take_no_name_of_the_page(self):
        table = Table(id="content", caption="", head=(), groups=())
        chapter, = with_unique_ids([Chapter("one", "One", (table, table))])
        self.assertEqual(len({*(block.id for block in chapter.blocks), "content", "one"}), 4)

    def test_studies_that_differ_by_a_number_keep_their_tables(self):
        """The second table of a study and the first of another once had the same file."""
        def double_studies(at, row):
            if row["study"] == "2.4-bezier":
                row["study"], row["scalar"] = "a", "float" if row["degree"] == 20 else "double"
            elif row["study"] == "peers-speed":
                row["study"] = "a-2"
        fixture.without_figures(self)
        chapters, _ = build_all(fixture.bundle(double_studies, [f for f in fixture.FILES if f != "timing.csv"]), ([], []))
        tables = [id for chapter in chapters for id in of_kind(chapter.blocks, "table")]
        self.assertEqual(len({id.casefold() for id in tables}), len(tables))
        self.assertLessEqual({"timing-a-1", "timing-a-2", "timing-a-2-2"}, set(tables))

    def test_an_id_that_no_suite_takes_is_refused(self):
        for file, column, word in (("accuracy.csv", "study", "x/../../../y"), ("worst.csv", "worst_id", "w1; rm x"), ("timing.csv", "study", "a b"),
                                   ("pareto.csv", "accuracy_study", "../x"), ("accuracy.csv", "method", "a`b"), ("audit.csv", "study", "é")):
            with self.assertRaisesRegex(BundleError, f"{file}:2: `{column}` is .*, which is not an id", msg=word):
                fixture.bundle(changed(file, {column: word}))


if __name__ == "__main__":
    unittest.main()
