# SPDX-License-Identifier: MIT
"""Other libraries beside our own methods: error and time in one table."""

from ..bundle import Missing
from ..document import Cell, Text
from ..tables import by_axis
from ..wording import count, general, large, listing
from .suite_parts import figure, of_suite

TITLE = "Other libraries"
SUITE = "peers"
PEER = "peer_"  # how the ids of other libraries' methods begin
ERRORS = (("mean error / (u p~)", "mean_error_u"), ("largest error / (u p~)", "max_error_u"), ("largest error", "max_error"))
MODES = {"point": "ns per point, prepared", "one_shot": "ns, prepare and one point"}


def blocks(bundle, findings):
    """Findings, the figure, then one table: each method's errors and times, degree by degree."""
    table = bundle.exact(SUITE)
    errors = table.select(form="bernstein", scalar="double", dimension=2)
    if not any(r["method"].startswith(PEER) for r in errors):
        raise Missing(f"`unstable.csv` has no method of another library in a study of the suite `{SUITE}`")
    times = times_of(bundle)
    yield from of_suite(findings, "peers")
    yield from figure("peers_against_degree", bundle)
    lines = [(label, _error(column), lambda r: r.file != "timing.csv") for label, column in ERRORS]
    lines += [(label, _time, lambda r, mode=mode: r["mode"] == mode) for mode, label in MODES.items()]
    yield by_axis([*errors, *times], "degree", "peers-errors-and-times", "Errors and times of our own methods and of other libraries', Bézier curves",
                  "自有方法与其他程序库：误差与用时", lines, row_head="quantity")
    yield Text(f"{large(max(r['trials'] for r in errors))} trials per cell against the exact value, in double in the plane; every method "
               "on the same inputs, through the same harness, timed in the same races. " + _libraries(bundle)
               + "What a library has in headers is compiled like our own methods, the rest is as the system ships it, so last bits may "
                 "differ from version to version: their errors stand in `unstable.csv`, which no digest covers."
               + (" ✗: the timed output was not the judged one." if any(r["checked"] != "yes" for r in times) else "")
               + (" ~: the machine changed its speed during the race." if any(r["quality"] == "noisy" for r in times) else ""))


def times_of(bundle):
    """The timing rows of the suite, none where the bundle has no times."""
    try:
        rows = bundle["timing.csv"].of_suite(SUITE).rows
    except Missing:
        return []
    return [r for r in rows if r["degree"] is not None and r["form"] == "bernstein" and r["mode"] in MODES]


def _error(column):
    def cell(row):
        if row["status"] != "ok":
            return Cell(row["status"] or "", row["status"] or "")
        return Cell(general(row[column]), row.text(column))
    return cell


def _time(row):
    failed = "" if row["checked"] == "yes" else " ✗"
    return Cell(general(row["median_ns"]) + (" ~" if row["quality"] == "noisy" else "") + failed, row.text("median_ns"),
                "outside" if failed else "")


def _libraries(bundle):
    """`3 libraries: gsl 2.7.1, ...` as machine.json has them."""
    versions = (bundle.machine or {}).get("peers")
    if not isinstance(versions, dict):
        return ""
    named = listing(f"{library} {version}" for library, version in versions.items())
    return f"{count(len(versions), 'library', 'libraries')}: {named}. "
