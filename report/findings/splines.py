# SPDX-License-Identifier: MIT
"""What the suites show of splines and fits."""

from ..bundle import Missing
from ..document import Finding
from ..time_tables import fits_with_times
from ..wording import count, factor, general, large, listing, percent, scientific, shortest
from .evaluators import names
from .finding import finding

@finding(suite="fitting")
def fitting_promise(bundle):
    """Holds where no data point was farther from a fitted curve than asked for or than claimed."""
    rows = bundle["fitting.csv"].of_suite("fitting").rows
    broken = [r for r in rows if r["broken_promises"] or r["understated"]]
    trials = sum(r.number("trials") for r in rows)
    closest = max((r for r in rows if r["max_error_over_tolerance"] is not None), key=lambda r: r["max_error_over_tolerance"])
    return Finding(
        id="fitting_promise", about="suite", suite="fitting", claim="", holds=not broken,
        headline=f"No data point is farther from a fitted curve than asked for, in {large(trials)} fits." if not broken else
        f"Data lie farther from a curve than promised by {names(dict.fromkeys(r['method'] for r in broken))}.",
        detail=(f"{count(len({r['method'] for r in rows}), 'method')}, judged by exact distances to the whole curve; the largest is "
                f"{general(closest['max_error_over_tolerance'])} of the tolerance.",),
        rows=tuple(broken or [closest]))


CUBICS = "fitting-cubics"
FITTER, OTHER_FITTER = "gauss_newton", "schneider"


@finding(suite="fitting")
def fitting_source(bundle):
    """Holds where, at the smallest tolerance, the orthogonal distance fit needs one segment for most sampled cubics and
    Schneider's fit for few."""
    table = bundle["fitting.csv"]
    rows = table.some(study=CUBICS, data="samples", degree=3)
    smallest = min(r.number("tolerance") for r in rows)
    share, segments, used = {}, {}, []
    for method in (FITTER, OTHER_FITTER):
        chosen = table.some(study=CUBICS, data="samples", degree=3, tolerance=smallest, method=method)
        share[method] = sum(r.number("one_segment") for r in chosen) / sum(r.number("trials") for r in chosen)
        segments[method] = max(r.number("mean_segments") for r in chosen)
        used += chosen
    holds = share[FITTER] > 0.5 and share[OTHER_FITTER] < 0.1
    given = f"{percent(share[FITTER])} of sampled cubics"
    where = f"at a tolerance of {scientific(smallest)}"
    return Finding(
        id="fitting_source", about="suite", suite="fitting", claim="", holds=holds,
        headline=f"Orthogonal distances give {given} back as one segment {where}, Schneider's fit {percent(share[OTHER_FITTER])}." if holds else
        f"Orthogonal distances give only {given} back as one segment {where}; Schneider's fit gives {percent(share[OTHER_FITTER])}.",
        detail=(f"Segments on average: {general(segments[FITTER])} and {general(segments[OTHER_FITTER])}, for "
                f"{large(used[0].number('points'))} points. Schneider's directions at the ends are chords of the data, and no "
                "iteration corrects them.",),
        rows=tuple(used))


@finding(suite="companion_speed")
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
        return (f"{factor(ratio)} times the time for {general(fit.number('mean_segments'))} segments in place of "
                f"{general(other(time).number('mean_segments'))} (`{time['data']}`, tolerance {shortest(time['tolerance'])})")
    slower = [race for race in races if race[1].number("ratio_low") > 1]
    least, most = min(races, key=lambda r: r[0]), max(races, key=lambda r: r[0])
    holds = len(slower) == len(races)
    fewer = sum(fit.number("mean_segments") < other(time).number("mean_segments") for _, time, fit in races)
    return Finding(
        id="fitting_time", about="suite", suite="companion_speed", claim="", holds=holds,
        headline=f"To fit orthogonal distances takes {factor(least[0])} to {factor(most[0])} times as long as Schneider's fit."
        if holds else
        f"To fit orthogonal distances takes longer than Schneider's fit in only {len(slower)} of {count(len(races), 'race')}.",
        detail=(f"At the least {words(*least)}, at the most {words(*most)}. It needs fewer segments in {fewer} of "
                f"{count(len(races), 'race')}, a race for each kind of data and tolerance.",),
        rows=tuple(row for _, time, fit in (least, most) for row in (time, fit, other(time))))


