# SPDX-License-Identifier: MIT
"""What the suites of times show of evaluators, and of other libraries."""

from collections import Counter

from ..answer import useful
from ..bundle import Missing
from ..document import Finding
from ..wording import count, factor, general, listing, percent, scientific, shortest, span
from .evaluators import by_degree, names
from .finding import finding

ON, OFF = "yes", "no"


def race_cell(rows, curve, mode="point", scalar="double"):
    """{degree: rows, fastest first} of one form, mode and scalar type, in the plane."""
    degrees = {}
    for row in rows:
        if (row["form"], row["mode"], row["scalar"], row["dimension"]) == (curve, mode, scalar, 2):
            degrees.setdefault(row["degree"], []).append(row)
    return {n: sorted(degrees[n], key=lambda r: r.number("ns")) for n in sorted(degrees)}


@finding(suite="speed")
def choosing(bundle):
    """Holds where at every degree at least half of the methods are never worth choosing."""
    table = bundle["pareto.csv"].of_suite("speed")
    degrees = race_cell(table.rows, "bernstein")
    if not degrees:
        raise Missing("`pareto.csv` has no Bézier curves in double, mode `point`")
    off = {n: [r for r in rows if r["pareto"] == OFF] for n, rows in degrees.items()}
    fewer = [f"{n:g}" for n, rows in degrees.items() if 2 * len(off[n]) < len(rows)]
    holds = not fewer
    top = max(degrees)
    front = [r for r in degrees[top] if r["pareto"] == ON and useful(r["observed_max_u"], r["scalar"])]
    steps = [f"`{r['method']}` ({general(r['ns'])} ns, at most {general(r['observed_max_u'])} u p~ seen)" for r in front]
    always = [m for m in dict.fromkeys(r["method"] for rows in degrees.values() for r in rows)
              if all(any(r["method"] == m and r["pareto"] == ON and useful(r["observed_max_u"], r["scalar"]) for r in rows) for rows in degrees.values())]
    return Finding(
        id="choosing", about="suite", suite="speed", claim="", holds=holds,
        headline=("At every degree at least half of the methods are beaten in both time and error by another: " if holds else
                  f"At degree {listing(fewer)} fewer than half of the methods are beaten in both time and error by another; ")
        + f"at degree {top:g} {len(off[top])} of {len(degrees[top])} are beaten, one point at a time.",
        detail=(f"Worth choosing at degree {top:g}, fastest first: {listing(steps)}.",
                f"Worth choosing at every degree: {names(always)}." if always else
                "No method is worth choosing at every degree."),
        rows=tuple(r for rows in degrees.values() for r in rows))


@finding(suite="roofline")
def roofline(bundle):
    """Holds where every row that has a goal meets it; the sentences name the worst row of each method."""
    rows = [r for r in bundle["roofline.csv"].rows if r["goal_met"] in ("yes", "no")]
    if not rows:
        raise Missing("no row of `roofline.csv` has a goal")
    missed = [r for r in rows if r["goal_met"] == "no"]
    nearest = {}
    for row in rows:
        key = (row["method"], row["target"])
        if key not in nearest or _margin(row) < _margin(nearest[key]):
            nearest[key] = row
    return Finding(
        id="roofline", about="suite", suite="roofline", claim="", holds=not missed,
        headline=f"The batch kernels reach every goal of this run, {len(rows)} in all." if not missed else
        f"The batch kernels reach {len(rows) - len(missed)} of {count(len(rows), 'goal')} of this run; not all of "
        f"{listing(f'`{m}`' for m in dict.fromkeys(r['method'] for r in missed))} do.",
        detail=tuple(_sentence(row) for row in nearest.values()), rows=tuple(missed or nearest.values()))


def _margin(row):
    """The factor by which a row is better than its goal; 1 just reaches it."""
    if row["goal_share"] is not None:
        return row.number("share_of_peak") / row.number("goal_share")
    return row.number("goal_ns") / row.number("median_ns")


