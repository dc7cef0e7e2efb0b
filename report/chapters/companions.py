# SPDX-License-Identifier: MIT
"""Companion problems, from derivatives to B-splines: findings, figures, the tables of each study, what the words mean, times."""

from .. import inputs
from ..bundle import Missing
from ..document import Heading, Text
from ..error_tables import error_tables, swept, swept_with, tolerance_tables
from ..findings.curves import GOAL as PROJECTION_GOAL
from ..findings.splines import GOAL as SPLINE_GOAL
from ..rows import distinct
from ..tables import by_axis, one, over
from ..wording import general, large, listing, scientific, shortest
from .parts import COMPANION_PEERS, chapter, figure, of_studies, of_suite, study_figure, tables_of, with_times


def companion(kind, title, *notes, figures=(), timed=(), more=lambda bundle: ()):
    """Declares the chapter of a kind of study that has a suite of the same name. `timed` are the figures about times, and `more` makes what
    follows the notes."""
    def blocks(bundle, findings):
        table = bundle.judged(f"{kind}.csv").of_suite(kind, COMPANION_PEERS)
        yield from of_suite(findings, kind)
        for name in figures:
            yield from figure(name, bundle)
        yield from of_studies(bundle, table.distinct("study"))
        yield from map(Text, notes)
        yield from more(bundle)
    blocks.__name__ = kind
    chapter(title, suite=kind, kind=kind)(with_times(kind, *timed)(blocks))


def _trials(rows):
    """The trials of one method."""
    return large(sum(r["trials"] for r in rows if r["method"] == rows[0]["method"]))


def _degrees(rows):
    found = distinct(rows, "degree")
    return f"degree{'s' if len(found) > 1 else ''} {', '.join(map(shortest, found))}"


@tables_of("derivative")
def _derivatives(bundle, study):
    rows = bundle["derivative.csv"].some(study=study)
    yield from error_tables(study, rows, *swept_with("order", rows))


companion(
    "derivative", "Derivatives",
    "p~ is that of the derivative: its own control points D^k b_i, times n (n-1) ... (n-k+1), in magnitude, weighted with the Bernstein "
    "polynomials of degree n-k (in power form its own coefficients with the powers of t). The bound has a second part for the differences, "
    "which control points far from the origin make large. A derivative of an order above the degree is 0. `seed_000` has no bound: it is "
    "kept for comparison.")


@tables_of("arc_length")
def _arc_lengths(bundle, study):
    return tolerance_tables(study, bundle.judged("arc_length.csv").some(study=study), "Arc lengths against tolerance", (
        ("mean relative error", "mean_relative", scientific), ("largest relative error", "max_relative", scientific),
        ("evaluations, mean", "mean_evaluations", general), ("not converged", "non_converged", general),
        ("broken promises", "broken_promises", general)))


companion(
    "arc_length", "Arc lengths",
    "The tolerance is relative to the length. A method that cannot keep it reports that it did not converge; a promise is broken where the "
    "method reports convergence and the error is larger. `gauss_legendre_24`, `simpson38` and `seed_000_simpson38` have no estimate of their "
    "error and never promise, nor do other libraries, which count no evaluations. Evaluations are those of the speed, for sums of chords those of the curve. The truth is "
    "integrated with 70 digits.", figures=["arc_length_evaluations"])


@tables_of("inverse_arc_length")
def _inverse_arc_lengths(bundle, study):
    return tolerance_tables(study, bundle["inverse_arc_length.csv"].some(study=study), "Parameters at a length against tolerance", (
        ("mean relative error of the length", "mean_relative", scientific),
        ("largest relative error of the length", "max_relative", scientific), ("largest error of t", "max_t_error", scientific),
        ("iterations, mean", "mean_iterations", general), ("iterations, most", "max_iterations", general),
        ("evaluations, mean", "mean_evaluations", general), ("not converged", "non_converged", general),
        ("broken promises", "broken_promises", general)))


