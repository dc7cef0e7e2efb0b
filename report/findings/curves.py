# SPDX-License-Identifier: MIT
"""What the suites show of derivatives, lengths, foot points, halves and grids."""

from dataclasses import dataclass

from ..bundle import Missing
from ..document import Finding
from ..wording import count, factor, general, large, listing, percent, scientific, shortest
from .evaluators import best, by_degree, degrees, names
from .finding import finding
from .times import faster_than_peers, fastest_right

ORDERS, PRINTED_LOOP, MENDED = "derivative-order", "seed_000", "differences_de_casteljau"
NOT_ROUNDING = 1e6  # an error larger than the corrected loop's by this factor is not a rounding error


@finding(suite="derivative")
def derivative_as_printed(bundle):
    """Holds where the printed loop is as accurate as the corrected one for the first derivative and wrong for every
    higher one."""
    table = bundle["derivative.csv"]
    pairs = []
    for row in table.select(study=ORDERS, method=PRINTED_LOOP, generator="continuous"):
        if 0 < row["order"] <= row["degree"]:
            other = table.one(study=ORDERS, method=MENDED, generator="continuous", degree=row["degree"], order=row["order"])
            pairs.append((row, other, row.number("mean_error") / other.number("mean_error")))
    first = [p for p in pairs if p[0]["order"] == 1]
    higher = [p for p in pairs if p[0]["order"] > 1]
    if not first or not higher:
        raise Missing(f"`derivative.csv` has no `{ORDERS}` rows of `{PRINTED_LOOP}` for the first and higher orders")
    holds = all(ratio < 2 for *_, ratio in first) and all(ratio > NOT_ROUNDING for *_, ratio in higher)
    mildest = min(higher, key=lambda p: p[2])
    return Finding(
        id="derivative_as_printed", about="suite", suite="derivative", claim="", holds=holds,
        headline="The difference loop of Document 000 is right for the first derivative and wrong for every higher one."
        if holds else "The difference loop of Document 000 is not told from the mended one order by order.",
        detail=(f"For the first derivative its mean error is at most {factor(max(r for *_, r in first))} times that of the loop "
                f"with pass m ending at n-m; from the second on it is at least {factor(mildest[2])} times that (degree "
                f"{shortest(mildest[0]['degree'])}, order {shortest(mildest[0]['order'])}: "
                f"{scientific(mildest[0]['mean_error'])} against {scientific(mildest[1]['mean_error'])}).",),
        rows=tuple(r for pair in (max(first, key=lambda p: p[2]), mildest) for r in pair[:2]))


DISTANT, FIRST, LAST = "derivative-distant", "differences_de_casteljau", "triangle_derivatives"
LOST = 1e3  # in u p~: ten of the twenty bits by which the coordinates exceed the differences


@finding(suite="derivative")
def derivative_distant(bundle):
    """Holds where differences of the control points keep every digit that differences of the triangle's points lose."""
    table = bundle["derivative.csv"]

    def rows(method):
        return [r for r in table.select(study=DISTANT, method=method) if 0 < r["order"] < r["degree"]]
    before, after = rows(FIRST), rows(LAST)
    if not before or not after:
        raise Missing(f"`derivative.csv` has no `{DISTANT}` rows of `{FIRST}` and `{LAST}`")
    kept = max(before, key=lambda r: r.number("mean_error_u"))
    lost = min(after, key=lambda r: r.number("mean_error_u"))
    holds = kept["mean_error_u"] < 10 and lost["mean_error_u"] > LOST
    return Finding(
        id="derivative_distant", about="suite", suite="derivative", claim="", holds=holds,
        headline="Far from the origin derivatives must be taken of the control points, not of the points of de Casteljau's triangle."
        if holds else "Far from the origin it does not matter whether control points or points of the triangle are differenced.",
        detail=(f"With control points in [R (1 - 2^-20), R], their first differences are exact and the mean error of `{FIRST}` is at most "
                f"{general(kept['mean_error_u'])} u p~; `{LAST}` differences rounded points and has at least "
                f"{scientific(lost['mean_error_u'])} u p~ (degree {shortest(lost['degree'])}, order {shortest(lost['order'])}).",),
        rows=(kept, lost))


