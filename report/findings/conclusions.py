# SPDX-License-Identifier: MIT
"""Conclusions of the source report, held against the bundle."""

from itertools import count as natural
import math
import sys

from ..bundle import Missing
from ..document import Finding
from ..methods import FORM, IN_STUDIES, name, yardstick
from ..wording import count, factor, general, interval, large, listing, percent, scientific, shortest, span
from .finding import finding
from .printed_tables import EXPONENTIAL, FLAT, accuracy_cells, against_exact, degrees, per_degree, series

def in_part(row):
    """Whether the bounds cover only a part of the trials: the largest error exceeds all bounds, but no trial violates
    its own."""
    return bool(row["bound_u"]) and not row["bound_violations"] and (row["max_error_u"] or 0) > row["bound_u"]


@finding(suite=None)
def bounds_hold(bundle):
    """Holds where no trial of any method exceeds its proved bound."""
    rows = [r for r in bundle.judged().some(baseline="exact") if r["bound_u"] and r["status"] == "ok"]
    if not rows:
        raise Missing("`accuracy.csv` has no row with a bound")
    broken = [r for r in rows if r["bound_violations"]]
    trials = sum(r.number("trials") for r in rows)
    partly = [r for r in rows if in_part(r)]
    closest = max((r for r in rows if not in_part(r)), key=lambda r: (r["max_error_u"] or 0) / r["bound_u"], default=None)
    if closest is None:
        raise Missing("`accuracy.csv` has no row whose bound covers its largest error")
    used = (closest["max_error_u"] or 0) / closest["bound_u"]
    studies = dict.fromkeys(f"`{r['study']}`" for r in partly)
    methods = listing(dict.fromkeys(f"`{r['method']}`" for r in broken))
    return Finding(
        id="bounds_hold", about="reproduction" if bundle.has_suite("report") else "note", claim="", holds=not broken,
        headline=f"No proved error bound is exceeded in {large(trials)} judged evaluations." if not broken else
        f"A proved error bound is exceeded by {methods}: a bound or its condition is wrong.",
        detail=(f"{count(len(rows), 'cell')} of {count(len({r['method'] for r in rows}), 'method')} carry a bound. The closest "
                f"that an observed error comes to its bound is {general(used, 2)} of it (`{closest['method']}`, degree "
                f"{closest['degree']:g}).",
                f"In {count(len(partly), 'cell')} of {listing(studies)} some trials lie outside what is proved, and the "
                "largest error is one of theirs." if partly else ""),
        rows=tuple(broken or [closest, *partly]))


@finding()
def yardstick_ranking(bundle):
    """Holds where de Casteljau has the smaller mean error at most of the printed degrees."""
    pairs = [(n, *(against_exact(bundle, m, n) for m in ("de_casteljau", "direct"))) for n in degrees(bundle)]
    wins = [n for n, a, b in pairs if a.number("mean_error") < b.number("mean_error")]
    top, casteljau, direct = pairs[-1]
    ratio = direct.number("mean_error") / casteljau.number("mean_error")
    holds = 2 * len(wins) > len(pairs)
    worst = [r.number("max_error_u") for r in (casteljau, direct)]
    return Finding(
        id="yardstick_ranking", about="correction",
        claim="For Bézier curves direct evaluation is the most accurate, and de Casteljau comes second.",
        place="section 3.2, paragraph 1",
        holds=holds,
        headline=(f"Against the exact value de Casteljau is more accurate on average than direct evaluation at {len(wins)} of "
                  f"{count(len(pairs), 'degree')}" + (": the yardstick inverts the ranking." if holds else
                                                      ": the report's ranking stands.")),
        detail=(f"At degree {top:g}, over {large(direct['trials'])} trials, the mean errors are {scientific(casteljau['mean_error'])} (de Casteljau) and "
                f"{scientific(direct['mean_error'])} (direct), a ratio of {general(ratio)}; the largest are {general(worst[0])} "
                f"and {general(worst[1])} times u p~. The report could not see this: it had set the error of direct evaluation "
                "to zero.",
                *((f"De Casteljau is ahead at degree {listing(f'{n:g}' for n in wins)}.",) if 0 < len(wins) < len(pairs)
                  else ())),
        rows=tuple(r for _, a, b in pairs for r in (a, b)))


