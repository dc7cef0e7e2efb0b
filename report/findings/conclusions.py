# SPDX-License-Identifier: MIT
"""Conclusions of the source report, compared with the bundle."""

from itertools import count as natural
import math
import sys

from ..bundle import Missing
from ..methods import FORM, IN_STUDIES, name, yardstick
from ..rows import distinct, grouped
from ..wording import count, factor, general, interval, large, listing, percent, scientific, shortest, span
from .finding import degrees, finding, how_many_methods, methods_of, trials_of, verdict
from .printed_times import ORDERS
from .printed_tables import EXPONENTIAL, FLAT, accuracy_cells, against_exact, per_degree, printed_degrees, series


def in_part(row):
    """Whether the bounds cover only a part of the trials: the largest error exceeds all bounds, but no trial violates its own."""
    return bool(row["bound_u"]) and not row["bound_violations"] and (row["max_error_u"] or 0) > row["bound_u"]


@finding(suite=None)
def bounds_hold(bundle):
    """Holds where no trial of any method exceeds its proved bound."""
    rows = [r for r in bundle.judged().some(baseline="exact") if r["bound_u"] and r["status"] == "ok"]
    broken, partly = [r for r in rows if r["bound_violations"]], [r for r in rows if in_part(r)]
    closest = max((r for r in rows if not in_part(r)), key=lambda r: (r["max_error_u"] or 0) / r["bound_u"], default=None)
    if closest is None:
        raise Missing("`accuracy.csv` has no row whose bound covers its largest error")
    return verdict(
        not broken, f"No proved error bound is exceeded in {trials_of(rows)} judged evaluations.",
        f"A proved error bound is exceeded by {methods_of(broken)}: a bound or its condition is wrong.",
        f"{count(len(rows), 'cell')} of {how_many_methods(rows)} have a bound. The closest observed error is "
        f"{general((closest['max_error_u'] or 0) / closest['bound_u'], 2)} of its bound (`{closest['method']}`, degree {closest['degree']:g}).",
        f"In {count(len(partly), 'cell')} of {listing(f'`{study}`' for study in distinct(partly, 'study'))} the proof does not apply to some trials, and the "
        "largest error is that of one of them." if partly else "", rows=broken or [closest, *partly],
        about="reproduction" if bundle.has_suite("report") else "note")


@finding(about="correction", claim="For Bézier curves direct evaluation is the most accurate, and de Casteljau comes second.",
         place="section 3.2, paragraph 1")
def yardstick_ranking(bundle):
    """Holds where de Casteljau has the smaller mean error at most of the printed degrees."""
    pairs = [(n, *(against_exact(bundle, m, n) for m in ("de_casteljau", "direct"))) for n in printed_degrees(bundle)]
    wins = [n for n, a, b in pairs if a.number("mean_error") < b.number("mean_error")]
    top, casteljau, direct = pairs[-1]
    means, largest = ([r.number(c) for r in (casteljau, direct)] for c in ("mean_error", "max_error_u"))
    better = f"Against the exact value de Casteljau is more accurate on average than direct evaluation at {len(wins)} of {count(len(pairs), 'degree')}"
    return verdict(
        2 * len(wins) > len(pairs), f"{better}: the yardstick inverts the ranking.", f"{better}: the report's ranking stands.",
        f"At degree {top:g}, over {large(direct['trials'])} trials, the mean errors are {scientific(means[0])} (de Casteljau) and {scientific(means[1])} "
        f"(direct), a ratio of {general(means[1] / means[0])}; the largest are {general(largest[0])} and {general(largest[1])} times u p~. The report could "
        "not see this: its yardstick sets the error of direct evaluation to zero.",
        f"De Casteljau is ahead at {degrees(wins)}." if 0 < len(wins) < len(pairs) else "", rows=[r for _, a, b in pairs for r in (a, b)])