@finding(suite="derivative")
def derivative_bounds(bundle):
    """Holds where no derivative of any trial exceeds its proved bound."""
    rows = [r for r in bundle["derivative.csv"].of_suite("derivative").rows if r["bound_u"]]
    if not rows:
        raise Missing("`derivative.csv` has no `derivative-` row with a bound")
    broken = [r for r in rows if r["bound_violations"]]
    closest = max(rows, key=lambda r: (r["max_error_u"] or 0) / r["bound_u"])
    return Finding(
        id="derivative_bounds", about="suite", suite="derivative", claim="", holds=not broken,
        headline=f"No proved bound of a derivative is exceeded in {large(sum(r.number('trials') for r in rows))} judged evaluations."
        if not broken else
        f"A proved bound of a derivative is exceeded by {names(dict.fromkeys(r['method'] for r in broken))}: a bound or its "
        "condition is wrong.",
        detail=(f"{count(len(rows), 'cell')} of {count(len({r['method'] for r in rows}), 'method')} carry a bound. The closest comes "
                f"to {general((closest['max_error_u'] or 0) / closest['bound_u'], 2)} of it (`{closest['method']}`, degree "
                f"{shortest(closest['degree'])}, order {shortest(closest['order'])}).",),
        rows=tuple(broken or [closest]))


@finding(suite="companion_speed")
def derivative_time(bundle):
    """Holds where one method certainly takes less time than every other that is right, from degree 5 on."""
    return fastest_right(bundle, "derivative_time", "companion_speed-derivative", "Derivatives of curves from degree 5 on", lambda row: row["degree"] >= 5)


@finding(suite="arc_length")
def arc_length_promise(bundle):
    """Holds where no method said that it kept a tolerance that it did not keep."""
    rows = bundle["arc_length.csv"].of_suite("arc_length").rows
    broken = [r for r in rows if r["broken_promises"]]
    trials = sum(r.number("trials") for r in rows)
    refused = sum(r.number("non_converged") for r in rows)
    silent = sorted({r["method"] for r in rows} - {r["method"] for r in rows if r["non_converged"] < r["trials"]})
    return Finding(
        id="arc_length_promise", about="suite", suite="arc_length", claim="", holds=not broken,
        headline=f"Every promised tolerance of an arc length is kept, in {large(trials - refused)} promises." if not broken else
        f"A promised tolerance of an arc length is broken by {names(dict.fromkeys(r['method'] for r in broken))}.",
        detail=(f"{count(len({r['method'] for r in rows}), 'method')} were asked {large(trials)} times and said "
                f"{percent(refused / trials)} of the time that they could not keep the tolerance."
                + (f" Never to promise anything is all that {names(silent)} can do." if silent else ""),),
        rows=tuple(broken or rows[:1]))


TOLERANCES, SIMPSON, GAUSS = "arc_length-tolerance", "adaptive_simpson38", "gauss_legendre_adaptive"
STRICT = 1e-6


@finding(suite="arc_length")
def arc_length_cost(bundle):
    """Holds where adaptive Gauss-Legendre rules take fewer evaluations than Simpson's at every strict tolerance."""
    table = bundle["arc_length.csv"]
    pairs = []
    for row in table.select(study=TOLERANCES, method=SIMPSON):
        if row["tolerance"] <= STRICT and not row["non_converged"]:
            key = {c: row[c] for c in ("degree", "generator", "tolerance")}
            other = table.one(study=TOLERANCES, method=GAUSS, **key)
            pairs.append((row.number("mean_evaluations") / other.number("mean_evaluations"), row, other))
    if not pairs:
        raise Missing(f"`arc_length.csv` has no converged `{TOLERANCES}` rows of `{SIMPSON}` at {STRICT:g} or below")
    least = min(pairs, key=lambda p: p[0])
    most = max(pairs, key=lambda p: p[0])
    holds = least[0] > 1
    return Finding(
        id="arc_length_cost", about="suite", suite="arc_length", claim="", holds=holds,
        headline=f"At tolerances of {shortest(STRICT)} and below, adaptive Gauss-Legendre rules take fewer evaluations than "
        "Simpson's 3/8 rule." if holds else
        f"At tolerances of {shortest(STRICT)} and below, adaptive Gauss-Legendre rules do not always take fewer evaluations than "
        "Simpson's 3/8 rule.",
        detail=(f"Simpson's rule takes {factor(least[0])} to {factor(most[0])} times as many: at {shortest(most[1]['tolerance'])} "
                f"{general(most[1]['mean_evaluations'])} against {general(most[2]['mean_evaluations'])} (degree "
                f"{shortest(most[1]['degree'])}, `{most[1]['generator']}`).",),
        rows=(*least[1:], *most[1:]))


