# SPDX-License-Identifier: MIT
"""The first minute: machine and build, violations, noise, digest."""

import statistics

from .. import schema
from ..bundle import Missing
from ..document import Bullets, Heading, Text, Tile, Tiles
from ..findings.roster import grouped
from ..wording import count, large, percent
from .parts import chapter

COUNTED = {"exhaustive.csv": "points", "easing_floats.csv": "points"}  # the column of the judged inputs, where it is not `trials`
NOT_JUDGED = ("reference.csv", "audit.csv", "worst.csv", "conversion.csv")
BROKEN = {"bound_violations": ("violation of a proved bound", "violations of proved bounds"),
          "broken_promises": ("broken promise", "broken promises")}


@chapter("The verdict on the source report", suite="report")
def verdict(bundle, findings):
    """What is reproduced, then each statement with what the bundle says of it."""
    decided = [f for f in findings[0] if not f.suite]
    if not bundle.has_suite("report") or not any(f.claim for f in decided):
        raise Missing("no statement of the source report can be judged")
    yield Text("“The report” is the source report of this project. Each line is judged from the numbers of this bundle; what decides it stands under "
               "“What was found”.")
    for heading, members in grouped(decided):
        yield Heading(heading)
        yield Bullets(tuple(f"**{f.headline}** The report says{f' ({f.place})' if f.place else ''}: {f.claim}" if f.claim else f.headline for f in members))


@chapter("At a glance", whole=True)
def opening(bundle, _findings):
    """Whether the bundle is complete, then the tiles."""
    if bundle.info.get("state") != "complete":
        yield Text(f"**The state of this bundle is {bundle.info.get('state', 'unknown')}: the run is not complete.** Every number below is of the part "
                   "that is there.")
    yield Tiles((*_machine_and_build(bundle), *_judged(bundle), _times(bundle), _digest(bundle)))


def _text(value, *keys):
    """The text or number at a path of a JSON object; empty where there is none."""
    for key in keys:
        value = value.get(key) if isinstance(value, dict) else None
    return str(value) if isinstance(value, (str, int, float)) and not isinstance(value, bool) and value != "unknown" else ""


def _joined(*parts):
    return ", ".join(part for part in parts if part)


def _machine_and_build(bundle):
    machine = bundle.machine or {}
    cores = _text(machine, "cpu", "logical_cores_available")
    virtual = isinstance(machine.get("cpu"), dict) and machine["cpu"].get("virtualised") is True
    yield Tile("machine", _text(machine, "cpu", "model_name") or "unknown",
               _joined(_text(machine, "cpu", "architecture"), cores and f"{cores} cores", "virtual" if virtual else ""))
    commit, version = (_text(bundle.info, key) for key in ("git_commit", "program_version"))
    yield Tile("build", _text(machine, "build", "compiler") or "unknown",
               _joined(version and f"version {version}",
                       commit and f"commit {commit[:10]}{' with changes' if bundle.info.get('git_clean') is False else ''}"))


def _judged(bundle):
    """How many trials were judged, and how many broke a proved bound or a promise."""
    trials, methods, broken = 0, set(), {}
    for file, table in bundle.tables.items():
        judged = COUNTED.get(file, "trials")
        if judged not in table.columns or "method" not in table.columns or file in NOT_JUDGED or not schema.is_declared(file):
            continue
        for row in table.rows:
            if row["baseline"] in (None, "exact") and isinstance(row[judged], float):
                trials += row[judged]
                methods.add(row["method"])
            for column in BROKEN:
                if isinstance(row[column], float):
                    broken[column] = broken.get(column, 0) + row[column]
    yield Tile("judged", large(trials), f"evaluations by {count(len(methods), 'method')} against the exact value")
    total = sum(broken.values())
    found = [f"1 {one}" if broken[column] == 1 else f"{large(broken[column])} {many}" for column, (one, many) in BROKEN.items() if broken.get(column)]
    yield Tile("violations", large(total) if broken else "none judged", _joined(*found) or _joined(*(many for column, (_, many) in BROKEN.items() if column in broken)),
               "outside" if total else "inside" if broken else "")


def _times(bundle):
    """How wide the intervals of the ratios are, which says how small a difference the times can show."""
    ratios = [r for r in bundle.tables["timing.csv"].rows if r["ratio"] and r["relative_to"] != r["method"]] if "timing.csv" in bundle else []
    if not ratios:
        return Tile("times", "none", "nothing was timed")
    width = statistics.median((r["ratio_high"] - r["ratio_low"]) / r["ratio"] for r in ratios)
    return Tile("times", percent(width), f"the median width of the intervals of {count(len(ratios), 'ratio')} of times")


def _digest(bundle):
    digest = _text(bundle.info, "accuracy_digest")
    if not digest:
        return Tile("digest", "unknown", "the bundle has no accuracy digest")
    return Tile("digest", digest[:10], "of all accuracy data: the same everywhere", full=digest)
