# SPDX-License-Identifier: MIT
"""Which method to choose; what holds and what does not."""

from ..answer import FORMS, LOSING, NO_TIME, SMALL, USELESS, candidates, default_cell, is_proved_small, lost, small, useful
from ..bundle import Missing
from ..document import Answer, Bullets, Cell, Heading, Text
from ..findings.roster import grouped
from ..tables import listed
from ..wording import general, listing, shortest
from .parts import chapter, figure


@chapter("Which method to choose", whole=True)
def answer(bundle, _findings):
    """A sentence, the picker, the table of the cell that it shows first, and its figure."""
    cells = candidates(bundle)
    if not any(useful(one.error_u, cell.scalar) for cell, members in cells.items() for one in members):
        raise Missing("no method has a time or an error that could be ranked")
    cell = default_cell(cells)
    yield Answer(cells=cells, first=cell, sentence=_sentence(cell, cells[cell]), table=_table(cell, cells[cell]))
    yield from figure("answer_cell", bundle)
    yield Text(("✓ not dominated: no other method of the same race is at least as accurate and certainly faster; ? undecided: another is, by its "
                "median, but the 99 % intervals of the two times overlap. " if cell.mode != NO_TIME else "")
               + f"Methods whose proved bound is small come first: at most {SMALL}n u p~, for rational curves {2 * SMALL}n. Above {LOSING} u p~ the table "
               f"gives the number of decimal digits that an error loses. A method whose largest error exceeds {shortest(USELESS)} of p~, the sum of the "
               "absolute terms, is left out as useless. Largest errors are those of the trials, and other inputs may give larger ones; the proved bound "
               "is the largest of the bounds of the trials.")


def where(cell):
    """The choices of the picker, in words."""
    mode = "" if cell.mode == NO_TIME else f", mode `{cell.mode}`"
    return f"{FORMS.get(cell.form, cell.form)}, degree {shortest(cell.degree)}{mode}, {cell.scalar}, {cell.where}"


def _sentence(cell, members):
    good = [one for one in members if useful(one.error_u, cell.scalar)]
    if not good:
        return f"For {where(cell)} no method is useful."
    if cell.mode == NO_TIME:
        return f"Nothing was timed here. For {where(cell)}, `{good[0].method}` has the smallest error: {general(good[0].error_u)} u p~ at most."
    proved = [one for one in good if is_proved_small(one.bound_u, cell.degree, cell.form)]
    limit = general(small(cell.degree, cell.form))
    if not proved:
        return f"For {where(cell)} no method has a proved bound of at most {limit} u p~; the table lists the other methods."
    front = [one for one in proved if one.front == "yes"] or proved[:1]
    steps = [f"`{one.method}` ({general(one.ns)} ns, observed errors of at most {general(one.error_u)} u p~)" for one in front]
    return f"For {where(cell)}, with a proved bound of at most {limit} u p~, fastest first: {listing(steps)}."


WORTH = {"yes": "✓ not dominated", "unresolved": "? undecided", "no": "dominated", "": ""}


def _table(cell, members):
    timed = cell.mode != NO_TIME

    def row(one):
        errors = one.timed or one.errors
        error, bound = errors.text("observed_max_u" if timed else "max_error_u"), errors.text("bound_u")
        cells = [Cell(", ".join(filter(None, (general(one.error_u), lost(one.error_u)))), error), Cell(general(one.bound_u), bound)]
        if timed:
            cells.insert(0, Cell(f"{general(one.ns)} [{general(one.timed['ns_low'])} – {general(one.timed['ns_high'])}]", one.timed.text("ns")))
            cells.append(Cell(WORTH.get(one.front, ""), one.front, "inside" if one.front == "yes" and not lost(one.error_u) else ""))
        return f"`{one.method}`", *cells
    head = ("method", *(["ns per point"] if timed else []), "largest observed error, u p~", "proved bound, u p~",
            *(["time against error"] if timed else []))
    order = "those with a small proved bound first, those that lose digits last, then by time" if timed else "smallest error first"
    return listed("answer-table", f"Methods for {where(cell)}, {order}", head,
                  [row(one) for one in members if useful(one.error_u, cell.scalar)])


@chapter("What was found")
def found(bundle, findings):
    """Findings under their headings, then those that the bundle cannot decide."""
    decided, undecided = findings
    if not decided and not undecided:
        raise Missing("there is nothing to judge")
    if any(f.claim for f in decided):
        yield Text("Every number and every judgement is computed from the bundle; the rows that decide a statement are listed below it.")
    for heading, members in grouped(decided):
        yield Heading(heading)
        if all(f.suite for f in members):  # each stands in full in the chapter of its suite
            yield Bullets(tuple(f.headline for f in members))
        else:
            yield from members
    if undecided:
        yield Text(f"Not decided, because the bundle has no rows for it: {listing(name.replace('_', ' ') for name, _ in undecided)}.")
