#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pages_test.py PROGRAM: the pages in results/pages are what today's renderer makes of the bundles beside them: results/baseline
with its comparison with results/clang, and the small bundles of results/atlas. Their text, tables, and the words of their figures.

Shapes and the numbers of axes are left out: other versions of matplotlib choose them otherwise.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))
sys.dont_write_bytecode = True  # the source tree may be read-only
from scripts import atlas  # noqa: E402

BASELINE = ROOT / "results/pages/baseline"
MOST_OF_A_SAMPLE = 200 * 2**10  # bytes of a bundle; the pages of all 20 would take a minute


def words(path):
    """What a reader finds in a file; of a picture its labels, except for the numbers of its axes."""
    text = path.read_text(encoding="utf-8")
    return re.findall(r"<text[^>]*>(?!-?[\d.]+(?:e-?\d+)?<)([^<]*)</text>", text) if path.suffix == ".svg" else text


def render(program, out):
    with tempfile.TemporaryDirectory() as comparison:
        subprocess.run([program, "compare", "results/baseline", "results/clang", "--out", comparison], cwd=ROOT, check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([ROOT / "scripts/report", ROOT / "results/baseline", "--comparison", comparison, "--out", out], check=True,
                       stdout=subprocess.DEVNULL)


def stale(page, command, draw):
    """A line that names the files of a committed page which `draw(out)` makes otherwise, and the command that remakes them."""
    with tempfile.TemporaryDirectory() as place:
        fresh = Path(place) / "page"
        draw(fresh)
        names = {path.relative_to(folder) for folder in (fresh, page) for path in folder.rglob("*") if path.suffix in (".md", ".csv", ".tex", ".svg")}
        differing = [str(name) for name in sorted(names)
                     if not (fresh / name).exists() or not (page / name).exists() or words(fresh / name) != words(page / name)]
    if differing:
        yield f"{page.relative_to(ROOT)}: not what the renderer makes of its bundle: {', '.join(differing)}; {command}"


def main(program):
    found = [*stale(BASELINE, f"remove {BASELINE.relative_to(ROOT)} and run scripts/pages_test.py PROGRAM --update", lambda out: render(program, out))]
    sample = [suite for suite in atlas.recorded() if atlas.size_of(atlas.BUNDLES / suite) <= MOST_OF_A_SAMPLE]
    for suite in sample:
        found += stale(atlas.PAGES / suite, "run scripts/atlas.py pages", lambda out, bundle=atlas.BUNDLES / suite: atlas.render(bundle, out))
    print(*found or [f"the pages of the baseline and of {', '.join(sample)} are what the renderer makes"], sep="\n")
    return 1 if found or not sample else 0


if __name__ == "__main__":
    program = Path(sys.argv[1]).resolve()
    sys.exit(render(program, BASELINE) if sys.argv[2:] == ["--update"] else main(program))