@finding(suite="companion_peers")
def arc_length_time(bundle):
    """Holds where the best of our methods takes less time than every other library."""
    return faster_than_peers(bundle, "arc_length_time", 'companion_peers', "companion_peers-length_speed", "The length of a cubic")


@finding(suite="companion_speed")
def arc_length_time_fastest(bundle):
    """Holds where one method certainly takes less time than every other that is right."""
    return fastest_right(bundle, "arc_length_time_fastest", "companion_speed-length", "Lengths of cubics")


GUARDED = ("bracketed_newton", "halley")
STRICTEST = 1e-12  # below this, rounding errors decide


@finding(suite="inverse_arc_length")
def inverse_arc_length_brackets(bundle):
    """Holds where the guarded methods always converge and no method breaks a promise."""
    table = bundle["inverse_arc_length.csv"].of_suite("inverse_arc_length")
    guarded = [r for r in table.select(method=GUARDED) if r["tolerance"] >= STRICTEST]
    if not guarded:
        raise Missing(f"`inverse_arc_length.csv` has no row of {names(GUARDED)} at {STRICTEST:g} or above")
    broken = [r for r in table.rows if r["broken_promises"]]
    failed = [r for r in guarded if r["non_converged"]]
    longest = max(guarded, key=lambda r: r.number("max_iterations"))
    trials = sum(r.number("trials") for r in guarded)
    wrong = broken or failed
    return Finding(
        id="inverse_arc_length_brackets", about="suite", suite="inverse_arc_length", claim="", holds=not wrong,
        headline=f"Newton's and Halley's method in a bracket reach every length, at tolerances of {shortest(STRICTEST)} and above, "
        f"{large(trials)} times." if not wrong else
        f"A length is not reached as promised by {names(dict.fromkeys(r['method'] for r in wrong))}.",
        detail=(f"At most {general(longest['max_iterations'])} iterations (`{longest['method']}`, degree {shortest(longest['degree'])}, "
                f"`{longest['generator']}`, tolerance {shortest(longest['tolerance'])}). "
                + ("No method says that it kept a tolerance that it did not keep." if not broken else
                   f"{large(sum(r.number('broken_promises') for r in broken))} promises are broken."),),
        rows=tuple(wrong or [longest]))


UNGUARDED, BRACKETED = "seed_000_newton", "bracketed_newton"


@finding(suite="inverse_arc_length")
def inverse_arc_length_unguarded(bundle):
    """Holds where the document's iteration fails on curves on which a bracket does not."""
    table = bundle["inverse_arc_length.csv"].of_suite("inverse_arc_length")
    pairs = []
    for row in table.some(method=UNGUARDED):
        key = {c: row[c] for c in ("study", "dimension", "degree", "coordinate_range", "t_min", "t_max", "generator", "tolerance")}
        pairs.append((row, table.one(method=BRACKETED, **key)))
    pairs = [(row, other) for row, other in pairs if not other["non_converged"]]
    failed = sum(row.number("non_converged") for row, _ in pairs)
    trials = sum(row.number("trials") for row, _ in pairs)
    worst, beside = max(pairs, key=lambda p: p[0].number("non_converged") / p[0].number("trials"))
    return Finding(
        id="inverse_arc_length_unguarded", about="suite", suite="inverse_arc_length", claim="", holds=failed > 0,
        headline=f"The source document's iteration for the parameter at a length fails in {percent(failed / trials)} of the trials in "
        "which a bracket does not." if failed else
        "The source document's iteration for the parameter at a length fails nowhere that a bracket does not.",
        detail=(f"{large(failed)} of {large(trials)}; most in {general(worst['non_converged'])} of {general(worst['trials'])} trials "
                f"of degree {shortest(worst['degree'])}, `{worst['generator']}`, at a tolerance of {shortest(worst['tolerance'])}. Its mean number of "
                f"iterations there is {general(worst['mean_iterations'])}, that of `{BRACKETED}` "
                f"{general(beside['mean_iterations'])}.",) if failed else
        (f"{large(trials)} trials.",),
        rows=(worst, beside))


EVEN = 1e-9  # relative difference from the mean up to which gaps are called even


