# SPDX-License-Identifier: MIT
"""The page's script and its data: one inline script, known to the content policy by its hash, and a block of JSON that it reads."""

import base64
import hashlib
import json
import math
from pathlib import Path

from markupsafe import Markup

from .answer import FORMS, LOSING, NO_TIME, ROUNDOFF, USELESS, small
from .inline import to_plain

PARTS = ("state", "tables", "figures", "answer", "main")
FOLDER = Path(__file__).parent / "templates" / "script"


def text():
    """The script as it stands in the page. A file that ended the element would end the page's script, so none may."""
    script = '"use strict";\n(() => {\n' + "\n".join((FOLDER / f"{part}.js").read_text(encoding="utf-8") for part in PARTS) + "})();\n"
    if "</" in script or "<!--" in script:
        raise ValueError("the script holds the beginning of a tag")
    return script


def digest(script):
    """The source expression of the content policy that allows this script and no other."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"


def block(value):
    """JSON that is inert inside a script element: no tag, no entity, no line that JavaScript ends."""
    written = json.dumps(value, ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    return Markup(written.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026"))


def data(bundle, chapters):
    """What the script knows beside what it reads from the page."""
    blocks = [one for chapter in chapters for one in chapter.blocks]
    answer = next((one for one in blocks if one.kind == "answer"), None)
    replays = _replays(bundle)
    return {"bundle": _shell_word(bundle.name), "roots": roots(bundle), "colours": _colours(blocks),
            "answer": _answer(answer) if answer else None,
            "figures": {one.id: [_series(series, replays) for series in one.drawing.series]
                        for one in blocks if one.kind == "figure" and one.drawing.series}}


def _shell_word(name):
    """The name as a word of a command line."""
    return name if name.replace("-", "").replace("_", "").replace(".", "").isalnum() and name.isascii() else "BUNDLE"


def roots(bundle):
    """{method: the shortest id that it begins with}: `direct_pow` belongs to `direct`."""
    ids = {row["method"] for table in bundle.tables.values() if "method" in table.columns for row in table.rows if row["method"]}
    plain = sorted(one for one in ids if ":" not in one)
    return {one: next((root for root in plain if one == root or one.startswith(f"{root}_")), one) for one in plain}


def _colours(blocks):
    if not any(one.kind == "figure" for one in blocks):
        return []
    from .figures.canvas import COLOURS  # only where a figure was drawn
    return list(COLOURS)


def _number(value):
    return value if isinstance(value, float) and math.isfinite(value) else None


def _answer(answer):
    from .chapters.choice import where
    cells = []
    for cell, members in answer.cells.items():
        methods = [dict(method=one.method, ns=_number(one.ns), low=_number(one.timed and one.timed["ns_low"]),
                        high=_number(one.timed and one.timed["ns_high"]), error_u=_number(one.error_u), bound_u=_number(one.bound_u),
                        error=_number(one.number("observed_max", "max_error")), bound=_number(one.number("bound", "max_bound")),
                        front=one.front or "", replay=one.replay or "")
                   for one in members]
        cells.append(dict(form=cell.form, degree=cell.degree, mode=cell.mode, scalar=cell.scalar,
                          dimension=cell.dimension, small=small(cell.degree, cell.form), where=cell.where, words=to_plain(where(cell)), methods=methods))
    return dict(cells=cells, first=list(answer.cells).index(answer.first), forms=FORMS, useless=USELESS, losing=LOSING, untimed=NO_TIME,
                roundoff={**ROUNDOFF, **{c["scalar"]: ROUNDOFF["double"] for c in cells if c["scalar"] not in ROUNDOFF}})


KEY = ("study", "method", "scalar", "dimension", "degree", "coordinate_range", "t_min", "t_max", "curves", "generator")


def _replays(bundle):
    """{what a row is about: the id of the kept trial behind its largest error}."""
    return {tuple(row[c] for c in KEY): row["worst_id"] for row in bundle.tables["worst.csv"].rows} if "worst.csv" in bundle else {}


def _series(series, replays):
    def replay(row):
        return (row["search_id"] or replays.get(tuple(row[c] for c in KEY), "")) if row else ""
    return dict(name=series.name, method=series.name.split(" (")[0], colour=series.colour,
                points=[[x, y, words, replay(row)] for x, y, words, row in series.points])