def _sentence(row):
    where = f"`{row['method']}` on {row['target']}, at its worst (degree {row.number('degree'):g}, {row['scalar']})"
    if row["goal_share"] is not None:
        return f"{where}: {percent(row['share_of_peak'])} of the peak, asked for {percent(row['goal_share'])}."
    return f"{where}: {general(row['median_ns'])} ns, asked for at most {general(row['goal_ns'])} ns."


METHOD = "horner_bernstein_fma"
LEAST = 2  # times as long; no other difference between the two intervals of t has an effect of this size


@finding(suite="roofline")
def roofline_subnormal(bundle):
    """Holds where the same work takes LEAST times as long over the whole of [0, 1] as in the middle of it."""
    rows = bundle["roofline.csv"].select(method=METHOD, scalar="float", study=("roofline-bezier", "roofline-middle"))
    pairs = [(whole, middle) for whole in rows if whole["study"] == "roofline-bezier"
             for middle in rows if middle["study"] == "roofline-middle"
             and all(whole[column] == middle[column] for column in ("degree", "dimension", "target", "mode"))]
    if not pairs:
        raise Missing(f"no row of `{METHOD}` in float is in both `roofline-bezier` and `roofline-middle`")
    slowest = max(pairs, key=lambda pair: pair[0].number("median_ns") / pair[1].number("median_ns"))
    whole, middle = slowest
    times = whole.number("median_ns") / middle.number("median_ns")
    where = f"`{METHOD}` in float at degree {whole.number('degree'):g} on {whole['target']}"
    return Finding(
        id="roofline_subnormal", about="suite", suite="roofline", claim="", holds=times >= LEAST,
        headline=f"With t anywhere in [0, 1], {where} takes {general(times)} times as long as with t in the middle." if times >= LEAST
        else f"With t anywhere in [0, 1], {where} takes about as long as with t in the middle.",
        detail=(f"{general(whole['median_ns'])} ns per point for t drawn from [0, 1], {general(middle['median_ns'])} ns from "
                f"[{middle.number('t_min'):g}, {middle.number('t_max'):g}], with the same instructions. Powers of t near 0, and of "
                "1 - t near 1, are subnormal numbers in float at such degrees, "
                + ("and a processor that is slow with these waits with a whole vector for one of them. de Casteljau's algorithm forms "
                   "no powers." if times >= LEAST else f"which cost less than a factor of {LEAST} here."),),
        rows=slowest)


PEER = "peer_"


def _race(race, ours):
    """A sentence with the times of one race: `To 1e-3: a 500 ns, b 900 ns.`"""
    tolerance = race[ours]["tolerance"]
    times = ", ".join(f"`{m}` {general(row['median_ns'])} ns" for m, row in race.items() if m == ours or m.startswith(PEER))
    return (f"To {shortest(tolerance)}: " if tolerance is not None else "") + times + "."


def _ours(races):
    """Our own method that is right in most races and, of several, has the least median in most; None where there is
    none."""
    right, fastest = Counter(), Counter()
    for race in races:
        own = {m: row for m, row in race.items() if not m.startswith(PEER)}
        right.update({m: row["checked"] == "yes" for m, row in own.items()})
        fastest.update([min(own, key=lambda m, own=own: own[m].number("median_ns"))] if own else [])
    return max(right, key=lambda m: (right[m], fastest[m]), default=None)


