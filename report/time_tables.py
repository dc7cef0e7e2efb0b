# SPDX-License-Identifier: MIT
"""Times by the problem that was solved: a table for each timing study, and how near its times are to the limits of the processor."""

from . import inputs, schema
from .bundle import Missing
from .document import Bullets, Cell, Text
from .predictions import column, processors
from .rows import distinct, grouped
from .tables import by_axis
from .wording import count, general, interval, listing, percent, shortest, span

EVALUATION = "evaluation"
# columns in which the lines of a method may differ, and their values in words
APART = {"mode": str, "degree": lambda v: f"degree {shortest(v)}", "order": lambda v: f"order {shortest(v)}",
         "tolerance": lambda v: f"to {shortest(v)}", "data": str, "points": lambda v: f"{shortest(v)} points",
         "coordinate_range": lambda v: f"R = {shortest(v)}", "curves": lambda v: f"set {v}", "generator": inputs.kind, "interval": lambda v: f"t in {interval(*v)}"}
MICROSECONDS = 1e4  # ns from which on a time is easier to read in µs,
SHORTEST = 1e2  # where the shortest is at least a tenth of one
HALF = 0.5  # of the limit, the goal of a coding
SHOWN = 8  # pairs of methods that a sentence names


def where(row):
    """The scalar type and the number of axes of a row of times."""
    return f"{row['scalar'] or 'double'}, {shortest(row['dimension']) or 'any number of'} axes"


def times(bundle, problem):
    """The rows of timing.csv about that problem, without sentinels; none where the bundle has no times."""
    if "timing.csv" not in bundle:
        return []
    listed = bundle["methods.csv"].rows if "methods.csv" in bundle else []
    problems = {row["id"]: row["problem"] for row in listed if row["problem"] != "conversion"}
    return [r for r in bundle["timing.csv"].rows if r["degree"] is not None and problems.get(r["method"], EVALUATION) == problem]


def time_tables(bundle, problem):
    """One table per study, scalar type and dimension: the ratios of times to those of one method with their intervals, the times themselves, and
    where the bundle has limits how near the times are to them; then the counted instructions and predicted cycles. The axis of the problem runs across, everything
    else that varies is named at the lines."""
    unit, axis = (schema.timed()[problem][key] for key in ("unit", "across"))
    for study, of_study in grouped(times(bundle, problem), "study").items():
        kinds = grouped(of_study, "scalar", "dimension").values()
        for number, rows in enumerate(kinds, 1):
            medians = [r["median_ns"] for r in rows]
            long = max(medians) >= MICROSECONDS and min(medians) >= SHORTEST
            scale, english = (1e-3, "micro") if long else (1, "nano")
            table_id = f"timing-{study}" + (f"-{number}" if len(kinds) > 1 else "")
            named = ", ".join(f"`{m}`" for m in distinct(rows, "relative_to") if m)
            yield by_axis(rows, axis, table_id,
                          (f"Time over that of {named}, and about how many {english}seconds" if named else f"{english.capitalize()}seconds")
                          + f" per {unit}: {bundle.title(study)} ({where(rows[0])})",
                          _lines(rows, axis, lambda row, scale=scale: _cell(row, scale)), row_head="time")
            yield from nearness(rows)
            counted = bundle["cost.csv"].select(study=study, scalar=rows[0]["scalar"], dimension=rows[0]["dimension"]) if "cost.csv" in bundle else []
            if counted:
                yield by_axis(counted, axis, table_id.replace("timing", "cost"),
                              f"Instructions per {unit}: {bundle.title(study)} ({where(rows[0])})",
                              _lines(counted, axis, lambda row: Cell(general(row["instructions"], 4), row.text("instructions"))), row_head="instructions")
            for name in processors():
                predicted = [row for row in counted if row[column(name, row["mode"])] is not None]
                if predicted:
                    yield by_axis(predicted, axis, table_id.replace("timing", f"cycles-{name}"),
                                  f"Predicted cycles per {unit} on {name}: {bundle.title(study)} ({where(rows[0])})",
                                  _lines(predicted, axis, lambda row, name=name: Cell(general(row[at := column(name, row["mode"])]), row.text(at))),
                                  row_head="cycles")


