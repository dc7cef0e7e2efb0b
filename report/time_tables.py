# SPDX-License-Identifier: MIT
"""Times by the problem that was solved: a table for each timing study, in whichever chapter the problem stands."""

from . import schema
from .bundle import Missing
from .document import Cell, Text
from .limits import nearness
from .tables import axis_value, by_axis
from .wording import general, listing, shortest

EVALUATION = "evaluation"
# what may tell the lines of a method apart, and how a line says it
APART = {"mode": str, "degree": lambda v: f"degree {shortest(v)}", "order": lambda v: f"order {shortest(v)}",
         "tolerance": lambda v: f"to {shortest(v)}", "data": str, "points": lambda v: f"{shortest(v)} points",
         "coordinate_range": lambda v: f"R = {shortest(v)}", "generator": lambda v: f"{v} inputs",
         "interval": lambda v: f"t in [{shortest(v[0])}, {shortest(v[1])}]"}
MICROSECONDS = 1e4  # ns from which on a time is better read in µs,
SHORTEST = 1e2  # where the shortest is no small part of one


def times(bundle, problem):
    """The rows of timing.csv about that problem, without sentinels; none where the bundle has no times."""
    if "timing.csv" not in bundle:
        return []
    listed = bundle["methods.csv"].rows if "methods.csv" in bundle else []
    problems = {row["id"]: row["problem"] for row in listed if row["problem"] != "conversion"}
    return [r for r in bundle["timing.csv"].rows
            if r["degree"] is not None and problems.get(r["method"], EVALUATION) == problem]


def time_tables(bundle, problem):
    """One table per study, scalar type and dimension: medians with their intervals, and where the bundle knows them how near they
    are to their limits. The axis of the problem runs across, what else varies stands at the lines."""
    unit, chinese, axis = (schema.timed()[problem][key] for key in ("unit", "unit_zh", "across"))
    studies = {}
    for row in times(bundle, problem):
        studies.setdefault(row["study"], {}).setdefault((row["scalar"], row["dimension"]), []).append(row)
    for study, kinds in studies.items():
        for number, ((scalar, dimension), rows) in enumerate(kinds.items(), 1):
            medians = [r["median_ns"] for r in rows]
            long = max(medians) >= MICROSECONDS and min(medians) >= SHORTEST
            scale, english, unit_zh = (1e-3, "Micro", "微秒") if long else (1, "Nano", "纳秒")
            yield by_axis(
                rows, axis, f"timing-{study}" + (f"-{number}" if len(kinds) > 1 else ""),
                f"{english}seconds per {unit}: {bundle.title(study)} ({scalar or 'double'}, "
                f"{shortest(dimension) or 'any number of'} axes)", f"每{chinese}用时（{unit_zh}）",
                _lines(rows, axis, scale), row_head="time")
            yield from nearness(rows)


def _lines(rows, axis, scale):
    """A line for each value of what varies beside the axis; the mode where nothing does."""
    varies = [c for c in APART if c != axis and len({axis_value(r, c) for r in rows}) > 1] or ["mode"]
    keys = list(dict.fromkeys(tuple(axis_value(r, c) for c in varies) for r in rows))
    return [(", ".join(APART[c](value) for c, value in zip(varies, key) if value is not None),
             lambda r: _cell(r, scale), lambda r, key=key: tuple(axis_value(r, c) for c in varies) == key) for key in keys]


def _cell(row, scale):
    failed = "" if row["checked"] == "yes" else " ✗"
    noisy = " ~" if row["quality"] == "noisy" else ""
    median, low, high = (general(scale * row[c]) for c in ("median_ns", "low_ns", "high_ns"))
    return Cell(f"{median} [{low} – {high}]{noisy}{failed}", row.text("median_ns"), "outside" if failed else "")


def _without_bound(bundle):
    """What results without a proved bound were held to."""
    if "allowed_error_u" not in bundle["timing.csv"].columns:
        return "or, where none is proved, a lenient one"
    return ("or, where none is proved, has no error above a multiple of the largest that an accuracy study of this bundle saw in the "
            "same cell (`allowed_error_u`), or has half of its digits where there is no such study")


def reading_times(bundle, problem):
    """What the numbers, brackets and marks of such tables mean, as far as they occur."""
    rows = times(bundle, problem)
    wrong = list(dict.fromkeys(r["method"] for r in rows if r["checked"] != "yes"))
    return Text(
        ("" if problem == EVALUATION else f"A time is that of one {schema.timed()[problem]['unit']} from the control points or the data on, all that "
         "a method prepares included. ")
        + "The interval in brackets, `low_ns` to `high_ns` of the file, covers how far the median varies from one race to another of "
        "the same methods, spread over the run. Every timed output was checked against one that was judged first: right where "
        f"{schema.timed()[problem]['right']}" + (f" {_without_bound(bundle)}" if problem == EVALUATION else "") + (f"; **✗ marks times of {listing(f'`{m}`' for m in wrong)} whose output was not right, or another.**" if wrong else ".")
        + (" A time marked ~ comes from a race in which fixed work beside it changed its speed by more than 2 %: "
           "ratios within a race stand, times of different races compare badly." if any(r["quality"] == "noisy" for r in rows) else ""))


def fits_with_times(bundle, study="companion_speed-fitting", errors="companion_speed-fitting_errors"):
    """[(row of timing.csv, row of fitting.csv)] about the same tolerance, of data that were drawn alike."""
    same = ("method", "dimension", "degree", "coordinate_range", "generator", "data", "points", "tolerance")
    judged = {tuple(r[c] for c in same): r for r in bundle["fitting.csv"].some(study=errors)}
    pairs = [(r, judged[key]) for r in bundle["timing.csv"].select(study=study)
             if (key := tuple(r[c] for c in same)) in judged]
    if not pairs:
        raise Missing(f"`timing.csv` has no row of `{study}` about what `{errors}` judged")
    return pairs
