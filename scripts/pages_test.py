#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pages_test.py PROGRAM: report/baseline is what today's renderer makes of results/baseline and its comparison with
results/clang: its text, tables, and the words of its figures.

Shapes are left out: other versions of matplotlib draw them otherwise.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGES = ROOT / "report/baseline"


def words(path):
    """What a reader finds in a file; of a picture its labels."""
    text = path.read_text(encoding="utf-8")
    return re.findall(r"<text[^>]*>([^<]*)</text>", text) if path.suffix == ".svg" else text


def render(program, out):
    with tempfile.TemporaryDirectory() as comparison:
        subprocess.run([program, "compare", "results/baseline", "results/clang", "--out", comparison], cwd=ROOT, check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([ROOT / "scripts/report", ROOT / "results/baseline", "--comparison", comparison, "--out", out], check=True,
                       stdout=subprocess.DEVNULL)


def main(program):
    with tempfile.TemporaryDirectory() as place:
        fresh = Path(place) / "page"
        render(program, fresh)
        names = {path.relative_to(folder) for folder in (fresh, PAGES) for path in folder.rglob("*") if path.suffix in (".md", ".csv", ".tex", ".svg")}
        differing = [str(name) for name in sorted(names)
                     if not (fresh / name).exists() or not (PAGES / name).exists() or words(fresh / name) != words(PAGES / name)]
    if differing:
        print(f"report/baseline: not what the renderer makes of results/baseline: {', '.join(differing)}; "
              "remove it and run scripts/pages_test.py PROGRAM --update")
    return 1 if differing else 0


if __name__ == "__main__":
    program = Path(sys.argv[1]).resolve()
    sys.exit(render(program, PAGES) if sys.argv[2:] == ["--update"] else main(program))
