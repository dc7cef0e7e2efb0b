# SPDX-License-Identifier: MIT
"""Errors of a study as tables: means and maxima with their bounds, what a tolerance costs, what a search finds."""

import math

from . import inputs
from .document import Cell, Group, Table, Text
from .findings.conclusions import in_part
from .findings.evaluators import exceeding, gain
from .methods import form
from .rows import distinct, grouped
from .tables import by_axis, one
from .wording import count, factor, general, large, shortest

CELL = ("form", "scalar", "dimension", "degree", "order", "points", "knots", "coordinate_range", "interval", "curves", "generator")  # what distinguishes cells
NAMES = {"curves": "{}", "generator": "{}", "scalar": "{}", "dimension": "{} axes", "degree": "degree {}", "order": "order {}", "points": "{} points",
         "knots": "{} knots", "coordinate_range": "R = {}"}
DRAWN = ("generator", "knots")  # kinds of inputs on which a bound does not depend


def swept(rows):
    """(axis across, kind of inputs down) of a study: what it varies, the longest axis that tables and figures know first."""
    def varies(column):
        return len(distinct(rows, column)) > 1
    across = next((a for a in ("curves", "interval", "coordinate_range", "degree") if varies(a)), "degree")
    return across, next((d for d in ("scalar", "dimension", "degree", "coordinate_range", "generator") if d != across and varies(d)), "generator")


def swept_with(case, rows):
    """The same where an axis of cases, such as the order of a derivative, distinguishes rows as well: it runs across where it has more
    values than the degree has and no other axis runs there, and down otherwise."""
    across = swept(rows)[0]
    if across == "degree" and len(distinct(rows, case)) > len(distinct(rows, "degree")):
        return case, "degree"
    return across, case


def error_tables(study, rows, across="degree", down="generator", curves=None):
    """Two tables for each cell of the remaining axes, then the bound violations. `curves`: what the curves are, where that is not
    their form."""
    cells = grouped(rows, *(c for c in CELL if c not in (across, down)))
    for number, members in enumerate(cells.values(), 1):
        yield from _pair(study if len(cells) == 1 else f"{study}-{number}", members, across, down, curves)
    yield _bounds(rows)


# The same quantity in the other units of accuracy.csv; a bound is stated in coordinate units, too.
UNITS = {
    "mean_error_u": (("coordinate", "mean_error"), ("ulp", "mean_error_ulp"), ("relative", "mean_relative"), ("size", "mean_error_size")),
    "max_error_u": (("coordinate", "max_error"), ("ulp", "max_error_ulp"), ("relative", "max_relative"), ("size", "max_error_size")),
    "bound_u": (("coordinate", "max_bound"),),
}


def _number(column):
    def cell(rows):
        units = tuple((unit, general(rows[-1][other])) for unit, other in UNITS[column] if isinstance(rows[-1][other], float))
        shown = one(column)(rows)
        return shown if rows[-1]["status"] != "ok" else Cell(shown.text, shown.raw, units=units)
    return cell


def _counted(column):
    def cell(rows):
        return Cell(f"{rows[-1][column]:g}", rows[-1].text(column), "outside") if rows[-1][column] else Cell()
    return cell


def _where(row, across, down):
    """What all rows of a table have in common."""
    parts = {"degree": f"degree {shortest(row['degree'])}", "scalar": row["scalar"], "dimension": count(int(row["dimension"] or 0), "axis", "axes"),
             **inputs.parts(row)}
    if row["knots"] is not None:
        parts["knots"] = f"{row['knots']} knots"
    if across == "curves":
        parts["curves"] = "curves of sets"
    return ", ".join(text for name, text in parts.items() if name == "curves" or name not in (across, down))


def named(down, kind):
    """A kind of inputs in words: `degree 3`."""
    return NAMES[down].format(shortest(kind) if isinstance(kind, float) else inputs.PLACED.get(kind, kind))


