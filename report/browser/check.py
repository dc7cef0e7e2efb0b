# SPDX-License-Identifier: MIT
"""The page in headless Chromium: python3 -I check.py. Exit 77 where Chromium, playwright-core or axe-core is missing, with a line that says so.

Debian's package `chromium` has the first; `npm install playwright-core axe-core` in build/browser, or wherever BEZIERBENCH_PLAYWRIGHT says,
the others. Nothing else of this project needs any of them.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT))
SKIPPED = 77
TABLES, ROWS = 100, 1000


def required():
    """The arguments of a check by Node: playwright-core, axe-core and Chromium. None where one is missing, which is printed."""
    places = [os.environ.get("BEZIERBENCH_PLAYWRIGHT", ""), *(str(ROOT / f"{build}/node_modules/playwright-core") for build in ("build/browser", "."))]
    playwright = next((place for place in places if place and (Path(place) / "package.json").is_file()), "")
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    axe = Path(playwright, "../axe-core/axe.min.js")
    absent = [name for name, there in (("chromium", chromium), ("node", shutil.which("node")), ("playwright-core", playwright),
                                       ("axe-core", axe.is_file())) if not there]
    if absent:
        print(f"skipped: missing: {', '.join(absent)}")
        return None
    return [playwright, str(axe), chromium]


def _large(bundle, out):
    """Writes a page of a hundred thousand rows: tables of methods as a study of many cells has them."""
    from report import output, render
    from report.document import Cell, Chapter, Group, Table
    names = [f"{root}_{number}" for number in range(ROWS // 5) for root in ("de_casteljau", "horner", "direct", "estrin", "volk")]
    chapters = [Chapter(f"many-{number}", f"Study {number}", (Table(
        id=f"table-{number}", caption="Mean error over u p~", head=("3",), groups=tuple(
            Group(f"`{name}`", name, (("", [Cell(f"{at % 97}", f"{at % 97}.0", units=(("ulp", "2"),))]),))
            for at, name in enumerate(names))),)) for number in range(TABLES)]
    output.write(out, render.files(bundle, chapters, []))


def main():
    tools = required()
    if not tools:
        return SKIPPED
    from report import fixture
    from report.bundle import Bundle
    from report.__main__ import main as render
    with tempfile.TemporaryDirectory() as place:
        bundle, comparison = fixture.write(f"{place}/bundle"), fixture.write_comparison(f"{place}/comparison")
        if code := render([str(bundle), "--comparison", str(comparison), "--out", f"{place}/page"]):
            return code
        _large(Bundle(bundle), f"{place}/large")
        if code := render([str(ROOT / "results/atlas/speed"), "--out", f"{place}/real"]):
            return code
        done = subprocess.run(["node", str(HERE / "page.mjs"), *tools, f"{place}/page", f"{place}/large", f"{place}/real"], check=False)
        return done.returncode


if __name__ == "__main__":
    sys.exit(main())