@finding()
def common_rounding(bundle):
    """Holds where both methods are farther from the truth than from each other, and gain where 1-t is exact."""
    n = degrees(bundle)[-1]
    pair = dict(study="2.3.1-bezier", generator="continuous", degree=n)
    apart = bundle.accuracy(method="de_casteljau", baseline="direct", **pair)
    truth = {m: against_exact(bundle, m, n) for m in ("direct", "de_casteljau")}
    dyadic = {m: bundle.accuracy(study="truth-bezier", method=m, degree=n, baseline="exact", generator="dyadic") for m in truth}
    gap = apart.number("mean_error")
    error = {m: row.number("mean_error") for m, row in truth.items()}
    after = {m: row.number("mean_error") for m, row in dyadic.items()}
    hidden = gap < min(error.values())
    gains = all(after[m] < error[m] for m in truth)
    numbers = (f"At degree {n:g}, de Casteljau and direct evaluation lie {scientific(gap)} apart on average; from the exact "
               f"value de Casteljau is {scientific(error['de_casteljau'])} away and direct {scientific(error['direct'])}.")
    shift = (f"Where t is a multiple of the unit roundoff, so that 1-t is exact, de Casteljau goes from "
             f"{scientific(error['de_casteljau'])} to {scientific(after['de_casteljau'])} and direct from "
             f"{scientific(error['direct'])} to {scientific(after['direct'])}")
    return Finding(
        id="common_rounding", about="correction", claim="Evaluation by the definition is taken to be completely accurate.",
        place="section 2.3, paragraph 2",
        holds=hidden and gains,
        headline="The report's yardstick hides an error that it shares with de Casteljau: the rounding of 1-t."
        if hidden and gains else "No error shared with the report's yardstick shows in this bundle.",
        detail=(numbers + (" What both have in common cancels in their distance." if hidden else
                           " Their distance does not understate the error."),
                shift + (": that rounding is a large part of the error of both." if gains else
                         ": the rounding of 1-t is not what both have in common.")),
        rows=(apart, *truth.values(), *dyadic.values()))


@finding()
def forward_substitution(bundle):
    """Holds where the error grows exponentially with forward substitution and does not with the positive sum."""
    low, *_, high = degrees(bundle)
    rows = {c: [bundle.accuracy(study="truth-polynomial", method=f"{c}:de_casteljau", degree=n, baseline="exact",
                                generator="continuous") for n in (low, high)]
            for c in ("forward_substitution", "positive_sum")}
    error = {c: [r.number("mean_error") for r in pair] for c, pair in rows.items()}
    growth = {c: per_degree(*pair, low, high) for c, pair in error.items()}
    holds = growth["positive_sum"] < EXPONENTIAL <= growth["forward_substitution"]
    solve, positive = error["forward_substitution"], error["positive_sum"]
    ratio = solve[1] / positive[1]
    decades = math.log10(ratio)
    return Finding(
        id="forward_substitution", about="correction",
        claim="On polynomial curves the errors grow exponentially with the degree; where it is large, they come mainly from the "
              "conversion to Bernstein form.", place="section 2.3.1, after the second table",
        holds=holds,
        headline="The exponential error of power form to Bernstein form is the report's forward substitution, not the "
                 "conversion: with the positive sum it vanishes." if holds else
                 "Replacing forward substitution by the positive sum does not remove an exponential error in this bundle.",
        detail=(f"At degree {high:g} the mean error against the exact value is {scientific(solve[1])} with "
                f"`forward_substitution` and {scientific(positive[1])} with `positive_sum`, both followed by de Casteljau: "
                f"a ratio of {factor(ratio)}, {general(decades, 2)} decades.",
                f"From degree {low:g} to {high:g} the error is multiplied by {general(growth['forward_substitution'])} per "
                f"degree with the one and by {general(growth['positive_sum'])} with the other."),
        rows=tuple(r for pair in rows.values() for r in pair))


