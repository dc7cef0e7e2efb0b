# SPDX-License-Identifier: MIT
"""What the suites show of derivatives, lengths, foot points, halves, grids and B-splines."""

from dataclasses import dataclass

from ..bundle import Missing
from ..rows import distinct, grouped
from ..wording import count, factor, general, large, listing, percent, scientific, shortest
from .evaluators import best, by_degree
from .finding import by_winners, finding, how_many_methods, methods_of, names, trials_of, verdict
from .times import faster_than_peers, fastest_correct

ORDERS, PRINTED_LOOP, CORRECTED = "derivative-order", "seed_000", "differences_de_casteljau"
NOT_ROUNDING = 1e6  # an error larger than the corrected loop's by this factor is not a rounding error


@finding("derivative")
def derivative_as_printed(bundle):
    """Holds where the printed loop is as accurate as the corrected one for the first derivative and wrong for every higher one."""
    table = bundle["derivative.csv"]
    pairs = []
    for row in table.select(study=ORDERS, method=PRINTED_LOOP, generator="continuous"):
        if 0 < row["order"] <= row["degree"]:
            other = table.one(study=ORDERS, method=CORRECTED, generator="continuous", degree=row["degree"], order=row["order"])
            pairs.append((row.number("mean_error") / other.number("mean_error"), row, other))
    first, higher = [p for p in pairs if p[1]["order"] == 1], [p for p in pairs if p[1]["order"] > 1]
    if not first or not higher:
        raise Missing(f"`derivative.csv` has no `{ORDERS}` rows of `{PRINTED_LOOP}` for the first and higher orders")
    worst, mildest = max(first, key=lambda p: p[0]), min(higher, key=lambda p: p[0])
    ratio, row, other = mildest
    return verdict(
        worst[0] < 2 and ratio > NOT_ROUNDING,
        "The difference loop of Document 000 is correct for the first derivative and wrong for every higher one.",
        "In this bundle the difference loop of Document 000 cannot be distinguished from the corrected one order by order.",
        f"For the first derivative its mean error is at most {factor(worst[0])} times that of the loop with pass m ending at n-m; from the second on "
        f"it is at least {factor(ratio)} times that (degree {shortest(row['degree'])}, order {shortest(row['order'])}: "
        f"{scientific(row['mean_error'])} against {scientific(other['mean_error'])}).", rows=(*worst[1:], row, other))


DISTANT, FIRST, LAST = "derivative-distant", "differences_de_casteljau", "triangle_derivatives"
LOST = 1e3  # in u p~: ten of the twenty bits by which the coordinates exceed the differences


@finding("derivative")
def derivative_distant(bundle):
    """Holds where differences of the control points keep every digit that differences of the triangle's points lose."""
    before, after = ([r for r in bundle["derivative.csv"].select(study=DISTANT, method=method) if 0 < r["order"] < r["degree"]]
                     for method in (FIRST, LAST))
    if not before or not after:
        raise Missing(f"`derivative.csv` has no `{DISTANT}` rows of `{FIRST}` and `{LAST}`")
    kept, lost = max(before, key=lambda r: r.number("mean_error_u")), min(after, key=lambda r: r.number("mean_error_u"))
    return verdict(
        kept["mean_error_u"] < 10 and lost["mean_error_u"] > LOST,
        "Far from the origin derivatives must be taken of the control points, not of the points of de Casteljau's triangle.",
        "Far from the origin it does not matter whether control points or points of the triangle are differenced.",
        f"With control points in [R (1 - 2^-20), R], their first differences are exact and the mean error of `{FIRST}` is at most "
        f"{general(kept['mean_error_u'])} u p~; `{LAST}` differences rounded points and has at least {scientific(lost['mean_error_u'])} u p~ (degree "
        f"{shortest(lost['degree'])}, order {shortest(lost['order'])}).", rows=(kept, lost))


