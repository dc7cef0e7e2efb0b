# SPDX-License-Identifier: MIT
"""The written files: numbers, offline page, LaTeX, determinism."""

import csv
import io
import re
import tempfile
import unittest
from html.parser import HTMLParser

from . import fixture, render
from .bundle import Bundle
from .chapters.first_glance import opening
from .chapters.parts import ROSTER
from .chapters.printed import figures
from .chapters.roster import build_all
from .findings.roster import find_all
from .fixture import evaluators, scorecards
from .fixture.comparison import write_comparison
from .wording import as_printed, general, scientific, shortest

OF_SETS = "real-curves"  # the chapter of a bundle with curve sets
VOID = {"meta", "link", "br"}


def files(change=None, without=()):
    with tempfile.TemporaryDirectory() as place:
        bundle = Bundle(fixture.write(f"{place}/b", change, without), write_comparison(f"{place}/c"))
        return render.files(bundle, *build_all(bundle, find_all(bundle)))


class Page(HTMLParser):
    """Tables by id as lists of cell texts, all ids and references, and whether tags balance."""

    def __init__(self, text):
        super().__init__()
        self.tables, self.ids, self.references, self.open, self.problems = {}, [], [], [], []
        self.table = self.cell = None
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if "id" in attrs:
            self.ids.append(attrs["id"])
        self.references += [v for k, v in attrs.items() if k in ("href", "src", "xlink:href", "srcset", "data", "action")]
        if tag not in VOID:
            self.open.append(tag)
        if tag == "table":
            self.table = self.tables.setdefault(attrs["id"], [])
        if tag == "tr" and self.table is not None:
            self.table.append([])
        if tag in ("td", "th") and self.table is not None:
            self.cell = ""

    def handle_startendtag(self, tag, attrs):
        attrs = dict(attrs)
        self.references += [v for k, v in attrs.items() if k in ("href", "src", "xlink:href")]
        if "id" in attrs:
            self.ids.append(attrs["id"])

    def handle_data(self, data):
        if self.cell is not None:
            self.cell += data

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.problems.append(f"</{tag}> at {self.getpos()}")
        if tag in ("td", "th") and self.cell is not None:
            self.table[-1].append(self.cell)
            self.cell = None
        if tag == "table":
            self.table = None


class WrittenFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.files = files()
        cls.html = cls.files["report.html"].decode()
        cls.page = Page(cls.html)

    def test_every_chapter_is_there(self):
        self.assertEqual([one.id for one in ROSTER if one.id != OF_SETS and f'<h2 id="{one.id}"' not in self.html], [])

    def test_numbers_of_the_page_are_those_of_the_csv(self):
        write = {"published": as_printed, "ours_median": scientific, "continuous_median": scientific,
                 "against_exact": scientific}
        label = {"published": "published", "ours, median": "ours_median", "continuous inputs": "continuous_median",
                 "against exact": "against_exact", "verdict": "verdict"}
        for number in ("2.3.1", "2.3.2", "2.3.3"):
            for curve in evaluators.PATHS:
                name = f"table-{number}-{curve}"
                held = list(csv.reader(io.StringIO(self.files[f"tables/{name}.csv"].decode())))
                self.assertEqual(held[0][3:], self.page.tables[name][0][2:])
                groups = iter({(r[0], r[1]): None for r in held[1:]})
                for row in self.page.tables[name][1:]:
                    if len(row) == len(held[0]) - 1:
                        group, row = next(groups), row[1:]
                    if row[0] not in label:
                        continue
                    want = next(r[3:] for r in held[1:] if (r[0], r[1]) == group and r[2] == label[row[0]])
                    if row[0] == "verdict":
                        self.assertEqual([c.split()[-1] for c in row[1:]], want)
                    else:
                        self.assertEqual(row[1:], [write[label[row[0]]](float(v)) for v in want])

    def test_csv_holds_the_digits_of_the_bundle(self):
        rows = {tuple(r[:3]): r[3:] for r in csv.reader(io.StringIO(self.files["tables/table-2.3.1-bernstein.csv"].decode()))}
        want = [str(r["ours_median"]) for r in scorecards.scorecard() if r["table"] == "2.3.1" and r["form"] == "bernstein"
                and r["method"] == "de_casteljau" and r["statistic"] == "mean_error"]
        self.assertEqual(rows["de_casteljau", "mean_error", "ours_median"], want)

    def test_page_is_one_offline_file(self):
        self.assertNotRegex(self.html, r"(?i)https?://(?!www\.w3\.org/2000/svg)|<script (?!type=\"application/json\" id=\"page-data\")|@import|url\((?!#)")
        for reference in self.page.references:
            if (link := re.fullmatch(r"(tables/[\w.-]+\.(csv|tex))", reference)):
                self.assertIn(link[1], self.files)
                continue
            self.assertRegex(reference, r"^(#|data:)")
            if reference.startswith("#"):
                self.assertIn(reference[1:], self.page.ids)

    def test_page_is_well_formed(self):
        self.assertEqual(self.page.problems + self.page.open, [])
        self.assertEqual(len(self.page.ids), len(set(self.page.ids)))
        self.assertEqual(self.html.count("<svg"), self.html.count('role="img"'))
        self.assertEqual(self.html.count("<svg"), sum(name.endswith(".svg") for name in self.files))

    def test_page_is_whole_without_script(self):
        self.assertGreater(len(self.page.tables["answer-table"]), 2)
        self.assertGreater(sum(map(len, self.page.tables.values())), 100)
        self.assertRegex(self.html, r'id="answer-sentence"[^>]*>[^<]{20}')
        self.assertNotRegex(self.html, r"<(button|input|select)\b")

    def test_bundle_text_is_escaped(self):
        self.assertIn("none &amp; &lt;none&gt;", self.html)
        self.assertIn(r"none \& \textless{}none\textgreater{}", self.files["tables/provenance-bundle.tex"].decode())

    def test_captions_are_bilingual(self):
        for name in self.page.tables:
            if name.startswith("table-"):
                self.assertRegex(self.html, rf'<table id="{re.escape(name)}"[^>]*>\s*<caption>.*Table .*lang="zh-Hans">表')

    def test_latex_is_regular(self):
        special = re.compile(r"(?<!\\)[#$_^~%]")
        for name, data in self.files.items():
            if not name.endswith(".tex"):
                continue
            text = data.decode()
            with self.subTest(name):
                body = text[text.index(r"\hline"):text.index(r"\end{longtable}")].replace(r"$\approx$", "").replace(r"$\le$", "")
                self.assertNotRegex(body, special)
                bare = re.sub(r"\\[{}]", "", text)
                self.assertEqual(bare.count("{"), bare.count("}"))
                columns = len(re.search(r"\\begin\{longtable\}\{(.*)\}\n", text)[1].replace("p{65mm}", "l"))
                for line in body.splitlines():
                    if line.endswith(r"\\") and not line.startswith(r"\multicolumn"):
                        self.assertEqual(len(re.findall(r"(?<!\\)&", line)), columns - 1)

    def test_figures_carry_no_date_and_printed_points(self):
        for name, data in self.files.items():
            if name.endswith(".svg"):
                self.assertNotRegex(data, rb"(?i)dc:date|matplotlib v")
                self.assertTrue(data.startswith(b"<?xml"))
            if name.endswith(".png"):
                self.assertTrue(data.startswith(b"\x89PNG"))
        self.assertGreaterEqual(sum(name.startswith("figures/") for name in self.files), 12)

    def test_markdown_tables_are_regular(self):
        width = None
        for line in self.files["report.md"].decode().splitlines():
            cells = len(re.findall(r"(?<!\\)\|", line)) if line.startswith("|") else None
            if cells is not None and width is not None:
                self.assertEqual(cells, width, line)
            width = cells

    def test_missing_files_are_said(self):
        made = files(without=tuple(fixture.FILES))
        bare, words = made["report.html"].decode(), made["report.md"].decode()
        self.assertEqual(Page(bare).problems, [])
        line = next(line for line in words.splitlines() if line.startswith("Left out"))
        for absent in ("scorecard.csv", "accuracy.csv", "timing.csv"):
            self.assertIn(f"the bundle has no `{absent}`", line)

    def test_missing_rows_leave_a_figure_out(self):
        with tempfile.TemporaryDirectory() as place:
            bundle = Bundle(fixture.write(f"{place}/b", lambda at, row: row["table"] not in ("2.3.3", "2.4") if at.startswith("scorecard") else None))
            blocks = list(figures(bundle, ([], [])))
        self.assertNotIn("error-against-interval", [block.id for block in blocks if block.kind == "figure"])
        self.assertTrue(any(block.kind == "text" and "The figure error against interval is left out" in block.text for block in blocks))

    def test_partial_bundle_is_said(self):
        with tempfile.TemporaryDirectory() as place:
            bundle = Bundle(fixture.write(f"{place}/b"))
            bundle.info["state"] = "partial"
            self.assertIn("The state of this bundle is partial", next(opening(bundle, ([], []))).text)


class Wording(unittest.TestCase):
    def test_numbers(self):
        self.assertEqual(scientific(6.92e-11), "6.92e-11")
        self.assertEqual(scientific(0.0), "0")
        self.assertEqual([shortest(v) for v in (1e-6, 0.0001, 1.0, 1e6, 0.2, 0.00364)],
                         ["1e-6", "1e-4", "1", "1e6", "0.2", "3.64e-3"])
        self.assertEqual([as_printed(v) for v in (0.054, 1e-15, 0.0446)], ["0.054", "1.00e-15", "4.46e-2"])
        self.assertEqual([general(v) for v in (12.0, 0.7544, 14.02, 697482.5, 4.83e7)],
                         ["12", "0.754", "14.0", "6.97e5", "4.83e7"])


if __name__ == "__main__":
    unittest.main()
