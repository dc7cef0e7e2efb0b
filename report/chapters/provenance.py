# SPDX-License-Identifier: MIT
"""What the numbers rest on: other bundles, the audit of the reference, methods, definitions, machine and build."""

import json
import math

from .. import inputs, schema
from ..bundle import Missing
from ..document import Cell, Definitions, Group, Table, Text
from ..methods import form
from ..rows import distinct, grouped
from ..tables import by_axis, listed
from ..time_tables import where
from ..wording import count, general, large, listing, shortest
from .parts import chapter

MOST_CELLS = 20  # of accuracy that are shown where values differ
VERDICT = {"slower": "outside", "faster": "inside", "same": "inside", "unresolved": ""}


@chapter("Compared with other bundles", whole=True)
def comparison(bundle, _findings):
    """Machines and builds, then accuracy, then times; with several bundles, how they rank."""
    found = bundle.comparison
    if found is None:
        raise Missing("no comparison was given: `bezierbench compare` writes one with `--out`, `--comparison` names it")
    for number, (other, rows) in enumerate(grouped(found.rows.rows, "bundle").items(), 1):
        yield Text(f"**a** is `{rows[0]['against']}`, **b** is `{other}`.")
        facts = [(f"`{r['fact']}`", r.text("a"), r.text("b")) for r in found.facts.select(bundle=other)]
        if facts:
            yield listed(f"comparison-{number}-machines", "Differences between machines and builds", ("fact", "a", "b"), facts)
        else:
            yield Text("Machines and builds do not differ in any recorded fact.")
        yield from _accuracy([r for r in rows if r["kind"] == "accuracy"], f"comparison-{number}-accuracy")
        yield from _times([r for r in rows if r["kind"] == "timing" and r["degree"] is not None], f"comparison-{number}-times")  # no sentinel
    yield listed("comparison-standings", "Geometric mean of time over a's, over all common timings",
                 ("bundle", "rank", "processor", "compiler", "machine", "accuracy rows that differ", "timings", "time", "in sentinels"),
                 [(f"`{r['bundle']}`", *(Cell(shortest(r[c]) if isinstance(r[c], float) else r[c] or "", r.text(c)) for c in (
                     "rank", "cpu", "compiler", "machine", "accuracy_rows_differing", "timings")),
                   *(Cell("" if math.isnan(r[c]) else _three(r[c]), r.text(c)) for c in ("mean_ratio", "mean_normalised")))
                  for r in found.standings.rows])


def _accuracy(rows, table_id):
    differing = [r for r in rows if r["verdict"] != "identical"]
    if not rows:
        yield Text("No row of accuracy is in both.")
    elif not differing:
        yield Text(f"Accuracy is identical, bit for bit, in all {len(rows)} common rows.")
    else:
        yield Text(f"Accuracy **differs** in {len(differing)} of {len(rows)} common rows"
                   + (f"; the first {MOST_CELLS} are:" if len(differing) > MOST_CELLS else ":"))
        yield listed(table_id, "Cells whose values differ", ("study", "method", "degree n", "file", "column", "a", "b"),
                     [(r["study"] or "", f"`{r['method']}`", r.text("degree"), f"`{r['file']}`", f"`{r['column']}`", r.text("a"), r.text("b"))
                      for r in differing[:MOST_CELLS]])


def _times(rows, table_id):
    if not rows:
        yield Text("No time is in both.")
        return
    yield Text("Times of b over times of a, with the interval in brackets that contains the ratio in 99 of 100 cases, according to the variation of "
               "times between the races of a run. The line below gives the ratio with every time in units of the sentinel, fixed work that runs beside "
               "the methods. `same` is within 1 %, `slower` and `faster` are beyond it, each with both whole intervals on one kind of machine and with that "
               "in sentinels between two; anything else is `unresolved`.")
    for study, of_study in grouped(rows, "study").items():
        kinds = grouped(of_study, "scalar", "dimension").values()
        for number, kind in enumerate(kinds, 1):
            english = form(kind[0]["form"])[0]
            yield by_axis(kind, "degree", f"{table_id}-{study}" + (f"-{number}" if len(kinds) > 1 else ""),
                          f"Time of b over time of a, {english}, study {study} ({where(kind[0])})",
                          [(label, _ratio(column), {"mode": mode}) for mode in distinct(kind, "mode")
                           for label, column in ((mode, "ratio"), (f"{mode}, in sentinels", "normalised"))],
                          row_head="mode")