def faster_than_peers(bundle, finding_id, suite, study, what):
    """A finding that holds where, in every race, our best method is right and its interval of times is below that of
    every other library."""
    rows = bundle["timing.csv"].some(study=study)
    races = {}
    for row in rows:
        races.setdefault(tuple(row[c] for c in ("dimension", "degree", "tolerance")), {})[row["method"]] = row
    ours = _ours(races.values())
    races = {asked: race for asked, race in races.items() if ours in race}
    duels = [(race[ours], rival) for race in races.values() for m, rival in race.items() if m.startswith(PEER)]
    if not duels:
        raise Missing(f"`{study}` needs a method of ours in a race with a method of another library")
    won = [(us, them) for us, them in duels if us.number("high_ns") < them.number("low_ns") and us["checked"] == "yes"]
    ratios = {}
    for us, them in duels:
        ratios.setdefault(them["method"], []).append(them.number("median_ns") / us.number("median_ns"))
    holds = len(won) == len(duels)
    wrong = list(dict.fromkeys(them["method"] for _, them in duels if them["checked"] != "yes"))
    lost = list(dict.fromkeys(them["method"] for us, them in duels if (us, them) not in won))
    return Finding(
        id=finding_id, about="suite", suite=suite, claim="", holds=holds,
        headline=f"{what} by `{ours}` takes less time than by any other library here: "
                 + listing(f"`{m}` takes {span(min(r), max(r), factor)} times as long" for m, r in ratios.items()) + "." if holds else
        f"{what} by `{ours}` does not take less time than by {listing(f'`{m}`' for m in lost)}.",
        detail=(*(_race(race, ours) for race in races.values()),
                f"Not every answer of {listing(f'`{m}`' for m in wrong)} is right." if wrong else ""),
        rows=tuple(dict.fromkeys(row for duel in duels for row in duel)))


ASKED = ("scalar", "dimension", "degree", "mode", "order", "tolerance", "points", "data", "coordinate_range", "t_min", "t_max",
         "generator")  # what the rows of one race have in common


def _races(rows):
    """[{method: row}] for the races in which the method that times are relative to took part."""
    races = {}
    for row in rows:
        races.setdefault(tuple(row[c] for c in ASKED), {})[row["method"]] = row
    return [race for race in races.values() if all(row["relative_to"] in race for row in race.values())]


def _ratio(row):
    """(low end, ratio, high end) of the time relative to the race's reference method."""
    if row["method"] == row["relative_to"]:
        return 1.0, 1.0, 1.0
    return row.number("ratio_low"), row.number("ratio"), row.number("ratio_high")


def _right(race):
    return [row for row in race.values() if row["checked"] == "yes"]


def _winner(races, study):
    """(method, wins): of the methods that are right in every race, the one that most often has the least ratio of the
    right ones."""
    always = [m for m in races[0] if all(m in race and race[m]["checked"] == "yes" for race in races)] if races else []
    if not always or not any(len(_right(race)) > 1 for race in races):
        raise Missing(f"`{study}` needs ratios of two methods that are right")
    wins = Counter(min(_right(race), key=lambda row: _ratio(row)[1])["method"] for race in races)
    best = max(always, key=lambda m: wins[m])
    return best, wins[best]


def _times(races, best):
    """Two sentences: the ratios of the right methods and those of the wrong ones, as in the bundle."""
    base = next(iter(races[0].values()))["relative_to"]
    right, wrong = {}, {}
    for race in races:
        for m, row in race.items():
            if m != base:
                (right if row["checked"] == "yes" else wrong).setdefault(m, []).append(_ratio(row)[1])
    of = "its own" if best == base else f"that of `{base}`"

    def words(ratios):
        return listing(f"`{m}` {span(min(r), max(r), factor)}" for m, r in ratios.items())
    return (f"Times of the others over {of}, in {count(len(races), 'race')}: {words(right)}." if best == base else
            f"Times over {of}, in {count(len(races), 'race')}: {words(right)}.",
            f"Where answers were not right: {words(wrong)}." if wrong else "")


def fastest_right(bundle, finding_id, study, answers, belongs=lambda row: True):
    """A finding that holds where one method is right in every race that `belongs` accepts, and every other right method
    certainly takes longer there: the intervals of their ratios, taken round by round, do not overlap."""
    races = _races(r for r in bundle["timing.csv"].some(study=study) if r["degree"] is not None and belongs(r))
    best, wins = _winner(races, study)
    duels = [(race[best], row) for race in races for row in _right(race) if row["method"] != best]
    beaten = [(own, row) for own, row in duels if _ratio(row)[0] > _ratio(own)[2]]
    holds = len(beaten) == len(duels)
    return Finding(
        id=finding_id, about="suite", suite="companion_speed", claim="", holds=holds,
        headline=f"{answers} come fastest by `{best}`, of the methods that are right." if holds else
        f"{answers} come certainly fastest by no one method: `{best}`, the fastest in {wins} of {count(len(races), 'race')}, is "
        f"certainly faster than {len(beaten)} of {count(len(duels), 'right rival')}.",
        detail=_times(races, best), rows=tuple(row for race in races for row in race.values()))


