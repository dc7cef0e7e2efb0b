# SPDX-License-Identifier: MIT
"""Evaluators and conversions by suite: degrees, limits, multiple roots, conversions, worst inputs, rational curves."""

from .. import inputs
from ..bundle import Missing
from ..document import Cell, Group, Heading, Table, Text
from ..error_tables import error_tables, search_table, search_tables, swept
from ..findings.conversion import NORMS, SOURCES, sources
from ..methods import form
from ..rows import distinct, grouped
from ..tables import by_axis, one
from ..wording import factor, scientific, shortest
from .parts import chapter, figure, of_suite, replay, study_figure, tables_of


@tables_of("accuracy")
def _accuracy(bundle, study):
    judged = bundle.judged().some(study=study)
    rows = [r for r in judged if r["baseline"] == "exact"] or judged
    yield from error_tables(study, rows, *swept(rows))


@tables_of("search")
def _search(bundle, study):
    yield search_table(study, bundle["search.csv"].some(study=study))


def errors_of(suite, title, note, axes=lambda rows: (), more=lambda bundle: ()):
    """Declares the chapter of a suite of evaluators: findings, then each study with its figure and its tables along the `axes` of its rows; `more`
    makes what follows."""
    def blocks(bundle, findings):
        table = bundle.exact(suite)
        yield from of_suite(findings, suite)
        for study, rows in grouped(table.rows, "study").items():
            yield Heading(bundle.title(study))
            yield from study_figure(bundle, study)
            yield from error_tables(study, rows, *axes(rows))
        yield from more(bundle)
        yield Text(note)
        yield from replay(bundle, suite)
    blocks.__name__ = suite
    chapter(title, suite=suite)(blocks)


errors_of("ladder", "Every method by degree",
          "The p~ of a converted path is that of the form in which the curve is given, so the tables show what the conversion adds.")
errors_of("regimes", "At the limits: parameters, coordinates, degrees, float, dimensions",
          "u is that of the scalar: 2^-53 for double, 2^-24 for float. Means are over finite trials; where trials overflow, the finite ones of "
          "that cell are its milder ones, and its mean cannot be compared with those of other cells.", swept)


@chapter("Near multiple roots: relative error against the condition number", suite="conditioning")
def conditioning(bundle, findings):
    """A table for each study and degree: the condition number rises from column to column."""
    table = bundle.exact("conditioning")
    if "p50_condition" not in table.columns:
        raise Missing("`accuracy.csv` has no column `p50_condition`")
    yield from of_suite(findings, "conditioning")
    yield from figure("error_against_condition", bundle)
    for (study, degree), rows in grouped(table.rows, "study", "degree").items():
        yield _by_condition(study, degree, rows)
    yield Text("The coefficients are exact, so the error is that of the evaluation alone, and the condition number is that of the form in which the "
               "curve is given, also for converted paths. Medians of relative error and condition number are taken separately. A relative error of "
               "exactly 1 is a computed 0.")
    yield from replay(bundle, "conditioning")


def _by_condition(study, degree, rows):
    """Columns by rising condition number; the first lines are those of the curves, the others those of the methods."""
    columns = sorted({r["interval"]: r for r in rows}.values(), key=lambda r: r["p50_condition"] or 0)
    csv = ("method", "t_min", "t_max", "p50_condition", "max_condition", "p50_relative", "max_relative")

    def lines(own, kind):
        at = {r["interval"]: r for r in own}
        return tuple((label, [Cell(scientific(at[c["interval"]][f"{statistic}_{kind}"]), at[c["interval"]].text(f"{statistic}_{kind}"))
                              if c["interval"] in at else Cell() for c in columns]) for label, statistic in (("median", "p50"), ("largest", "max")))
    english = form(rows[0]["form"])[0]
    return Table(id=f"{study}-{shortest(degree)}", caption=f"Condition number and relative error, degree {shortest(degree)}, {english} "
                 f"({rows[0]['generator']} inputs)",
                 groups=(Group("condition number", "condition", lines(columns, "condition")),
                         *(Group(f"`{method}`", method, lines(own, "relative")) for method, own in grouped(rows, "method").items())),
                 axis="median condition number; the intervals of t are in the CSV file", row_head="over the trials",
                 head=tuple(factor(r.number("p50_condition")) for r in columns), csv_head=csv,
                 csv_rows=tuple(tuple(r.text(c) for c in csv) for r in rows))