METHOD = "factorial:power_sum"


def _spread(values):
    return max(values) / min(values)


@finding()
def range_bend(bundle):
    """Holds where the error grows with the range, as printed and ours: in proportion with continuous inputs, with a bend on the report's
    grid."""
    rows = series(bundle, "coordinate_range", table="2.3.2", form="bernstein", method=METHOD, statistic="mean_error")
    over_range = {c: [r.number(c) / r.number("coordinate_range") for r in rows]
                  for c in ("published", "ours_median", "continuous_median")}
    in_u = {}
    used = []
    for generator in ("report", "continuous"):
        found = [bundle.accuracy(study="2.3.2-bezier", method=METHOD, baseline="direct", generator=generator, degree=r["degree"],
                                 coordinate_range=r["coordinate_range"]) for r in rows]
        used += found
        in_u[generator] = [r.number("mean_error_u") for r in found]
    spread = {c: _spread(v) for c, v in over_range.items()}
    grows = all(a.number(c) < b.number(c) for a, b in zip(rows, rows[1:]) for c in over_range)
    holds = grows and spread["continuous_median"] <= FLAT < spread["ours_median"]
    first, last = rows[0]["coordinate_range"], rows[-1]["coordinate_range"]
    ours, published, continuous = (over_range[c] for c in ("ours_median", "published", "continuous_median"))
    printed = (f"Via power form, mean error over range falls from {scientific(published[0])} at R = {shortest(first)} to "
               f"{scientific(published[-1])} at R = {shortest(last)} in print, and from {scientific(ours[0])} to "
               f"{scientific(ours[-1])} with the report's generator; with continuous inputs it stays at "
               f"{span(min(continuous), max(continuous), scientific)}.")
    units = (f"Over u p~ the mean error varies by a factor of {general(_spread(in_u['report']))} with the report's grid and "
             f"{general(_spread(in_u['continuous']))} with continuous inputs.")
    return Finding(
        id="range_bend", about="conclusion", claim="As the range of the coordinates grows, the error grows.",
        place="section 2.3.2, after each table", holds=holds,
        headline="The error grows with the range, with continuous inputs in proportion to it; the bend of the printed errors is the "
                 "random grid." if holds else
                 "The random grid does not explain the error over the range in this bundle: "
                 f"error over range varies by a factor of {general(spread['ours_median'])} with the grid and "
                 f"{general(spread['continuous_median'])} with continuous inputs.",
        detail=(printed, units, *_conversion(bundle, rows)), rows=tuple(rows + used))


def _conversion(bundle, rows):
    """Yields the conversion's part of the error on the grid at both ends of the range; nothing where no error was split
    into parts."""
    shares = []
    for row in (rows[0], rows[-1]):
        parts = bundle.judged().select(study="2.3.2-bezier", method=METHOD, baseline="exact", generator="report", scalar="double",
                                       dimension=2, degree=row["degree"], coordinate_range=row["coordinate_range"])
        if len(parts) != 1 or parts[0]["mean_conversion_error"] is None:
            return
        shares.append((row, parts[0].number("mean_conversion_error"), parts[0].number("mean_evaluation_error")))
    (first, *before), (last, *after) = shares
    yield (f"On the grid the conversion makes a mean error of {scientific(before[0])} and the evaluation one of {scientific(before[1])} at "
           f"R = {shortest(first['coordinate_range'])}; at R = {shortest(last['coordinate_range'])} they make {scientific(after[0])} and "
           f"{scientific(after[1])}.")


def _against_truth(bundle, printed):
    """The rows at the printed degrees, in the same order."""
    rows = [against_exact(bundle, "de_casteljau", row["degree"]) for row in printed]
    sizes = {row["coordinate_range"] for row in (*rows, *printed)}
    if len(sizes) > 1:
        raise Missing("`accuracy.csv` has the degrees that are printed for another coordinate range")
    return rows


