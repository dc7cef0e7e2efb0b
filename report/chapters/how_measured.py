# SPDX-License-Identifier: MIT
"""Definitions: words, how inputs are drawn, and what every column means, as the bundle and the schema of its tables have it."""

from .. import schema
from ..document import Cell, Definitions, Group, Table, Text
from ..wording import listing

TITLE = "How it was measured"
DRAWN = "generators.csv"


def blocks(bundle, _findings):
    """Words that hold for every bundle, the generators that it used, and the columns of its tables."""
    yield Text("The true point is computed exactly: control points and t are binary fractions, so the point of a Bézier curve is "
               "one too, and of a polynomial curve likewise. Errors are distances to it unless a yardstick is named.")
    yield Definitions((
        ("error", "Euclidean distance in coordinate units, rounded to 24 significant bits"),
        ("u, ulp", "u = 2^-53 is the unit roundoff of double; an ulp is the spacing of doubles at the exact value"),
        ("p~", "the sum of the absolute terms of the curve at t, over the coefficients in the form in which it is given, each with its "
         "Euclidean norm: for t in [0, 1] at most the root of the dimension times the largest coordinate"),
        ("condition number", "p~/|p|: by what relative errors of the coefficients can grow at t"),
        ("path", "`conversion:evaluator`: convert to the other form, then evaluate there"),
        ("replicate", "one independent repetition of all trials of a study; a band is over replicates"),
    ))
    yield from _generators(bundle)
    yield from _columns(bundle)


def used_generators(bundle):
    """Their ids, in order of first appearance."""
    return list(dict.fromkeys(row["generator"] for table in bundle.tables.values() if "generator" in table.columns
                              for row in table.rows if row["generator"]))


def _generators(bundle):
    used = used_generators(bundle)
    known = {row["id"]: row for row in bundle[DRAWN].rows} if DRAWN in bundle else {}
    rows = [known[one] for one in used if one in known]
    if rows:
        columns = ("coordinates", "t", "weights")
        groups = tuple(Group(f"`{row['id']}`", row["id"], (("", [Cell(row.text(c), row.text(c)) for c in columns]),)) for row in rows)
        yield Table(id="generators", caption="How inputs were drawn, by generator; R is the coordinate range", caption_zh="输入的生成方式",
                    group_head="generator", head=columns, groups=groups)
    unknown = [f"`{one}`" for one in used if one not in known]
    if unknown:
        yield Text(f"How inputs of {listing(unknown)} are drawn the bundle does not say; `bezierbench list generators` does.")


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
        yield Table(id="columns", caption="The columns of the bundle's tables", caption_zh="各列的含义", group_head="file",
                    row_head="column", head=("meaning", "unit"), groups=groups)