@finding(about="correction", claim="Evaluation by the definition is taken to be completely accurate.", place="section 2.3, paragraph 2")
def common_rounding(bundle):
    """Holds where both methods are farther from the truth than from each other, and gain where 1-t is exact."""
    n = printed_degrees(bundle)[-1]
    apart = bundle.accuracy(method="de_casteljau", baseline="direct", study="2.3.1-bezier", generator="continuous", degree=n)
    methods = ("de_casteljau", "direct")
    truth = [against_exact(bundle, m, n) for m in methods]
    dyadic = [bundle.accuracy(study="truth-bezier", method=m, degree=n, baseline="exact", generator="dyadic") for m in methods]
    gap = apart.number("mean_error")
    (casteljau, direct), after = ([r.number("mean_error") for r in rows] for rows in (truth, dyadic))
    hidden, gains = gap < min(casteljau, direct), after[0] < casteljau and after[1] < direct
    return verdict(
        hidden and gains, "The report's yardstick hides an error that it shares with de Casteljau: the rounding of 1-t.",
        "This bundle shows no error that the report's yardstick shares with de Casteljau.",
        f"At degree {n:g}, de Casteljau and direct evaluation lie {scientific(gap)} apart on average; from the exact value de Casteljau is "
        f"{scientific(casteljau)} away and direct {scientific(direct)}."
        + (" The common part cancels in their distance." if hidden else " Their distance does not understate the error."),
        f"Where t is a multiple of the unit roundoff, so that 1-t is exact, de Casteljau goes from {scientific(casteljau)} to {scientific(after[0])} and "
        f"direct from {scientific(direct)} to {scientific(after[1])}: "
        + ("that rounding is a large part of the error of both." if gains else "the rounding of 1-t is not the common part."),
        rows=(apart, *truth, *dyadic))


@finding(about="correction", claim="On polynomial curves the errors grow exponentially with the degree; where it is large, they come mainly from the "
         "conversion to Bernstein form.", place="section 2.3.1, after the second table")
def forward_substitution(bundle):
    """Holds where the error grows exponentially with forward substitution and does not with the positive sum."""
    low, *_, high = printed_degrees(bundle)
    rows = [bundle.accuracy(study="truth-polynomial", method=f"{c}:de_casteljau", degree=n, baseline="exact", generator="continuous")
            for c in ("forward_substitution", "positive_sum") for n in (low, high)]
    solve, positive = ([r.number("mean_error") for r in pair] for pair in (rows[:2], rows[2:]))
    growth = [per_degree(*pair, low, high) for pair in (solve, positive)]
    ratio = solve[1] / positive[1]
    return verdict(
        growth[1] < EXPONENTIAL <= growth[0], "The exponential error of power form to Bernstein form is the report's forward substitution, not the "
        "conversion: with the positive sum it vanishes.",
        "Replacing forward substitution by the positive sum does not remove an exponential error in this bundle.",
        f"At degree {high:g} the mean error against the exact value is {scientific(solve[1])} with `forward_substitution` and {scientific(positive[1])} with "
        f"`positive_sum`, both followed by de Casteljau: a ratio of {factor(ratio)}, {general(math.log10(ratio), 2)} decades.",
        f"From degree {low:g} to {high:g} the error is multiplied by {general(growth[0])} per degree with the first and by {general(growth[1])} with the "
        "second.", rows=rows)


METHOD = "factorial:power_sum"


def _spread(values):
    return max(values) / min(values)


