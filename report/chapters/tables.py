# SPDX-License-Identifier: MIT
"""The source report's tables in its own layout."""

from ..bundle import Missing
from ..document import Definitions
from ..tables import scorecard_tables

TITLE = "The report's tables, with ours and the truth beside them"
SUITE = "report"


def blocks(bundle, _findings):
    """One table per printed table and form of curve."""
    files = [f for f in ("scorecard.csv", "scorecard_timing.csv") if f in bundle]
    if not files:
        raise Missing("the bundle has no `scorecard.csv`")
    yield Definitions((
        ("published", "as the source report prints it, coloured by its verdict"),
        ("ours, median; 5–95 %", "the report's statistic over independent repetitions of its experiment, with its generator "
                                 "and its yardstick"),
        ("continuous inputs", "the median of the same with inputs that use every bit, not the report's grid"),
        ("against exact", "the median of the same statistic, measured against the exact value"),
        ("prepared once", "time per point where conversion and set-up are done once per curve"),
    ))
    tables = [table for file in files for table in scorecard_tables(bundle, file)]
    yield from sorted(tables, key=lambda table: table.caption.split()[1])