companion(
    "inverse_arc_length", "Inverse arc length and equal spacing",
    "The length at which t is sought is a share of the curve's length, drawn for each curve; the tolerance is relative to the whole length. "
    "The promise concerns the length up to t, not t: where a curve nearly stops, t changes much over a very small length. A method that "
    "cannot keep the tolerance reports that it did not converge; a promise is broken where the method reports convergence and the error is "
    "larger. A t outside the curve counts as the nearest end. The truth is computed with 70 digits.",
    "Corrections to the source document (seed 000, section 3). The point at a quarter of the length is requested at 0.25; the 0.4 there is "
    "a slip. Its formulas (19) and (20) omit a factor 2 of |C'|², so a step is twice Newton's next to the root, and t jumps from side to "
    "side for ever; its code divides both derivatives by 2 and converges, as `seed_000_newton` shows, but takes |C''| for the acceleration "
    "along the curve, and nothing keeps t on the curve. Newton's method for the squared distance with the correct second derivative is no "
    "better guarded: on (0,0), (1,1), (0.1,1), (1,0), for 0.3 of the length, a step from t = 0.3 ends a distance of 3 from the root. The "
    "step from sums of chords to the integral of the speed rests on |C(b) - C(a)| = |C'(ξ)| (b - a), which holds for no ξ of a full circle: "
    "its chord is 0, its length 2π times the radius. Chords are at most as long as arcs, and their sum tends to the length. The document's "
    "loop for many points makes chords equal, not arcs: an arc of length h and curvature κ is longer than its chord by about κ² h³ / 24, so "
    "`chord_equalising` is biased where the curvature changes, and it has a bound for this bias.", figures=["spacing"])


@tables_of("projection")
def _foot_points(bundle, study):
    """Placements of the point across."""
    rows = bundle.judged("projection.csv").some(study=study, status="ok")
    lines = [(label, over(column, combine, write), {}) for label, column, combine, write in (
        ("missed", "missed", sum, large), ("largest error, units", "max_error_eps", max, general),
        ("largest error of t", "max_t_error", max, scientific), ("gave up", "non_converged", sum, large))]
    for where, own in inputs.by_set(rows):
        yield by_axis(own, "placement", study, f"Foot points, {_degrees(own)}{where} ({_trials(own)} trials per method, by placement of the point)", lines, values=distinct(own, "placement"), row_head="quantity")


companion(
    "projection", "The nearest point of a curve",
    "Truth: the real roots of (C - P)·C' in [0, 1], isolated with integers. A foot point is missed where the distance exceeds the smallest "
    "distance by more than 2^-20 times the largest coordinate of control points and point. Errors of the distance are in units of 2^-52 "
    f"times that coordinate; the goal is {PROJECTION_GOAL}. The error of t is to the nearest of equally near foot points; where the "
    "distance hardly depends on t, no method can determine t accurately. Placements of the point: `uniform` as a control point, `on_curve`, "
    "`beside` it by a millionth, `centre` of curvature, in a `cusp`, on the axis of a `mirrored` curve, and as a control point of a curve "
    "that is a `line` at constant speed.")


@tables_of("interpolation")
def _splines(bundle, study):
    """Numbers of points across."""
    rows = bundle["interpolation.csv"].some(study=study)
    lines = [(label, over(column, max), {}) for label, column in (
        ("C1, largest", "max_c1_u"), ("C2, largest", "max_c2_u"), ("natural ends, largest", "max_natural_u"),
        ("control points, largest error", "max_error_u"))]
    yield by_axis(rows, "points", study, f"Residuals of splines by number of points, {', '.join(distinct(rows, 'generator'))} "
                  f"({_trials(rows)} sets of points per method)", lines, row_head="quantity")


companion(
    "interpolation", "Splines through points",
    "All in units of u times the largest coordinate of an axis; the largest over trials, knots and axes, and over the cells of a study. C1 "
    "is the jump of P1 - P0 over P3 - P2 of the segment before, C2 that of the second differences, natural ends are the second differences "
    f"there; points and joints are met bit for bit. The goal is {SPLINE_GOAL}. The truth is the exact spline in integers; for very many "
    "points only the conditions are judged, also exactly.")


