# SPDX-License-Identifier: MIT
"""Conversions: errors of the coefficients, and what of it a path feels."""

from ..bundle import Missing
from ..document import Cell, Group, Heading, Table, Text
from ..error_tables import error_tables
from ..findings.conversion import NORMS, SOURCES, sources
from ..methods import form
from ..tables import by_axis
from ..wording import scientific, shortest
from .suite_parts import figure, of_suite, replay

TITLE = "Conversions, and what they cost a path"
SUITE = "conversion"
PARTS = (("error", "mean_error"), *((name, column) for column, name in SOURCES))


def blocks(bundle, findings):
    """Findings; coefficients, parts of the error, and error over t, each as figure and tables where the bundle has the rows."""
    if not bundle.has_suite(SUITE):
        raise Missing(f"the bundle has no study of the suite `{SUITE}`")
    yield from of_suite(findings, "conversion")
    yield from _coefficients(bundle)
    yield from _parts(bundle)
    yield from _over_t(bundle)
    yield from replay(bundle, SUITE)


def _rows(read):
    try:
        return read()
    except Missing:
        return []


def _coefficients(bundle):
    rows = _rows(lambda: bundle["conversion.csv"].of_suite(SUITE).rows)
    if not rows:
        return
    yield Heading("Coefficients")
    yield from figure("conversion_coefficients", bundle)
    for study in dict.fromkeys(r["study"] for r in rows):
        yield from study_tables(bundle, study)
    yield Text("The error of a conversion is the largest distance of a converted coefficient from the exact one, in "
               "coordinate units; R is "
               "the range, d the number of axes. The dashed lines are not fitted: u R √d times the norm is what one rounding "
               "of the given "
               "coefficients can do. A conversion of whole numbers is exact as long as they fit into 53 bits.")


def study_tables(bundle, study):
    """Errors of the coefficients."""
    yield _coefficient_table(study, bundle["conversion.csv"].some(study=study))


def _coefficient_table(study, rows):
    generators = list(dict.fromkeys(r["generator"] for r in rows))
    title = NORMS[rows[0]["form"]][0] if rows[0]["form"] in NORMS else study
    degrees = sorted({r["degree"] for r in rows})
    groups = []
    for conversion in dict.fromkeys(r["conversion"] for r in rows):
        lines = []
        for g in generators:
            own = {r["degree"]: r for r in rows if r["conversion"] == conversion and r["generator"] == g}
            for name, column in (("mean", "mean_error"), ("largest", "max_error")):
                lines.append((f"{name}, {g}", [Cell(scientific(own[n][column]), own[n].text(column)) if n in own else Cell()
                                              for n in degrees]))
        groups.append(Group(f"`{conversion}`", conversion, tuple(lines)))
    return Table(id=study, caption=f"{title}: error of the coefficients", caption_zh="转换后系数的误差", group_head="conversion",
                 row_head="inputs", axis="degree n", head=tuple(shortest(n) for n in degrees), groups=tuple(groups))


def _parts(bundle):
    rows = _rows(lambda: sources(bundle))
    if not rows:
        return
    yield Heading("Where the error of a path comes from")
    yield from figure("conversion_sources", bundle)
    for study in dict.fromkeys(r["study"] for r in rows):
        for degree in dict.fromkeys(r["degree"] for r in rows if r["study"] == study):
            own = [r for r in rows if r["study"] == study and r["degree"] == degree]
            english, chinese = form(own[0]["form"])
            yield by_axis(own, "interval", f"{study}-parts-{shortest(degree)}",
                          f"Mean error and its parts, degree {shortest(degree)}, {english} (coordinate units)",
                          f"平均误差及其来源，{shortest(degree)} 阶，{chinese}",
                          [(name, lambda r, c=column: Cell(scientific(r[c]), r.text(c)), lambda r: True) for name, column in PARTS],
                          row_head="part")
    yield Text("Conversion: the exactly evaluated converted curve against the given one. Rounding of 1-t: what t and the "
               "rounded 1-t make of "
               "the curve. Evaluation: the rest. Each is a mean of distances, so the parts need not add up, and the error is "
               "over more trials "
               "than its parts.")


def _over_t(bundle):
    rows = _rows(lambda: bundle.exact(SUITE).rows)
    if not rows:
        return
    yield Heading("Error against the interval of t")
    drawn = figure("conversion_interval", bundle)
    yield from drawn
    for study in dict.fromkeys(r["study"] for r in rows):
        yield from error_tables(study, [r for r in rows if r["study"] == study], "interval", "degree")
    if drawn:
        yield Text("(1+2t)^n is the sum of |C(n,j)| (2t)^j: what the power form of a curve with coefficients of size one can "
                   "reach at t. It is "
                   "drawn at the middles of the intervals, and its scale is fixed by the first interval alone: there it "
                   "starts at the error of "
                   "the path that is worst in the last one.")