@finding()
def de_casteljau_flat(bundle):
    """Holds where the error against the exact value, in coordinate units, clearly varies with the degree or with t,
    over the degrees and the range that are printed."""
    printed = series(bundle, "degree", table="2.3.1", form="bernstein", method="de_casteljau", statistic="mean_error")
    truth = _against_truth(bundle, printed)
    by_t = bundle.judged().some(scalar="double", dimension=2, study="2.3.3-bezier", method="de_casteljau", baseline="exact",
                                generator="continuous")
    errors = [r.number("mean_error") for r in truth]
    growth = max(errors) / min(errors)
    least, most = (f(by_t, key=lambda r: r.number("mean_error")) for f in (min, max))
    ratio = most.number("mean_error") / least.number("mean_error")
    seen = [r.number("published") for r in printed]
    first, last = (shortest(r["degree"]) for r in (truth[0], truth[-1]))
    holds = growth > FLAT or ratio > FLAT
    return Finding(
        id="de_casteljau_flat", about="correction",
        claim="The error of de Casteljau hardly changes with the degree and has little to do with t.",
        place="sections 2.3.1 and 2.3.3, after the first table of each", holds=holds,
        headline="Against the exact value de Casteljau's error does depend on the degree and on t."
        if growth > FLAT and ratio > FLAT else
        f"Against the exact value de Casteljau's error depends on {'the degree' if growth > FLAT else 't'}." if holds else
        "Against the exact value, too, de Casteljau's error hardly depends on the degree or on t.",
        detail=(f"From degree {first} to {last} its mean error goes from {scientific(errors[0])} to {scientific(errors[-1])} against the "
                f"exact value, and its extremes are a factor of {general(growth)} apart; the printed ones go from {scientific(seen[0])} to "
                f"{scientific(seen[-1])}, extremes a factor of {general(max(seen) / min(seen))} apart.",
                f"Between intervals of t the mean error goes from {scientific(least['mean_error'])} on "
                f"{interval(least['t_min'], least['t_max'])} to {scientific(most['mean_error'])} on "
                f"{interval(most['t_min'], most['t_max'])}, a factor of {general(ratio)}."),
        rows=(*truth, *by_t, *printed))


@finding()
def factorial_overflow(bundle):
    """Holds where every method with factorials reaches the last degree whose factorial is a double and no further, and is finite at the
    degrees of the bundle up to there."""
    printed = degrees(bundle)[-1]
    methods = bundle["methods.csv"]
    used = [m for m in bundle.judged().distinct("method", study="truth-bezier")
            if m == "direct" or m.startswith("factorial:")]
    limits = [r for r in methods.some(id=[*used, "factorial"]) if r["max_degree"] is not None]
    overflow = next(n for n in natural(1) if math.factorial(n) > sys.float_info.max)
    rows = [r for r in bundle.judged().some(study="truth-bezier", method=used) if printed < r["degree"] < overflow]
    past = sorted({r["degree"] for r in rows})
    good = [r for r in rows if r["status"] == "ok" and r["non_finite"] == 0
            and r["mean_error"] is not None and math.isfinite(r["mean_error"])]
    reach = {r.number("max_degree") for r in limits}
    holds = bool(rows) and len(good) == len(rows) and reach == {overflow - 1}
    tried = f"at degree {listing(f'{n:g}' for n in past)}" if past else "past the printed degrees"
    finite = f"{len(good)} of {count(len(rows), 'cell')} with factorials {tried} are finite"
    limited = [f"`{r['id']}`" for r in limits]
    stated = (f"the methods that form factorials ({listing(limited)}) are stated to reach degree "
              f"{listing(f'{n:g}' for n in sorted(reach))}")
    return Finding(
        id="factorial_overflow", about="conclusion",
        claim="As the degree rises further, factorials overflow in floating point, and the conversion fails.",
        place="section 2.2, paragraph 3; section 3.2, paragraph 3", holds=holds,
        headline=f"Factorials overflow in double from degree {overflow} on; up to there the conversion does not fail: {finite}." if holds
        else f"Factorials overflow in double from degree {overflow} on, but {finite}, and {stated}.",
        detail=(f"{overflow}! is the first factorial that no double holds; {stated}." if holds else "",),
        rows=tuple(rows) + tuple(limits))


