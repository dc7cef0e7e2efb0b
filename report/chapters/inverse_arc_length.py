# SPDX-License-Identifier: MIT
"""Inverse arc length: where a length is reached, in how many iterations, and what a source document says of it."""

from ..document import Text
from ..wording import general, scientific
from .suite_parts import of_studies, with_times
from .tolerance_tables import tolerance_tables

TITLE = "Inverse arc length and equal spacing"
SUITE = KIND = "inverse_arc_length"
LINES = (("mean relative error of the length", "mean_relative", scientific),
         ("largest relative error of the length", "max_relative", scientific), ("largest error of t", "max_t_error", scientific),
         ("iterations, mean", "mean_iterations", general), ("iterations, most", "max_iterations", general),
         ("evaluations, mean", "mean_evaluations", general), ("not converged", "non_converged", general),
         ("promises broken", "broken_promises", general))


def study_tables(bundle, study):
    """A table for each kind of curves."""
    yield from tolerance_tables(study, bundle["inverse_arc_length.csv"].some(study=study), "Parameters at a length against tolerance",
                                "反弧长误差与容差", LINES)


@with_times("inverse_arc_length")
def blocks(bundle, findings):
    """Findings, the picture, a table for each kind of curves, then the corrections."""
    table = bundle["inverse_arc_length.csv"].of_suite(SUITE)
    yield from of_studies(bundle, findings, SUITE, table.distinct("study"), study_tables, "spacing")
    yield Text("The length at which t is sought is a share of the curve's length, drawn for each curve; the tolerance is relative to "
               "the whole length. What is promised is the length up to t, not t: where a curve nearly stops, t changes much over "
               "next to no length. A method that cannot keep the tolerance says that it did not converge; a promise is broken "
               "where it said that it did and the error is larger. A t outside the curve counts as the nearest end. The truth is "
               "found in 70 digits.")
    yield Text("Corrections to the source document (seed 000, section 3). The point at a quarter of the length is asked for at 0.25; "
               "the 0.4 there is a slip. Its formulas (19) and (20) lack a factor 2 of |C'|², so a step is twice Newton's next to "
               "the root and t jumps from side to side for ever; its code divides both derivatives by 2 and converges, as "
               "`seed_000_newton` shows, but takes |C''| for the acceleration along the curve, and nothing keeps t on the curve. "
               "Newton's method for the squared distance with the right second derivative is no better guarded: on (0,0), (1,1), "
               "(0.1,1), (1,0), for 0.3 of the length, a step from t = 0.3 ends a distance of 3 from the root. The step from sums of "
               "chords to the integral of the speed rests on |C(b) - C(a)| = |C'(ξ)| (b - a), which holds for no ξ of a full "
               "circle: its chord is 0, its length 2π times the radius. Chords are at most as long as arcs, and their sum tends to the length. "
               "The document's loop for many points makes chords equal, not arcs: an arc of length h and curvature κ is longer than "
               "its chord by about κ² h³ / 24, so `chord_equalising` is biased where the curvature changes, and knows by how "
               "much at most.")
