# SPDX-License-Identifier: MIT
"""Links between the pages: the four doors of README.md and the index of docs."""
import os
from pathlib import Path

from scripts.pages.markdown import table

DOCS = Path(__file__).resolve().parents[2] / "docs"
INDEX = DOCS / "README.md"
DOORS = (("choose a method for your degree, range and tolerance", ("choose", "methods", "guarantees")),
         ("use the methods in your code", ("cpp", "c", "python", "own_method")),
         ("repeat the source report", ("reproduce", "scorecard")),
         ("test your own change, or your machine", ("change", "compare")))


def title(path):
    return path.read_text(encoding="utf-8").split("\n", 1)[0].removeprefix("# ")


def first_sentence(path):
    """The first paragraph below the title, up to the end of its first sentence."""
    paragraph = path.read_text(encoding="utf-8").split("\n\n")[1].replace("\n", " ")
    return paragraph.partition(". ")[0].removesuffix(".") + "."


def link(page, path):
    return f"[{title(path)}]({os.path.relpath(path, page.parent)})"


def doors(page):
    """A line for each thing that a reader may want, with the pages about it that there are."""
    body = [[want, ", ".join(link(page, DOCS / f"{name}.md") for name in names if (DOCS / f"{name}.md").exists())] for want, names in DOORS]
    return table(["you want to", "read"], body)


def index(page):
    """A line for each page: the doors first, in their order, then the others by name."""
    names = [name for _, names in DOORS for name in names]
    others = sorted(path.stem for path in DOCS.glob("*.md") if path.stem not in names and path != INDEX)
    there = [DOCS / f"{name}.md" for name in names + others if (DOCS / f"{name}.md").exists()]
    return "\n".join(f"- {link(page, path)}: {first_sentence(path)}" for path in there)
