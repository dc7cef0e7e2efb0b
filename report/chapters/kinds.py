# SPDX-License-Identifier: MIT
"""What a page shows of a study whose suite has no chapter of its own: by its kind, the tables, and what its figure draws."""

from dataclasses import dataclass
from typing import Callable

from ..error_tables import error_tables, swept
from ..search_tables import search_table
from . import (arc_length, bspline, conversion, derivative, exhaustive, fitting, grid, guarantees, hard_cases, interpolation, inverse_arc_length, projection,
               roofline, subdivision, timing)

OF_U = (("mean_error_u", "mean error, u p~"), ("max_error_u", "largest error, u p~"))
OF_LENGTHS = (("max_relative", "largest relative error"), ("mean_evaluations", "mean evaluations"))


@dataclass(frozen=True)
class Kind:
    """A kind of study."""

    file: str
    tables: Callable  # of (bundle, study) to tables and texts
    measures: tuple  # (column, what it is), a panel each
    axes: tuple  # that may run across, the first that the study varies
    method: str = "method"  # the column of the method


def _accuracy(bundle, study):
    judged = bundle.judged().some(study=study)
    exact = [r for r in judged if r["baseline"] == "exact"]
    yield from error_tables(study, exact or judged, *swept(exact or judged))


def _search(bundle, study):
    yield search_table(study, bundle["search.csv"].some(study=study))


KINDS = {
    "accuracy": Kind("accuracy.csv", _accuracy, OF_U, ("interval", "coordinate_range", "degree")),
    "conversion": Kind("conversion.csv", conversion.study_tables, (("mean_error", "mean error of the coefficients"),
                                                                   ("max_error", "largest error of the coefficients")),
                       ("coordinate_range", "degree"), "conversion"),
    "search": Kind("search.csv", _search, (("searched_error_u", "searched maximum, u p~"),), ("degree",)),
    "timing": Kind("timing.csv", timing.study_tables, (("median_ns", "time, ns"),), ("tolerance", "points", "order", "degree")),
    "roofline": Kind("roofline.csv", roofline.study_tables, (("share_of_peak", "share of the peak"),), ("degree",)),
    "derivative": Kind("derivative.csv", derivative.study_tables, OF_U, ("interval", "coordinate_range", "order", "degree")),
    "subdivision": Kind("subdivision.csv", subdivision.study_tables, OF_U, ("interval", "coordinate_range", "degree")),
    "grid": Kind("grid.csv", grid.study_tables, OF_U, ("points", "degree")),
    "bspline": Kind("bspline.csv", bspline.study_tables,
                    (("max_error_u", "largest error of points, u p~"), ("max_control_error_u", "largest error of control points, u p~")),
                    ("interval", "degree")),
    "arc_length": Kind("arc_length.csv", arc_length.study_tables, OF_LENGTHS, ("tolerance", "degree")),
    "inverse_arc_length": Kind("inverse_arc_length.csv", inverse_arc_length.study_tables, OF_LENGTHS, ("tolerance", "degree")),
    "projection": Kind("projection.csv", projection.study_tables,
                       (("max_error_eps", "largest error / (2^-52 max |coordinate|)"), ("missed", "missed foot points")),
                       ("placement", "degree")),
    "interpolation": Kind("interpolation.csv", interpolation.study_tables,
                          (("max_c2_u", "jump of the second differences, u"), ("max_error_u", "error of control points, u")),
                          ("points",)),
    "fitting": Kind("fitting.csv", fitting.study_tables,
                    (("mean_segments", "mean segments"), ("max_error_over_tolerance", "largest error / tolerance")),
                    ("tolerance", "points")),
    "guarantees": Kind("guarantees.csv", guarantees.study_tables, (), ("degree",)),
    "hard_cases": Kind("hard_cases.csv", hard_cases.study_tables, (), ("degree",), "family"),
    "exhaustive": Kind("exhaustive.csv", exhaustive.study_tables, (("max_error_ulp", "largest error, ulp"),), ("curve_id", "degree")),
}


def rows_of(bundle, study):
    """The rows of a study that a table of its kind is made of; of accuracy those against the exact value, where there are any."""
    rows = bundle.judged(KINDS[bundle.studies[study].kind].file).some(study=study)
    return [r for r in rows if r["baseline"] == "exact"] or rows
