# SPDX-License-Identifier: MIT
"""The first glance: machine and build, what was judged and what broke, noise, digest."""

from .. import schema
from ..document import Text, Tile, Tiles
from ..wording import count, large

TITLE = "At a glance"
COUNTED = {"exhaustive.csv": "points"}  # what a row judged, where that is not in the column `trials`
BROKEN = {"bound_violations": ("violation of a proved bound", "violations of proved bounds"),
          "broken_promises": ("broken promise", "broken promises")}


def blocks(bundle, _findings):
    """Whether the bundle is whole, then the tiles."""
    if bundle.info.get("state") != "complete":
        yield Text(f"**This bundle is {bundle.info.get('state', 'of unknown state')}: a run that is not complete.** Every number "
                   "below is of the part that is there.")
    yield Tiles((_machine(bundle), _build(bundle), *_judged(bundle), _noise(bundle), _digest(bundle)))


def _text(value, *keys):
    """What stands at a path of a JSON object; empty where nothing or no word does."""
    for key in keys:
        value = value.get(key) if isinstance(value, dict) else None
    return str(value) if isinstance(value, (str, int, float)) and not isinstance(value, bool) and value != "unknown" else ""


def _joined(*parts):
    return ", ".join(part for part in parts if part)


def _machine(bundle):
    machine = bundle.machine or {}
    cores = _text(machine, "cpu", "logical_cores_available")
    virtual = machine.get("cpu", {}).get("virtualised") is True if isinstance(machine.get("cpu"), dict) else False
    return Tile("machine", _text(machine, "cpu", "model_name") or "unknown",
                _joined(_text(machine, "cpu", "architecture"), cores and f"{cores} cores", "virtual" if virtual else ""))


def _build(bundle):
    commit = _text(bundle.info, "git_commit")
    clean = "" if bundle.info.get("git_clean") is not False else " with changes"
    return Tile("build", _text(bundle.machine or {}, "build", "compiler") or "unknown",
                _joined(f"version {_text(bundle.info, 'program_version')}" if _text(bundle.info, "program_version") else "",
                        f"commit {commit[:10]}{clean}" if commit else ""))


def _judged(bundle):
    """How many trials were judged, and how many broke what is proved or promised."""
    trials, methods, broken, asked = 0, set(), dict.fromkeys(BROKEN, 0), set()
    for file, table in bundle.tables.items():
        judged = COUNTED.get(file, "trials")
        if judged not in table.columns or "method" not in table.columns or not _judges(file):
            continue
        for row in table.rows:
            if row["baseline"] in (None, "exact") and isinstance(row[judged], float):
                trials += row[judged]
                methods.add(row["method"])
            for column in BROKEN:
                if isinstance(row[column], float):
                    broken[column] += row[column]
                    asked.add(column)
    yield Tile("judged", large(trials), f"evaluations by {count(len(methods), 'method')} against the exact value")
    total = sum(broken.values())
    what = [f"1 {one}" if broken[column] == 1 else f"{large(broken[column])} {many}"
            for column, (one, many) in BROKEN.items() if column in asked]
    yield Tile("violations", large(total) if asked else "none asked", _joined(*what), "outside" if total else "inside" if asked else "")


def _judges(file):
    return file not in ("reference.csv", "audit.csv", "worst.csv", "conversion.csv") and schema.is_declared(file)


def _noise(bundle):
    times = [r for r in bundle.tables["timing.csv"].rows if r["quality"]] if "timing.csv" in bundle else []
    noisy = sum(r["quality"] == "noisy" for r in times)
    if not times:
        return Tile("noise", "no times", "nothing was timed")
    return Tile("noise", f"{large(noisy)} of {large(len(times))}", "times of noisy races", "explained" if noisy else "inside")


def _digest(bundle):
    digest = _text(bundle.info, "accuracy_digest")
    if not digest:
        return Tile("digest", "unknown", "the bundle states no accuracy digest")
    return Tile("digest", digest[:10], "of all accuracy data: the same everywhere", full=digest)
