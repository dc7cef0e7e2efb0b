# SPDX-License-Identifier: MIT
"""A bundle in which every text that is free is an attack: no page, table or message does what it says."""

import base64
import hashlib
import json
import re
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

from . import fixture, render, schema, script, summary
from .bundle import Bundle
from .chapters.roster import build_all
from .findings.roster import find_all
from .fixture.comparison import FACTS, write_comparison
from .inline import visible

EVIL = ('"><script>x</script><img src=//x onerror=y><meta http-equiv=refresh content="0;url=//x"><form action=//x><base href=//x>'
        "</style></title></svg> `c`` <b> ** [t](javascript:x) ![i](//x/y) | https://x.invalid www.x.invalid $\\write18{x}$ "
        "\\input{/etc/passwd} ^^5c % # _ ~ & \x1b[2J \u202e \u2028 '{{ 7 * 7 }}")
SHOWN = ("truth-bezier", "2.4-bezier", "worst-bezier")  # few figures, which take long to draw
ALLOWED_META = ["charset", "name", "name", "http-equiv"]


def evil_bundle(place):
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
    bundle = fixture.write(place, change)
    info = {**fixture.INFO, "seed": EVIL, "state": EVIL, "git_commit": EVIL, EVIL: {EVIL: [EVIL, {EVIL: 1}]}}
    (bundle / "bundle.json").write_text(json.dumps(info))
    (bundle / "machine.json").write_text(json.dumps({"cpu": {"model_name": EVIL}, "peers": {EVIL: EVIL}}))
    (bundle / "suite.toml").write_text(fixture.suite_toml(**{"2.4-bezier": EVIL}))
    return fixture.seal(bundle)


class Tags(HTMLParser):
    """Every tag with its attributes, and the text between them."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.text = [], ""
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, attrs))

    handle_startendtag = handle_starttag

    def handle_data(self, data):
        self.text += data


class Escaping(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        bundle = Bundle(evil_bundle(Path(place.name) / f"b{EVIL[:60].replace('/', '')}"), write_comparison(
            f"{place.name}/c", facts=({**FACTS[0], "against": EVIL, "fact": EVIL, "a": EVIL},)))
        found = find_all(bundle)
        cls.files = render.files(bundle, *build_all(bundle, found))
        cls.summary = summary.text(bundle, found)

    def test_html_has_no_tag_of_theirs(self):
        page = Tags(self.files["report.html"].decode())
        self.assertIn("<script>x</script>", page.text)
        kinds = {tag for tag, _ in page.tags}
        self.assertEqual([attrs for tag, attrs in page.tags if tag == "script"], [[("type", "application/json"), ("id", "page-data")], []])
        self.assertFalse(kinds & {"img", "form", "base", "iframe", "object", "embed", "b", "input", "button"}, kinds)
        self.assertEqual([attrs[0][0] for tag, attrs in page.tags if tag == "meta"], ALLOWED_META)
        for tag, attrs in page.tags:
            for name, value in attrs:
                self.assertFalse(name.startswith("on") or name in ("src", "srcdoc", "action", "formaction"), (tag, name))
                if name in ("href", "xlink:href"):
                    self.assertRegex(value, r"^(#[\w.-]+|data:,|tables/[A-Za-z0-9][\w.-]*\.(csv|tex))$")
                if name == "id":
                    self.assertRegex(value, r"^[A-Za-z0-9][\w.-]*$")

    def test_the_policy_forbids_what_a_slip_could_let_in(self):
        policy = dict(part.strip().split(" ", 1) for part in re.search(r'Content-Security-Policy" content="([^"]+)"',
                                                                       self.files["report.html"].decode())[1].split(";"))
        own = re.search(r"<script>(.*?)</script>", self.files["report.html"].decode(), re.S)[1]
        digest = base64.b64encode(hashlib.sha256(own.encode()).digest()).decode()
        self.assertEqual(policy, {"default-src": "'none'", "script-src": f"'sha256-{digest}'", "style-src": "'unsafe-inline'", "img-src": "data:", "base-uri": "'none'",
                                  "form-action": "'none'"})

    def test_the_data_of_the_script_is_inert(self):
        """What a bundle says comes back from the block as it is, and cannot end it."""
        page = self.files["report.html"].decode()
        block = re.search(r'<script type="application/json" id="page-data">(.*?)</script>', page, re.S)[1]
        self.assertNotRegex(block, "[<>&\u2028\u2029]")
        self.assertEqual(script.block("</script><!--&\u2028").encode(), b'"\\u003c/script\\u003e\\u003c!--\\u0026\\u2028"')
        self.assertEqual(json.loads(block)["bundle"], "BUNDLE")
        for name in script.FOLDER.glob("*.js"):
            self.assertNotRegex(name.read_text(), r"innerHTML|outerHTML|insertAdjacent|document\.write|\beval\b|new Function|fetch\(|XMLHttp|import\(")

    def test_a_suite_of_ones_own_is_escaped(self):
        """Chapters of suites that nobody knows show the same texts."""
        with tempfile.TemporaryDirectory() as place:
            path = evil_bundle(Path(place) / "b")
            (path / "suite.toml").write_text(f'[suite]\nid = "mine"\ntitle = {json.dumps(EVIL)}\n')
            bundle = Bundle(fixture.seal(path)).only({"truth-bezier", "2.4-bezier"})
            html = render.files(bundle, *build_all(bundle, find_all(bundle)))["report.html"].decode()
        page = Tags(html)
        self.assertIn("<script>x</script>", page.text)
        self.assertEqual(sum(tag == "script" for tag, _ in page.tags), 2)

    def test_html_is_well_formed(self):
        from .page_test import Page
        page = Page(self.files["report.html"].decode())
        self.assertEqual(page.problems + page.open, [])
        self.assertEqual(len(page.ids), len(set(page.ids)))

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
        width = None
        for line in text.splitlines():
            cells = len(re.findall(r"(?<!\\)\|", line)) if line.startswith("|") else None
            if cells is not None and width is not None:
                self.assertEqual(cells, width, line)
            width = cells

    def test_latex_runs_nothing(self):
        known = {*"textbackslash & % $ # _ { } textasciitilde textasciicircum textless textgreater textbar textmu ldots textquotedbl textasciigrave "
                 r"quad texttt textbf multicolumn hline endhead \ begin end le ge times approx nopagebreak '".split()}
        for name, data in self.files.items():
            if not name.endswith(".tex"):
                continue
            text = data.decode()
            body = text[text.index(r"\begin{center}"):text.index(r"\endgroup")]
            with self.subTest(name):
                self.assertLessEqual(set(re.findall(r"\\([a-zA-Z]+|[^a-zA-Z])", body)), known)
                bare = re.sub(r"\\[^a-zA-Z]", "", body)
                self.assertEqual(bare.count("{"), bare.count("}"))
                self.assertNotRegex(bare.replace(r"$\le$", "").replace(r"$\approx$", ""), r"[$#~^%]")

    def test_nothing_acts_on_a_terminal_or_ends_a_line(self):
        self.assertIsNone(re.search("[\0-\x08\x0b-\x1f\x7f\u202e\u2028]", self.summary))
        self.assertEqual(visible("a\nb\x1b[2J\r\u2028\ud800"), r"a\nb\x1b[2J\r\u2028\ud800")


if __name__ == "__main__":
    unittest.main()
