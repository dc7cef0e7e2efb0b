# SPDX-License-Identifier: MIT
"""Times of evaluators: every timed method, times against errors, other libraries."""

from .. import schema
from ..answer import USELESS, lost, useful
from ..bundle import Missing
from ..document import Cell, Text
from ..methods import form
from ..predictions import predictions
from ..rows import distinct, grouped
from ..tables import by_axis, one
from ..time_tables import EVALUATION, reading_limits, reading_load, reading_times, time_tables, times, where
from ..wording import count, general, large, listing, shortest
from .parts import chapter, figure, of_suite, study_figure, tables_of


@chapter("Time per point on this machine", kind="timing")
def timing(bundle, _findings):
    """One table per study: median with its interval, by mode. Times of other problems stand in the chapters of these."""
    rows = times(bundle, EVALUATION) if bundle["timing.csv"].rows else []
    if not rows:
        raise Missing("`timing.csv` has no time of an evaluation; times of other problems are in their chapters")
    yield Text("`one_shot`: prepare a curve and evaluate one point. `point`: prepared, one point at a time. `latency`: likewise, where each t depends on "
               "the previous point. `batch`: one curve, many t.")
    yield reading_times(bundle, EVALUATION)
    yield from filter(None, (reading_load(bundle), reading_limits(rows)))
    for study in distinct(rows, "study"):
        yield from study_figure(bundle, study)
        yield from time_tables(bundle.only({study}), EVALUATION)
    yield from predictions(bundle, rows)


@tables_of("timing")
def _any_times(bundle, study):
    """Medians with their intervals, whatever problem was timed."""
    part = bundle.only({study})
    for problem in schema.timed():
        if times(part, problem):
            yield from time_tables(part, problem)
            yield reading_times(part, problem)


@chapter("Time against error", kind="timing")
def choosing(bundle, findings):
    """A table for each form and scalar type of the methods that are on the front anywhere."""
    rows = bundle["pareto.csv"].rows
    if not rows:
        raise Missing("`pareto.csv` has no rows")
    yield from of_suite(findings, "speed")
    yield from figure("time_against_error", bundle)
    yield Text("Each cell gives nanoseconds per point and the largest observed error, in units of u p~. ✓: no other method of the same race is at least "
               "as accurate and certainly faster. ✗: useless, since its largest error exceeds "
               f"{shortest(USELESS)} of p~, whatever its time. ?: another method is at least as accurate and faster by its median, but the 99 % intervals "
               "of the two times overlap. Methods that are dominated everywhere are in `pareto.csv` only. `bezierbench choose BUNDLE --degree N "
               "--tolerance E` answers the same question for a tolerance.")
    for number, own in enumerate(grouped(rows, "study", "accuracy_study", "form", "scalar", "dimension").values(), 1):
        worth = {(r["method"], r["mode"]) for r in own if r["pareto"] != "no" and useful(r["observed_max_u"], r["scalar"])}
        english, modes = form(own[0]["form"])[0], distinct(own, "mode")
        yield by_axis([r for r in own if (r["method"], r["mode"]) in worth], "degree", f"choosing-{number}",
                      f"Not dominated, {english} ({where(own[0])}): times of `{own[0]['study']}`, errors of `{own[0]['accuracy_study']}`, modes "
                      f"{listing(modes)}", [(mode, _chosen, {"mode": mode}) for mode in modes], row_head="mode")


def _chosen(rows):
    row = rows[-1]
    good, loss = useful(row["observed_max_u"], row["scalar"]), lost(row["observed_max_u"])
    text = ", ".join(filter(None, (f"{general(row['ns'])} ns", f"{general(row['observed_max_u'])} u", loss)))
    return Cell(text + ({"yes": " ✓", "unresolved": " ?"}.get(row["pareto"], "") if good else " ✗"),
                f"{row.text('ns')} {row.text('observed_max_u')} {row.text('pareto')}",
                "outside" if not good else "inside" if row["pareto"] == "yes" and not loss else "")


PEER = "peer_"  # how the ids of other libraries' methods begin
MODES = {"point": "ns per point, prepared", "one_shot": "ns, prepare and one point"}


@chapter("Other libraries", suite="peers")
def peers(bundle, findings):
    """One table: the errors and times of each method, degree by degree."""
    errors = bundle.exact("peers").select(form="bernstein", scalar="double", dimension=2)
    if not any(r["method"].startswith(PEER) for r in errors):
        raise Missing("`unstable.csv` has no method of another library in a study of the suite `peers`")
    timed = [r for r in bundle["timing.csv"].rows if bundle.studies[r["study"]].suite == "peers" and r["degree"] is not None
             and r["form"] == "bernstein" and r["mode"] in MODES] if "timing.csv" in bundle else []
    yield from of_suite(findings, "peers")
    for study in distinct(errors, "study"):
        yield from study_figure(bundle, study)
    lines = [(label, one(column), {"mode": None}) for label, column in (
        ("mean error / (u p~)", "mean_error_u"), ("largest error / (u p~)", "max_error_u"), ("largest error", "max_error"))]
    yield by_axis([*errors, *timed], "degree", "peers-errors-and-times", "Errors and times of our own methods and of other libraries', Bézier curves", lines + [(label, _time, {"mode": mode}) for mode, label in MODES.items()], row_head="quantity")
    yield Text(f"{large(max(r['trials'] for r in errors))} trials per cell against the exact value, in double in the plane; every method on the same "
               "inputs, through the same harness, timed in the same races. " + _libraries(bundle)
               + "Header-only libraries are compiled like our own methods, the others are as the system ships them, so last bits may differ from version "
                 "to version: their errors are in `unstable.csv`, which no digest covers."
               + (" ✗: the timed output was not the judged one." if any(r["checked"] != "yes" for r in timed) else ""))


def _time(rows):
    row = rows[-1]
    failed = "" if row["checked"] == "yes" else " ✗"
    return Cell(general(row["median_ns"]) + failed, row.text("median_ns"), "outside" if failed else "")


def _libraries(bundle):
    """`3 libraries: gsl 2.7.1, ...` as in machine.json."""
    versions = (bundle.machine or {}).get("peers")
    if not isinstance(versions, dict):
        return ""
    return f"{count(len(versions), 'library', 'libraries')}: {listing(f'{library} {version}' for library, version in versions.items())}. "