ALIKE = 10  # times the mean error of our own method


@finding(suite="peers")
def peers_accuracy(bundle):
    """Holds where most methods of other libraries have at most `ALIKE` times the mean error of de Casteljau's algorithm at every
    degree."""
    methods = by_degree(bundle.exact("peers").select(form="bernstein", scalar="double", dimension=2))
    ours = methods.get("de_casteljau")
    theirs = {m: rows for m, rows in methods.items() if m.startswith(PEER)}
    if not ours or not theirs:
        raise Missing("a `peers-` study needs `de_casteljau` beside a method of another library")
    ratio = {m: max((rows[n]["mean_error"] / ours[n].number("mean_error"), n) for n in rows if n in ours) for m, rows in theirs.items()}
    far = [m for m in ratio if ratio[m][0] > ALIKE]
    near = [m for m in ratio if m not in far]
    holds = len(near) > len(far)
    lines = [f"`{m}`: at most {factor(ratio[m][0])} times, at degree {shortest(ratio[m][1])}, where it has "
             f"{general(theirs[m][ratio[m][1]]['mean_error_u'])} u p~." for m in ratio]
    return Finding(
        id="peers_accuracy", about="suite", suite="peers", claim="", holds=holds,
        headline=f"{len(near)} of {len(ratio)} methods of other libraries have at most {ALIKE} times the mean error of de Casteljau's "
                 "algorithm at every degree"
                 + (f"; not {listing(f'`{m}`' for m in far)}." if far else ".") if holds else
        f"Most methods of other libraries exceed {ALIKE} times the mean error of de Casteljau's algorithm at some degree: "
        f"{listing(f'`{m}`' for m in far)}.",
        detail=tuple(lines), rows=tuple(theirs[m][n] for m, (_, n) in ratio.items()))


CACHED, DIRECT = "peer_occt_cached", "peer_occt_bsplclib"
LOSS = 1000  # three digits


@finding(suite="peers")
def peers_cache(bundle):
    """Holds where at the highest degree the cache errs more than a thousand times as much, on average."""
    methods = by_degree(bundle.exact("peers").select(form="bernstein", scalar="double", dimension=2, method=(CACHED, DIRECT)))
    common = sorted(set(methods.get(CACHED, {})) & set(methods.get(DIRECT, {})))
    if not common:
        raise Missing(f"no degree of a `peers-` study has both `{CACHED}` and `{DIRECT}`")
    rows = [(methods[CACHED][n], methods[DIRECT][n]) for n in common]
    ratios = [a.number("mean_error") / b.number("mean_error") for a, b in rows]
    cached, direct = rows[-1]
    top, holds = shortest(common[-1]), ratios[-1] > LOSS
    lines = [f"Degree {shortest(n)}: {factor(ratio)} times the mean error; {general(a['max_error_u'])} u p~ at worst through the "
             f"cache, {general(b['max_error_u'])} from the control points." for n, ratio, (a, b) in zip(common, ratios, rows)]
    return Finding(
        id="peers_cache", about="suite", suite="peers", claim="", holds=holds,
        headline=f"The power form that Open CASCADE's adaptor keeps costs digits as the degree grows: at degree {top} its mean error "
                 f"is {factor(ratios[-1])} times that of its own evaluation from the control points "
                 f"({scientific(cached.number('mean_error'))} against {scientific(direct.number('mean_error'))})." if holds else
        f"The power form that Open CASCADE's adaptor keeps errs {factor(ratios[-1])} times as much at degree {top} as its own "
        "evaluation from the control points: no more than three digits are lost.",
        detail=tuple(lines), rows=tuple(r for pair in rows for r in pair))
