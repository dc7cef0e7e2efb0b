# SPDX-License-Identifier: MIT
"""What the suites of times show of evaluators, and of other libraries."""

from collections import Counter

from ..answer import useful
from ..bundle import Missing
from ..rows import distinct, grouped
from ..wording import count, factor, general, listing, scientific, shortest, span
from .evaluators import by_degree
from .finding import finding, methods_of, names, verdict

ON, OFF = "yes", "no"


def race_cell(rows, curve, mode="point", scalar="double"):
    """{degree: rows, fastest first} of one form, mode and scalar type, in the plane."""
    degrees = grouped((r for r in rows if (r["form"], r["mode"], r["scalar"], r["dimension"]) == (curve, mode, scalar, 2)), "degree")
    return {n: sorted(degrees[n], key=lambda r: r.number("ns")) for n in sorted(degrees)}


@finding("speed")
def choosing(bundle):
    """Holds where at every degree at least half of the methods are dominated."""
    degrees = race_cell(bundle["pareto.csv"].of_suite("speed").rows, "bernstein")
    if not degrees:
        raise Missing("`pareto.csv` has no Bézier curves in double, mode `point`")
    off = {n: [r for r in rows if r["pareto"] == OFF] for n, rows in degrees.items()}
    front = {n: [r for r in rows if r["pareto"] == ON and useful(r["observed_max_u"], r["scalar"])] for n, rows in degrees.items()}
    fewer = [f"{n:g}" for n, rows in degrees.items() if 2 * len(off[n]) < len(rows)]
    top = max(degrees)
    steps = [f"`{r['method']}` ({general(r['ns'])} ns, observed errors of at most {general(r['observed_max_u'])} u p~)" for r in front[top]]
    always = [m for m in distinct((r for rows in front.values() for r in rows), "method") if all(m in distinct(rows, "method") for rows in front.values())]
    there = f"at degree {top:g}, {len(off[top])} of {len(degrees[top])} are, one point at a time"
    return verdict(
        not fewer, f"At every degree at least half of the methods are dominated in both time and error: {there}.",
        f"At degree {listing(fewer)} fewer than half of the methods are dominated in both time and error; {there}.",
        f"Not dominated at degree {top:g}, fastest first: {listing(steps)}.",
        f"Not dominated at any degree: {names(always)}." if always else "Every method is dominated at some degree.",
        rows=[r for rows in degrees.values() for r in rows])


PEER = "peer_"


def _ours(races):
    """Our own method that is correct in most races and, of several, has the smallest median in most; None where there is none."""
    correct, fastest = Counter(), Counter()
    for race in races:
        own = {m: row for m, row in race.items() if not m.startswith(PEER)}
        correct.update({m: row["checked"] == "yes" for m, row in own.items()})
        fastest.update([min(own, key=lambda m, own=own: own[m].number("median_ns"))] if own else [])
    return max(correct, key=lambda m: (correct[m], fastest[m]), default=None)


def faster_than_peers(bundle, study, what):
    """Holds where, in every race, our best method is correct and its interval of times is below that of every other library."""
    races = [{r["method"]: r for r in rows} for rows in grouped(bundle["timing.csv"].some(study=study), "dimension", "degree", "tolerance").values()]
    ours = _ours(races)
    races = [race for race in races if ours in race]
    duels = [(race[ours], rival) for race in races for m, rival in race.items() if m.startswith(PEER)]
    if not duels:
        raise Missing(f"`{study}` requires a method of ours in a race with a method of another library")
    lost = [them for us, them in duels if not us.number("high_ns") < them.number("low_ns") or us["checked"] != "yes"]
    ratios = {}
    for us, them in duels:
        ratios.setdefault(them["method"], []).append(them.number("median_ns") / us.number("median_ns"))

    def words(race):
        tolerance = race[ours]["tolerance"]
        return ("" if tolerance is None else f"To {shortest(tolerance)}: ") + ", ".join(
            f"`{m}` {general(row['median_ns'])} ns" for m, row in race.items() if m == ours or m.startswith(PEER)) + "."
    wrong = [them for _, them in duels if them["checked"] != "yes"]
    return verdict(
        not lost, f"`{ours}` computes {what} in less time than any other library here: "
        + listing(f"`{m}` takes {span(min(r), max(r), factor)} times as long" for m, r in ratios.items()) + ".",
        f"`{ours}` does not compute {what} in less time than {methods_of(lost)}.", *map(words, races),
        f"Not every answer of {methods_of(wrong)} is correct." if wrong else "", rows=dict.fromkeys(row for duel in duels for row in duel))


RACE = ("scalar", "dimension", "degree", "mode", "order", "tolerance", "points", "data", "coordinate_range", "t_min", "t_max", "generator")


def _ratio(row):
    """(low end, ratio, high end) of the time relative to the race's reference method."""
    return (1.0, 1.0, 1.0) if row["method"] == row["relative_to"] else tuple(row.number(c) for c in ("ratio_low", "ratio", "ratio_high"))