@finding("derivative")
def derivative_bounds(bundle):
    """Holds where no derivative of any trial exceeds its proved bound."""
    rows = [r for r in bundle["derivative.csv"].of_suite("derivative").rows if r["bound_u"]]
    if not rows:
        raise Missing("`derivative.csv` has no `derivative-` row with a bound")
    broken = [r for r in rows if r["bound_violations"]]
    closest = max(rows, key=lambda r: (r["max_error_u"] or 0) / r["bound_u"])
    return verdict(
        not broken, f"No proved bound of a derivative is exceeded in {trials_of(rows)} judged evaluations.",
        f"A proved bound of a derivative is exceeded by {methods_of(broken)}: a bound or its condition is wrong.",
        f"{count(len(rows), 'cell')} of {how_many_methods(rows)} have a bound. The closest error is "
        f"{general((closest['max_error_u'] or 0) / closest['bound_u'], 2)} of it (`{closest['method']}`, degree {shortest(closest['degree'])}, order "
        f"{shortest(closest['order'])}).", rows=broken or [closest])


@finding("companion_speed")
def derivative_time(bundle):
    """Holds where one method certainly takes less time than every other correct one, from degree 5 on."""
    return fastest_correct(bundle, "companion_speed-derivative", "derivatives of curves from degree 5 on", lambda row: row["degree"] >= 5)


@finding("arc_length")
def arc_length_promise(bundle):
    """Holds where no method reported a tolerance as kept that it did not keep."""
    rows = bundle["arc_length.csv"].of_suite("arc_length").rows
    broken = [r for r in rows if r["broken_promises"]]
    trials, refused = (sum(r.number(c) for r in rows) for c in ("trials", "non_converged"))
    silent = sorted({r["method"] for r in rows} - {r["method"] for r in rows if r["non_converged"] < r["trials"]})
    return verdict(
        not broken, f"Every promised tolerance of an arc length is kept, in {large(trials - refused)} promises.",
        f"A promised tolerance of an arc length is broken by {methods_of(broken)}.",
        f"In {large(trials)} calls of {how_many_methods(rows)}, {percent(refused / trials)} returned that the tolerance could not be kept."
        + (f" {names(silent)} never promises." if silent else ""), rows=broken or rows[:1])


PRINTED_RULE = "seed_000_simpson38"


@finding("arc_length")
def arc_length_as_printed(bundle):
    """Holds where the printed adaptive rule is off by more than the tolerance with which its test accepted."""
    rows = bundle["arc_length.csv"].of_suite("arc_length").some(method=PRINTED_RULE)
    beyond = [r for r in rows if r.number("max_relative") > r.number("tolerance")]
    in_mean = [r for r in rows if r.number("mean_relative") > r.number("tolerance")]
    worst = max(rows, key=lambda r: r.number("max_relative") / r.number("tolerance"))
    return verdict(
        beyond, f"The source document's adaptive Simpson rule, which accepts at 15 eps, exceeds its tolerance in {len(beyond)} of {count(len(rows), 'cell')}.",
        "The source document's adaptive Simpson rule exceeds its tolerance in no cell.",
        f"In {count(len(in_mean), 'cell')} the mean error does. The largest error is {factor(worst['max_relative'] / worst['tolerance'])} times a tolerance of "
        f"{shortest(worst['tolerance'])} (degree {shortest(worst['degree'])}, `{worst['generator']}`).", rows=[worst])


TOLERANCES, SIMPSON, GAUSS = "arc_length-tolerance", "adaptive_simpson38", "gauss_legendre_adaptive"
STRICT = 1e-6


