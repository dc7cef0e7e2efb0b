#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds CONTRIBUTING.md and the pages for contributors to the sources.

adding_test.py --compiler CXX [--include FOLDER]... --kind PROGRAM

The diff of CONTRIBUTING.md is applied to a copy of core; the program below it is compiled against this copy and must print what the
page shows. PROGRAM is compiled with docs/adding/enclosure.diff: it must have the kind that this diff adds. Every link of a page must lead somewhere, and every file that a page for contributors names must exist.
"""
import argparse
import csv
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
import snippets_test  # noqa: E402
import sources  # noqa: E402

PAGE = ROOT / "CONTRIBUTING.md"
READMES = [ROOT / folder / "README.md" for folder in ("core", "core/evaluate", "core/batch", "reference", "experiments", "report")]
FOR_CONTRIBUTORS = [PAGE, ROOT / "docs/design.md", *sorted((ROOT / "docs/adding").glob("*.md")), *READMES]
LINK = re.compile(r"\]\((?!https?:)([^)#\s]+)(?:#[^)]*)?\)")
NAMED = re.compile(r"`([\w./-]+/[\w.-]+|[\w-]+\.(?:hpp|cpp|py))`")
PLACES = ("", "experiments", "core/evaluate")  # folders that names on these pages may begin in
ARGUMENTS = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
ARGUMENTS.add_argument("--compiler", default="c++")
ARGUMENTS.add_argument("--include", action="append", default=[])
ARGUMENTS.add_argument("--kind", type=Path, required=True)
KIND_DIFF = ROOT / "docs/adding/enclosure.diff"
KIND_SUITE = """schema_version = 1
[suite]
id = "boxes"
title = "Boxes"
[[study]]
id = "boxes"
kind = "enclosure"
degree = [1, 3]
points = [17]
trials = 50
[[study]]
id = "boxes-time"
kind = "timing"
methods = ["points_enclosure"]
degree = [3]
points = [17]
modes = ["one_shot"]
"""


def block(language):
    return re.search(rf"^```{language}\n(.*?)^```$", PAGE.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)[1]


def is_there(name, page):
    """A name with a folder begins in one of PLACES, or beside the page; a bare name may stand in any folder."""
    if "/" not in name:
        return any(next((ROOT / folder).rglob(name), None) for folder in ("core", "reference", "experiments", "report", "bindings"))
    return any((place / name).exists() for place in (page.parent, *(ROOT / one for one in PLACES)))


class Evaluator(unittest.TestCase):
    options = None

    def test_the_diff_makes_a_method(self):
        with tempfile.TemporaryDirectory(prefix="bezierbench-adding-") as folder:
            place = Path(folder)
            shutil.copytree(ROOT / "core", place / "core")
            subprocess.run(["patch", "-p1", "--fuzz=0", "--no-backup-if-mismatch"], cwd=place, input=block("diff"), text=True, check=True,
                           stdout=subprocess.DEVNULL)
            added = {path.relative_to(place).as_posix() for path in place.rglob("*.hpp")
                     if not (ROOT / path.relative_to(place)).exists() and path.is_file()}
            self.assertEqual(len(added), 1, "an evaluator is one header")
            header = added.pop()
            self.assertIn(header, sources.method_headers(place), "the roster does not include the header of a method")
            text = (place / header).read_text(encoding="utf-8")
            keys = sources.keys_of((ROOT / sources.SOURCES).read_text(encoding="utf-8"))
            self.assertEqual([*sources.header_findings(header, text), *sources.citation_findings(header, text, keys),
                              *sources.line_findings(header, text)], [])
            (place / "program.cpp").write_text(block("cpp"), encoding="utf-8")
            subprocess.run([*self.options.compiler.split(), "-std=c++20", "-O1", *snippets_test.WARNINGS, "-I.",
                            *(f"-isystem{one}" for one in self.options.include), "program.cpp", "-o", "program"], cwd=place, check=True)
            printed = subprocess.run(["./program"], cwd=place, check=True, capture_output=True, text=True).stdout
        self.assertEqual(printed, block("text"))


class Kind(unittest.TestCase):
    options = None

    def answer(self, *arguments, **more):
        return subprocess.run([self.options.kind, *arguments], check=True, capture_output=True, text=True, **more).stdout

    def test_the_diff_makes_a_kind(self):
        self.assertIn("enclosure: boxes around curves", self.answer("list", "kinds"))
        self.assertIn("points: numbers of exact points", self.answer("list", "kinds", "enclosure"))
        self.assertIn("points_enclosure,enclosure,", self.answer("list", "methods", "--format", "csv"))
        with tempfile.TemporaryDirectory(prefix="bezierbench-kind-") as folder:
            (Path(folder) / "boxes.toml").write_text(KIND_SUITE, encoding="utf-8")
            self.answer("run", "boxes.toml", "--quiet", "--out", "boxes", cwd=folder)
            self.answer("verify", "boxes", cwd=folder)
            with open(Path(folder) / "boxes/enclosure.csv", newline="", encoding="utf-8") as text:
                rows = {(row["method"], row["degree"]): row for row in csv.DictReader(text)}
            with open(Path(folder) / "boxes/timing.csv", newline="", encoding="utf-8") as text:
                self.assertIn("points_enclosure", {row["method"] for row in csv.DictReader(text)})
        # A curve is inside the hull of its control points; a line is the box's diagonal; a cubic mostly leaves that of its ends.
        for box in (("points_enclosure", "1"), ("points_enclosure", "3"), ("ends_enclosure", "1")):
            self.assertEqual((rows[box]["max_error"], rows[box]["outside"]), ("0", "0"), box)
        self.assertGreater(int(rows["ends_enclosure", "3"]["outside"]), 25)

    def test_the_page_shows_the_files_of_the_diff(self):
        shown = subprocess.run(["git", "apply", "--stat", KIND_DIFF], check=True, capture_output=True, text=True, cwd=ROOT).stdout
        self.assertIn(f"```text\n{shown}```", (ROOT / "docs/adding/study_kind.md").read_text(encoding="utf-8"))
        outside = [line for line in shown.splitlines() if "/enclosure/" not in line and "|" in line]
        self.assertLessEqual(len(outside), 8)


class Pages(unittest.TestCase):
    def test_contributing_is_short(self):
        self.assertLessEqual(len(PAGE.read_text(encoding="utf-8").split()), 900)

    def test_links_lead_somewhere(self):
        pages = {ROOT / "README.md", *(ROOT / "docs").rglob("*.md"), *FOR_CONTRIBUTORS}
        broken = [f"{page.relative_to(ROOT)}: {target}" for page in sorted(pages)
                  for target in LINK.findall(page.read_text(encoding="utf-8")) if not (page.parent / target).exists()]
        self.assertEqual(broken, [])

    def test_named_files_exist(self):
        missing = [f"{page.relative_to(ROOT)}: {name}" for page in FOR_CONTRIBUTORS
                   for name in NAMED.findall(page.read_text(encoding="utf-8"))
                   if not name.startswith("build/") and not is_there(name, page)]
        self.assertEqual(missing, [])


if __name__ == "__main__":
    Evaluator.options, rest = ARGUMENTS.parse_known_args()
    Kind.options = Evaluator.options
    unittest.main(argv=[sys.argv[0], *rest])