@chapter("Conversions, and their effect on evaluated points", suite="conversion")
def conversion(bundle, findings):
    """Coefficients, parts of the error, and error over t, each as figure and tables where the bundle has the rows."""
    if not bundle.has_suite("conversion"):
        raise Missing("the bundle has no study of the suite `conversion`")
    yield from of_suite(findings, "conversion")
    for part in (_coefficients, _parts, _over_t):
        try:
            yield from list(part(bundle))
        except Missing:
            pass  # a bundle may have the rows of one part only
    yield from replay(bundle, "conversion")


def _coefficients(bundle):
    table = bundle["conversion.csv"].of_suite("conversion")
    yield Heading("Coefficients")
    yield from figure("conversion_coefficients", bundle)
    for study in table.distinct("study"):
        yield from _coefficient_table(bundle, study)
    yield Text("The error of a conversion is the largest distance of a converted coefficient from the exact one, in coordinate units; R is the range, "
               "d the number of axes. The dashed lines are not fitted: u R √d times the norm is the possible effect of one rounding of the given "
               "coefficients. A conversion of whole numbers is exact as long as they fit into 53 bits.")


@tables_of("conversion")
def _coefficient_table(bundle, study):
    rows = bundle["conversion.csv"].some(study=study)
    title = NORMS[rows[0]["form"]][0] if rows[0]["form"] in NORMS else study
    for where, own in inputs.by_set(rows):
        lines = [(f"{name}, {inputs.PLACED.get(g, g)}", one(column, scientific), {"generator": g}) for g in distinct(own, "generator")
                 for name, column in (("mean", "mean_error"), ("largest", "max_error"))]
        yield by_axis(own, "degree", study, f"{title}: error of the coefficients{where}", lines, method="conversion", row_head="inputs")


def _parts(bundle):
    rows = sources(bundle)
    yield Heading("Where the error of a path comes from")
    yield from figure("conversion_sources", bundle)
    for (study, degree), own in grouped(rows, "study", "degree").items():
        english = form(own[0]["form"])[0]
        yield by_axis(own, "interval", f"{study}-parts-{shortest(degree)}",
                      f"Mean error and its parts, degree {shortest(degree)}, {english} (coordinate units)",
                      [(name, one(column, scientific), {}) for column, name in (("mean_error", "error"), *SOURCES)], row_head="part")
    yield Text("Conversion: the exactly evaluated converted curve against the given one. Rounding of 1-t: the effect of t and the rounded 1-t on the "
               "curve. Evaluation: the rest. Each is a mean of distances, so the parts need not add up, and the error is over more trials than its "
               "parts.")


def _over_t(bundle):
    rows = bundle.exact("conversion").rows
    yield Heading("Error against the interval of t")
    drawn = figure("conversion_interval", bundle)
    yield from drawn
    for study, own in grouped(rows, "study").items():
        yield from error_tables(study, own, "interval", "degree")
    if drawn:
        yield Text("(1+2t)^n is the sum of |C(n,j)| (2t)^j: the size that the power form of a curve with coefficients of size one can reach at t. It is "
                   "drawn at the middles of the intervals, and its scale is fixed by the first interval alone: there it starts at the error of the "
                   "path that is worst in the last one.")


@chapter("Worst cases, sampled and searched", suite="worst")
def worst(bundle, findings):
    """Sampled <= searched <= bound for every method and degree."""
    tables = search_tables(bundle, "worst")
    yield from of_suite(findings, "worst")
    yield from figure("searched_maxima", bundle)
    yield from tables
    yield Text("A searched maximum is a lower bound of the worst case, and the proved bound an upper one; the worst case itself is not known. "
               "`reached`: the search gained the requested factor over the sample. `near_bound`: it cannot, since the sample alone is that close to the "
               "bound. `short`: neither. `non_finite`: an input was found whose value is not finite. Every case can be replayed from its bits: "
               "`bezierbench replay BUNDLE ID` with the id of its line.")


def _searched(bundle):
    try:
        return search_tables(bundle, "rational")
    except Missing:
        return ()  # searches are a study of their own, which a bundle may omit


errors_of("rational", "Rational curves",
          "p~ of a rational curve is the sum of the absolute terms of its numerator over the absolute value of its denominator. Weights are "
          "positive: a bound holds under the conditions that are stated with the method.", lambda rows: swept(rows)[:1], _searched)
