# SPDX-License-Identifier: MIT
"""Arc lengths: what is promised, what is kept, and for how many evaluations."""

from ..document import Text
from ..wording import general, scientific
from .suite_parts import COMPANION_PEERS, of_studies, with_times
from .tolerance_tables import tolerance_tables

TITLE = "Arc lengths"
SUITE = KIND = "arc_length"
LINES = (("mean relative error", "mean_relative", scientific), ("largest relative error", "max_relative", scientific),
         ("evaluations, mean", "mean_evaluations", general), ("not converged", "non_converged", general),
         ("promises broken", "broken_promises", general))


def study_tables(bundle, study):
    """A table for each kind of curves."""
    yield from tolerance_tables(study, bundle.judged("arc_length.csv").some(study=study), "Arc lengths against tolerance",
                                "弧长误差与容差", LINES)


@with_times("arc_length")
def blocks(bundle, findings):
    """Findings, the figure, then a table for each kind of curves."""
    table = bundle.judged("arc_length.csv").of_suite(SUITE, COMPANION_PEERS)
    yield from of_studies(bundle, findings, SUITE, table.distinct("study"), study_tables, "arc_length_evaluations")
    yield Text("The tolerance is relative to the length. A method that cannot keep it says that it did not converge; a promise "
               "is broken where it said that it did and the error is larger. `gauss_legendre_24` knows no error of its own and "
               "never promises, nor do other libraries, which count no evaluations. Evaluations are those of the speed, of chord sums those of the curve. The truth is integrated "
               "in 70 digits.")
