# SPDX-License-Identifier: MIT
"""The page in headless Chromium: python3 -I check.py. Exit 77 where Chromium or playwright-core is missing, with a line that says so.

Debian's package `chromium` has the first; `npm install playwright-core` in build/browser, or wherever BEZIERBENCH_PLAYWRIGHT says,
the second. Nothing else of this project needs either.
"""

import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SKIPPED = 77
METHODS, STUDIES, RANGES = 205, 5, 100


def _playwright():
    """The folder of playwright-core; None where there is none."""
    places = [os.environ.get("BEZIERBENCH_PLAYWRIGHT", ""), *(str(ROOT / f"{build}/node_modules/playwright-core") for build in ("build/browser", "."))]
    return next((place for place in places if place and (Path(place) / "package.json").is_file()), None)


def _report():
    spec = importlib.util.spec_from_file_location("isolated", HERE.parent / "isolated.py")
    isolated = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(isolated)
    isolated.load()


def _large(place, fixture):
    """A bundle with as many rows of accuracy as METHODS, STUDIES and RANGES make: more than a hundred thousand."""
    like = next(row for row in fixture.accuracy() if row["study"] == "ladder-bezier")
    names = [f"{root}_{number}" for number in range(METHODS // 5) for root in ("de_casteljau", "horner", "direct", "estrin", "volk")]

    def rows():
        return [{**like, "study": f"mine-{study}", "method": method, "coordinate_range": size + 1,
                 "mean_error_u": 1 + size / 7} for study in range(STUDIES) for method in names for size in range(RANGES)]
    others = tuple(file for file in fixture.FILES if file not in ("accuracy.csv", "methods.csv"))
    kept, fixture.FILES["accuracy.csv"] = fixture.FILES["accuracy.csv"], rows
    try:
        path = fixture.write(place, without=others)
        (path / "suite.toml").write_text('[suite]\nid = "mine"\ntitle = "Many rows"\n' + "".join(
            f'[[study]]\nid = "mine-{study}"\ntitle = "Study {study}"\nkind = "accuracy"\n' for study in range(STUDIES)))
        return fixture.seal(path)
    finally:
        fixture.FILES["accuracy.csv"] = kept


def main():
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    lacking = [name for name, there in (("chromium", chromium), ("node", shutil.which("node")), ("playwright-core", _playwright())) if not there]
    if lacking:
        print(f"skipped: not here: {', '.join(lacking)}")
        return SKIPPED
    _report()
    from report import fixture
    from report.__main__ import main as render
    with tempfile.TemporaryDirectory() as place:
        comparison = fixture.write_comparison(f"{place}/c")
        arguments = [[str(fixture.write(f"{place}/all")), "--comparison", str(comparison), "--out", f"{place}/page"],
                     [str(_large(f"{place}/many", fixture)), "--out", f"{place}/large"]]
        for one in arguments:
            if code := render(one):
                return code
        done = subprocess.run(["node", str(HERE / "page.mjs"), _playwright(), chromium, f"{place}/page", f"{place}/large"], check=False)
        return done.returncode


if __name__ == "__main__":
    sys.exit(main())