@finding(suite="inverse_arc_length")
def inverse_arc_length_spacing(bundle):
    """Holds where points at true parameters are even on every curve, and points at equal steps of t on none."""
    table = bundle["spacing.csv"].of_suite("inverse_arc_length")
    gaps = {spacing: [r for r in table.select(spacing=spacing) if r["gap"] is not None] for spacing in ("parameter", "arc_length")}
    if not all(gaps.values()):
        raise Missing("`spacing.csv` has no gaps of both spacings")
    uneven = [r for r in gaps["arc_length"] if abs(r.number("gap") - 1) > EVEN]
    studies = {r["study"] for r in gaps["parameter"]}
    bunched = {r["study"] for r in gaps["parameter"] if abs(r.number("gap") - 1) > EVEN}
    least = min(gaps["parameter"], key=lambda r: r.number("gap"))
    most = max(gaps["parameter"], key=lambda r: r.number("gap"))
    holds = not uneven and bunched == studies
    return Finding(
        id="inverse_arc_length_spacing", about="suite", suite="inverse_arc_length", claim="", holds=holds,
        headline="Points at equal steps of t are not evenly spaced, points at equal steps of the length are." if holds else
        "Points are not spaced as expected: even at equal steps of the length, and only there.",
        detail=(f"On {len(studies)} drawn curves, equal steps of t cover {general(least['gap'])} to {general(most['gap'])} times the "
                "mean step of the length.",),
        rows=(least, most, *uneven))


@finding(suite="companion_speed")
def inverse_arc_length_time(bundle):
    """Holds where one method certainly takes less time than every other that is right."""
    return fastest_right(bundle, "inverse_arc_length_time", "companion_speed-at_length", "Parameters at a length of cubics")


FILE = "projection.csv"
GOAL = 4  # units of 2^-52 times the largest coordinate


@dataclass(frozen=True)
class Method:
    """One method over the cells that it supports."""

    rows: tuple
    trials: float
    missed: float
    largest: float  # error of a distance, in units of 2^-52 times the largest coordinate

    @property
    def share(self):
        return self.missed / self.trials


def rows_of(bundle, *suites):
    """The rows of all methods that have numbers; Missing where there are none."""
    return bundle.judged(FILE).of_suite(*suites or ('projection',)).some(status="ok")


def of_rows(rows):
    """The Method of these rows. Raises Missing where there are none."""
    if not rows:
        raise Missing(f"`{FILE}` has no cells of the same degree for two methods that are compared")
    return Method(tuple(rows), sum(r.number("trials") for r in rows), sum(r.number("missed") for r in rows),
                  max(r.number("max_error_eps") for r in rows))


def by_method(bundle):
    """{method: Method}, ordered by missed foot points, then by error."""
    methods = {}
    for row in rows_of(bundle):
        methods.setdefault(row["method"], []).append(row)
    all_of = {m: of_rows(rows) for m, rows in methods.items()}
    return dict(sorted(all_of.items(), key=lambda item: (item[1].share, item[1].largest, item[0])))


@finding(suite="projection")
def projection_isolate(bundle):
    """Holds where `quintic_isolate` misses no foot point and no distance is off by more than the goal."""
    methods = by_method(bundle)
    isolate = methods.get("quintic_isolate")
    if isolate is None:
        raise Missing("a `projection-` study needs `quintic_isolate`")
    holds = isolate.missed == 0 and isolate.largest <= GOAL
    worst = max(isolate.rows, key=lambda r: (r["missed"], r["max_error_eps"]))
    unit = "2^-52 times the largest coordinate"
    lines = [f"`{m}`: {large(one.missed)} of {large(one.trials)} missed ({percent(one.share)}), largest error of the distance "
             f"{general(one.largest)} units." for m, one in methods.items() if m != "quintic_isolate"]
    return Finding(
        id="projection_isolate", about="suite", suite="projection", claim="", holds=holds,
        headline=f"Isolating the roots of (C - P)·C' and polishing them misses none of {large(isolate.trials)} foot points; the "
                 f"distance is at most {general(isolate.largest)} units of {unit} off." if holds else
        f"Isolating the roots of (C - P)·C' misses {large(isolate.missed)} of {large(isolate.trials)} foot points; the largest error "
        f"of the distance is {general(isolate.largest)} units of {unit}, the goal {GOAL}.",
        detail=tuple(lines), rows=(worst,))


MANY_MISSED = 0.1  # share of missed foot points that no choice of inputs explains