@tables_of("fitting")
def _fits(bundle, study):
    """Kinds of data across."""
    rows = bundle["fitting.csv"].some(study=study)
    lines = [(f"segments at {scientific(e)}", over("mean_segments", max), {"tolerance": e})
             for e in sorted(distinct(rows, "tolerance"), reverse=True)]
    lines += [("largest error / tolerance", over("max_error_over_tolerance", max), {}), ("steps, most", over("max_iterations", max, large), {}),
              ("broken promises", over("broken_promises", sum, large), {})]
    yield by_axis(rows, "data", study, f"Fits to {', '.join(map(shortest, distinct(rows, 'points')))} points of curves of {_degrees(rows)} "
                  f"({_trials(rows)} fits per method)", lines, values=distinct(rows, "data"), row_head="quantity")


companion(
    "fitting", "Curves near points",
    "The tolerance is a distance in coordinate units. The error is the largest distance of a data point from the whole curve, computed "
    "exactly; a promise is broken where it exceeds the tolerance, or where the curve leaves the polyline of the data by more than the "
    "tolerance and the sampling allow. Segments are the mean over trials, in the cell with the largest mean. Data: `samples` of a Bézier "
    "curve at equal steps of t, `uneven` at random ones, `noisy` with noise of 2^-10 R, along the control `polyline`, of a `closed` curve, "
    "and `drawn` as by an unsteady pen, with repetitions and steps backwards. Corners of the data are kept, and a tight bend is a corner "
    "for a loose tolerance, so a curve can have more segments than necessary.",
    figures=["fitting_example", "fitting_segments"], timed=["fitting_time"])


def _count(column):
    """How often something happened to a method over all cells of a degree; empty where it was not counted."""
    return over(column, sum, lambda value: f"{value:g}", "outside")


@tables_of("subdivision")
def _halves(bundle, study):
    """Errors, then what must hold to the last bit, by degree, over the ranges, parameters and inputs of the study."""
    rows = bundle["subdivision.csv"].some(study=study)
    yield from error_tables(study, rows, *swept(rows))
    for where, own in inputs.by_set(rows):
        yield by_axis(own, "degree", f"{study}-kept", f"Trials in which halves do not fit together{where} "
                      f"({large(sum(r['trials'] for r in own))} trials of all methods)",
                      [(text, _count(column), {}) for text, column in (
                          ("junctions apart", "junctions_apart"), ("ends moved", "ends_moved"), ("points off", "points_off"),
                          ("bound violations", "bound_violations"), ("not finite", "non_finite"))], row_head="trials")


companion(
    "subdivision", "Subdivision",
    "Each control point of both halves is compared with the true one; p~ is that of the control point, the sum of the magnitudes of its "
    "terms. A junction is apart where the last control point of the left half is not the first of the right one, an end is moved where it "
    "is not that of the curve, both to the last bit. A point is off where the point of a half at its parameter 1/2 differs from that of the "
    "curve by more than the bounds of the control points; this is checked for methods with a bound of p~ only.")


@tables_of("grid")
def _grids(bundle, study):
    rows = bundle["grid.csv"].some(study=study)
    yield from error_tables(study, rows, *swept_with("points", rows))


companion(
    "grid", "Points on a grid",
    "A grid has the parameters k/m for k = 0, 1, ..., m, where m is a power of two, and its errors are those of all its points. Forward "
    "differencing makes each point from the one before by n additions on each axis, so every step adds its roundings, and the bound grows "
    "with k; `pointwise_...` applies an evaluator to one point after another.")


@tables_of("bounds")
def _boxes(bundle, study):
    """Sides inside and outside, by degree, over the ranges and inputs of the study."""
    rows = bundle["bounds.csv"].some(study=study, status="ok")
    lines = [(label, over(column, combine, write), {}) for label, column, combine, write in (
        ("too small", "too_small", sum, large), ("farthest inside, sizes", "max_inside_size", max, scientific),
        ("mean excess, sizes", "mean_excess_size", max, scientific), ("largest excess, ulp", "max_excess_ulp", max, general))]
    for where, own in inputs.by_set(rows):
        yield by_axis(own, "degree", study, f"Boxes{where} ({_trials(own)} curves per method)", lines, row_head="quantity")