def _ratio(column):
    def cell(rows):
        row = rows[-1]
        if row[column] is None:
            return Cell()
        verdict = row["verdict"] if column == "ratio" else ""
        return Cell(f"{_three(row[column])} [{_three(row[f'{column}_low'])} – {_three(row[f'{column}_high'])}] {verdict}".rstrip(),
                    row.text(column), VERDICT.get(verdict, ""))
    return cell


def _three(ratio):
    """With three digits, which a margin of 1 % requires."""
    return f"{ratio:.3f}"


@chapter("Audit of the extended-precision tier", whole=True)
def audit(bundle, _findings):
    """How far the fast reference tiers are from the exact value: the worst cells in words, then every row."""
    rows = bundle["audit.csv"].rows
    if not rows:
        raise Missing("`audit.csv` has no rows")
    worst = max(rows, key=lambda r: r.number("max_axis_error_ulp"))
    yield Text(f"The tier `{worst['tier']}` is compared with the exact value on inputs of the suite. Its largest error is "
               f"{general(worst['max_axis_error_ulp'])} ulp of double on an axis (study {worst['study']}, degree {worst.text('degree')}, "
               f"{inputs.words(worst)})"
               + (": more than half an ulp, so it cannot serve as the truth without the check against the exact value."
                  if worst["max_axis_error_ulp"] > 0.5 else "."))
    columns = {"study": str, "tier": str, "degree": shortest, "coordinate_range": shortest, "t_min": shortest, "t_max": shortest, "generator": str,
               "trials": large, "mean_axis_error_ulp": general, "max_axis_error_ulp": general}
    yield listed("audit-tiers", "Error of the tier against the exact value, in ulp of double",
                 ("study", "tier", "degree", "R", "t from", "t to", "inputs", "trials", "mean error, ulp", "largest error, ulp"),
                 [(r["study"], *(Cell(inputs.words(r) if r["curves"] and c == "generator" else write(r[c]), r.text(c))
                                     for c, write in list(columns.items())[1:])) for r in rows], whole=False)


# heading and what it shows of the texts of a row of methods.csv; docs/methods.md has a table of the same columns, made by scripts/readme.py
METHOD_COLUMNS = (
    ("id", lambda row: f"`{row['id']}`"),
    ("takes", lambda row: row["form"]),
    ("degrees", lambda row: f"{row['min_degree']}–{row['max_degree']}"),
    ("flops per point", lambda row: row["flops"]),
    ("error bound", lambda row: row["bound"] or "none"),
    ("source", lambda row: row["citation"]),
)


@chapter("The methods", whole=True)
def method_list(bundle, _findings):
    """One row per method and form that it takes; converted paths are counted."""
    rows = [row for row in bundle["methods.csv"].rows if ":" not in row["id"]]
    if not rows:
        raise Missing("`methods.csv` has no rows")
    paths = len(bundle["methods.csv"].rows) - len(rows)
    yield Text(f"The output of `bezierbench list methods`: {count(len(rows), 'entry', 'entries')}, one per method and form of curve that it takes. The "
               f"{count(paths, 'path')} `conversion:evaluator` are compositions of these.")
    yield listed("methods", "Methods, with the form that they take, cost, proved bound and source", [name for name, _ in METHOD_COLUMNS],
                 [[write(row.texts) for _, write in METHOD_COLUMNS] for row in rows])