@finding(suite="projection")
def projection_printed(bundle):
    """Holds where the printed coefficients miss foot points that the right ones projection_printed."""
    methods = by_method(bundle)
    printed, right = methods.get("quintic_seed_002"), methods.get("quintic_companion")
    if printed is None or right is None:
        raise Missing("a `projection-` study needs `quintic_seed_002` beside `quintic_companion`")
    degrees = {r["degree"] for r in printed.rows}
    right = of_rows([r for r in right.rows if r["degree"] in degrees])  # the printed one is for cubics only
    holds = printed.share > MANY_MISSED and right.share < MANY_MISSED
    shares = f"{percent(printed.share)} of {large(printed.trials)}"
    return Finding(
        id="projection_printed", about="suite", suite="projection", claim="", holds=holds,
        headline=f"The quintic with the printed coefficients k2, k3 and k4 misses {shares} foot points, with the right ones and the "
                 f"same solver {percent(right.share)} of {large(right.trials)}." if holds else
        f"The quintic with the printed coefficients misses {shares} foot points, that with the right ones "
        f"{percent(right.share)}: these inputs do not tell them apart.",
        detail=("Printed: k2 = A·D + 6 B·C + 3 C·C, k3 = 3 B·D + 6 C·C + 3 C·D, k4 = 3 C·D + 3 D·D. Expanded: k2 = A·D + 9 B·C, "
                "k3 = 4 B·D + 6 C·C, k4 = 5 C·D.",),
        rows=(max(printed.rows, key=lambda r: r["missed"]), max(right.rows, key=lambda r: r["missed"])))


@finding(suite="companion_peers")
def projection_time(bundle):
    """Holds where the best of our methods takes less time than every other library."""
    return faster_than_peers(bundle, "projection_time", 'companion_peers', "companion_peers-projection_speed", "The nearest point of a cubic")


@finding(suite="companion_speed")
def projection_time_fastest(bundle):
    """Holds where one method certainly takes less time than every other that is right."""
    return fastest_right(bundle, "projection_time_fastest", "companion_speed-projection", "Foot points on cubics")


COUNTS = ("junctions_apart", "ends_moved", "points_off")


@finding(suite="subdivision")
def subdivision_halves(bundle):
    """Holds where every method shares the junction, keeps the ends and puts points of halves within the bounds."""
    rows = [r for r in bundle["subdivision.csv"].of_suite('subdivision').rows if any(r[c] is not None for c in COUNTS)]
    if not rows:
        raise Missing("`subdivision.csv` has no row of the suite `subdivision` that says whether halves fit together")
    broken = [r for r in rows if any(r[c] for c in COUNTS)]
    trials = large(sum(r.number("trials") for r in rows))
    asked = [r for r in rows if r["points_off"] is not None]
    return Finding(
        id="subdivision_halves", about="suite", suite="subdivision", claim="", holds=not broken,
        headline=f"In {trials} splits the halves share their junction and keep the ends of the curve to the last bit." if not broken
        else f"Halves do not fit together: {names(dict.fromkeys(r['method'] for r in broken))}.",
        detail=(f"{count(len({r['method'] for r in rows}), 'method')} split {large(len(rows))} cells. In {large(len(asked))} of them "
                f"a point of each half is held to the true point within the bounds of the control points: "
                f"{large(sum(r['points_off'] for r in asked))} of {large(sum(r.number('trials') for r in asked))} are off.",),
        rows=tuple(broken or rows[:1]))


@finding(suite="subdivision")
def subdivision_best(bundle):
    """Holds where the same method has the least mean error over u p~ at every degree."""
    table = bundle["subdivision.csv"].of_suite('subdivision')
    study = next((s for s in table.distinct("study") if len(table.distinct("degree", study=s)) > 1), None)
    if study is None:
        raise Missing("`subdivision.csv` has no study of the suite `subdivision` that varies the degree")
    size = min(table.distinct("coordinate_range", study=study), key=lambda value: abs(value - 1))
    methods = by_degree(table.select(study=study, coordinate_range=size))
    groups = {}
    for n, winners in best(methods).items():
        groups.setdefault(winners, []).append(n)
    top = max(n for rows in methods.values() for n in rows)
    last = sorted((rows[top]["mean_error_u"], m) for m, rows in methods.items() if top in rows)
    (least, winner), (most, loser) = last[0], last[-1]
    first = next(iter(groups))
    return Finding(
        id="subdivision_best", about="suite", suite="subdivision", claim="", holds=len(groups) == 1,
        headline=f"{names(first)} splits with the least mean error over u p~ at every degree." if len(groups) == 1 else
        "Which method splits with the least mean error over u p~ changes with the degree.",
        detail=("The least mean error has " + "; ".join(f"{names(w)} at {degrees(at)}" for w, at in groups.items())
                + f". At degree {top:g} `{winner}` has {general(least)} u p~ and `{loser}` {general(most)}, "
                  f"{factor(most / least)} times as much.",),
        rows=(methods[winner][top], methods[loser][top]))