def _promised_boxes(bundle):
    """What is proved of which methods, and how far outside their sides were."""
    promises = {r["id"]: r["bound"] for r in bundle["methods.csv"].rows if r["problem"] == "bounds" and r["bound"]}
    judged = [r for r in bundle["bounds.csv"].rows if r["status"] == "ok" and r["method"] in promises]
    for promise in dict.fromkeys(promises[r["method"]] for r in judged):
        rows = [r for r in judged if promises[r["method"]] == promise]
        yield Text(f"Proved of {listing(f'`{method}`' for method in distinct(rows, 'method'))}: {promise}. The farthest side of "
                   f"{large(sum(r['trials'] for r in rows))} boxes is {general(max(r['max_excess_ulp'] for r in rows))} ulp outside.")


companion(
    "bounds", "Boxes",
    "Truth: the extrema of every axis by isolation of the roots of the derivative with integers. The tightest box of doubles has the largest "
    "double that no point is below and the smallest that none is above. A box is too small where a point of the curve is outside; the curve "
    "that is farthest outside stands in `bounds.csv` with all its bits. Excess is that of the sides that are not inside, in doubles and over "
    "the size of the curve; next to 0 there are many doubles. `quadratic_formula_margin_box` is the rule of OpenJDK since 19.",
    more=_promised_boxes)


@tables_of("roots")
def _roots(bundle, study):
    """Roots missed and added, and errors, by degree, over the ranges and inputs of the study."""
    rows = bundle.judged("roots.csv").some(study=study, status="ok")
    lines = [(label, over(column, combine, write), {}) for label, column, combine, write in (
        ("roots", "roots", sum, large), ("missed", "missed", sum, large), ("missed where the sign changes", "missed_odd", sum, large),
        ("spurious", "spurious", sum, large), ("largest error of t", "max_t_error", max, scientific),
        ("largest error of simple roots, u max(1, condition)", "max_error_condition", max, general),
        ("triangles, most of a mean", "mean_evaluations", max, general))]
    for where, own in inputs.by_set(rows):
        yield by_axis(own, "degree", study, f"Roots{where} ({_trials(own)} curves per method)", lines, row_head="quantity")


companion(
    "roots", "Roots",
    "Truth: the roots in [0, 1] of every coordinate minus a value, with their multiplicities, by isolation with integers. The value is 0, and "
    "the middle of the control points for curves of sets. An answer belongs to the nearest root, within 2^-20; a root without an answer is "
    "missed, an answer without a root, or a second one, is spurious. The condition of a simple root is p~ / |p'|. `certified` encloses all "
    "roots and says which enclosures have exactly one; a root that it cannot tell apart from another counts as one answer.")


@tables_of("bspline")
def _knot_spans(bundle, study):
    """Errors of points, then those of the control points of the Bernstein form, where a method makes it."""
    rows = bundle["bspline.csv"].some(study=study)
    across = swept(rows)[0]
    yield from error_tables(study, rows, across, "knots", "B-spline curves")
    made = [r for r in rows if r["max_control_error_u"] is not None]
    if made:
        lines = [(f"{text}, {knots} knots", one(column), {"knots": knots})
                 for text, column in (("mean", "mean_control_error_u"), ("largest", "max_control_error_u")) for knots in distinct(made, "knots")]
        lines.append(("proved bound", one("control_bound_u"), {}))  # it does not depend on the kind of knots
        yield by_axis(made, across, f"{study}-control", "Error of the control points of the span's Bernstein form over u p~", lines, row_head="quantity")


def _evaluators_on_spans(bundle):
    """Errors of evaluators of Bezier curves on knot spans; nothing where the bundle has none."""
    try:
        judged = bundle.judged().of_suite("bspline")
    except Missing:
        return
    yield Heading("Evaluators on knot spans")
    yield Text("The inputs `bspline` are knot spans of random B-spline curves in Bernstein form, rounded, and exact from there on; their "
               "neighbouring control points are averages of the same points. Those of `continuous` inputs are independent.")
    for study in judged.distinct("study"):
        yield from study_figure(bundle, study)
        yield from error_tables(study, judged.some(study=study))