@finding("arc_length")
def arc_length_cost(bundle):
    """Holds where adaptive Gauss-Legendre rules take fewer evaluations than Simpson's at every strict tolerance."""
    table = bundle["arc_length.csv"]
    pairs = []
    for row in table.select(study=TOLERANCES, method=SIMPSON):
        if row["tolerance"] <= STRICT and not row["non_converged"]:
            other = table.one(study=TOLERANCES, method=GAUSS, **{c: row[c] for c in ("degree", "generator", "tolerance")})
            pairs.append((row.number("mean_evaluations") / other.number("mean_evaluations"), row, other))
    if not pairs:
        raise Missing(f"`arc_length.csv` has no converged `{TOLERANCES}` rows of `{SIMPSON}` at {STRICT:g} or below")
    low, high = (end(pairs, key=lambda p: p[0]) for end in (min, max))
    ratio, simpson, gauss = high
    return verdict(
        low[0] > 1,
        f"At tolerances of {shortest(STRICT)} and below, adaptive Gauss-Legendre rules take fewer evaluations than Simpson's 3/8 rule.",
        f"At tolerances of {shortest(STRICT)} and below, adaptive Gauss-Legendre rules do not always take fewer evaluations than Simpson's 3/8 rule.",
        f"Simpson's rule takes {factor(low[0])} to {factor(ratio)} times as many: at {shortest(simpson['tolerance'])} "
        f"{general(simpson['mean_evaluations'])} against {general(gauss['mean_evaluations'])} (degree {shortest(simpson['degree'])}, "
        f"`{simpson['generator']}`).", rows=(*low[1:], simpson, gauss))


@finding("companion_peers")
def arc_length_time(bundle):
    """Holds where the best of our methods takes less time than every other library."""
    return faster_than_peers(bundle, "companion_peers-length_speed", "the length of a cubic")


@finding("companion_speed")
def arc_length_time_fastest(bundle):
    """Holds where one method certainly takes less time than every other correct one."""
    return fastest_correct(bundle, "companion_speed-length", "lengths of cubics")


GUARDED = ("bracketed_newton", "halley")
STRICTEST = 1e-12  # below this, rounding errors decide


@finding("inverse_arc_length")
def inverse_arc_length_brackets(bundle):
    """Holds where the guarded methods always converge and no method breaks a promise."""
    table = bundle["inverse_arc_length.csv"].of_suite("inverse_arc_length")
    guarded = [r for r in table.select(method=GUARDED) if r["tolerance"] >= STRICTEST]
    if not guarded:
        raise Missing(f"`inverse_arc_length.csv` has no row of {names(GUARDED)} at {STRICTEST:g} or above")
    broken = [r for r in table.rows if r["broken_promises"]]
    wrong = broken or [r for r in guarded if r["non_converged"]]
    longest = max(guarded, key=lambda r: r.number("max_iterations"))
    return verdict(
        not wrong, f"Newton's and Halley's method in a bracket reach every length, at tolerances of {shortest(STRICTEST)} and above, "
        f"{trials_of(guarded)} times.", f"A length is not reached as promised by {methods_of(wrong)}.",
        f"At most {general(longest['max_iterations'])} iterations (`{longest['method']}`, degree {shortest(longest['degree'])}, "
        f"`{longest['generator']}`, tolerance {shortest(longest['tolerance'])}). "
        + (f"{large(sum(r.number('broken_promises') for r in broken))} promises are broken." if broken else "No method breaks a promise."),
        rows=wrong or [longest])


UNGUARDED, BRACKETED = "seed_000_newton", "bracketed_newton"


