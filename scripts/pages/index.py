# SPDX-License-Identifier: MIT
"""Links between the pages: the four doors of README.md, and the start page of docs."""
import os
from pathlib import Path

from scripts import atlas
from scripts.pages.markdown import table
from scripts.pages.program import rows_of

DOCS = Path(__file__).resolve().parents[2] / "docs"
INDEX = DOCS / "README.md"
DOORS = (("choose a method for your degree, range and tolerance", ("choose", "methods", "guarantees")),
         ("use the methods in your code", ("cpp", "c", "python", "own_method")),
         ("repeat the source report", ("reproduce", "scorecard")),
         ("test your own change, or your machine", ("change", "compare")))
# Headings of the start page: pages that are not there are left out, and those that no heading names come last.
HEADINGS = (("begin", ("introduction", "walks", "glossary")),
            ("try it in a browser, or publish it", ("web", "site")),
            *DOORS,
            ("answer questions about curves in a file", ("curves", "curve_sets")),
            ("work with the program", ("terminal", "commands", "suites", "ci")))
KINDS_OF_QUESTIONS = {"Which": "Which one?", "How fast": "How fast?", "How wrong": "How wrong?", "": "Other questions"}


def title(path):
    return path.read_text(encoding="utf-8").split("\n", 1)[0].removeprefix("# ")


def first_sentence(path):
    """The first paragraph below the title, up to the end of its first sentence."""
    paragraph = path.read_text(encoding="utf-8").split("\n\n")[1].replace("\n", " ")
    return paragraph.partition(". ")[0].rstrip(".:") + "."


def link(page, path):
    return f"[{title(path)}]({os.path.relpath(path, page.parent)})"


def doors(page):
    """A line for each thing that a reader may want, with the pages about it that there are."""
    body = [[want, ", ".join(link(page, DOCS / f"{name}.md") for name in names if (DOCS / f"{name}.md").exists())] for want, names in DOORS]
    return table(["you want to", "read"], body)


def index(page):
    """The pages, with their first sentences, below the purpose that each serves; then the others by name."""
    named = {name for _, names in HEADINGS for name in names}
    others = sorted(path.stem for path in DOCS.glob("*.md") if path.stem not in named and path != INDEX)
    parts = []
    for want, names in (*HEADINGS, ("read everything else", others)):
        there = [DOCS / f"{name}.md" for name in names if (DOCS / f"{name}.md").exists()]
        lines = [f"- {link(page, path)}: {first_sentence(path)}" for path in there]
        parts += ["\n".join([f"## To {want}", "", *lines])] if there else []
    return "\n\n".join(parts)


def questions(page, program):
    """The shipped suites by the first words of the question that each answers; those of other libraries, which are not everywhere,
    have no seconds."""
    body = {kind: [] for kind in KINDS_OF_QUESTIONS}
    for row in rows_of(program, "suites"):
        kind = next(kind for kind in body if row["question"].startswith(kind))
        found = atlas.PAGES / atlas.ELSEWHERE.get(row["id"], f"{row['id']}/README.md")
        answer = f"[found]({os.path.relpath(found.resolve(), page.parent)})" if found.exists() else ""
        body[kind].append([f"[`{row['id']}`](../experiments/suites/{row['file']})", row["question"], row["seconds"], answer])
    return "\n\n".join(f"### {KINDS_OF_QUESTIONS[kind]}\n\n" + table(["suite", "question", "processor seconds", "answer"], lines)
                       for kind, lines in body.items())
