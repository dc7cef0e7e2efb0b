# SPDX-License-Identifier: MIT
"""Sampled maximum, searched maximum and proved bound, as tables: methods down, a line for each cell."""

import math

from .document import Cell, Group, Table
from .error_tables import NAMES, named
from .findings.evaluators import exceeding, gain
from .methods import form
from .wording import factor, general, large

HEAD = ("sampled", "searched", "proved bound", "gain", "status", "id")


def search_tables(bundle, *suites):
    """One Table per study, in the order of search.csv; the gain is searched over sampled maximum."""
    table = bundle["search.csv"].of_suite(*suites)
    return [search_table(study, table.select(study=study)) for study in table.distinct("study")]


def search_table(study, rows):
    """Sampled and searched maximum of a study beside its proved bound."""
    broken = exceeding([r for r in rows if isinstance(r["searched_error_u"], float)])
    varying = [c for c in NAMES if len({r[c] for r in rows}) > 1] or ["degree"]
    methods = {}
    for row in rows:
        methods.setdefault(row["method"], []).append(row)
    groups = tuple(Group(f"`{m}`", m, tuple((", ".join(named(c, r[c]) for c in varying), _cells(r, r in broken))
                                            for r in own)) for m, own in methods.items())
    english, chinese = form(rows[0]["form"])
    return Table(id=f"{study}-search", caption=f"Sampled and searched maximum over u p~ and proved bound, {english} "
                 f"({large(max(r['trials'] for r in rows))} trials, then {large(max(r['budget'] for r in rows))} steps)",
                 caption_zh=f"抽样与搜索所得最大误差及已证误差界（以 u p~ 计），{chinese}", groups=groups, head=HEAD, row_head="cell")


def _cells(row, broken):
    known = all(isinstance(row[c], float) and math.isfinite(row[c]) for c in ("sampled_error_u", "searched_error_u"))
    gained = gain(row) if known else None
    return [Cell(general(row["sampled_error_u"]), row.text("sampled_error_u")),
            Cell(general(row["searched_error_u"]), row.text("searched_error_u"), "outside" if broken else ""),
            Cell(general(row["bound_u"]), row.text("bound_u")), Cell(factor(gained), repr(gained)) if known else Cell(),
            Cell(row.text("status"), row.text("status"), "outside" if row["status"] == "non_finite" else ""),
            Cell(f"`{row['search_id']}`", row["search_id"])]