@finding("inverse_arc_length")
def inverse_arc_length_unguarded(bundle):
    """Holds where the document's iteration fails on curves on which a bracket does not."""
    table = bundle["inverse_arc_length.csv"].of_suite("inverse_arc_length")
    same = ("study", "dimension", "degree", "coordinate_range", "t_min", "t_max", "generator", "tolerance")
    pairs = [(row, table.one(method=BRACKETED, **{c: row[c] for c in same})) for row in table.some(method=UNGUARDED)]
    pairs = [(row, other) for row, other in pairs if not other["non_converged"]]
    failed, trials = (sum(row.number(c) for row, _ in pairs) for c in ("non_converged", "trials"))
    worst, beside = max(pairs, key=lambda p: p[0].number("non_converged") / p[0].number("trials"))
    return verdict(
        failed > 0, f"The source document's iteration for the parameter at a length fails in {percent(failed / trials)} of the trials in which a "
        "bracket does not.", "The source document's iteration for the parameter at a length fails nowhere that a bracket does not.",
        f"It fails in {large(failed)} of {large(trials)} trials, most often in {general(worst['non_converged'])} of {general(worst['trials'])} of degree "
        f"{shortest(worst['degree'])}, `{worst['generator']}`, at a tolerance of {shortest(worst['tolerance'])}. Its mean number of iterations there is "
        f"{general(worst['mean_iterations'])}, that of `{BRACKETED}` {general(beside['mean_iterations'])}.", rows=(worst, beside))


EVEN = 1e-9  # relative difference from the mean up to which gaps are called even


@finding("inverse_arc_length")
def inverse_arc_length_spacing(bundle):
    """Holds where points at true parameters are even on every curve, and points at equal steps of t on none."""
    table = bundle["spacing.csv"].of_suite("inverse_arc_length")
    gaps = {spacing: [r for r in table.select(spacing=spacing) if r["gap"] is not None] for spacing in ("parameter", "arc_length")}
    if not all(gaps.values()):
        raise Missing("`spacing.csv` has no gaps of both spacings")
    uneven, bunched = ([r for r in rows if abs(r.number("gap") - 1) > EVEN] for rows in (gaps["arc_length"], gaps["parameter"]))
    studies = distinct(gaps["parameter"], "study")
    low, high = (end(gaps["parameter"], key=lambda r: r.number("gap")) for end in (min, max))
    return verdict(
        not uneven and {r["study"] for r in bunched} == set(studies),
        "Points at equal steps of t are not evenly spaced, points at equal steps of the length are.",
        "Points are not spaced as expected: even at equal steps of the length, and only there.",
        f"On {len(studies)} drawn curves, equal steps of t cover {general(low['gap'])} to {general(high['gap'])} times the mean step of the length.",
        rows=(low, high, *uneven))


@finding("companion_speed")
def inverse_arc_length_time(bundle):
    """Holds where one method certainly takes less time than every other correct one."""
    return fastest_correct(bundle, "companion_speed-at_length", "parameters at a length of cubics")


FILE = "projection.csv"
GOAL = 4  # units of 2^-52 times the largest coordinate


@dataclass(frozen=True)
class Method:
    """One method over the cells that it supports; Missing where there are none."""

    rows: list

    def __post_init__(self):
        if not self.rows:
            raise Missing(f"`{FILE}` has no cells of the same degree for two methods that are compared")

    @property
    def missed(self):
        return sum(r.number("missed") for r in self.rows)

    @property
    def largest(self):
        """The largest error of a distance, in units of 2^-52 times the largest coordinate."""
        return max(r.number("max_error_eps") for r in self.rows)

    @property
    def share(self):
        return self.missed / sum(r.number("trials") for r in self.rows)


def _projectors(bundle, *required):
    """{method: Method}, ordered by missed foot points, then by error; Missing without those required."""
    rows = bundle.judged(FILE).of_suite("projection").some(status="ok")
    methods = {m: Method(own) for m, own in grouped(rows, "method").items()}
    if not set(required) <= set(methods):
        raise Missing(f"a `projection-` study requires {names(required)}")
    return dict(sorted(methods.items(), key=lambda item: (item[1].share, item[1].largest, item[0])))