def _lines(rows, axis, cell):
    """A line for each value of what varies beside the axis; the mode where nothing does."""
    varies = [c for c in APART if c != axis and len(distinct(rows, c)) > 1] or ["mode"]
    keys = dict.fromkeys(tuple(r[c] for c in varies) for r in rows)
    return [(", ".join(APART[c](value) for c, value in zip(varies, key) if value is not None), lambda own: cell(own[-1]),
             dict(zip(varies, key))) for key in keys]


def _cell(row, scale):
    failed = "" if row["checked"] == "yes" else " ✗"
    about = general(scale * row["median_ns"])
    if row["ratio"] is None:
        low, high = (general(scale * row[c]) for c in ("low_ns", "high_ns"))
        text = f"{about} [{low} – {high}]"
    elif row["relative_to"] == row["method"]:
        text = f"1, {about}"
    else:
        ratio, low, high = (general(row[c]) for c in ("ratio", "ratio_low", "ratio_high"))
        text = f"{ratio} [{low} – {high}], {about}"
    return Cell(text + failed, row.text("median_ns"), "outside" if failed else "")


def reading_times(bundle, problem):
    """The meaning of the numbers, brackets and marks of such tables, as far as they occur."""
    rows = times(bundle, problem)
    wrong = distinct((r for r in rows if r["checked"] != "yes"), "method")
    unproved = ("or, where none is proved, has no error above a multiple of the largest that an accuracy study of this bundle found in the same cell "
                "(`allowed_error_u`), or has half of its digits where there is no such study"
                if "allowed_error_u" in bundle["timing.csv"].columns else "or, where none is proved, a lenient one")
    return Text(
        ("" if problem == EVALUATION else f"A time is that of one {schema.timed()[problem]['unit']}, computed from the control points or the data, all preparation "
         "included. ")
        + "A ratio is that of two times that were taken side by side, in the same rounds; the interval in brackets, `ratio_low` to `ratio_high` of the "
        "file, covers its variation from one race to another of the same methods, spread over the run. The times are those of this machine. "
        f"Every timed output was checked against a judged one first: it is correct where {schema.timed()[problem]['right']}"
        + (f" {unproved}" if problem == EVALUATION else "")
        + (f"; **✗ marks times of {listing(f'`{m}`' for m in wrong)} whose output was incorrect or was not the judged one.**" if wrong else "."))


def fits_with_times(bundle, study="companion_speed-fitting", errors="companion_speed-fitting_errors"):
    """[(row of timing.csv, row of fitting.csv)] about the same tolerance, of data drawn in the same way."""
    same = ("method", "dimension", "degree", "coordinate_range", "generator", "data", "points", "tolerance")
    judged = {tuple(r[c] for c in same): r for r in bundle["fitting.csv"].some(study=errors)}
    pairs = [(r, judged[key]) for r in bundle["timing.csv"].select(study=study) if (key := tuple(r[c] for c in same)) in judged]
    if not pairs:
        raise Missing(f"`timing.csv` has no row of `{study}` about what `{errors}` judged")
    return pairs


def limited(rows):
    """Those that have a limit."""
    return [r for r in rows if r["limit_ns"] is not None and r["share_of_limit"] is not None]


def nearness(rows):
    """Blocks below a table of times: the shares of their limits, which are below one half, and which orders would hold at the limits. None
    where no time has a limit."""
    found = limited(rows)
    if not found:
        return
    without = len(rows) - len(found)
    yield Text("**Distance to the limit.**"
               + (f" {count(without, 'time has', 'times have')} no limit: not all of the work is counted." if without else ""))
    yield Bullets(tuple(_of_mode(mode, members) for mode, members in grouped(found, "mode").items()))
    slow = tuple(f"`{method}`: " + "; ".join(f"`{mode}` at degree {', '.join(map(shortest, sorted(distinct(members, 'degree'))))}{_chain(members)}"
                                             for mode, members in grouped(own, "mode").items())
                 for method, own in grouped((r for r in found if r["share_of_limit"] < HALF), "method").items())
    yield Text("Below one half of the limit:" if slow else "None is below one half of the limit.")
    if slow:
        yield Bullets(slow)
    yield Text(_orders(found))


