# SPDX-License-Identifier: MIT
"""The tables of a study whose suite has no chapter of its own, by its kind; tables.schema.json says what its figure draws."""

from .. import schema
from ..error_tables import error_tables, swept
from ..search_tables import search_table
from . import (arc_length, bspline, conversion, derivative, exhaustive, fitting, grid, guarantees, hard_cases, interpolation, inverse_arc_length, projection,
               roofline, subdivision, timing)


def _accuracy(bundle, study):
    judged = bundle.judged().some(study=study)
    exact = [r for r in judged if r["baseline"] == "exact"]
    yield from error_tables(study, exact or judged, *swept(exact or judged))


def _search(bundle, study):
    yield search_table(study, bundle["search.csv"].some(study=study))


def _of_any(kind):
    """Tables of a kind that has no others: mean and largest error, by method."""
    def study_tables(bundle, study):
        rows = bundle.judged(f"{kind}.csv").some(study=study)
        yield from error_tables(study, rows, *swept(rows))
    return study_tables


_OWN = {"accuracy": _accuracy, "search": _search} | {module.__name__.rsplit(".", 1)[-1]: module.study_tables for module in (
    arc_length, bspline, conversion, derivative, exhaustive, fitting, grid, guarantees, hard_cases, interpolation, inverse_arc_length, projection,
    roofline, subdivision, timing)}
TABLES = {kind: _OWN.get(kind, _of_any(kind)) for kind in schema.kinds()}  # by kind: a function of (bundle, study) to tables and texts