@finding("projection")
def projection_isolate(bundle):
    """Holds where `quintic_isolate` misses no foot point and no distance is off by more than the goal."""
    methods = _projectors(bundle, "quintic_isolate")
    isolate = methods.pop("quintic_isolate")
    unit = "2^-52 times the largest coordinate"
    return verdict(
        isolate.missed == 0 and isolate.largest <= GOAL,
        f"Isolating the roots of (C - P)·C' and polishing them misses none of {trials_of(isolate.rows)} foot points; the largest error of the distance is "
        f"{general(isolate.largest)} units of {unit}.",
        f"Isolating the roots of (C - P)·C' misses {large(isolate.missed)} of {trials_of(isolate.rows)} foot points; the largest error of the distance is "
        f"{general(isolate.largest)} units of {unit}, the goal {GOAL}.",
        *(f"`{m}`: {large(one.missed)} of {trials_of(one.rows)} missed ({percent(one.share)}), largest error of the distance {general(one.largest)} units."
          for m, one in methods.items()), rows=[max(isolate.rows, key=lambda r: (r["missed"], r["max_error_eps"]))])


MANY_MISSED = 0.1  # share of missed foot points that no choice of inputs explains


@finding("projection")
def projection_printed(bundle):
    """Holds where the printed coefficients miss foot points that the correct ones find."""
    methods = _projectors(bundle, "quintic_seed_002", "quintic_companion")
    printed = methods["quintic_seed_002"]
    known = distinct(printed.rows, "degree")  # the printed one is for cubics only
    correct = Method([r for r in methods["quintic_companion"].rows if r["degree"] in known])
    shares = f"{percent(printed.share)} of {trials_of(printed.rows)}"
    return verdict(
        printed.share > MANY_MISSED > correct.share,
        f"The quintic with the printed coefficients k2, k3 and k4 misses {shares} foot points, with the correct ones and the same solver "
        f"{percent(correct.share)} of {trials_of(correct.rows)}.",
        f"The quintic with the printed coefficients misses {shares} foot points, that with the correct ones {percent(correct.share)}: these inputs do not "
        "distinguish them.",
        "Printed: k2 = A·D + 6 B·C + 3 C·C, k3 = 3 B·D + 6 C·C + 3 C·D, k4 = 3 C·D + 3 D·D. Expanded: k2 = A·D + 9 B·C, k3 = 4 B·D + 6 C·C, k4 = 5 C·D.",
        rows=[max(one.rows, key=lambda r: r["missed"]) for one in (printed, correct)])


@finding("companion_peers")
def projection_time(bundle):
    """Holds where the best of our methods takes less time than every other library."""
    return faster_than_peers(bundle, "companion_peers-projection_speed", "the nearest point of a cubic")


@finding("companion_speed")
def projection_time_fastest(bundle):
    """Holds where one method certainly takes less time than every other correct one."""
    return fastest_correct(bundle, "companion_speed-projection", "foot points on cubics")


COUNTS = ("junctions_apart", "ends_moved", "points_off")


@finding("subdivision")
def subdivision_halves(bundle):
    """Holds where every method shares the junction, keeps the ends and puts points of halves within the bounds."""
    rows = [r for r in bundle["subdivision.csv"].of_suite("subdivision").rows if any(r[c] is not None for c in COUNTS)]
    if not rows:
        raise Missing("`subdivision.csv` has no row of the suite `subdivision` that states whether halves fit together")
    broken = [r for r in rows if any(r[c] for c in COUNTS)]
    judged = [r for r in rows if r["points_off"] is not None]
    return verdict(
        not broken, f"In {trials_of(rows)} splits the halves share their junction and keep the ends of the curve to the last bit.",
        f"Halves do not fit together: {methods_of(broken)}.",
        f"{how_many_methods(rows)} split {large(len(rows))} cells. In {large(len(judged))} of them a point of each half is compared with the true point, "
        f"within the bounds of the control points: {large(sum(r['points_off'] for r in judged))} of {trials_of(judged)} are off.", rows=broken or rows[:1])


def _that_varies(table, column):
    """The first study of a table that varies a column."""
    study = next((s for s in table.distinct("study") if len(table.distinct(column, study=s)) > 1), None)
    if study is None:
        raise Missing(f"`{table.file}` has no study of its suite that varies `{column}`")
    return study


