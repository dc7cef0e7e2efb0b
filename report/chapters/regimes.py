# SPDX-License-Identifier: MIT
"""Where methods leave the comfortable middle."""

from ..document import Heading, Text
from ..error_tables import error_tables, swept
from .suite_parts import figure, of_suite, replay, study_figure

TITLE = "At the limits: parameters, coordinates, degrees, float, dimensions"
SUITE = "regimes"


def blocks(bundle, findings):
    """Findings, the figure, then the tables of each study along the axis that it varies."""
    table = bundle.exact(SUITE)
    yield from of_suite(findings, "regimes")
    yield from figure("regimes_overview", bundle)
    for study in table.distinct("study"):
        rows = table.select(study=study)
        yield Heading(bundle.title(study))
        yield from study_figure(bundle, study)
        yield from error_tables(study, rows, *swept(rows))
    yield Text("u is that of the scalar: 2^-53 for double, 2^-24 for float. Means are over finite trials; where trials "
               "overflow, the finite "
               "ones of that cell are its milder ones, and its mean cannot be compared with those of other cells.")
    yield from replay(bundle, SUITE)