@finding(about="conclusion", claim="As the range of the coordinates grows, the error grows.", place="section 2.3.2, after each table")
def range_bend(bundle):
    """Holds where the error grows with the range, as printed and ours: in proportion with continuous inputs, with a bend on the report's
    grid."""
    rows = series(bundle, "coordinate_range", table="2.3.2", form="bernstein", method=METHOD, statistic="mean_error")
    columns = ("published", "ours_median", "continuous_median")
    published, ours, continuous = ([r.number(c) / r.number("coordinate_range") for r in rows] for c in columns)
    used = [[bundle.accuracy(study="2.3.2-bezier", method=METHOD, baseline="direct", generator=generator, degree=r["degree"],
                             coordinate_range=r["coordinate_range"]) for r in rows] for generator in ("report", "continuous")]
    in_u = [general(_spread([r.number("mean_error_u") for r in found])) for found in used]
    grows = all(a.number(c) < b.number(c) for a, b in zip(rows, rows[1:]) for c in columns)
    first, last = (shortest(r["coordinate_range"]) for r in (rows[0], rows[-1]))
    return verdict(
        grows and _spread(continuous) <= FLAT < _spread(ours),
        "The error grows with the range, with continuous inputs in proportion to it; the bend of the printed errors is the random grid.",
        f"The random grid does not explain the error over the range in this bundle: error over range varies by a factor of {general(_spread(ours))} with the "
        f"grid and {general(_spread(continuous))} with continuous inputs.",
        f"Via power form, mean error over range falls from {scientific(published[0])} at R = {first} to {scientific(published[-1])} at R = {last} in print, "
        f"and from {scientific(ours[0])} to {scientific(ours[-1])} with the report's generator; with continuous inputs it stays at "
        f"{span(min(continuous), max(continuous), scientific)}.",
        f"Over u p~ the mean error varies by a factor of {in_u[0]} with the report's grid and {in_u[1]} with continuous inputs.",
        _conversion(bundle, rows[0], rows[-1]), rows=(*rows, *used[0], *used[1]))


def _conversion(bundle, first, last):
    """The conversion's part of the error on the grid at both ends of the range; empty where no error was decomposed."""
    parts = []
    for row in (first, last):
        found = bundle.judged().select(study="2.3.2-bezier", method=METHOD, baseline="exact", generator="report", scalar="double", dimension=2,
                                       degree=row["degree"], coordinate_range=row["coordinate_range"])
        if len(found) != 1 or found[0]["mean_conversion_error"] is None:
            return ""
        parts += [scientific(found[0].number(c)) for c in ("mean_conversion_error", "mean_evaluation_error")]
    return (f"On the grid the conversion makes a mean error of {parts[0]} and the evaluation one of {parts[1]} at R = {shortest(first['coordinate_range'])}; "
            f"at R = {shortest(last['coordinate_range'])} they make {parts[2]} and {parts[3]}.")


@finding(about="correction", claim="The error of de Casteljau hardly changes with the degree and has little to do with t.",
         place="sections 2.3.1 and 2.3.3, after the first table of each")
def de_casteljau_flat(bundle):
    """Holds where the error against the exact value, in coordinate units, clearly varies with the degree or with t, over the degrees and the
    range that are printed."""
    printed = series(bundle, "degree", table="2.3.1", form="bernstein", method="de_casteljau", statistic="mean_error")
    truth = [against_exact(bundle, "de_casteljau", row["degree"]) for row in printed]
    if len(distinct((*truth, *printed), "coordinate_range")) > 1:
        raise Missing("`accuracy.csv` has the degrees that are printed for another coordinate range")
    by_t = bundle.judged().some(scalar="double", dimension=2, study="2.3.3-bezier", method="de_casteljau", baseline="exact", generator="continuous")
    errors, seen = [r.number("mean_error") for r in truth], [r.number("published") for r in printed]
    low, high = (end(by_t, key=lambda r: r.number("mean_error")) for end in (min, max))
    ratio = high["mean_error"] / low["mean_error"]
    depends = [what for what, varies in (("the degree", _spread(errors)), ("t", ratio)) if varies > FLAT]
    return verdict(
        depends, f"Against the exact value de Casteljau's error depends on {listing(depends)}.",
        "Against the exact value, too, de Casteljau's error hardly depends on the degree or on t.",
        f"From degree {shortest(truth[0]['degree'])} to {shortest(truth[-1]['degree'])} its mean error goes from {scientific(errors[0])} to "
        f"{scientific(errors[-1])} against the exact value, and its extremes are a factor of {general(_spread(errors))} apart; the printed ones go from "
        f"{scientific(seen[0])} to {scientific(seen[-1])}, extremes a factor of {general(_spread(seen))} apart.",
        f"Between intervals of t the mean error goes from {scientific(low['mean_error'])} on {interval(*low['interval'])} to "
        f"{scientific(high['mean_error'])} on {interval(*high['interval'])}, a factor of {general(ratio)}.", rows=(*truth, *by_t, *printed))