@finding("subdivision")
def subdivision_best(bundle):
    """Holds where the same method has the smallest mean error over u p~ at every degree."""
    table = bundle["subdivision.csv"].of_suite("subdivision")
    study = _that_varies(table, "degree")
    size = min(table.distinct("coordinate_range", study=study), key=lambda value: abs(value - 1))
    methods = by_degree(table.select(study=study, coordinate_range=size))
    winners = best(methods)
    top = max(winners)
    last = sorted((rows[top]["mean_error_u"], m) for m, rows in methods.items() if top in rows)
    (low, winner), (high, loser) = last[0], last[-1]
    return verdict(
        len(set(winners.values())) == 1, f"{names(winners[top])} splits with the smallest mean error over u p~ at every degree.",
        "Which method splits with the smallest mean error over u p~ changes with the degree.",
        f"Smallest mean error: {by_winners(winners)}. At degree {top:g} `{winner}` has {general(low)} u p~ and `{loser}` {general(high)}, "
        f"{factor(high / low)} times as much.", rows=(methods[winner][top], methods[loser][top]))


@finding("bounds")
def boxes_contain(bundle):
    """Holds where no method that is proved to contain the curve lost a point of one."""
    rows = [r for r in bundle["bounds.csv"].of_suite("bounds").rows if r["status"] == "ok"]
    if not rows:
        raise Missing("`bounds.csv` has no row of the suite `bounds` with a box")
    refuted = [r for r in rows if r["contains"] == "refuted"]
    promised = {r["id"] for r in bundle["methods.csv"].rows if r["problem"] == "bounds" and r["bound"]}
    proved = [r for r in rows if r["method"] in promised]
    broken = [r for r in proved if r["too_small"]]
    return verdict(
        not broken, f"No box of a method that is proved to contain the curve loses a point: {trials_of(proved)} boxes.",
        f"Boxes that are proved to contain the curve lose points: {methods_of(broken)}.",
        f"{large(sum(r['too_small'] for r in refuted))} boxes of the other methods do, {methods_of(refuted) or 'none'}.",
        rows=broken or refuted[:1] or rows[:1])


@finding("roots")
def roots_enclosed(bundle):
    """Holds where no method that encloses all roots lost one."""
    rows = [r for r in bundle.judged("roots.csv").of_suite("roots").rows if r["status"] == "ok"]
    promised = {r["id"] for r in bundle["methods.csv"].rows if r["problem"] == "roots" and r["bound"]}
    proved = [r for r in rows if r["method"] in promised]
    if not proved:
        raise Missing("`roots.csv` has no row of the suite `roots` of a method that encloses all roots")
    broken = [r for r in proved if r["broken_promises"]]
    others = [r for r in rows if r["method"] not in promised and r["missed_odd"]]
    return verdict(
        not broken, f"Every root is in an enclosure where a method promises that: {trials_of(proved)} curves.",
        f"Roots are outside the enclosures that are proved: {methods_of(broken)}.",
        f"The other methods miss {large(sum(r['missed_odd'] for r in others))} roots at which the sign changes, {methods_of(others) or 'none'}.",
        rows=broken or others[:1] or rows[:1])


