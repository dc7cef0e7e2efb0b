# SPDX-License-Identifier: MIT
"""The start page: the answer for real and for random cubics, and where to go from it."""
import posixpath
from html import escape
from pathlib import Path

from report.answer import is_proved_small
from report.wording import general
from scripts.pages import answers, index

from . import repository
from .methods import address

DEGREE = 3.0
# (title, what the curves are, [(name of the need, the scalar type, what its demand means)])
CARDS = (
    ("Real cubics", "outlines of fonts, icons, drawings and maps", (
        ("Real curves, float", "float", "at most {share} of the coordinates are not the nearest number, on every set"),
        ("Real curves, double", "double", "the same demand"))),
    ("Random cubics", "any control points, t in [0, 1]", (
        ("Fast and safe, t in [0, 1]", "double", "the fastest with an error that is proved small"),
        ("Proved, and not growing with n", "double", "the fastest whose error stays below 2 u p~ at any degree"))),
)
DOORS = ("Choose", "Use in code", "Repeat the source report", "Test your own change")  # of index.DOORS, in its order


def _row(known, name, scalar, sentence):
    need, _ = known.asked[name]
    found = known.winners[name]
    if found is None:
        return None
    rows = [row for row in found.errors[DEGREE] if row["study"] == need.studies[0]]
    timed = found.times[DEGREE]
    ratio = answers.time_text(timed, None).partition("<br>")[0].removesuffix(" ×")
    bound = rows[0]["bound_u"]
    proved = f" (at most {general(bound, 2)} is proved)" if name in (one.name for one in answers.NEEDS) and is_proved_small(bound, DEGREE, "bernstein") else ""
    error = need.error(rows).replace(" u", " u p~") if proved else need.error(rows)
    return {"method": found.method, "link": address(found.method), "scalar": scalar, "error": error, "proved": proved, "ratio": ratio, "base": timed["relative_to"],
            "sentence": sentence.replace("{share}", f"{100 * answers.MISROUNDED:g} %")}


def cards(known):
    return [{"title": title, "what": what, "rows": [row for need in needs if (row := _row(known, *need))]} for title, what, needs in CARDS]


def doors():
    """[(name, what it is for, [(title, link)])]"""
    found = []
    for name, (want, pages) in zip(DOORS, index.DOORS):
        paths = [index.DOCS / f"{page}.md" for page in pages if (index.DOCS / f"{page}.md").exists()]
        found.append((name, want, [(index.title(path), repository.place(path.relative_to(repository.ROOT))) for path in paths]))
    return found


def every_need():
    """The table of README.md, as HTML for the start page."""
    readme = (repository.ROOT / "README.md").read_text(encoding="utf-8")
    part = readme.partition("<!-- begin answers -->")[2].partition("<!-- end answers -->")[0]
    seen = set()
    body = repository.scrolling(repository.to_html({"README.md": part})["README.md"])
    return repository.linked(body, Path("README.md"), seen, "index.html"), seen