@finding(about="conclusion", claim="As the degree rises further, factorials overflow in floating point, and the conversion fails.",
         place="section 2.2, paragraph 3; section 3.2, paragraph 3")
def factorial_overflow(bundle):
    """Holds where every method with factorials reaches the last degree whose factorial is a double and no further, and is finite at the
    degrees of the bundle up to there."""
    printed = printed_degrees(bundle)[-1]
    used = [m for m in bundle.judged().distinct("method", study="truth-bezier") if m == "direct" or m.startswith("factorial:")]
    limits = [r for r in bundle["methods.csv"].some(id=[*used, "factorial"]) if r["max_degree"] is not None]
    overflow = next(n for n in natural(1) if math.factorial(n) > sys.float_info.max)
    rows = [r for r in bundle.judged().some(study="truth-bezier", method=used) if printed < r["degree"] < overflow]
    good = [r for r in rows if r["status"] == "ok" and r["non_finite"] == 0 and r["mean_error"] is not None and math.isfinite(r["mean_error"])]
    reach = {r.number("max_degree") for r in limits}
    finite = (f"{len(good)} of {count(len(rows), 'cell')} with factorials "
              f"{f'''at {degrees(sorted(distinct(rows, 'degree')))}''' if rows else 'above the printed degrees'} are finite")
    stated = f"the methods that form factorials ({listing(f'`{one}`' for one in distinct(limits, 'id'))}) are stated to reach {degrees(sorted(reach))}"
    return verdict(
        rows and len(good) == len(rows) and reach == {overflow - 1},
        f"Factorials overflow in double from degree {overflow} on; up to there the conversion does not fail: {finite}.",
        f"Factorials overflow in double from degree {overflow} on, but {finite}, and {stated}.",
        f"{overflow}! is the first factorial that no double holds; {stated}.", rows=(*rows, *limits))


POWER_WORSE = dict(claim="For Bézier curves de Casteljau is always more accurate than conversion to power form.",
                   place="sections 2.3.2 and 2.3.3, after the first table of each")


@finding(about="conclusion", **POWER_WORSE)
def via_power_worse(bundle):
    """Holds where de Casteljau errs less in every printed cell, against the yardstick and against the exact value."""
    cells = grouped((r for r in accuracy_cells(bundle) if r["form"] == "bernstein"), "statistic", "degree", "coordinate_range", "interval").values()
    found = [{r["method"]: r for r in cell} for cell in cells]
    pairs = [(cell["de_casteljau"], cell[METHOD]) for cell in found if {"de_casteljau", METHOD} <= set(cell)]
    if not pairs:
        raise Missing("`scorecard.csv` has no cell with both de Casteljau and the power form")
    wins = [sum(a.number(c) < b.number(c) for a, b in pairs) for c in ("published", "ours_median", "continuous_median", "against_exact")]
    ratios = [b.number("against_exact") / a.number("against_exact") for a, b in pairs]
    n = len(pairs)
    return verdict(
        min(wins) == n, f"De Casteljau is more accurate than the power form in all {n} pairs of cells, by every comparison.",
        f"De Casteljau is not more accurate than the power form in all {n} pairs of cells.",
        f"It is more accurate in {wins[0]} as printed, {wins[1]} in our repetition, {wins[2]} with continuous inputs and {wins[3]} against the exact value, "
        f"where the power form's error is {span(min(ratios), max(ratios), factor)} times as large.", rows=[r for pair in pairs for r in pair])