def _of_mode(mode, rows):
    """`point`: shares from 12 % to 95 %, one half or more at 30 of 40 times; an empty kernel takes 2 ns."""
    calls, shares = [r.number("call_ns") for r in rows], [r["share_of_limit"] for r in rows]
    return (f"`{mode}`: shares from {share_of_limit(min(shares))} to {share_of_limit(max(shares))}, one half or more at "
            f"{sum(share >= HALF for share in shares)} of {count(len(rows), 'time')}; an empty kernel takes {span(min(calls), max(calls), general)} ns.")


def share_of_limit(value):
    """A share of the limit; one above 1 means only that work is done during the call."""
    return percent(value) if value <= 1 else "more than 100 %"


def _chain(rows):
    """The cause that the bundle has: operations of a point that wait for each other."""
    factors = [r["chain_ns"] / r["limit_ns"] for r in rows if r["chain_ns"] and r["limit_ns"]]
    if not factors or max(factors) <= 1:
        return ""
    return f" (its chain of dependent operations takes {span(min(factors), max(factors), lambda v: general(v, 2))} times the limit)"


def orders(rows):
    """({pairs of methods: how many races} whose order at the limits is that of the times, likewise those of which it is not), of the
    pairs of one race whose intervals do not overlap."""
    rows, kept, turned = limited(rows), {}, {}
    method = schema.table(rows[0].file)["method"]
    for race in grouped(rows, *(c for c, declared in schema.columns(rows[0].file).items() if declared.get("key") and c != method)).values():
        for first in race:
            for second in race:
                if first.number("high_ns") < second.number("low_ns"):
                    pairs, pair = kept if first["limit_ns"] < second["limit_ns"] else turned, (first["method"], second["method"])
                    pairs[pair] = pairs.get(pair, 0) + 1
    return kept, turned


def _orders(rows):
    kept, turned = orders(rows)
    held, lost = sum(kept.values()), sum(turned.values())
    if not held + lost:
        return "No two methods of a race differ in time."
    if not lost:
        return f"All {count(held, 'order')} of two methods of a race would hold at the limits."
    named = [f"`{a}` before `{b}` in {count(races, 'race')}" for (a, b), races in sorted(turned.items(), key=lambda item: -item[1])]
    more = [count(len(named) - SHOWN, "other pair")] if len(named) > SHOWN else []
    return (f"Of {count(held + lost, 'order')} of two methods of a race {held} would hold at the limits and {lost} would not: "
            f"{listing(named[:SHOWN] + more)}.")


def reading_limits(rows):
    """What the words mean; None where no time has a limit."""
    if not limited(rows):
        return None
    return Text("The limit of a time (`limit_ns` of the file) is the least that this processor could take for the operations of the method, counted by "
                "kind on its own code, at the speeds of these kinds measured in the same run: with the axes of one point in one vector, in `batch` with "
                "a point in every lane, in `latency` along the longest chain of operations. Loads, stores and branches are not counted. A share of the "
                "limit is the limit over the time minus that of an empty kernel (`call_ns`), which ran in the same race.")


def reading_load(bundle):
    """The load of the machine before the run; None where the bundle does not have it."""
    machine = bundle.machine if isinstance(bundle.machine, dict) else {}
    load, cpu = machine.get("load_average"), machine.get("cpu")
    cores = cpu.get("logical_cores_available") if isinstance(cpu, dict) else None
    if not isinstance(load, list) or len(load) != 3 or not all(isinstance(v, (int, float)) for v in load):
        return None
    return Text(f"Load of the machine when the run began, over 1, 5 and 15 minutes: {listing(general(v) for v in load)}"
                + (f", on {count(cores, 'processor')}." if isinstance(cores, int) else "."))