SPLINE, PLAIN = "c2_natural", "c2_natural_handles"
GOAL = 8  # units of u times the largest coordinate
RESIDUALS = ("max_data_u", "max_c0_u", "max_c1_u", "max_c2_u", "max_natural_u")


def largest_residual(row):
    """The largest residual of a row: of interpolation, C0, C1, C2 and natural ends."""
    return max(row.number(c) for c in RESIDUALS)


@finding(suite="interpolation")
def interpolation_residuals(bundle):
    """Holds where the refined spline keeps the goal in every cell and breaks no bound."""
    table = bundle["interpolation.csv"].of_suite('interpolation')
    ours, plain = table.select(method=SPLINE), table.select(method=PLAIN)
    if not ours or not plain:
        raise Missing(f"a study of the suite `{'interpolation'}` needs `{SPLINE}` and `{PLAIN}`")
    worst, other = max(ours, key=largest_residual), max(plain, key=largest_residual)
    holds = largest_residual(worst) <= GOAL and not any(r["bound_violations"] for r in ours)
    sets = large(sum(r.number("trials") for r in ours))
    unit = "u times the largest coordinate"
    errors = [r["max_error_u"] for r in ours if r["max_error_u"] is not None]
    return Finding(
        id="interpolation_residuals", about="suite", suite="interpolation", claim="", holds=holds,
        headline=f"C2 natural splines through {sets} sets of points miss no condition by more than {general(largest_residual(worst))} "
                 f"units of {unit}; the goal is {GOAL}." if holds else
        f"A C2 natural spline misses a condition by {general(largest_residual(worst))} units of {unit}, the goal is {GOAL}, or breaks "
        "its bound.",
        detail=(f"Slopes are refined once and added to the points before they are rounded, so that every control point is the exact "
                f"one rounded (largest error {general(max(errors, default=0))} units). By elimination for the handles alone, "
                f"`{PLAIN}`, {general(largest_residual(other))} units are missed ({shortest(other['points'])} points, "
                f"`{other['generator']}`).",),
        rows=(worst, other))


SPLINE_TIMES = "companion_speed-interpolation"
CLAIM = 1


@finding(suite="companion_speed")
def interpolation_time(bundle):
    """Holds where the exponent of the number of points, with its interval, is that of linear time for every method."""
    rows = [r for r in bundle["complexity.csv"].select(study=SPLINE_TIMES) if r["first_points"] is not None]
    if not rows:
        raise Missing(f"`complexity.csv` has no `{SPLINE_TIMES}` row of at least three numbers of points")
    holds = all(r.number("claimed") == CLAIM and r["verdict"] == "within" for r in rows)
    words = listing(f"N^{general(r.number('exponent'))} ({general(r.number('exponent_low'))} to {general(r.number('exponent_high'))}) "
                    f"for `{r['method']}`" for r in rows)
    span = f"From {large(rows[0].number('first_points'))} to {large(rows[0].number('last_points'))} points"
    times = bundle["timing.csv"].select(study=SPLINE_TIMES, method=PLAIN, relative_to=SPLINE)
    ratios = [1 / r.number("ratio") for r in times]
    return Finding(
        id="interpolation_time", about="suite", suite="companion_speed", claim="", holds=holds,
        headline=f"{span}, splines take linear time." if holds else
        f"{span}, it is not certain that splines take linear time.",
        detail=(f"The time of a spline through N points grows like {words}, with the 99 % interval of the exponent.",
                f"To refine slopes and add them before they are rounded costs {factor(min(ratios))} to {factor(max(ratios))} times the "
                "time of elimination for the handles alone." if ratios else ""),
        rows=(*rows, *times))