@finding(about="conclusion", claim="With rising degree the error of conversion to power form rises exponentially.",
         place="section 2.3.1, after the first table")
def growth_with_degree(bundle):
    """Holds where the mean error against the exact value grows exponentially through the power form."""
    rows = series(bundle, "degree", table="2.3.1", form="bernstein", method=METHOD, statistic="mean_error")
    first, last = rows[0], rows[-1]
    low, high = first.number("degree"), last.number("degree")
    growth = {c: per_degree(first.number(c), last.number(c), low, high) for c in ("published", "ours_median", "continuous_median", "against_exact")}
    rate = general(growth["against_exact"])
    return verdict(
        min(growth["against_exact"], growth["continuous_median"]) >= EXPONENTIAL,
        f"Through the power form the error of a Bézier curve is multiplied by {rate} with every degree: it grows exponentially.",
        f"Through the power form the error is multiplied by only {rate} with every degree: it does not grow exponentially.",
        f"From degree {low:g} to {high:g} the mean error goes from {scientific(first['against_exact'])} to {scientific(last['against_exact'])} against the "
        f"exact value. The factor per degree is {general(growth['published'])} as printed, {general(growth['ours_median'])} in our repetition and "
        f"{general(growth['continuous_median'])} with continuous inputs.", rows=rows)


def _middle(row):
    return (row.number("t_min") + row.number("t_max")) / 2


@finding(about="conclusion", claim="On converted curves the mean error grows with the mean of t, more than linearly.",
         place="section 2.3.3, after each table")
def growth_with_t(bundle):
    """Holds where, over intervals of one width, the mean error grows more than in proportion to their middle, on every path."""
    rows = [r for r in bundle["scorecard.csv"].some(table="2.3.3", statistic="mean_error") if r["method"] != "de_casteljau"]
    width = min(r.number("t_max") - r.number("t_min") for r in rows)
    narrow = sorted((r for r in rows if r["t_max"] - r["t_min"] < 1.001 * width), key=lambda r: r["t_min"])
    paths = list(grouped(narrow, "form", "method").values())
    if min(map(len, paths)) < 2:
        raise Missing("`scorecard.csv` has fewer than two intervals of one width in table 2.3.3")
    grows = sum(all(b.number(c) / a.number(c) > _middle(b) / _middle(a) for a, b in zip(p, p[1:]) for c in ("ours_median", "against_exact")) for p in paths)
    first, last = paths[0][0], paths[0][-1]
    said = f"On converted curves the error grows more than in proportion to t on {grows} of {len(paths)} paths"
    return verdict(
        grows == len(paths), f"{said}, as the report concludes.", f"{said}: the report's conclusion does not hold on all.",
        f"Over {listing(interval(*r['interval']) for r in paths[0])}, the mean error of `{first['method']}` goes from "
        f"{scientific(first.number('against_exact'))} to {scientific(last.number('against_exact'))} against the exact value, a factor of "
        f"{factor(last['against_exact'] / first['against_exact'])}; printed: {scientific(first['published'])} to {scientific(last['published'])}.",
        rows=narrow)


NEGLIGIBLE = 0.01


@finding(about="conclusion", claim="On polynomial curves the errors and the cost come mainly from the conversion to Bernstein form.",
         place="section 3.2, paragraph 2")