@finding()
def via_power_worse(bundle):
    """Holds where de Casteljau errs less in every printed cell, against the yardstick and against the exact value."""
    cells = {}
    for row in accuracy_cells(bundle):
        if row["form"] == "bernstein":
            key = tuple(row[c] for c in ("statistic", "degree", "coordinate_range", "t_min", "t_max"))
            cells.setdefault(key, {})[row["method"]] = row
    pairs = [(c["de_casteljau"], c["factorial:power_sum"]) for c in cells.values()
             if {"de_casteljau", "factorial:power_sum"} <= set(c)]
    if not pairs:
        raise Missing("`scorecard.csv` has no cell with both de Casteljau and the power form")
    wins = {c: sum(a.number(c) < b.number(c) for a, b in pairs)
            for c in ("published", "ours_median", "continuous_median", "against_exact")}
    ratios = [b.number("against_exact") / a.number("against_exact") for a, b in pairs]
    n = len(pairs)
    holds = all(w == n for w in wins.values())
    return Finding(
        id="via_power_worse", about="conclusion",
        claim="For Bézier curves de Casteljau is always more accurate than conversion to power form.",
        place="sections 2.3.2 and 2.3.3, after the first table of each", holds=holds,
        headline=f"De Casteljau is more accurate than the power form in all {n} pairs of cells, whatever it is held against."
        if holds else f"De Casteljau is not more accurate than the power form in all {n} pairs of cells.",
        detail=(f"It wins in {wins['published']} as printed, {wins['ours_median']} in our repetition, "
                f"{wins['continuous_median']} with continuous inputs and {wins['against_exact']} against the exact value, "
                f"where the power form's error is {span(min(ratios), max(ratios), factor)} times as large.",),
        rows=tuple(r for pair in pairs for r in pair))


@finding()
def growth_with_degree(bundle):
    """Holds where the mean error against the exact value grows exponentially through the power form."""
    rows = series(bundle, "degree", table="2.3.1", form="bernstein", method="factorial:power_sum", statistic="mean_error")
    low, high = rows[0].number("degree"), rows[-1].number("degree")
    growth = {c: per_degree(rows[0].number(c), rows[-1].number(c), low, high)
              for c in ("published", "ours_median", "continuous_median", "against_exact")}
    holds = growth["against_exact"] >= EXPONENTIAL and growth["continuous_median"] >= EXPONENTIAL
    return Finding(
        id="growth_with_degree", about="conclusion",
        claim="With rising degree the error of conversion to power form rises exponentially.",
        place="section 2.3.1, after the first table", holds=holds,
        headline=f"Through the power form the error of a Bézier curve is multiplied by {general(growth['against_exact'])} "
                 "with every degree: it grows exponentially." if holds else
                 f"Through the power form the error is multiplied by only {general(growth['against_exact'])} with every "
                 "degree: it does not grow exponentially.",
        detail=(f"From degree {low:g} to {high:g} the mean error goes from {scientific(rows[0]['against_exact'])} to "
                f"{scientific(rows[-1]['against_exact'])} against the exact value. The factor per degree is "
                f"{general(growth['published'])} as printed, {general(growth['ours_median'])} in our repetition and "
                f"{general(growth['continuous_median'])} with continuous inputs.",),
        rows=tuple(rows))


def _middle(row):
    return (row.number("t_min") + row.number("t_max")) / 2


