# SPDX-License-Identifier: MIT
"""The report's page lists the methods of methods.csv. The CTest `readme` compares docs/methods.md with what the program lists."""

import csv
import html
import re
import tempfile
import unittest
from pathlib import Path

from . import fixture, render
from .bundle import Bundle
from .chapters.provenance import method_list
from .chapters.roster import build_all
from .document import Chapter

ROOT = Path(__file__).resolve().parent.parent


def cells(markdown, heading):
    """Rows of the first table of a Markdown text whose first heading is `heading`, without escapes."""
    lines = iter(markdown.splitlines())
    found = [next(line for line in lines if line.startswith(f"| {heading} |"))]
    for line in lines:
        if not line.startswith("|"):
            break
        found.append(line)
    split = [[c.strip() for c in re.split(r"(?<!\\)\|", line)[1:-1]] for line in found if not re.match(r"\|[-: |]+$", line)]
    return [[html.unescape(re.sub(r"\\([^\w\s])", r"\1", c.replace(r"\_", "_"))) for c in line] for line in split]


def page(bundle):
    chapter = Chapter("methods", "The methods", tuple(method_list(bundle, ([], []))))
    return render.files(bundle, [chapter], [])


class Methods(unittest.TestCase):
    def test_report_and_list_show_the_same(self):
        made = page(Bundle(ROOT / "results" / "baseline"))
        readme = (ROOT / "docs/methods.md").read_text(encoding="utf-8").split("<!-- begin methods -->")[1]
        in_report = cells(made["report.md"].decode(), "id")
        self.assertEqual(cells(readme, "id")[0], in_report[0])
        with open(ROOT / "results" / "baseline" / "methods.csv", newline="", encoding="utf-8") as file:
            listed = [row for row in csv.DictReader(file) if ":" not in row["id"]]
        self.assertGreater(len(listed), 20)
        self.assertEqual([(row[0], row[1], row[-1]) for row in in_report[1:]],
                         [(f"`{row['id']}`", row["form"], row["citation"]) for row in listed])
        self.assertEqual([row[0] for row in list(csv.reader(made["tables/methods.csv"].decode().splitlines()))[1:]],
                         [row["id"] for row in listed])

    def test_an_id_may_stand_once_per_form(self):
        with tempfile.TemporaryDirectory() as place:
            path = fixture.write(f"{place}/b")
            with open(path / "methods.csv", "a", encoding="utf-8") as file:
                file.write("direct,evaluation,rational,0,170,,yes,n | n,none\n")
            fixture.seal(path)
            bundle = Bundle(path)
            rows = [row for row in cells(page(bundle)["report.md"].decode(), "id") if row[0] == "`direct`"]
        self.assertEqual([(row[1], row[3], row[4]) for row in rows],
                         [("bernstein", "n", "gamma_3n p~"), ("rational", "n | n", "none")])

    def test_the_page_has_the_chapter(self):
        with tempfile.TemporaryDirectory() as place:
            chapters, _ = build_all(Bundle(fixture.write(f"{place}/b")), ([], []))
        self.assertIn("method-list", [chapter.id for chapter in chapters])


if __name__ == "__main__":
    unittest.main()
