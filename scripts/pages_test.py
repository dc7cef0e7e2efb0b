#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""report/baseline is what today's renderer makes of results/baseline: its text, tables, and the words of its figures.

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


def main():
    with tempfile.TemporaryDirectory() as place:
        fresh = Path(place) / "page"
        subprocess.run([ROOT / "scripts/report", ROOT / "results/baseline", "--out", fresh], check=True, stdout=subprocess.DEVNULL)
        names = {path.relative_to(folder) for folder in (fresh, PAGES) for path in folder.rglob("*") if path.suffix in (".md", ".csv", ".tex", ".svg")}
        differing = [str(name) for name in sorted(names)
                     if not (fresh / name).exists() or not (PAGES / name).exists() or words(fresh / name) != words(PAGES / name)]
    if differing:
        print(f"report/baseline: not what the renderer makes of results/baseline: {', '.join(differing)}; "
              "run scripts/report results/baseline --out report/baseline")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