def conversion_dominates(bundle):
    """Holds where, at the highest degree, both evaluators have about the same error after the report's conversion."""
    pairs = list(zip(*(series(bundle, "degree", table="2.3.1", form="power", method=f"forward_substitution:{m}", statistic="mean_error")
                       for m in ("de_casteljau", "direct"))))
    apart = [abs(a.number("ours_median") / b.number("ours_median") - 1) for a, b in pairs]
    low, high = (pair[1]["degree"] for pair in (pairs[0], pairs[-1]))
    timed = bundle["scorecard_timing.csv"].select(table="2.4", form="power", method="forward_substitution:direct", degree=high) \
        if "scorecard_timing.csv" in bundle else []
    return verdict(
        apart[-1] < NEGLIGIBLE,
        "On polynomial curves, converted as the report does it, the error comes from the conversion: both evaluators have the same error.",
        f"On polynomial curves the evaluator still matters at degree {high:g}: the errors differ by a factor of {general(1 + apart[-1])}.",
        f"The mean errors after `forward_substitution` differ by {percent(apart[0])} at degree {low:g} and by {percent(apart[-1])} at degree {high:g}.",
        f"Of the time per curve at degree {high:g}, conversion and preparation take "
        f"{percent(1 - timed[0].number('prepared_median') / timed[0].number('ours_median'))}." if timed and timed[0]["prepared_median"] else "",
        rows=[r for a in zip(*pairs) for r in a])


NEARLY = 2  # times the time of direct evaluation


@finding(about="conclusion", claim="In practice Bézier curves are to be evaluated by de Casteljau's algorithm: it has no factorials, which overflow, and is "
         "hardly slower or less accurate than direct evaluation.", place="section 3.2, paragraph 3")
def recommended(bundle):
    """Holds where, at every printed degree, de Casteljau's mean error is at most about that of direct evaluation, and its time, measured as
    the report does, at most twice as long."""
    degrees_ = printed_degrees(bundle)
    errors = [[against_exact(bundle, m, n) for m in ("de_casteljau", "direct")] for n in degrees_]
    less = [a.number("mean_error") / b.number("mean_error") for a, b in errors]
    table = bundle["scorecard_timing.csv"]
    times = [[table.one(table="2.4", form="bernstein", method=m, degree=n) for m in ("de_casteljau", "direct")] for n in degrees_]
    slower = [a.number("ours_median") / b.number("ours_median") for a, b in times]
    once = [a.number("prepared_median") / b.number("prepared_median") for a, b in times if a["prepared_median"] and b["prepared_median"]]
    said = f"Against the exact value de Casteljau's mean error is {span(min(less), max(less), general)} times that of direct evaluation"
    return verdict(
        max(less) <= FLAT and max(slower) <= NEARLY,
        "De Casteljau's algorithm is a sound first choice: no factorials, and hardly slower or less accurate than direct evaluation.",
        "De Casteljau's algorithm is clearly slower or less accurate than direct evaluation at a printed degree.",
        f"{said}, its time {span(min(slower), max(slower), general)} times, with everything that the report charges to a curve"
        + (f", and {span(min(once), max(once), general)} times when factorials are prepared once." if once else "."),
        _without_factorials(bundle, degrees_[-1]), rows=[r for pair in (*errors, *times) for r in pair])


def _without_factorials(bundle, n):
    """How Horner's scheme in Bernstein form, which has no factorials either, compares at the highest degree; empty without its rows."""
    exact = bundle.judged().select(study="truth-bezier", method="horner_bernstein", degree=n, baseline="exact", generator="continuous", scalar="double")
    timed = [bundle["timing.csv"].select(study="2.4-bezier", method=m, degree=n, mode="point", scalar="double")
             for m in ("horner_bernstein", "de_casteljau")] if "timing.csv" in bundle else [[]]
    if len(exact) != 1 or any(len(rows) != 1 for rows in timed):
        return ""
    ratio = exact[0].number("mean_error") / against_exact(bundle, "de_casteljau", n).number("mean_error")
    return (f"Horner's scheme in Bernstein form has no factorials either: at degree {shortest(n)}, for a prepared curve, it takes "
            f"{general(timed[0][0].number('median_ns') / timed[1][0].number('median_ns'))} of de Casteljau's time with {general(ratio)} times its mean error.")


def _kept(rows, column, order):
    """(degrees at which the order holds, {degree: its fastest method} at which it can be judged)."""
    times = {n: {r["method"]: r.number(column) for r in own} for n, own in
             grouped((r for r in rows if r["method"] in order and r[column] is not None), "degree").items()}
    judged = {n: times[n] for n in sorted(times) if len(times[n]) == len(order)}
    return ([n for n, t in judged.items() if all(t[a] < t[b] for a, b in zip(order, order[1:]))],
            {n: min(t, key=t.get) for n, t in judged.items()})