@finding(suite="grid")
def grid_growth(bundle):
    """Holds where, at every degree, the least accurate method on the largest grid has a larger mean error over that of the best method
    there than on the smallest grid."""
    table = bundle["grid.csv"].of_suite('grid')
    study = next((s for s in table.distinct("study") if len(table.distinct("points", study=s)) > 1), None)
    if study is None:
        raise Missing("`grid.csv` has no study of the suite `grid` that varies the number of points")
    points = sorted(table.distinct("points", study=study))
    ends = _ends(table, study, points)
    if not ends:
        raise Missing("`grid.csv` has no two methods with errors on the same grids")
    losers = names(dict.fromkeys(worst for worst, _, _ in ends.values()))
    holds = all(few < many for _, few, many in ends.values())
    rows = tuple(table.select(study=study, degree=n, points=points[-1], method=ends[n][0])[0] for n in ends)
    return Finding(
        id="grid_growth", about="suite", suite="grid", claim="", holds=holds,
        headline=f"The more points a grid has, the more digits {losers} loses against the best method." if holds else
        f"{losers} does not lose more digits against the best method where a grid has more points.",
        detail=("Mean error over u p~, over that of the best method on the same grid: "
                + "; ".join(f"{factor(few)} times at degree {shortest(n)} with {large(points[0])} points and {factor(many)} times with "
                            f"{large(points[-1])}" for n, (_, few, many) in ends.items()) + f" (study `{study}`).",),
        rows=rows)


def _ends(table, study, points):
    """{degree: (the least accurate method on the largest grid, its ratio on the smallest grid, on the largest)}"""
    ends = {}
    for n in table.distinct("degree", study=study):
        smallest, largest = ({r["method"]: r for r in table.select(study=study, degree=n, points=p) if r["mean_error_u"]}
                             for p in (points[0], points[-1]))
        if len(largest) < 2:
            continue
        worst = max(largest.values(), key=lambda r: r["mean_error_u"])["method"]
        if worst in smallest:
            ends[n] = worst, _over_best(smallest, worst), _over_best(largest, worst)
    return ends


def _over_best(grid, method):
    return grid[method]["mean_error_u"] / min(r["mean_error_u"] for r in grid.values())


@finding(suite="bspline")
def bspline_recurrence(bundle):
    """Holds where no largest error of control points exceeds the proved bound of another method in the same cell."""
    rows = [r for r in bundle["bspline.csv"].of_suite('bspline').rows if r["max_control_error_u"] is not None]
    bounds, proved = {}, set()
    for r in rows:
        if r["control_bound_u"] is not None:
            key = _cell(r)
            bounds[key] = min(bounds.get(key, r["control_bound_u"]), r["control_bound_u"])
            proved.add(r["method"])
    judged = [r for r in rows if r["control_bound_u"] is None and bounds.get(_cell(r))]
    if not judged:
        raise Missing("`bspline.csv` has no Bernstein form without a proved bound beside one that has it")
    beyond = [r for r in judged if r["max_control_error_u"] > bounds[_cell(r)]]
    worst = max(judged, key=lambda r: r["max_control_error_u"])
    of_methods = names(dict.fromkeys(r["method"] for r in judged))
    return Finding(
        id="bspline_recurrence", about="suite", suite="bspline", claim="", holds=not beyond,
        headline=f"{of_methods}, of which nothing is proved, stays below the bound that is proved of {names(sorted(proved))}."
        if not beyond else f"{of_methods} loses digits: over {listing(dict.fromkeys(r['knots'] for r in beyond))} knots its control "
        f"points have errors above the bound that is proved of {names(sorted(proved))}.",
        detail=(f"The largest error of a control point is {general(worst['max_control_error_u'])} u p~, at degree "
                f"{shortest(worst['degree'])} over {worst['knots']} knots, where {general(bounds[_cell(worst)])} is proved of "
                f"{names(sorted(proved))}."
                + (f" The lowest degree with an error above such a bound is {shortest(min(r['degree'] for r in beyond))}."
                   if beyond else ""),),
        rows=(worst,))


def _cell(row):
    return tuple(row[c] for c in ("dimension", "degree", "coordinate_range", "t_min", "t_max", "generator", "knots"))
