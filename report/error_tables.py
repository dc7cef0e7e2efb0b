# SPDX-License-Identifier: MIT
"""Mean and largest error of a study as tables: methods down, one axis across, a line for each kind of inputs."""

from .document import Cell, Text
from .findings.conclusions import in_part
from .methods import form
from .tables import axis_value, by_axis
from .wording import count, general, interval, large, shortest

CELL = ("scalar", "dimension", "degree", "order", "points", "knots", "coordinate_range", "t_min", "t_max", "generator")  # what sets a cell apart
COLUMNS = {"interval": ("t_min", "t_max")}  # of an axis that is not a column itself
NAMES = {"generator": "{}", "scalar": "{}", "dimension": "{} axes", "degree": "degree {}", "order": "order {}", "points": "{} points",
         "knots": "{} knots", "coordinate_range": "R = {}"}


def swept(rows):
    """(axis across, kind of inputs down) of a study: what it varies, the longest axis that tables and figures know first."""
    def varies(name):
        return len({axis_value(r, name) for r in rows}) > 1
    across = next((a for a in ("interval", "coordinate_range", "degree") if varies(a)), "degree")
    down = next((d for d in ("scalar", "dimension", "degree", "coordinate_range", "generator")
                 if d != across and varies(d)), "generator")
    return across, down


def swept_with(case, rows):
    """The same where an axis of cases, such as the order of a derivative, sets rows apart as well: it runs across where it has more
    values than the degree has and no other axis runs there, and down otherwise."""
    across = swept(rows)[0]
    if across == "degree" and len({r[case] for r in rows}) > len({r["degree"] for r in rows}):
        return case, "degree"
    return across, case


def error_tables(study, rows, across="degree", down="generator", curves=None):
    """Two tables for each cell of the remaining axes, then what became of the bounds. `curves`: what the
    curves are, in English and Chinese, where that is not their form."""
    free = {*COLUMNS.get(across, (across,)), down}
    fixed = [c for c in CELL if c not in free]
    cells = {}
    for row in rows:
        cells.setdefault(tuple(row[c] for c in fixed), []).append(row)
    for number, members in enumerate(cells.values(), 1):
        yield from _pair(study if len(cells) == 1 else f"{study}-{number}", members, across, down, curves)
    yield _bounds(rows)


# The same quantity in the other units of accuracy.csv; a bound is stated in coordinate units, too.
UNITS = {
    "mean_error_u": (("coordinate", "mean_error"), ("ulp", "mean_error_ulp"), ("relative", "mean_relative")),
    "max_error_u": (("coordinate", "max_error"), ("ulp", "max_error_ulp"), ("relative", "max_relative")),
    "bound_u": (("coordinate", "max_bound"),),
}


def _number(column):
    def cell(row):
        if row["status"] != "ok":
            return Cell(row["status"] or "", row["status"] or "")
        return Cell(general(row[column]), row.text(column),
                    units=tuple((unit, general(row[other])) for unit, other in UNITS[column] if isinstance(row[other], float)))
    return cell


def _counted(column):
    def cell(row):
        return Cell(f"{row[column]:g}", row.text(column), "outside") if row[column] else Cell()
    return cell


def _where(row, across, down):
    """What all rows of a table have in common."""
    axes = int(row["dimension"] or 0)
    parts = {"degree": f"degree {shortest(row['degree'])}", "scalar": row["scalar"], "dimension": count(axes, "axis", "axes"),
             "coordinate_range": f"R = {shortest(row['coordinate_range'])}", "interval": f"t in {interval(row['t_min'], row['t_max'])}",
             "generator": f"{row['generator']} inputs"}
    if row["knots"] is not None:
        parts["knots"] = f"{row['knots']} knots"
    return ", ".join(text for name, text in parts.items() if name not in (across, down))


def named(down, kind):
    """A kind of inputs in words: `degree 3`."""
    return NAMES[down].format(shortest(kind) if isinstance(kind, float) else kind)


def _pair(study, rows, across, down, curves):
    english, chinese = curves or form(rows[0]["form"])
    where, trials = _where(rows[0], across, down), large(max(r["trials"] for r in rows))
    kinds = list(dict.fromkeys(r[down] for r in rows))

    def line(text, column, kind):
        return (text, _number(column), lambda r: r[down] == kind)

    means = [line(named(down, k) + (" inputs" if down == "generator" else ""), "mean_error_u", k) for k in kinds]
    yield by_axis(rows, across, f"{study}-mean", f"Mean error over u p~, {english} ({where}, {trials} trials per cell)",
                  f"平均误差（以 u p~ 计），{chinese}", means, row_head="inputs" if down == "generator" else down)
    lines = [line(f"largest, {named(down, k)}", "max_error_u", k) for k in kinds]
    # the bound depends on method and degree, not on the kind of inputs
    drawn = down in ("generator", "knots")
    lines += [line("proved bound" + ("" if drawn else f", {named(down, k)}"), "bound_u", k) for k in (kinds[:1] if drawn else kinds)]
    lines += [("violations", _counted("bound_violations"), lambda r: True), ("not finite", _counted("non_finite"), lambda r: True)]
    yield by_axis(rows, across, f"{study}-largest", f"Largest error over u p~ and its proved bound, {english} ({where})",
                  f"最大误差与已证误差界（以 u p~ 计），{chinese}", lines, row_head="quantity")


def _bounds(rows):
    judged = [r for r in rows if r["bound_violations"] is not None]
    broken = sum(r["bound_violations"] for r in judged)
    return Text(f"Bound violations: {broken:g} in {large(sum(r['trials'] for r in judged))} trials. The bound is the largest of bound "
                "over u p~ among the trials; a method without a line has no proved bound."
                + (" An error above it that is no violation is that of a trial outside what is proved." if any(map(in_part, judged))
                   else ""))