def _pair(study, rows, across, down, curves):
    english = curves or form(rows[0]["form"])[0]
    where, trials, kinds = _where(rows[0], across, down), large(max(r["trials"] for r in rows)), distinct(rows, down)
    drawn = down in DRAWN

    means = [(inputs.kind(k) if down == "generator" else named(down, k), _number("mean_error_u"), {down: k}) for k in kinds]
    yield by_axis(rows, across, f"{study}-mean", f"Mean error over u p~, {english} ({where}, {trials} trials per cell)", means, row_head="inputs" if down == "generator" else down)
    lines = [(f"largest, {named(down, k)}", _number("max_error_u"), {down: k}) for k in kinds]
    lines += [("proved bound" if drawn else f"proved bound, {named(down, k)}", _number("bound_u"), {down: k})
              for k in (kinds[:1] if drawn else kinds)]
    lines += [("violations", _counted("bound_violations"), {}), ("not finite", _counted("non_finite"), {})]
    yield by_axis(rows, across, f"{study}-largest", f"Largest error over u p~ and its proved bound, {english} ({where})", lines, row_head="quantity")


def _bounds(rows):
    judged = [r for r in rows if r["bound_violations"] is not None]
    broken = sum(r["bound_violations"] for r in judged)
    return Text(f"Bound violations: {broken:g} in {large(sum(r['trials'] for r in judged))} trials. The bound is the largest of bound "
                "over u p~ among the trials; a method without a line has no proved bound."
                + (" An error above it that is not a violation comes from a trial to which the proof does not apply."
                   if any(map(in_part, judged)) else ""))


def tolerance_tables(study, rows, caption, lines):
    """Tables of methods that are given a tolerance, for each kind of curves, tolerances side by side. `lines` are (label, column, function of
    a value to its text)."""
    for number, members in enumerate(grouped(rows, "degree", "coordinate_range", *inputs.ONE_SET).values(), 1):
        row = members[0]
        where = f"degree {shortest(row['degree'])}, {count(int(row['dimension'] or 0), 'axis', 'axes')}, {inputs.words(row, 'interval')}, {large(row['trials'])} trials"
        yield by_axis(members, "tolerance", f"{study}-{number}", f"{caption} ({where})",
                      [(label, one(column, write, "outside" if column == "broken_promises" else ""), {}) for label, column, write in lines],
                      row_head="quantity")


def search_tables(bundle, *suites):
    """One Table per study, in the order of search.csv."""
    return [search_table(study, rows) for study, rows in grouped(bundle["search.csv"].of_suite(*suites).rows, "study").items()]


def search_table(study, rows):
    """Sampled and searched maximum of a study beside its proved bound; the gain is searched over sampled maximum."""
    broken = exceeding([r for r in rows if isinstance(r["searched_error_u"], float)])
    varying = [c for c in NAMES if len(distinct(rows, c)) > 1] or ["degree"]
    groups = tuple(Group(f"`{m}`", m, tuple((", ".join(named(c, r[c]) for c in varying), _searched(r, r in broken)) for r in own))
                   for m, own in grouped(rows, "method").items())
    english = form(rows[0]["form"])[0]
    return Table(id=f"{study}-search", caption=f"Sampled and searched maximum over u p~ and proved bound, {english} "
                 f"({large(max(r['trials'] for r in rows))} trials, then {large(max(r['budget'] for r in rows))} steps)", groups=groups, row_head="cell",
                 head=("sampled", "searched", "proved bound", "gain", "status", "id"))


def _searched(row, broken):
    known = all(isinstance(row[c], float) and math.isfinite(row[c]) for c in ("sampled_error_u", "searched_error_u"))
    return [Cell(general(row["sampled_error_u"]), row.text("sampled_error_u")),
            Cell(general(row["searched_error_u"]), row.text("searched_error_u"), "outside" if broken else ""),
            Cell(general(row["bound_u"]), row.text("bound_u")), Cell(factor(gain(row)), repr(gain(row))) if known else Cell(),
            Cell(row.text("status"), row.text("status"), "outside" if row["status"] == "non_finite" else ""),
            Cell(f"`{row['search_id']}`", row["search_id"])]
