# SPDX-License-Identifier: MIT
"""B-spline curves in a knot span: points, and the Bernstein form of the span."""

from ..bundle import Missing
from ..document import Cell, Heading, Text
from ..error_tables import error_tables, swept
from ..tables import by_axis
from ..wording import general
from .suite_parts import of_studies, study_figure, with_times

TITLE = "B-spline curves"
SUITE = KIND = "bspline"
CURVES = ("B-spline curves", "B 样条曲线")


def _number(column):
    return lambda row: Cell(general(row[column]), row.text(column)) if row[column] is not None else Cell()


def _control_points(study, rows, across):
    """Errors of the control points of the Bernstein form, by kind of knots; nothing where no method makes it."""
    made = [r for r in rows if r["max_control_error_u"] is not None]
    if not made:
        return
    kinds = dict.fromkeys(r["knots"] for r in made)
    lines = [(f"{text}, {knots} knots", _number(column), lambda r, knots=knots: r["knots"] == knots)
             for text, column in (("mean", "mean_control_error_u"), ("largest", "max_control_error_u")) for knots in kinds]
    lines.append(("proved bound", _number("control_bound_u"), lambda r: True))  # it does not depend on the kind of knots
    yield by_axis(made, across, f"{study}-control", "Error of the control points of the span's Bernstein form over u p~",
                  "节点区间 Bernstein 控制点的误差（以 u p~ 计）", lines, row_head="quantity")


def study_tables(bundle, study):
    """Errors of points, then those of control points."""
    rows = bundle["bspline.csv"].some(study=study)
    across = swept(rows)[0]
    yield from error_tables(study, rows, across, "knots", CURVES)
    yield from _control_points(study, rows, across)


def _evaluators(bundle):
    """Errors of evaluators of Bezier curves on knot spans; nothing where the bundle has none."""
    try:
        judged = bundle.judged().of_suite(SUITE)
    except Missing:
        return
    yield Heading("Evaluators on knot spans")
    yield Text("The inputs `bspline` are knot spans of random B-spline curves in Bernstein form, rounded, and exact from there on; "
               "neighbouring control points of theirs are averages of the same points. Those of `continuous` inputs are independent.")
    for study in judged.distinct("study"):
        yield from study_figure(bundle, study)
        yield from error_tables(study, judged.some(study=study))


@with_times("bspline")
def blocks(bundle, findings):
    """Findings, the figure, then the tables of each study."""
    table = bundle["bspline.csv"].of_suite(SUITE)
    yield from of_studies(bundle, findings, SUITE, table.distinct("study"), study_tables, "bspline_against_degree")
    yield Text("A trial is a B-spline curve in one knot span, over knots of a kind, and a t of the span. `..._span` makes the Bernstein "
               "form of the span and evaluates that by the triangle of de Casteljau; the other methods make the point from the control "
               "points of the B-spline curve. p~ is the sum of the magnitudes of these control points, times their weights in the "
               "result. A time is that of one point with everything that it takes: a Bernstein form would serve any number of points "
               "of its span, which these times do not show.")
    yield from _evaluators(bundle)
