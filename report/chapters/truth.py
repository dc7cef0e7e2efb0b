# SPDX-License-Identifier: MIT
"""Methods against the exact value, in units of u p~."""

from ..bundle import Missing
from ..document import Cell, Text
from ..methods import form
from ..tables import by_axis
from ..wording import general, interval, large, listing, shortest

TITLE = "Methods against the truth"
PREFIX = "truth-"
OTHER_AXES = ("scalar", "dimension", "coordinate_range", "t_min", "t_max")  # one table each; the degree runs over columns


def _studies(bundle):
    return [s for s in bundle.judged().distinct("study", baseline="exact") if s.startswith(PREFIX)]


def blocks(bundle, _findings):
    """Per study: mean error; then the largest error beside its proved bound."""
    studies = _studies(bundle)
    if not studies:
        raise Missing(f"`accuracy.csv` has no study whose id starts with `{PREFIX}`")
    yield Text("Errors are Euclidean distances to the exact value, in units of u p~ with u = 2^-53 and p~ the sum of the "
               "absolute terms of the curve at t in the form in which it is given.")
    unstable = list(dict.fromkeys(r["method"] for r in bundle.judged().rows if r.file == "unstable.csv"))
    if unstable:
        yield Text(f"Not part of the accuracy digest, because the machine's mathematics library decides their last bits: "
                   f"{listing(f'`{m}`' for m in unstable)}.")
    for study in studies:
        cells = {}
        for row in bundle.judged().select(study=study, baseline="exact"):
            cells.setdefault(tuple(row[c] for c in OTHER_AXES), []).append(row)
        for number, rows in enumerate(cells.values(), 1):
            yield from _study(study if len(cells) == 1 else f"{study}-{number}", rows)
    figure = _figure(bundle)
    if figure:
        yield figure


def _number(column):
    def cell(row):
        if row["status"] != "ok":
            return Cell(row["status"] or "", row["status"] or "")
        return Cell(general(row[column]), row.text(column))
    return cell


def _study(study, rows):
    english, chinese = form(rows[0]["curve"])
    first = rows[0]
    where = (f"{first['scalar']}, {first.text('dimension')} axes, R = {shortest(first['coordinate_range'])}, t in "
             f"{interval(first['t_min'], first['t_max'])}")
    generators = list(dict.fromkeys(r["generator"] for r in rows))
    trials = large(max(r["trials"] for r in rows))
    means = [(f"{g} inputs", _number("mean_error_u"), lambda r, g=g: r["generator"] == g) for g in generators]
    yield by_axis(rows, "degree", f"{study}-mean", f"Mean error over u p~, {english} ({where}, {trials} trials per cell)",
                  f"平均误差（以 u p~ 计），{chinese}", means, row_head="inputs")
    lines = []
    for g in generators:
        lines += [(f"largest, {g}", _number("max_error_u"), lambda r, g=g: r["generator"] == g)]
    lines += [("proved bound", _number("bound_u"), lambda r: r["generator"] == generators[0]),
              ("violations", lambda r: Cell(f"{r['bound_violations']:g}", r.text("bound_violations"), "outside")
               if r["bound_violations"] else Cell(), lambda r: True)]
    yield by_axis(rows, "degree", f"{study}-largest", f"Largest error over u p~ and its proved bound, {english} ({where})",
                  f"最大误差与已证误差界（以 u p~ 计），{chinese}", lines, row_head="quantity")
    judged = [r for r in rows if r["bound_violations"] is not None]
    broken = sum(r["bound_violations"] for r in judged)
    yield Text(f"Bound violations: {broken:g} in {large(sum(r['trials'] for r in judged))} trials. The bound is the largest of "
               "bound over u p~ among the trials; a method without a line has no proved bound.")


def _figure(bundle):
    from ..figures import truth_against_degree  # needs matplotlib, which --summary does without

    try:
        return truth_against_degree.draw(bundle)
    except Missing:
        return None
