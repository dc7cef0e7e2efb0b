# SPDX-License-Identifier: MIT
"""Every method, degree by degree, under every generator."""

from ..document import Text
from ..error_tables import error_tables
from .suite_parts import figure, of_suite, replay

TITLE = "Every method by degree"
SUITE = "ladder"


def blocks(bundle, findings):
    """Findings, the figure, then mean and largest error of every study."""
    table = bundle.exact(SUITE)
    yield from of_suite(findings, "ladder")
    yield from figure("ladder_against_degree", bundle)
    for study in table.distinct("study"):
        yield from error_tables(study, table.select(study=study))
    yield Text("The p~ of a converted path is that of the form in which the curve is given, so the tables show what the "
               "conversion adds. "
               "The figure draws methods that agree at every degree as one line.")
    yield from replay(bundle, SUITE)
