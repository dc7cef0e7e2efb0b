# SPDX-License-Identifier: MIT
"""The written files: numbers, offline page, Markdown, LaTeX; also of a bundle in which every text that is free is an attack."""

import base64
import csv
import hashlib
import io
import json
import re
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

from . import fixture, schema, script, summary
from .bundle import Bundle
from .chapters.first_glance import opening
from .chapters.parts import ROSTER
from .chapters.printed import figures
from .findings.roster import find_all
from .fixture import FACT, evaluators
from .inline import visible
from .wording import as_printed, general, scientific, shortest

OF_SETS = "real-curves"  # the chapter of a bundle with curve sets
VOID = {"meta", "link", "br", "wbr"}


class Page(HTMLParser):
    """All tags with their attributes, the text between them, tables by id as lists of cell texts, and whether tags balance."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.text, self.tables, self.open, self.problems = [], "", {}, [], []
        self.table = self.cell = None
        self.feed(text)
        self.close()

    def attributes(self, *names):
        return [value for _, attrs in self.tags for name, value in attrs if name in names]

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, attrs))
        if tag not in VOID:
            self.open.append(tag)
        if tag == "table":
            self.table = self.tables.setdefault(dict(attrs)["id"], [])
        if tag == "tr" and self.table is not None:
            self.table.append([])
        if tag in ("td", "th") and self.table is not None:
            self.cell = ""

    def handle_startendtag(self, tag, attrs):
        self.tags.append((tag, attrs))

    def handle_data(self, data):
        self.text += data
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


class Written:
    """What holds for the files of any bundle."""

    @classmethod
    def take(cls, files):
        cls.files = files
        cls.html = files["report.html"].decode()
        cls.page = Page(cls.html)

    def test_page_is_well_formed(self):
        ids = self.page.attributes("id")
        self.assertEqual(self.page.problems + self.page.open, [])
        self.assertEqual(len(ids), len(set(ids)))
        self.assertEqual(self.html.count("<svg"), self.html.count('role="img"'))
        self.assertEqual(self.html.count("<svg"), sum(name.endswith(".svg") for name in self.files))

    def test_page_is_one_offline_file(self):
        """It has no tag or attribute that loads or runs anything but its own script, nor a control, without which it is whole."""
        self.assertFalse({tag for tag, _ in self.page.tags} & {"img", "form", "base", "iframe", "object", "embed", "b", "button", "input", "select"})
        self.assertEqual([attrs for tag, attrs in self.page.tags if tag == "script"], [[("type", "application/json"), ("id", "page-data")], []])
        self.assertEqual([attrs[0][0] for tag, attrs in self.page.tags if tag == "meta"], ["charset", "name", "name", "http-equiv"])
        for tag, attrs in self.page.tags:
            for name, value in attrs:
                self.assertFalse(name.startswith("on") or name in ("src", "srcset", "srcdoc", "data", "action", "formaction"), (tag, name))
                if name == "id":
                    self.assertRegex(value, r"^[A-Za-z0-9][\w.-]*$")
        ids = set(self.page.attributes("id"))
        for reference in self.page.attributes("href", "xlink:href"):
            self.assertRegex(reference, r"^(#[\w.-]+|data:,|tables/[A-Za-z0-9][\w.-]*\.(csv|tex))$")
            if reference.startswith("#"):
                self.assertIn(reference[1:], ids)
            elif reference.startswith("tables/"):
                self.assertIn(reference, self.files)

    def test_markdown_tables_are_regular(self):
        width = None
        for line in self.files["report.md"].decode().splitlines():
            cells = len(re.findall(r"(?<!\\)\|", line)) if line.startswith("|") else None
            if cells is not None and width is not None:
                self.assertEqual(cells, width, line)
            width = cells

    def test_latex_is_regular_and_runs_nothing(self):
        known = {*"textbackslash & % $ # _ { } textasciitilde textasciicircum textless textgreater textbar textmu ldots textquotedbl textasciigrave "
                 r"quad texttt textbf multicolumn hline endhead \ begin end le ge times approx nopagebreak '".split()}
        for name, data in self.files.items():
            if not name.endswith(".tex"):
                continue
            text = data.decode()
            body = text[text.index(r"\begin{center}"):text.index(r"\endgroup")]
            rows = body[body.index(r"\hline"):body.index(r"\end{longtable}")]
            with self.subTest(name):
                self.assertLessEqual(set(re.findall(r"\\([a-zA-Z]+|[^a-zA-Z])", body)), known)
                bare = re.sub(r"\\[^a-zA-Z]", "", body)
                self.assertEqual(bare.count("{"), bare.count("}"))
                self.assertNotRegex(re.sub(r"\$\\(le|ge|times|approx)\$", "", bare), r"[$#~^%]")
                columns = len(re.search(r"\\begin\{longtable\}\{(.*)\}\n", text)[1].replace("p{65mm}", "l"))
                for line in rows.splitlines():
                    if line.endswith(r"\\") and not line.startswith(r"\multicolumn"):
                        self.assertEqual(len(re.findall(r"(?<!\\)&", line)), columns - 1)


class WrittenFiles(Written, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.take(fixture.rendered(fixture.bundle(comparison={})))

    def test_every_chapter_is_there(self):
        self.assertEqual([one.id for one in ROSTER if one.id != OF_SETS and f'<h2 id="{one.id}"' not in self.html], [])

    def test_numbers_of_the_page_are_those_of_the_csv(self):
        label = {"published": ("published", as_printed), "ours, median": ("ours_median", scientific),
                 "continuous inputs": ("continuous_median", scientific), "against exact": ("against_exact", scientific)}
        for number in ("2.3.1", "2.3.2", "2.3.3"):
            for curve in evaluators.PATHS:
                name = f"table-{number}-{curve}"
                head, *rows = csv.reader(io.StringIO(self.files[f"tables/{name}.csv"].decode()))
                self.assertEqual(head[3:], self.page.tables[name][0][2:])
                groups = iter(dict.fromkeys((r[0], r[1]) for r in rows))
                for row in self.page.tables[name][1:]:
                    if len(row) == len(head) - 1:
                        group, row = next(groups), row[1:]
                    wanted = {r[2]: r[3:] for r in rows if (r[0], r[1]) == group}
                    if row[0] == "verdict":
                        self.assertEqual([c.split()[-1] for c in row[1:]], wanted["verdict"])
                    elif row[0] in label:
                        quantity, write = label[row[0]]
                        self.assertEqual(row[1:], [write(float(v)) for v in wanted[quantity]])

    def test_csv_holds_the_digits_of_the_bundle(self):
        rows = {tuple(r[:3]): r[3:] for r in csv.reader(io.StringIO(self.files["tables/table-2.3.1-bernstein.csv"].decode()))}
        want = [str(r["ours_median"]) for r in evaluators.scorecard() if r["table"] == "2.3.1" and r["form"] == "bernstein"
                and r["method"] == "de_casteljau" and r["statistic"] == "mean_error"]
        self.assertEqual(rows["de_casteljau", "mean_error", "ours_median"], want)

    def test_page_is_whole_without_script_and_network(self):
        self.assertNotRegex(self.html, r"(?i)https?://(?!www\.w3\.org/2000/svg)|@import|url\((?!#)")
        self.assertGreater(len(self.page.tables["answer-table"]), 2)
        self.assertGreater(sum(map(len, self.page.tables.values())), 100)
        self.assertRegex(self.html, r'id="answer-sentence"[^>]*>[^<]{20}')

    def test_captions_are_bilingual(self):
        for name in self.page.tables:
            if name.startswith("table-"):
                self.assertRegex(self.html, rf'<table id="{re.escape(name)}"[^>]*>\s*<caption>.*Table .*lang="zh-Hans">表')

    def test_figures_carry_no_date(self):
        for name, data in self.files.items():
            if name.endswith(".svg"):
                self.assertNotRegex(data, rb"(?i)dc:date|matplotlib v")
                self.assertTrue(data.startswith(b"<?xml"))
        self.assertGreaterEqual(sum(name.startswith("figures/") for name in self.files), 12)

    def test_missing_files_are_said(self):
        made = fixture.rendered(fixture.bundle(without=tuple(fixture.FILES)))
        self.assertEqual(Page(made["report.html"].decode()).problems, [])
        line = next(line for line in made["report.md"].decode().splitlines() if line.startswith("Left out"))
        for absent in ("scorecard.csv", "accuracy.csv", "timing.csv"):
            self.assertIn(f"the bundle has no `{absent}`", line)

    def test_missing_rows_leave_a_figure_out(self):
        bundle = fixture.bundle(lambda at, row: row["table"] not in ("2.3.3", "2.4") if at.startswith("scorecard") else None)
        blocks = list(figures(bundle, ([], [])))
        self.assertNotIn("error-against-interval", fixture.of_kind(blocks, "figure"))
        self.assertTrue(any(block.kind == "text" and "The figure error against interval is left out" in block.text for block in blocks))

    def test_partial_bundle_is_said(self):
        bundle = fixture.bundle()
        bundle.info["state"] = "partial"
        self.assertIn("The state of this bundle is partial", next(opening(bundle, ([], []))).text)

    def test_numbers_are_written_as_the_report_writes_them(self):
        self.assertEqual([scientific(6.92e-11), scientific(0.0)], ["6.92e-11", "0"])
        self.assertEqual([shortest(v) for v in (1e-6, 0.0001, 1.0, 1e6, 0.2, 0.00364)], ["1e-6", "1e-4", "1", "1e6", "0.2", "3.64e-3"])
        self.assertEqual([as_printed(v) for v in (0.054, 1e-15, 0.0446)], ["0.054", "1.00e-15", "4.46e-2"])
        self.assertEqual([general(v) for v in (12.0, 0.7544, 14.02, 697482.5, 4.83e7)], ["12", "0.754", "14.0", "6.97e5", "4.83e7"])


EVIL = ('"><script>x</script><img src=//x onerror=y><meta http-equiv=refresh content="0;url=//x"><form action=//x><base href=//x>'
        "</style></title></svg> `c`` <b> ** [t](javascript:x) ![i](//x/y) | https://x.invalid www.x.invalid $\\write18{x}$ "
        "\\input{/etc/passwd} ^^5c % # _ ~ & \x1b[2J \u202e \u2028 '{{ 7 * 7 }}")
SHOWN = ("truth-bezier", "2.4-bezier", "worst-bezier")  # few figures, which take long to draw


def _evil_bundle(place, suite):
    """Hostile wherever a reader of bundles takes any text."""
    def change(at, row):
        if row.get("study", SHOWN[0]) not in SHOWN:
            return False
        row.update({c: EVIL.replace("\u2028", "") for c in ("note", "citation", "flops", "bound", "form", "quality", "status", "claimed_by")
                    if c in row and "word" in schema.types(at, c)
                    and at in ("scorecard.csv", "scorecard_timing.csv", "methods.csv", "timing.csv", "search.csv")})
        if at == "methods.csv":
            row["id"] = f"{row['id']}{EVIL}" if row["problem"] == "conversion" else row["id"]
        return True
    bundle = fixture.write(place, change, suite=suite)
    info = {**fixture.INFO, "seed": EVIL, "state": EVIL, "git_commit": EVIL, EVIL: {EVIL: [EVIL, {EVIL: 1}]}}
    (bundle / "bundle.json").write_text(json.dumps(info))
    (bundle / "machine.json").write_text(json.dumps({"cpu": {"model_name": EVIL}, "peers": {EVIL: EVIL}}))
    return fixture.seal(bundle)


class Hostile(Written, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as place:
            bundle = Bundle(_evil_bundle(Path(place) / f"b{EVIL[:60].replace('/', '')}", fixture.suite_toml(**{"2.4-bezier": EVIL})),
                            fixture.write_comparison(f"{place}/c", facts=({**FACT, "against": EVIL, "fact": EVIL, "a": EVIL},)))
        cls.summary = summary.text(bundle, find_all(bundle))
        cls.take(fixture.rendered(bundle))

    def test_texts_are_shown(self):
        self.assertIn("<script>x</script>", self.page.text)

    def test_the_policy_forbids_what_a_slip_could_let_in(self):
        policy = dict(part.strip().split(" ", 1) for part in re.search(r'Content-Security-Policy" content="([^"]+)"', self.html)[1].split(";"))
        own = re.search(r"<script>(.*?)</script>", self.html, re.S)[1]
        digest = base64.b64encode(hashlib.sha256(own.encode()).digest()).decode()
        self.assertEqual(policy, {"default-src": "'none'", "script-src": f"'sha256-{digest}'", "style-src": "'unsafe-inline'", "img-src": "data:",
                                  "base-uri": "'none'", "form-action": "'none'"})

    def test_the_data_of_the_script_is_inert(self):
        """What a bundle says comes back from the block as it is, and cannot end it."""
        block = re.search(r'<script type="application/json" id="page-data">(.*?)</script>', self.html, re.S)[1]
        self.assertNotRegex(block, "[<>&\u2028\u2029]")
        self.assertEqual(script.block("</script><!--&\u2028").encode(), b'"\\u003c/script\\u003e\\u003c!--\\u0026\\u2028"')
        self.assertEqual(json.loads(block)["bundle"], "BUNDLE")
        for name in script.FOLDER.glob("*.js"):
            self.assertNotRegex(name.read_text(), r"innerHTML|outerHTML|insertAdjacent|document\.write|\beval\b|new Function|fetch\(|XMLHttp|import\(")

    def test_markdown_is_text(self):
        """Left when all escapes and all code are taken away: nothing that Markdown or HTML reads as markup, but our own."""
        text = self.files["report.md"].decode()
        self.assertIn("script", text)
        left = re.sub(r"\\[^\w\s]", "", text)
        left = re.sub(r"(?<!`)(`+)(?!`).*?(?<!`)\1(?!`)", "", left)
        left = re.sub(r'</?sub>|<a id="[\w-]+"></a>', "", left)
        left = re.sub(r"^(- \[[^\]\[]*\]\(#[\w-]+\)|!\[[^\]\[]*\]\(figures/[\w.-]+\.svg\))$", "", left, flags=re.M)
        for markup in ("<", "[", "](", "`", "://", "www.", "$"):
            at = left.find(markup)
            self.assertEqual(at, -1, left[max(at - 50, 0):at + 50])

    def test_nothing_acts_on_a_terminal_or_ends_a_line(self):
        self.assertIsNone(re.search("[\0-\x08\x0b-\x1f\x7f\u202e\u2028]", self.summary))
        self.assertEqual(visible("a\nb\x1b[2J\r\u2028\ud800"), r"a\nb\x1b[2J\r\u2028\ud800")


class HostileSuite(Written, unittest.TestCase):
    """Chapters of suites that nobody knows show the same texts."""

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as place:
            path = _evil_bundle(Path(place) / "b", f'[suite]\nid = "mine"\ntitle = {json.dumps(EVIL)}\n')
            cls.take(fixture.rendered(Bundle(path).only({"truth-bezier", "2.4-bezier"})))


if __name__ == "__main__":
    unittest.main()
