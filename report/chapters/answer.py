# SPDX-License-Identifier: MIT
"""The answer: which method to choose for a form, degree, mode, scalar type, range and tolerance."""

from ..answer import FORMS, LOSING, NO_TIME, SMALL, USELESS, candidates, default_cell, is_proved_small, lost, small, useful
from ..bundle import Missing
from ..document import Answer, Cell, Group, Table, Text
from ..wording import general, listing, shortest
from .suite_parts import figure

TITLE = "Which method to choose"
WORTH = {"yes": "✓ worth choosing", "unresolved": "? perhaps", "no": "beaten", "": ""}


def blocks(bundle, _findings):
    """A sentence, the picker, the table of the cell that it shows first, and its figure."""
    cells = candidates(bundle)
    if not any(useful(one.error_u, cell.scalar) for cell, members in cells.items() for one in members):
        raise Missing("no method has a time or an error that could be ranked")
    cell = default_cell(cells)
    yield Answer(cells=cells, first=cell, sentence=_sentence(cell, cells[cell]), table=_table(cell, cells[cell]))
    yield from figure("answer_cell", bundle)
    yield Text((("✓ worth choosing: no other method of the same race is at least as right and certainly faster; ? perhaps: one is, by its "
                 "median, but the 99 % intervals of the two times overlap. ") if cell.mode != NO_TIME else "")
               + f"Methods whose proved bound is small come first: at most {SMALL}n u p~, for rational curves {2 * SMALL}n. "
               + f"Beyond {LOSING} u p~ the table says how many decimal digits an error loses. A method whose largest error exceeds {shortest(USELESS)} of p~, the sum of the absolute terms, is left out as useless. "
               "Largest errors are those seen in the trials, and other inputs may give larger ones; the proved bound is the largest of the bounds of "
               "the trials.")


def where(cell):
    """What was asked, in words."""
    mode = "" if cell.mode == NO_TIME else f", mode `{cell.mode}`"
    return f"{FORMS.get(cell.form, cell.form)}, degree {shortest(cell.degree)}{mode}, {cell.scalar}, {cell.where}"


def _sentence(cell, members):
    good = [one for one in members if useful(one.error_u, cell.scalar)]
    if not good:
        return f"For {where(cell)} no method is useful."
    if cell.mode == NO_TIME:
        return (f"Nothing was timed here. For {where(cell)}, `{good[0].method}` has the least error: "
                f"{general(good[0].error_u)} u p~ at most.")
    proved = [one for one in good if is_proved_small(one.bound_u, cell.degree, cell.form)]
    limit = general(small(cell.degree, cell.form))
    if not proved:
        return f"For {where(cell)} no method has a proved bound of at most {limit} u p~; the table has those without."
    front = [one for one in proved if one.front == "yes"] or proved[:1]
    steps = [f"`{one.method}` ({general(one.ns)} ns, at most {general(one.error_u)} u p~ seen)" for one in front]
    return f"For {where(cell)}, with a proved bound of at most {limit} u p~, fastest first: {listing(steps)}."


def _table(cell, members):
    timed = cell.mode != NO_TIME
    groups = []
    for one in members:
        if useful(one.error_u, cell.scalar):
            low, high = one.timed and one.timed["ns_low"], one.timed and one.timed["ns_high"]
            noisy = " ~" if timed and one.timed["quality"] == "noisy" else ""
            times = [Cell(f"{general(one.ns)} [{general(low)} – {general(high)}]{noisy}", one.timed.text("ns"))] if timed else []
            seen = ", ".join(filter(None, (general(one.error_u), lost(one.error_u))))
            error = one.timed.text("observed_max_u") if timed else one.errors.text("max_error_u")
            bound = (one.timed or one.errors).text("bound_u")
            marks = [Cell(WORTH.get(one.front, ""), one.front, "inside" if one.front == "yes" and not lost(one.error_u) else "")] if timed else []
            groups.append(Group(f"`{one.method}`", one.method,
                                (("", [*times, Cell(seen, error), Cell(general(one.bound_u), bound), *marks]),)))
    head = (*(("ns per point",) if timed else ()), "largest error seen, u p~", "proved bound, u p~", *(("time against error",) if timed else ()))
    return Table(id="answer-table", caption=f"Methods for {where(cell)}, {'those with a small proved bound first, then by time' if timed else 'least error first'}",
                 caption_zh="可选方法", head=head, groups=tuple(groups))
