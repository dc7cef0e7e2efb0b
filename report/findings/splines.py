# SPDX-License-Identifier: MIT
"""What the suites show of splines and fits."""

from ..bundle import Missing
from ..time_tables import fits_with_times
from ..wording import count, factor, general, large, listing, percent, scientific, shortest
from .finding import finding, how_many_methods, methods_of, trials_of, verdict


@finding("fitting")
def fitting_promise(bundle):
    """Holds where no data point was farther from a fitted curve than the tolerance or the claimed distance."""
    rows = bundle["fitting.csv"].of_suite("fitting").rows
    broken = [r for r in rows if r["broken_promises"] or r["understated"]]
    closest = max((r for r in rows if r["max_error_over_tolerance"] is not None), key=lambda r: r["max_error_over_tolerance"])
    return verdict(
        not broken, f"No data point is farther from a fitted curve than its tolerance, in {trials_of(rows)} fits.",
        f"Data lie farther from a curve than promised by {methods_of(broken)}.",
        f"{how_many_methods(rows)}, judged by exact distances to the whole curve; the largest is {general(closest['max_error_over_tolerance'])} of the "
        "tolerance.", rows=broken or [closest])


CUBICS = "fitting-cubics"
FITTER, OTHER_FITTER = "gauss_newton", "schneider"


@finding("fitting")
def fitting_source(bundle):
    """Holds where, at the smallest tolerance, the orthogonal distance fit takes one segment for most sampled cubics and Schneider's fit for few."""
    table = bundle["fitting.csv"]
    smallest = min(r.number("tolerance") for r in table.some(study=CUBICS, data="samples", degree=3))
    ours, theirs = (table.some(study=CUBICS, data="samples", degree=3, tolerance=smallest, method=method) for method in (FITTER, OTHER_FITTER))
    share, other = (sum(r.number("one_segment") for r in rows) / sum(r.number("trials") for r in rows) for rows in (ours, theirs))
    segments = [general(max(r.number("mean_segments") for r in rows)) for rows in (ours, theirs)]
    where = f"at a tolerance of {scientific(smallest)}"
    return verdict(
        share > 0.5 and other < 0.1,
        f"A fit by orthogonal distances returns {percent(share)} of sampled cubics as one segment {where}, Schneider's fit {percent(other)}.",
        f"A fit by orthogonal distances returns only {percent(share)} of sampled cubics as one segment {where}; Schneider's fit returns {percent(other)}.",
        f"Segments on average: {segments[0]} and {segments[1]}, for {large(ours[0].number('points'))} points. Schneider's directions at the ends are chords "
        "of the data, and no iteration corrects them.", rows=(*ours, *theirs))


@finding("companion_speed")
def fitting_time(bundle):
    """Holds where the orthogonal distance fit takes longer in every race, by the interval of the paired ratio."""
    pairs = fits_with_times(bundle)
    races = [(time.number("ratio"), time, fit) for time, fit in pairs
             if time["method"] == FITTER and time["relative_to"] == OTHER_FITTER and time["ratio"] is not None]
    if not races:
        raise Missing(f"`timing.csv` has no ratio of `{FITTER}` to `{OTHER_FITTER}`")

    def other(time):
        return next(fit for t, fit in pairs if t["method"] == OTHER_FITTER and all(t[c] == time[c] for c in ("data", "tolerance")))

    def words(ratio, time, fit):
        return (f"{factor(ratio)} times the time for {general(fit.number('mean_segments'))} segments instead of "
                f"{general(other(time).number('mean_segments'))} (`{time['data']}`, tolerance {shortest(time['tolerance'])})")
    slower = [race for race in races if race[1].number("ratio_low") > 1]
    low, high = min(races, key=lambda r: r[0]), max(races, key=lambda r: r[0])
    fewer = sum(fit.number("mean_segments") < other(time).number("mean_segments") for _, time, fit in races)
    return verdict(
        len(slower) == len(races), f"A fit by orthogonal distances takes {factor(low[0])} to {factor(high[0])} times as long as Schneider's fit.",
        f"A fit by orthogonal distances takes longer than Schneider's fit in only {len(slower)} of {count(len(races), 'race')}.",
        f"The smallest ratio is {words(*low)}, the largest {words(*high)}. The fit by orthogonal distances takes fewer segments in {fewer} of "
        f"{count(len(races), 'race')}, a race for each kind of data and tolerance.", rows=[row for _, time, fit in (low, high) for row in (time, fit, other(time))])


SPLINE, PLAIN = "c2_natural", "c2_natural_handles"
GOAL = 8  # units of u times the largest coordinate
RESIDUALS = ("max_data_u", "max_c0_u", "max_c1_u", "max_c2_u", "max_natural_u")


def largest_residual(row):
    """The largest residual of a row: of interpolation, C0, C1, C2 and natural ends."""
    return max(row.number(c) for c in RESIDUALS)


@finding("interpolation")
def interpolation_residuals(bundle):
    """Holds where the refined spline keeps the goal in every cell and breaks no bound."""
    table = bundle["interpolation.csv"].of_suite("interpolation")
    ours, plain = table.select(method=SPLINE), table.select(method=PLAIN)
    if not ours or not plain:
        raise Missing(f"a study of the suite `interpolation` requires `{SPLINE}` and `{PLAIN}`")
    worst, other = max(ours, key=largest_residual), max(plain, key=largest_residual)
    unit = f"{general(largest_residual(worst))} units of u times the largest coordinate"
    errors = [r["max_error_u"] for r in ours if r["max_error_u"] is not None]
    return verdict(
        largest_residual(worst) <= GOAL and not any(r["bound_violations"] for r in ours),
        f"C2 natural splines through {trials_of(ours)} sets of points miss no condition by more than {unit}; the goal is {GOAL}.",
        f"A C2 natural spline misses a condition by {unit}, the goal is {GOAL}, or breaks its bound.",
        f"Slopes are refined once and added to the points before they are rounded, so that every control point is the exact one rounded (largest error "
        f"{general(max(errors, default=0))} units). Elimination for the handles alone, `{PLAIN}`, misses a condition by {general(largest_residual(other))} "
        f"units ({shortest(other['points'])} points, `{other['generator']}`).", rows=(worst, other))


SPLINE_TIMES = "companion_speed-interpolation"
CLAIM = 1


@finding("companion_speed")
def interpolation_time(bundle):
    """Holds where the exponent of the number of points, with its interval, is that of linear time for every method."""
    rows = [r for r in bundle["complexity.csv"].select(study=SPLINE_TIMES) if r["first_points"] is not None]
    if not rows:
        raise Missing(f"`complexity.csv` has no `{SPLINE_TIMES}` row of at least three numbers of points")
    words = listing(f"N^{general(r.number('exponent'))} ({general(r.number('exponent_low'))} to {general(r.number('exponent_high'))}) for `{r['method']}`"
                    for r in rows)
    span = f"From {large(rows[0].number('first_points'))} to {large(rows[0].number('last_points'))} points"
    times = bundle["timing.csv"].select(study=SPLINE_TIMES, method=PLAIN, relative_to=SPLINE)
    ratios = [1 / r.number("ratio") for r in times]
    return verdict(
        all(r.number("claimed") == CLAIM and r["verdict"] == "within" for r in rows), f"{span}, splines take linear time.",
        f"{span}, it is not certain that splines take linear time.",
        f"The time of a spline through N points grows like {words}, with the 99 % interval of the exponent.",
        f"Refining slopes and adding them before rounding takes {factor(min(ratios))} to {factor(max(ratios))} times as long as elimination for the handles "
        "alone." if ratios else "", rows=(*rows, *times))