@chapter("How it was measured", whole=True)
def how_measured(bundle, _findings):
    """Words that hold for every bundle, the generators that it used, and the columns of its tables, as bundle and schema describe them."""
    yield Text("The true point is computed exactly: control points and t are binary fractions, so the point of a Bézier curve or a polynomial curve is "
               "one, too. Errors are distances to it except where a yardstick is named.")
    yield Definitions((
        ("error", "Euclidean distance in coordinate units, rounded to 24 significant bits"),
        ("u, ulp", "u = 2^-53 is the unit roundoff of double; an ulp is the spacing of doubles at the exact value"),
        ("p~", "the sum of the absolute terms of the curve at t, over the coefficients in the form in which it is given, each with its "
         "Euclidean norm: for t in [0, 1] at most the root of the dimension times the largest coordinate"),
        ("condition number", "p~/|p|: the factor by which relative errors of the coefficients can grow at t"),
        ("path", "`conversion:evaluator`: convert to the other form, then evaluate there"),
        ("replicate", "one independent repetition of all trials of a study; a band is over replicates"),
    ))
    used = used_generators(bundle)
    known = {row["id"]: row for row in bundle["generators.csv"].rows} if "generators.csv" in bundle else {}
    if any(one in known for one in used):
        columns = ("coordinates", "t", "weights")
        yield listed("generators", "How inputs were drawn, by generator; R is the coordinate range", ("generator", *columns),
                     [(f"`{one}`", *(known[one].text(c) for c in columns)) for one in used if one in known])
    unknown = [f"`{one}`" for one in used if one not in known]
    if unknown:
        yield Text(f"The bundle does not state how inputs of {listing(unknown)} are drawn; `bezierbench list generators` does.")
    yield from _columns(bundle)


def used_generators(bundle):
    """Their ids, in order of first appearance."""
    return list(filter(None, dict.fromkeys(g for table in bundle.tables.values() if "generator" in table.columns for g in table.distinct("generator", curves=None))))


def _columns(bundle):
    """One group for the files that have the same columns."""
    alike = {}
    for file, table in bundle.tables.items():
        declared = tuple((c, schema.description(file, c), schema.unit(file, c)) for c in schema.columns(file) if c in table.columns)
        if declared:
            alike.setdefault(declared, []).append(file)
    groups = tuple(Group(listing(f"`{file}`" for file in files), " ".join(files),
                         tuple((f"`{column}`", [Cell(meaning, meaning), Cell(unit, unit)]) for column, meaning, unit in declared))
                   for declared, files in alike.items())
    if groups:
        yield Table(id="columns", caption="The columns of the bundle's tables", group_head="file",
                    row_head="column", head=("meaning", "unit"), groups=groups)


def _flatten(value, prefix=""):
    """(dotted key, text) for nested objects."""
    if isinstance(value, dict):
        return [pair for key, inner in value.items() for pair in _flatten(inner, f"{prefix}.{key}" if prefix else key)]
    if isinstance(value, list):
        return [(prefix, ", ".join(one if isinstance(one, str) else json.dumps(one, ensure_ascii=False) for one in value))]
    return [(prefix, {True: "yes", False: "no", None: "unknown"}.get(value, str(value)) if isinstance(value, (bool, type(None)))
             else str(value))]


@chapter("Provenance", whole=True)
def provenance(bundle, _findings):
    """bundle.json and machine.json as they are, then the files of the bundle."""
    def shown(table_id, caption, value):
        return listed(table_id, caption, ("key", "value"), [(f"`{key}`", text) for key, text in _flatten(value)])
    yield shown("provenance-bundle", "The bundle", bundle.info)
    if bundle.machine is None:
        yield Text("The machine is not known: the bundle has no machine.json.")
    else:
        yield shown("provenance-machine", "The machine and the build", bundle.machine)
    yield Text("Read from " + ", ".join(f"`{name}` ({len(table.rows)} rows)" for name, table in bundle.tables.items()) + ". "
               + ("The suite is in `suite.toml`, the checksums are in `SHA256SUMS`." if bundle.suite is not None else "The bundle has no suite.toml."))