@finding()
def growth_with_t(bundle):
    """Holds where, over intervals of one width, the mean error grows more than in proportion to their middle, on every path."""
    scorecard = bundle["scorecard.csv"]
    rows = [r for r in scorecard.some(table="2.3.3", statistic="mean_error") if r["method"] != "de_casteljau"]
    width = min(r.number("t_max") - r.number("t_min") for r in rows)
    narrow = [r for r in rows if r["t_max"] - r["t_min"] < 1.001 * width]
    paths = {}
    for row in sorted(narrow, key=lambda r: r["t_min"]):
        paths.setdefault((row["form"], row["method"]), []).append(row)
    if not paths or min(map(len, paths.values())) < 2:
        raise Missing("`scorecard.csv` has fewer than two intervals of one width in table 2.3.3")
    grows = [all(b.number(c) / a.number(c) > _middle(b) / _middle(a) for a, b in zip(p, p[1:]) for c in ("ours_median", "against_exact"))
             for p in paths.values()]
    holds = all(grows)
    first, last = paths[next(iter(paths))][0], paths[next(iter(paths))][-1]
    places = listing(interval(r["t_min"], r["t_max"]) for r in paths[next(iter(paths))])
    return Finding(
        id="growth_with_t", about="conclusion",
        claim="On converted curves the mean error grows with the mean of t, more than linearly.",
        place="section 2.3.3, after each table", holds=holds,
        headline=f"On converted curves the error grows more than in proportion to t on {sum(grows)} of {len(grows)} paths" + (
            ", as the report says." if holds else ": the report's conclusion does not hold on all."),
        detail=(f"Over {places}, the mean error of `{first['method']}` goes from {scientific(first.number('against_exact'))} to "
                f"{scientific(last.number('against_exact'))} against the exact value, a factor of "
                f"{factor(last['against_exact'] / first['against_exact'])}; printed: {scientific(first['published'])} to "
                f"{scientific(last['published'])}.",),
        rows=tuple(narrow))


NEGLIGIBLE = 0.01


@finding()
def conversion_dominates(bundle):
    """Holds where, at the highest degree, both evaluators have about the same error after the report's conversion."""
    rows = {m: series(bundle, "degree", table="2.3.1", form="power", method=f"forward_substitution:{m}",
                      statistic="mean_error") for m in ("de_casteljau", "direct")}
    apart = [abs(a.number("ours_median") / b.number("ours_median") - 1)
             for a, b in zip(rows["de_casteljau"], rows["direct"])]
    low, high = rows["direct"][0], rows["direct"][-1]
    holds = apart[-1] < NEGLIGIBLE
    lines = [f"The mean errors after `forward_substitution` differ by {percent(apart[0])} at degree {low['degree']:g} and by "
             f"{percent(apart[-1])} at degree {high['degree']:g}."]
    if "scorecard_timing.csv" in bundle:
        timed = bundle["scorecard_timing.csv"].select(table="2.4", form="power", method="forward_substitution:direct",
                                                      degree=high["degree"])
        if timed and timed[0]["prepared_median"]:
            share = 1 - timed[0].number("prepared_median") / timed[0].number("ours_median")
            lines.append(f"Of the time per curve at degree {high['degree']:g}, conversion and set-up take {percent(share)}.")
    return Finding(
        id="conversion_dominates", about="conclusion",
        claim="On polynomial curves the errors and the cost come mainly from the conversion to Bernstein form.",
        place="section 3.2, paragraph 2",
        holds=holds,
        headline="On polynomial curves, converted as the report does it, the error comes from the conversion: both evaluators "
                 "err alike." if holds else
                 f"On polynomial curves the evaluator still matters at degree {high['degree']:g}: the errors differ by "
                 f"a factor of {general(1 + apart[-1])}.",
        detail=tuple(lines), rows=tuple(r for pair in rows.values() for r in pair))


# fastest first, as the report concludes
ORDERS = {
    "bernstein": ("direct", "de_casteljau", "factorial:power_sum"),
    "power": ("power_sum", "forward_substitution:direct", "forward_substitution:de_casteljau"),
}


def _times(rows, column, order):
    """{degree: {method: time}} for the degrees at which every method of the order has a time."""
    times = {}
    for row in rows:
        if row["method"] in order and row[column] is not None:
            times.setdefault(row.number("degree"), {})[row["method"]] = row.number(column)
    return {n: times[n] for n in sorted(times) if len(times[n]) == len(order)}


def _kept(rows, column, order):
    """(degrees at which the order holds, degrees at which it can be judged)."""
    times = _times(rows, column, order)
    kept = [n for n, t in times.items() if all(t[a] < t[b] for a, b in zip(order, order[1:]))]
    return kept, list(times)