companion(
    "bspline", "B-spline curves",
    "A trial is a B-spline curve in one knot span, over knots of a kind, and a t of the span. `..._span` converts the span to Bernstein "
    "form and evaluates it by the triangle of de Casteljau; the other methods compute the point from the control points of the B-spline "
    "curve. p~ is the sum of the magnitudes of these control points, times their weights in the result. A time is that of one point with "
    "all its preparation: a Bernstein form would serve any number of points of its span, which these times do not show.",
    more=_evaluators_on_spans)


@tables_of("flattening")
def _chords(bundle, study):
    """Tolerances across, each set or generator by itself."""
    rows = bundle["flattening.csv"].some(study=study, status="ok")
    lines = [(label, over(column, combine, write), {}) for label, column, combine, write in (
        ("chords over the least number, mean", "mean_over_least", max, general),
        ("largest distance over the tolerance", "max_error_over_tolerance", max, general), ("tolerance broken", "broken", sum, large),
        ("reversed curve with other points", "reversed_apart", sum, large), ("broken promises", "broken_promises", sum, large))]
    for where, own in inputs.by_set(rows):
        yield by_axis(own, "tolerance", study, f"Chords of curves of {_degrees(own)}{where} ({_trials(own)} trials per method, by tolerance)", lines, values=sorted(distinct(own, "tolerance"), reverse=True), row_head="quantity")


companion(
    "flattening", "Curves as chords",
    "The tolerance is relative to the size of a curve, the largest extent of its control points. A tolerance is broken where a point of the "
    "curve is certainly farther from the chord of its piece; enclosures of the distance decide that, and integers where they do not. The "
    "least number of chords has their ends on the curve: a lower bound is proved by a search over all starts and ends, and the ratio is to "
    "that bound. A method may have fewer where it breaks the tolerance. Ratios are the largest mean over the inputs of a study.")


@tables_of("easing")
def _eased(bundle, study):
    """Double and float across."""
    rows = bundle.judged("easing.csv").some(study=study, status="ok")
    lines = [(f"{label}{place}", over(prefix + column, combine, write), {}) for prefix, place in (("", ""), ("float_", ", float"))
             for label, column, combine, write in (
                 ("largest error, ulp", "max_error_ulp", max, general), ("99 % quantile, ulp", "p99_error_ulp", max, general),
                 ("largest error", "max_error", max, scientific), ("misrounded, of two answers a trial", "misrounded", sum, large),
                 ("goes back", "non_monotone", sum, large), ("wrong ends", "wrong_ends", sum, large),
                 ("most steps", "max_steps", max, large), ("does not end", "not_converged", sum, large))]
    for where, own in inputs.by_set(rows):
        yield by_axis(own, "generator", study, f"Easing curves{where} ({_trials(own)} trials per method, of which {_monotone(own)} of curves that "
                      "do not fall)", lines, row_head="quantity")
    yield Text("An easing curve is the cubic (0, 0) (x1, y1) (x2, y2) (1, 1) with x1 and x2 in [0, 1], `cubic-bezier()` of CSS; a method solves "
               "x(t) = x and takes y(t). Truth: the root enclosed with integers, y narrowed until its rounding is decided. Every trial is solved in "
               "double and, with curve and x rounded, in float. A trial of a curve that does not fall goes back where y falls between two of 32 "
               "neighbouring x or between k/64 and (k+1)/64. A loop is ended after 1000 steps: as published it may not end.")


def _monotone(rows):
    return large(sum(r["monotone_trials"] for r in rows if r["method"] == rows[0]["method"]))


@tables_of("easing_floats")
def _easing_floats(bundle, study):
    rows = bundle["easing_floats.csv"].some(study=study)
    lines = [(label, over(column, combine, write), {}) for label, column, combine, write in (
        ("largest error, ulp", "max_error_ulp", max, general), ("misrounded", "misrounded", sum, large),
        ("goes back", "non_monotone", sum, large), ("most steps", "max_steps", max, large), ("does not end", "not_converged", sum, large))]
    points = {row["points"] for row in rows}
    yield by_axis(rows, "curve_id", study, f"Easing curves at {large(max(points))} floats x each", lines, row_head="quantity")
