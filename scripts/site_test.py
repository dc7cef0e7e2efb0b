#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""site_test.py PROGRAM: scripts/site writes a site without faults, with the answers of the committed bundles first and a page for every
method that PROGRAM lists. site_test.py PROGRAM --browser: the same site in headless Chromium, light and dark, on a screen and on a phone.
Exit 77, with a line that says so, where pandoc or what --browser requires is missing."""
import csv
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from report.browser.check import SKIPPED, required  # noqa: E402
from report.bundle import Bundle  # noqa: E402
from report.site import check  # noqa: E402
from report.site.methods import address  # noqa: E402
from scripts.pages import answers, bundles  # noqa: E402
from scripts.pages.program import rows_of  # noqa: E402

RENDERED = "pages/baseline/"  # written by the report's renderer and copied


def faults(site, program):
    yield from check.faults(site, lambda name: not name.startswith((RENDERED, "playground/")))
    first = (site / "index.html").read_text(encoding="utf-8").partition('id="doors"')[0]
    for bundle, need in ((bundles.real(), answers.REAL[0]), (Bundle(bundles.ANSWERS), answers.NEEDS[0])):
        winner = answers.winner(bundle, need).method
        if f">{winner}</a>" not in first:
            yield f"index.html: does not name {winner} first, the answer to {need.name}"
    for row in rows_of(program, "methods"):
        page = site / address(row["id"])
        text = page.read_text(encoding="utf-8") if page.exists() else ""
        if "<math" not in text or f"<code>{row['id']}</code>" not in text:
            yield f"{address(row['id'])}: no page with formulas of {row['id']}"
    found = csv.DictReader((ROOT / "results/atlas/worst/search.csv").read_text(encoding="utf-8").splitlines())
    worst = max((row for row in found if row["method"] == "de_casteljau"), key=lambda row: float(row["searched_error_u"]))
    for name, words in (("docs/proofs/local.html", "<math"), ("atlas/roots/index.html", "<table"), ("methods/de_casteljau.html", "s * a + t * b"),
                        ("methods/de_casteljau.html", "bezierbench replay results/atlas/worst"),
                        ("methods/de_casteljau.html", f"{float(worst['searched_error_u']):.1f} u p~</strong> at degree {worst['degree']}")):
        if words not in (site / name).read_text(encoding="utf-8"):
            yield f"{name}: without {words}"


def main(program, in_browser):
    if not shutil.which("pandoc"):
        print("skipped: missing: pandoc")
        return SKIPPED
    tools = required() if in_browser else []
    if tools is None:
        return SKIPPED
    with tempfile.TemporaryDirectory() as place:
        site = Path(place) / "with a blank"
        subprocess.run([ROOT / "scripts/site", site, "--program", program], check=True)
        if in_browser:
            return subprocess.run(["node", ROOT / "report/site/page.mjs", *tools, site], check=False).returncode
        found = list(faults(site, program))
        pages = sum(1 for _ in site.rglob("*.html"))
    print(*found or [f"{pages} pages, every link and anchor resolves"], sep="\n")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve(), sys.argv[2:] == ["--browser"]))