def _at_limits(bundle, curve, order, mode):
    """As _kept(), for the least times that the processor could take in the studies that reproduce the table."""
    rows = bundle["timing.csv"].rows if "timing.csv" in bundle else []
    return _kept([r for r in rows if (r["study"] or "").startswith("2.4") and r["form"] == curve and r["mode"] == mode
                  and r["scalar"] == "double" and r["degree"] is not None], "limit_ns", order)


@finding()
def time_order(bundle):
    """Holds where, as the report times them, both orders hold at every degree."""
    used, lines, all_kept = [], [], True
    for curve, order in ORDERS.items():
        written = " < ".join(name(m) for m in order)
        rows = bundle["scorecard_timing.csv"].some(table="2.4", form=curve)
        kept, judged = _kept(rows, "ours_median", order)
        once, judged_once = _kept(rows, "prepared_median", order)
        used += rows
        all_kept = all_kept and bool(judged) and kept == judged
        failing = [f"{n:g}" for n in judged if n not in kept]
        fastest = [min(times, key=times.get) for times in _times(rows, "prepared_median", order).values()]
        limits = [_at_limits(bundle, curve, order, mode) for mode in ("one_shot", "point")]
        lines.append(f"{FORM[curve][0].capitalize()}: {written} in time holds at {len(kept)} of {len(judged)} degrees as "
                     "the report times it"
                     + (f" (not at degree {listing(failing)})" if failing else "")
                     + (f", and at {len(once)} of {len(judged_once)} when prepared once, where {name(order[0])} is fastest at "
                        f"{fastest.count(order[0])} and {name(order[-1])} at {fastest.count(order[-1])}." if judged_once
                        else ".")
                     + (" At the limits of this processor it would hold at "
                        + " and ".join(f"{len(k)} of {len(j)}{when}" for (k, j), when in zip(limits, ("", " when prepared once")) if j)
                        + "." if any(j for _, j in limits) else ""))
    return Finding(
        id="time_order", about="note",
        claim="In speed, for Bézier curves, direct evaluation comes before de Casteljau and that before conversion to power form; for "
              "polynomial curves direct evaluation comes before conversion followed by direct evaluation, and that before conversion "
              "followed by de Casteljau.",
        place="section 2.4, after each table", holds=all_kept,
        headline="The report's orders of speed hold on this machine and build when the conversion is charged to every curve." if all_kept
        else "The report's orders of speed do not all hold on this machine and build.",
        detail=(*lines, "What the report describes, compiled with and without optimisation, is timed by `scripts/check printed_times`."),
        rows=tuple(used))


@finding()
def sample_maximum(bundle):
    """Holds where the largest error over all pooled trials clearly exceeds the median of the printed statistic."""
    cells = [r for r in accuracy_cells(bundle) if r["statistic"] == "max_error" and r["table"] == "2.3.1"]
    found = []
    for cell in cells:
        pooled = bundle.accuracy(study=f"2.3.1-{IN_STUDIES[cell['form']]}", method=cell["method"], baseline=yardstick(cell["form"]),
                                 generator="report", degree=cell["degree"])
        found.append((pooled.number("max_error") / cell.number("ours_median"), cell, pooled))
    least, most = min(f[0] for f in found), max(f[0] for f in found)
    widths = sorted(r.number("ours_p95") / r.number("ours_p05") for r in cells)
    pooled = found[0][2]
    holds = least > FLAT
    return Finding(
        id="sample_maximum", about="note", claim="In all cases the largest error of evaluation is only 0.054.",
        place="section 3.1, paragraph 2", holds=holds,
        headline="The largest error of a sample is not a worst case." if holds else
        "The largest error of the report's sample is close to the largest that we found.",
        detail=(f"Over {large(pooled.number('trials'))} trials per cell the largest error is {factor(least)} to "
                f"{factor(most)} times the median of the report's statistic, and from one repetition to the next that statistic "
                f"varies by up to a factor of {general(widths[-1], 2)} (5 to 95 %).",),
        rows=tuple(r for f in found for r in f[1:]))
