# SPDX-License-Identifier: MIT
"""The page's script and its data: one inline script, known to the content policy by its hash, and a block of JSON that it reads."""

import base64
import hashlib
import json
import math
from pathlib import Path

from markupsafe import Markup

from .answer import FORMS, LOSING, NO_TIME, ROUNDOFF, USELESS, small, useful
from .figures.colours import leading, looks
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
    methods = _methods(bundle)
    return {"bundle": _shell_word(bundle.name), "roots": roots(methods), "answer": _answer(bundle, answer) if answer else None,
            "figures": {one.id: [_series(series, replays, methods) for series in one.drawing.series]
                        for block in blocks if block.kind == "figure" for one in (block, block.whole) if one and one.drawing.series}}


def _shell_word(name):
    """The name as a word of a command line."""
    return name if name.replace("-", "").replace("_", "").replace(".", "").isalnum() and name.isascii() else "BUNDLE"


def _methods(bundle):
    return {row[column] for table in bundle.tables.values() for column in ("method", "conversion") if column in table.columns for row in table.rows if row[column]}


def roots(methods):
    """{method: the shortest id that it begins with}: `direct_pow` belongs to `direct`."""
    plain = sorted(one for one in methods if ":" not in one)
    return {one: next((root for root in plain if one == root or one.startswith(f"{root}_")), one) for one in plain}


def _number(value):
    return value if isinstance(value, float) and math.isfinite(value) else None


def _answer(bundle, answer):
    from .chapters.choice import where
    cells = []
    for cell, members in answer.cells.items():
        methods = [dict(method=one.method, ns=_number(one.ns), low=_number(one.timed and one.timed["ns_low"]),
                        high=_number(one.timed and one.timed["ns_high"]), error_u=_number(one.error_u), bound_u=_number(one.bound_u),
                        error=_number(one.number("observed_max", "max_error")), bound=_number(one.number("bound", "max_bound")),
                        front=one.front or "", replay=one.replay or "")
                   for one in members]
        known = [one.method for one in members if useful(one.error_u, cell.scalar)]
        shown = leading(bundle, known, lambda method, ids=known: ids.index(method))
        for method, look in looks(bundle, shown + [method for method in known if method not in shown]).items():
            next(one for one in methods if one["method"] == method).update(colour=look["color"], shape=look["marker"], leads=method in shown)
        cells.append(dict(form=cell.form, degree=cell.degree, mode=cell.mode, scalar=cell.scalar,
                          dimension=cell.dimension, small=small(cell.degree, cell.form), where=cell.where, words=to_plain(where(cell)), methods=methods))
    return dict(cells=cells, first=list(answer.cells).index(answer.first), forms=FORMS, useless=USELESS, losing=LOSING, untimed=NO_TIME,
                roundoff={**ROUNDOFF, **{c["scalar"]: ROUNDOFF["double"] for c in cells if c["scalar"] not in ROUNDOFF}})


KEY = ("study", "method", "scalar", "dimension", "degree", "coordinate_range", "t_min", "t_max", "curves", "generator")


def _replays(bundle):
    """{what a row is about: the id of the kept trial behind its largest error}."""
    return {tuple(row[c] for c in KEY): row["worst_id"] for row in bundle.tables["worst.csv"].rows} if "worst.csv" in bundle else {}


def _series(series, replays, methods):
    def replay(row):
        return (row["search_id"] or replays.get(tuple(row[c] for c in KEY), "")) if row else ""
    own = [one for one in (series.name.split(" (")[0], *series.alike) if one in methods]
    return dict(name=series.name, methods=own, colour=series.colour,
                points=[[x, y, words, replay(row)] for x, y, words, row in series.points])