def fastest_correct(bundle, study, answers, belongs=lambda row: True):
    """Holds where one method is correct in every race that `belongs` accepts, and every other correct method certainly takes longer there: the
    intervals of their ratios, taken round by round, do not overlap."""
    rows = [r for r in bundle["timing.csv"].some(study=study) if r["degree"] is not None and belongs(r)]
    races = [race for own in grouped(rows, *RACE).values() for race in [{r["method"]: r for r in own}] if all(r["relative_to"] in race for r in own)]
    correct = [[row for row in race.values() if row["checked"] == "yes"] for race in races]
    always = [m for m in races[0] if all(m in distinct(own, "method") for own in correct)] if races else []
    if not always or max(map(len, correct)) < 2:
        raise Missing(f"`{study}` requires ratios of two methods that are correct")
    wins = Counter(min(own, key=lambda row: _ratio(row)[1])["method"] for own in correct)
    fastest = max(always, key=lambda m: wins[m])
    duels = [(race[fastest], row) for race, own in zip(races, correct) for row in own if row["method"] != fastest]
    slower = [row for own, row in duels if _ratio(row)[0] > _ratio(own)[2]]
    base = next(iter(races[0].values()))["relative_to"]

    def ratios(checked):
        found = {}
        for row in (r for race in races for r in race.values() if r["method"] != base and (r["checked"] == "yes") == checked):
            found.setdefault(row["method"], []).append(_ratio(row)[1])
        return listing(f"`{m}` {span(min(r), max(r), factor)}" for m, r in found.items())
    return verdict(
        len(slower) == len(duels), f"`{fastest}` is the fastest of the correct methods for {answers}.",
        f"No method is certainly the fastest for {answers}: `{fastest}`, the fastest in {wins[fastest]} of {count(len(races), 'race')}, is certainly "
        f"faster than {len(slower)} of {count(len(duels), 'correct rival')}.",
        f"Times over {'its own' if fastest == base else f'that of `{base}`'}, in {count(len(races), 'race')}: {ratios(True)}.",
        f"Where answers were not correct: {ratios(False)}." if ratios(False) else "", rows=[row for race in races for row in race.values()])


ALIKE = 10  # times the mean error of our own method


@finding("peers")
def peers_accuracy(bundle):
    """Holds where most methods of other libraries have at most `ALIKE` times the mean error of de Casteljau's algorithm at every degree."""
    methods = by_degree(bundle.exact("peers").select(form="bernstein", scalar="double", dimension=2))
    ours = methods.get("de_casteljau")
    theirs = {m: rows for m, rows in methods.items() if m.startswith(PEER)}
    if not ours or not theirs:
        raise Missing("a `peers-` study requires `de_casteljau` and a method of another library")
    ratio = {m: max((rows[n]["mean_error"] / ours[n].number("mean_error"), n) for n in rows if n in ours) for m, rows in theirs.items()}
    far = [m for m in ratio if ratio[m][0] > ALIKE]
    return verdict(
        len(ratio) > 2 * len(far), f"{len(ratio) - len(far)} of {len(ratio)} methods of other libraries have at most {ALIKE} times the mean error of de "
        f"Casteljau's algorithm at every degree{f'; the exceptions are {names(far)}' if far else ''}.",
        f"Most methods of other libraries exceed {ALIKE} times the mean error of de Casteljau's algorithm at some degree: {names(far)}.",
        *(f"`{m}`: at most {factor(most)} times, at degree {shortest(n)}, where it has {general(theirs[m][n]['mean_error_u'])} u p~."
          for m, (most, n) in ratio.items()), rows=[theirs[m][n] for m, (_, n) in ratio.items()])


CACHED, DIRECT = "peer_occt_cached", "peer_occt_bsplclib"
LOSS = 1000  # three digits


@finding("peers")
def peers_cache(bundle):
    """Holds where at the highest degree the cache errs more than a thousand times as much, on average."""
    methods = by_degree(bundle.exact("peers").select(form="bernstein", scalar="double", dimension=2, method=(CACHED, DIRECT)))
    common = sorted(set(methods.get(CACHED, {})) & set(methods.get(DIRECT, {})))
    if not common:
        raise Missing(f"no degree of a `peers-` study has both `{CACHED}` and `{DIRECT}`")
    pairs = [(methods[CACHED][n], methods[DIRECT][n]) for n in common]
    ratios = [a.number("mean_error") / b.number("mean_error") for a, b in pairs]
    (cached, direct), top = pairs[-1], shortest(common[-1])
    return verdict(
        ratios[-1] > LOSS, "The power form that Open CASCADE's adaptor keeps loses digits as the degree grows: at degree "
        f"{top} its mean error is {factor(ratios[-1])} times that of its own evaluation from the control points ({scientific(cached['mean_error'])} against "
        f"{scientific(direct['mean_error'])}).",
        f"The power form that Open CASCADE's adaptor keeps errs {factor(ratios[-1])} times as much at degree {top} as its own evaluation from the control "
        "points: at most three digits are lost.",
        *(f"Degree {shortest(n)}: {factor(ratio)} times the mean error; {general(a['max_error_u'])} u p~ at worst through the cache, "
          f"{general(b['max_error_u'])} from the control points." for n, ratio, (a, b) in zip(common, ratios, pairs)), rows=[r for pair in pairs for r in pair])