@finding("grid")
def grid_growth(bundle):
    """Holds where, at every degree, the least accurate method on the largest grid has a larger mean error over that of the best method there than
    on the smallest grid."""
    table = bundle["grid.csv"].of_suite("grid")
    study = _that_varies(table, "points")
    points = sorted(table.distinct("points", study=study))
    ends = {}  # degree: (row of the least accurate method on the largest grid, its ratio on the smallest grid, on the largest)
    for n in table.distinct("degree", study=study):
        smallest, largest = ({r["method"]: r for r in table.select(study=study, degree=n, points=p) if r["mean_error_u"]} for p in (points[0], points[-1]))
        worst = max(largest.values(), key=lambda r: r["mean_error_u"], default=None)
        if len(largest) > 1 and worst["method"] in smallest:
            ends[n] = worst, *(grid[worst["method"]]["mean_error_u"] / min(r["mean_error_u"] for r in grid.values()) for grid in (smallest, largest))
    if not ends:
        raise Missing("`grid.csv` has no two methods with errors on the same grids")
    losers = methods_of(worst for worst, _, _ in ends.values())
    return verdict(
        all(few < many for _, few, many in ends.values()), f"The more points a grid has, the more digits {losers} loses against the best method.",
        f"{losers} does not lose more digits against the best method where a grid has more points.",
        "Mean error over u p~, over that of the best method on the same grid: "
        + "; ".join(f"{factor(few)} times at degree {shortest(n)} with {large(points[0])} points and {factor(many)} times with {large(points[-1])}"
                    for n, (_, few, many) in ends.items()) + f" (study `{study}`).", rows=[worst for worst, _, _ in ends.values()])


@finding("bspline")
def bspline_recurrence(bundle):
    """Holds where no largest error of control points exceeds the proved bound of another method in the same cell."""
    def cell(row):
        return tuple(row[c] for c in ("dimension", "degree", "coordinate_range", "t_min", "t_max", "generator", "knots"))
    rows = [r for r in bundle["bspline.csv"].of_suite("bspline").rows if r["max_control_error_u"] is not None]
    proved = [r for r in rows if r["control_bound_u"] is not None]
    bounds = {}
    for r in proved:
        bounds[cell(r)] = min(bounds.get(cell(r), r["control_bound_u"]), r["control_bound_u"])
    judged = [r for r in rows if r["control_bound_u"] is None and bounds.get(cell(r))]
    if not judged:
        raise Missing("`bspline.csv` has no Bernstein form without a proved bound in a cell with a proved bound")
    beyond = [r for r in judged if r["max_control_error_u"] > bounds[cell(r)]]
    worst = max(judged, key=lambda r: r["max_control_error_u"])
    unproved, provers = methods_of(judged), names(sorted(distinct(proved, "method")))
    return verdict(
        not beyond, f"{unproved}, which has no proved bound, stays below the proved bound of {provers}.",
        f"{unproved} loses digits: over {listing(distinct(beyond, 'knots'))} knots its control points have errors above the proved bound of {provers}.",
        f"The largest error of a control point is {general(worst['max_control_error_u'])} u p~, at degree {shortest(worst['degree'])} over "
        f"{worst['knots']} knots, where the proved bound of {provers} is {general(bounds[cell(worst)])}."
        + (f" The lowest degree with an error above such a bound is {shortest(min(r['degree'] for r in beyond))}." if beyond else ""), rows=[worst])


@finding("flattening")
def flattening_kept(bundle):
    """Holds where no method breaks a tolerance."""
    rows = bundle["flattening.csv"].of_suite("flattening").some(status="ok")
    broken = [r for r in rows if r["broken"] > 0]
    keepers = sorted(set(distinct(rows, "method")) - set(distinct(broken, "method")))
    ratios = {m: max(r["mean_over_least"] for r in rows if r["method"] == m and r["study"] == "flattening-cubics") for m in keepers
              if any(r["method"] == m and r["study"] == "flattening-cubics" for r in rows)}
    detail = "Chords over the least number, the largest mean over tolerances, of random cubics by methods that kept all: " \
        + "; ".join(f"{names([m])} {general(ratio)}" for m, ratio in sorted(ratios.items(), key=lambda item: item[1])) + "."
    return verdict(not broken, "Every method keeps its tolerance on every curve.",
                   f"{names(sorted(distinct(broken, 'method')))} break{'s' if len(distinct(broken, 'method')) == 1 else ''} the tolerance on some curves.",
                   detail, rows=broken or rows)