def _order(bundle, curve, order, rows):
    """(whether the order holds as the report times it, the sentences about it)."""
    kept, judged = _kept(rows, "ours_median", order)
    once, fastest = _kept(rows, "prepared_median", order)
    failing = [n for n in judged if n not in kept]
    text = (f"{FORM[curve][0].capitalize()}: the order {' < '.join(map(name, order))} in time holds at {len(kept)} of {len(judged)} degrees as the report "
            f"times it{f' (not at {degrees(failing)})' if failing else ''}.")
    if fastest:
        wins = list(fastest.values())
        text += (f" When prepared once it holds at {len(once)} of {len(fastest)}; {name(order[0])} is then the fastest at {wins.count(order[0])} and "
                 f"{name(order[-1])} at {wins.count(order[-1])}.")
    # the least times that the processor could take in the studies that reproduce the table
    limits = [r for r in (bundle["timing.csv"].rows if "timing.csv" in bundle else ()) if (r["study"] or "").startswith("2.4") and r["form"] == curve
              and r["scalar"] == "double" and r["degree"] is not None]
    at = [(*_kept([r for r in limits if r["mode"] == mode], "limit_ns", order), when) for mode, when in (("one_shot", ""), ("point", " when prepared once"))]
    held = [f"{len(k)} of {len(j)}{when}" for k, j, when in at if j]
    return bool(judged) and not failing, text + (f" At the limits of this processor it would hold at {listing(held)}." if held else "")


@finding(about="note", claim="In speed, for Bézier curves, direct evaluation comes before de Casteljau and that before conversion to power form; for "
         "polynomial curves direct evaluation comes before conversion followed by direct evaluation, and that before conversion followed by de "
         "Casteljau.", place="section 2.4, after each table")
def time_order(bundle):
    """Holds where, as the report times them, both orders hold at every degree."""
    rows = {curve: bundle["scorecard_timing.csv"].some(table="2.4", form=curve) for curve in ORDERS}
    judged = [_order(bundle, curve, order, rows[curve]) for curve, order in ORDERS.items()]
    return verdict(
        all(holds for holds, _ in judged),
        "The report's orders of speed hold on this machine and build when the conversion is charged to every curve.",
        "The report's orders of speed do not all hold on this machine and build.", *(text for _, text in judged),
        "The programs that the report describes, compiled with and without optimisation, are timed by `scripts/check printed_times`.",
        rows=[r for own in rows.values() for r in own])


@finding(about="note", claim="In all cases the largest error of evaluation is only 0.054.", place="section 3.1, paragraph 2")
def sample_maximum(bundle):
    """Holds where the largest error over all pooled trials clearly exceeds the median of the printed statistic."""
    cells = [r for r in accuracy_cells(bundle) if r["statistic"] == "max_error" and r["table"] == "2.3.1"]
    pooled = [bundle.accuracy(study=f"2.3.1-{IN_STUDIES[cell['form']]}", method=cell["method"], baseline=yardstick(cell["form"]), generator="report",
                              degree=cell["degree"]) for cell in cells]
    ratios = [row.number("max_error") / cell.number("ours_median") for cell, row in zip(cells, pooled)]
    widths = [r.number("ours_p95") / r.number("ours_p05") for r in cells]
    return verdict(
        min(ratios) > FLAT, "The largest error of a sample is not a worst case.",
        "The largest error of the report's sample is close to the largest of all our trials.",
        f"Over {large(pooled[0].number('trials'))} trials per cell the largest error is {factor(min(ratios))} to {factor(max(ratios))} times the median of the "
        f"report's statistic, and from one repetition to the next that statistic varies by up to a factor of {general(max(widths), 2)} (5 to 95 %).",
        rows=[r for pair in zip(cells, pooled) for r in pair])
