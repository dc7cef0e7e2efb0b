# SPDX-License-Identifier: MIT
"""Subdivision: the control points of both halves of a curve that is split at t."""

from ..document import Cell, Text
from ..error_tables import error_tables, swept
from ..tables import by_axis
from ..wording import large
from .suite_parts import of_studies, with_times

TITLE = "Subdivision"
SUITE = KIND = "subdivision"
COUNTS = (("junctions apart", "junctions_apart"), ("ends moved", "ends_moved"), ("points off", "points_off"),
          ("bound violations", "bound_violations"), ("not finite", "non_finite"))


def _summed(rows, column):
    """How often something happened to a method over all cells of a study; empty where it was never asked."""
    def cell(row):
        counts = [r[column] for r in rows if r["method"] == row["method"] and r["degree"] == row["degree"]]
        counts = [k for k in counts if k is not None]
        return Cell(f"{sum(counts):g}", f"{sum(counts):g}", "outside" if sum(counts) else "") if counts else Cell()
    return cell


def _kept(study, rows):
    """What must hold to the last bit, by degree, over the ranges, parameters and inputs of the study."""
    first = {(r["method"], r["degree"]): r for r in reversed(rows)}
    shown = [r for r in rows if first[r["method"], r["degree"]] is r]
    lines = [(text, _summed(rows, column), lambda r: True) for text, column in COUNTS]
    return by_axis(shown, "degree", f"{study}-kept", "Trials in which halves do not fit together "
                   f"({large(sum(r['trials'] for r in rows))} trials of all methods)", "两段不相接的次数", lines, row_head="trials")


def study_tables(bundle, study):
    """Errors, then what does not fit together."""
    rows = bundle["subdivision.csv"].some(study=study)
    yield from error_tables(study, rows, *swept(rows))
    yield _kept(study, rows)


@with_times("subdivision")
def blocks(bundle, findings):
    """Findings, the figure, then the tables of each study: errors, and what does not fit together."""
    table = bundle["subdivision.csv"].of_suite(SUITE)
    yield from of_studies(bundle, findings, SUITE, table.distinct("study"), study_tables, "subdivision_against_degree")
    yield Text("Each control point of both halves is compared with the true one; p~ is that of the control point, the sum of the "
               "magnitudes that it is made of. A junction is apart where the last control point of the left half is not the first "
               "of the right one, an end is moved where it is not that of the curve, both to the last bit. A point is off where the "
               "point of a half at its parameter 1/2 is not that of the curve within the bounds of the control points, which is asked "
               "of methods with a bound of p~ only.")
