# SPDX-License-Identifier: MIT
"""What the suites show of evaluators: by degree, range, interval, scalar and conditioning, and at the worst inputs."""

from dataclasses import dataclass
import math
import re

from ..bundle import Missing, Row
from ..document import Finding
from ..methods import FORM
from ..wording import count, factor, general, interval, large, listing, shortest, span
from .finding import finding

def by_degree(rows):
    """{method: {degree: row}} of the rows with a number."""
    methods = {}
    for row in rows:
        if row["status"] == "ok" and isinstance(row["mean_error_u"], float):
            methods.setdefault(row["method"], {})[row.number("degree")] = row
    if not methods:
        raise Missing("no row has a mean error over u p~")
    return methods


def best(methods):
    """{degree: the methods with the least mean error}; several where their errors are equal."""
    degrees = sorted({n for rows in methods.values() for n in rows})
    least = {n: min(rows[n]["mean_error_u"] for rows in methods.values() if n in rows) for n in degrees}
    return {n: tuple(m for m, rows in methods.items() if n in rows and rows[n]["mean_error_u"] == least[n]) for n in degrees}


def growth(rows):
    """The largest mean error of one method over that at the lowest degree."""
    first = rows[min(rows)]["mean_error_u"]
    return max(r["mean_error_u"] for r in rows.values()) / first


def names(methods, most=6):
    """The names as text: `a`, `b` and 3 more."""
    methods = [f"`{m}`" for m in methods]
    return listing(methods) if len(methods) <= most else f"{', '.join(methods[:most - 1])} and {len(methods) - most + 1} more"


def degrees(values):
    return f"degree {listing(shortest(n) for n in values)}"


GENERATOR = "continuous"


@finding(suite="ladder")
def ladder_best(bundle):
    """Holds where in each form some method has the least mean error at every degree."""
    table = bundle.exact("ladder")
    always, lines, used = {}, [], []
    for curve in table.distinct("form", generator=GENERATOR):
        methods = by_degree(table.select(form=curve, generator=GENERATOR, scalar="double", dimension=2))
        winners = best(methods)
        always[curve] = [m for m in methods if all(m in some for some in winners.values())]
        top = max(winners)
        used += [methods[m][n] for n, some in winners.items() for m in some]
        groups = {}
        for n, some in winners.items():
            groups.setdefault(some, []).append(n)
        rows = [methods[m][top] for m in winners[top]]
        lines.append(f"{FORM[curve][0][0].upper()}{FORM[curve][0][1:]}: the least mean error at degree {top:g} is "
                     f"{general(rows[0]['mean_error_u'])} u p~. First at " + "; ".join(f"{degrees(at)}: {names(some)}"
                                                                                    for some, at in groups.items()) + ".")
    holds = all(always.values())
    return Finding(
        id="ladder_best", about="suite", suite="ladder", claim="", holds=holds,
        headline="At every degree of the ladder the most accurate on average are "
                 + listing(f"{names(some)} for {FORM[curve][0]}" for curve, some in always.items()) + "." if holds else
        "No method is the most accurate on average at every degree: "
        + listing(f"{count(len(some), 'method is', 'methods are')} so for {FORM[curve][0]}" for curve, some in always.items()) + ".",
        detail=tuple(lines), rows=tuple(used))


FLAT = 2  # the mean error at most doubles over the ladder
ALL_LOST = 2.0 ** 53  # in units of u p~: an error as large as the terms of the curve


@finding(suite="ladder")
def ladder_growth(bundle):
    """Holds where every method that evaluates the given form grows at most with the degree, and some converted path faster."""
    table = bundle.exact("ladder")
    lines, flat, fast, native_fast, used = [], [], [], [], []
    for curve in table.distinct("form", generator=GENERATOR):
        methods = by_degree(table.select(form=curve, generator=GENERATOR, scalar="double", dimension=2))
        grown = {m: growth(rows) for m, rows in methods.items()}
        limit = max(n for rows in methods.values() for n in rows) / min(n for rows in methods.values() for n in rows)
        mine = {"flat": [m for m in grown if grown[m] <= FLAT], "fast": [m for m in grown if grown[m] > limit]}
        between = [m for m in grown if m not in mine["flat"] and m not in mine["fast"]]
        flat += mine["flat"]
        fast += mine["fast"]
        native_fast += [m for m in mine["fast"] if ":" not in m]
        used += [rows[n] for rows in methods.values() for n in (min(rows), max(rows))]
        lost = {m: min((n for n, r in methods[m].items() if r["mean_error_u"] > ALL_LOST), default=None) for m in mine["fast"]}
        at = [n for n in lost.values() if n is not None]
        title = FORM[curve][0][0].upper() + FORM[curve][0][1:]
        lines.append(
            f"{title}. Flat, at most doubled from the lowest degree to any other: {names(mine['flat']) or 'none'}. "
            + (f"Growing, but no faster than the degree: {names(between)}, by a factor of "
               f"{span(min(grown[m] for m in between), max(grown[m] for m in between), factor)}. " if between else "")
            + (f"Faster than the degree: {names(mine['fast'])}, by "
               f"{span(min(grown[m] for m in mine['fast']), max(grown[m] for m in mine['fast']), factor)}"
               + (f"; {'all' if len(at) == len(lost) else len(at)} of these {len(lost)} lose every digit on average, the "
                  f"first at degree {min(at):g}." if at else ".")
               if mine["fast"] else "None grows faster than the degree."))
    holds = bool(fast) and not native_fast
    paths = len({r["method"] for r in table.rows if ":" in r["method"]})
    return Finding(
        id="ladder_growth", about="suite", suite="ladder", claim="", holds=holds,
        headline=f"No method that evaluates the given form grows faster than the degree; {len(fast)} of {general(paths)} "
                 "converted paths do."
        if holds else
        (f"Of the methods that evaluate the given form, {names(native_fast)} grow faster than the degree; of "
         f"{general(paths)} converted "
         f"paths {len(fast) - len(native_fast)} do." if native_fast else
         "No method and no converted path grows faster than the degree."),
        detail=tuple(lines), rows=tuple(used))


# Both are choices of this report, and every sentence that rests on one of them names it. No column is an interval of a mean error;
# that of a converted path, whose errors are heavy-tailed, differs more from sample to sample than others.
ALIKE = 2  # means that differ by no more say nothing of a dependence
CLOSE = 1.25  # means that differ by no more are counted as equal


@dataclass(frozen=True)
class Spread:
    """The least and the largest mean error over u p~ of a method among cells that differ in one column only."""

    low: Row
    high: Row

    @property
    def ratio(self):
        return self.high["mean_error_u"] / self.low["mean_error_u"]

    @property
    def apart(self):
        """Whether the means differ by more than the factor `ALIKE`."""
        return self.ratio > ALIKE


def study(bundle, name):
    """Rows of one study against the exact value."""
    return bundle.exact("regimes").some(study=f"regimes-{name}")


def spreads(rows, axis):
    """{method: its widest Spread along the column `axis`}

    Cells with trials that are not finite are left out, since their finite trials are not representative.
    """
    groups = {}
    for row in rows:
        if row["status"] == "ok" and not row["non_finite"] and isinstance(row["mean_error_u"], float) and row["mean_error_u"] > 0:
            rest = tuple(row[c] for c in ("scalar", "dimension", "degree", "coordinate_range", "t_min", "t_max") if c != axis)
            groups.setdefault((row["method"], rest), []).append(row)
    found = {}
    for (method, _), members in groups.items():
        if len(members) > 1:
            widest = Spread(*(end(members, key=lambda r: r["mean_error_u"]) for end in (min, max)))
            found.setdefault(method, []).append(widest)
    if not found:
        raise Missing(f"no two cells of the study differ in `{axis}` only")
    return {method: max(some, key=lambda s: (s.apart, s.ratio)) for method, some in found.items()}


def in_words(found):
    """A clause such as `33 of 34 methods stay within a factor of 1.25`."""
    close = sum(s.ratio <= CLOSE for s in found.values())
    return f"{close} of {count(len(found), 'method')} stay within a factor of {CLOSE}"


RUINED = 10  # times the worst mean error within [0, 1] at the same degree


def _outside(row):
    return row["t_min"] < 0 or row["t_max"] > 1


@finding(suite="regimes")
def regimes_parameter(bundle):
    """Holds where every method that evaluates the given form is about as accurate outside [0, 1] as inside."""
    rows = [r for r in study(bundle, "parameter") if ":" not in r["method"] and isinstance(r["mean_error_u"], float)]
    worst = {}  # method: (ratio, row outside, row inside), at its worst degree
    for method in dict.fromkeys(r["method"] for r in rows):
        for degree in sorted({r["degree"] for r in rows}):
            own = [r for r in rows if r["method"] == method and r["degree"] == degree]
            inside, outside = [r for r in own if not _outside(r)], [r for r in own if _outside(r)]
            if inside and outside:
                a, b = (max(some, key=lambda r: r["mean_error_u"]) for some in (outside, inside))
                ratio = a["mean_error_u"] / b["mean_error_u"]
                worst[method] = max(worst.get(method, (0, a, b)), (ratio, a, b), key=lambda w: w[0])
    ruined = {m: w for m, w in worst.items() if w[0] > RUINED}
    fine = [w[0] for m, w in worst.items() if m not in ruined]
    steepest = max(worst.values(), key=lambda w: w[0])
    near = max((r for r in rows if not _outside(r)), key=lambda r: r["mean_error_u"])
    return Finding(
        id="regimes_parameter", about="suite", suite="regimes", claim="", holds=not ruined,
        headline="Every method that evaluates the given form is as good outside [0, 1] as near its ends." if not ruined else
        f"Outside [0, 1] {names(ruined)} err by up to {general(steepest[1]['mean_error_u'])} u p~ on average; the other "
        f"{len(worst) - len(ruined)} methods that evaluate the given form are as good there as near the ends.",
        detail=(f"At its worst `{steepest[1]['method']}` errs {general(steepest[1]['mean_error_u'])} u p~ on average for t in "
                f"{interval(steepest[1]['t_min'], steepest[1]['t_max'])} at degree {steepest[1]['degree']:g}, against at most "
                f"{general(steepest[2]['mean_error_u'])} near the ends of [0, 1]."
                + (f" Of the others the worst outside is {span(min(fine), max(fine), factor)} times the worst near the ends." if fine and ruined
                   else ""),
                f"Near the ends the largest mean error is {general(near['mean_error_u'])} u p~ (`{near['method']}`, degree "
                f"{near['degree']:g}, t in {interval(near['t_min'], near['t_max'])})."),
        rows=(near, *(r for w in (ruined or worst).values() for r in w[1:])))


@finding(suite="regimes")
def regimes_range(bundle):
    """Holds where no method's mean error over u p~ depends on the range. Overflow is reported separately."""
    rows = study(bundle, "range")
    found = spreads(rows, "coordinate_range")
    uneven = [m for m, s in found.items() if s.apart]
    widest = max(found.values(), key=lambda s: (s.apart, s.ratio))
    ranges = sorted({r["coordinate_range"] for r in rows})
    broken = [r for r in rows if r["non_finite"]]
    places = listing(dict.fromkeys(f"R = {shortest(r['coordinate_range'])}, degree {r['degree']:g}" for r in broken))
    return Finding(
        id="regimes_range", about="suite", suite="regimes", claim="", holds=not uneven,
        headline=f"From R = {shortest(ranges[0])} to {shortest(ranges[-1])} the mean error over u p~ of no method changes "
                 f"by more than a factor of {ALIKE}" + (f", but {count(len({r['method'] for r in broken}), 'method overflows', 'methods overflow')} at {places}."
                                     if broken else ".") if not uneven else
        f"The mean error over u p~ of {names(uneven)} depends on the range, by a factor of up to {factor(widest.ratio)}.",
        detail=(f"{in_words(found)}; the largest variation is that of `{widest.high['method']}` at degree "
                f"{widest.high['degree']:g}: "
                f"{general(widest.low['mean_error_u'])} at R = {shortest(widest.low['coordinate_range'])}, "
                f"{general(widest.high['mean_error_u'])} at R = {shortest(widest.high['coordinate_range'])}.",
                f"Not finite: {large(sum(r['non_finite'] for r in broken))} trials, of "
                f"{names(dict.fromkeys(r['method'] for r in broken))}. These cells are not compared." if broken else
                "Every trial gave a finite value."),
        rows=(widest.low, widest.high, *broken))


@finding(suite="regimes")
def regimes_degree(bundle):
    """Holds where no method returns a value that is not finite."""
    rows = study(bundle, "degree")
    methods = by_degree(rows)
    broken = [r for r in rows if r["non_finite"]]
    refused = {}
    for r in rows:
        if r["status"] != "ok":
            refused.setdefault(r["method"], []).append(r["degree"])
    top = max(r["degree"] for r in rows)
    last = {m: at[top]["mean_error_u"] for m, at in methods.items() if top in at}
    best, worst = (end(last, key=last.get) for end in (min, max))
    return Finding(
        id="regimes_degree", about="suite", suite="regimes", claim="", holds=not broken,
        headline=f"Up to degree {shortest(top)} no method returns a value that is not finite"
                 + (" (not for this degree: " + listing(f"`{m}` from {shortest(min(at))}" for m, at in refused.items()) + ")."
                    if refused else ".")
        if not broken else f"{names(dict.fromkeys(r['method'] for r in broken))} return values that are not finite, first at "
                           "degree "
        f"{shortest(min(r['degree'] for r in broken))}.",
        detail=(f"At degree {shortest(top)} the mean error is {general(last[best])} u p~ (`{best}`) to "
                f"{general(last[worst])} (`{worst}`) "
                f"among {count(len(last), 'method')}; {large(sum(r['non_finite'] or 0 for r in rows))} trials are not finite.",),
        rows=tuple(broken or [at[top] for at in methods.values() if top in at]))


@finding(suite="regimes")
def regimes_float(bundle):
    """Holds where the mean errors of every method, in the unit of its scalar, agree between float and double."""
    found = spreads(study(bundle, "float"), "scalar")
    apart = {m: s for m, s in found.items() if s.apart}
    widest = max(found.values(), key=lambda s: (s.apart, s.ratio))
    return Finding(
        id="regimes_float", about="suite", suite="regimes", claim="", holds=not apart,
        headline=f"In units of its own u p~ float errs as double does: the mean errors of {count(len(found), 'method')} "
                 f"agree within a factor of {ALIKE}." if not apart else
        f"In units of its own u p~ float errs as double does for {len(found) - len(apart)} of {count(len(found), 'method')}, "
        "but not for "
        f"{names(apart)}.",
        detail=(f"{in_words(found)}; the largest difference is that of `{widest.high['method']}` at degree "
                f"{widest.high['degree']:g}: "
                f"{general(widest.low['mean_error_u'])} in {widest.low['scalar']} and {general(widest.high['mean_error_u'])} "
                "in "
                f"{widest.high['scalar']}.",),
        rows=tuple(r for s in (apart or found).values() for r in (s.low, s.high)))


@finding(suite="regimes")
def regimes_dimension(bundle):
    """Holds where no method's mean error over u p~ depends on the number of axes."""
    rows = study(bundle, "dimension")
    found = spreads(rows, "dimension")
    apart = [m for m, s in found.items() if s.apart]
    widest = max(found.values(), key=lambda s: (s.apart, s.ratio))
    axes = sorted({r["dimension"] for r in rows})
    return Finding(
        id="regimes_dimension", about="suite", suite="regimes", claim="", holds=not apart,
        headline=f"From {shortest(axes[0])} to {shortest(axes[-1])} axes the mean error over u p~ of no method changes "
                 f"by more than a factor of {ALIKE}." if not apart else
        f"The mean error over u p~ of {names(apart)} depends on the number of axes, by a factor of up to "
        f"{factor(widest.ratio)}.",
        detail=(f"{in_words(found)}; the largest variation is that of `{widest.high['method']}` at degree "
                f"{widest.high['degree']:g}: "
                f"{general(widest.low['mean_error_u'])} on {count(int(widest.low['dimension']), 'axis', 'axes')} and "
                f"{general(widest.high['mean_error_u'])} on {shortest(widest.high['dimension'])}.",),
        rows=(widest.low, widest.high))


UNIT = 2.0 ** -53
ACCURATE = 2 * UNIT  # one ulp at most: "accurate to u"
NO_DIGIT = 1.0  # a relative error of 1: no digit is right
SLACK = 2  # the rule holds up to a constant, since the condition number is a bound on what rounding can do


def precision(method):
    """K for a method that works as if in K-fold precision; None where the id does not state K."""
    if ":" in method:
        return None
    fold = re.search(r"_k(\d+)$", method)
    return int(fold[1]) if fold else 2 if method.startswith("compensated_") else 1


def cells(bundle):
    """{(curve, method): rows by ascending condition number}, for rows with a median condition number and relative
    error."""
    found = {}
    for row in bundle.exact("conditioning").rows:
        if row["p50_condition"] is not None and row["p50_relative"] is not None:
            found.setdefault((row["form"], row["method"]), []).append(row)
    if not found:
        raise Missing("`accuracy.csv` has no `conditioning-` row with `p50_condition` and `p50_relative`")
    return {key: sorted(rows, key=lambda r: r.number("p50_condition")) for key, rows in found.items()}


def first_above(rows, limit):
    """The row of least condition number whose median relative error exceeds `limit`; None where none does."""
    return next((r for r in rows if not r["p50_relative"] <= limit), None)


@finding(suite="conditioning")
def conditioning(bundle):
    """Holds where the median relative error of every K-fold scheme stays below about u + condition u^K."""
    by_method = cells(bundle)
    judged = [(r, precision(m)) for (_, m), rows in by_method.items() for r in rows if precision(m)]
    broken = [(r, k) for r, k in judged if not r["p50_relative"] <= SLACK * (UNIT + r["p50_condition"] * UNIT ** k)]
    top = max(k for _, k in judged)
    lines, used = [], [r for r, _ in broken]
    for (curve, method), rows in by_method.items():
        unsure, lost = first_above(rows, ACCURATE), first_above(rows, NO_DIGIT)
        used += [r for r in (unsure, lost) if r]
        lines.append((precision(method) or top + 1, f"`{method}` ({'Bernstein' if curve == 'bernstein' else 'power'} form) "
                      + (factor(unsure["p50_condition"]) if unsure else "in no cell") + " and "
                      + (factor(lost["p50_condition"]) if lost else "in no cell")))
    names = listing(dict.fromkeys(f"`{r['method']}`" for r, _ in broken))
    return Finding(
        id="conditioning_digits", about="suite", suite="conditioning", claim="", holds=not broken,
        headline=f"With K-fold precision the median relative error stays below about u + condition u^K, for K = 1 to {top} "
                 "in all "
                 f"{len(judged)} cells: accurate to u until the condition number nears 1/u^(K-1)." if not broken else
        f"The rule u + condition u^K does not describe {names}.",
        detail=("Condition number from which the median relative error exceeds 2u, and from which it exceeds 1: "
                + "; ".join(text for _, text in sorted(lines, key=lambda line: line[0])) + ".",),
        rows=tuple(used or [r for r, _ in judged]))


MILD, WILD = "weights_mild", "weights_wild"
COST = 4  # times the error under mild weights


@finding(suite="rational")
def rational_weights(bundle):
    """Holds where wild weights multiply no mean error over u p~ by more than a small constant."""
    table = bundle.exact("rational")
    ladder = next((s for s in table.distinct("study", scalar="double") if len(table.distinct("degree", study=s)) > 1), None)
    if ladder is None:
        raise Missing("`accuracy.csv` has no `rational-` study in double that varies the degree")
    methods = {g: by_degree(table.some(study=ladder, scalar="double", generator=g)) for g in (MILD, WILD)}
    pairs = [(rows[n], methods[WILD][m][n]) for m, rows in methods[MILD].items() for n in rows if n in methods[WILD].get(m, {})]
    if not pairs:
        raise Missing(f"no method has rows for both `{MILD}` and `{WILD}`")
    mild, wild = max(pairs, key=lambda p: p[1].number("mean_error_u") / p[0].number("mean_error_u"))
    ratio = wild["mean_error_u"] / mild["mean_error_u"]
    lines = []
    for g, some in methods.items():
        groups = {}
        for n, winners in best(some).items():
            groups.setdefault(winners, []).append(n)
        steepest = max(some, key=lambda m: growth(some[m]))
        lines.append(f"`{g}`: the least mean error has " + "; ".join(f"{names(w)} at {degrees(at)}" for w, at in groups.items())
                     + f". Over the ladder no mean error grows by more than a factor of {factor(growth(some[steepest]))} "
                       f"(`{steepest}`).")
    holds = ratio <= COST
    return Finding(
        id="rational_weights", about="suite", suite="rational", claim="", holds=holds,
        headline=f"Against `{MILD}`, the weights of `{WILD}` cost the methods for rational curves at most a factor of "
                 f"{factor(ratio)} in mean error over u p~." if holds else
        f"Against `{MILD}`, the weights of `{WILD}` cost `{wild['method']}` a factor of {factor(ratio)} in mean error over u p~.",
        detail=(f"The dearest is `{wild['method']}` at degree {wild['degree']:g}: {general(mild['mean_error_u'])} u p~ with "
                f"`{MILD}`, "
                f"{general(wild['mean_error_u'])} with `{WILD}`.", *lines),
        rows=(mild, wild, *(r for pair in pairs for r in pair)))


GAIN = 1.5  # the gain over the sample that the search aims at; search.csv says `reached` where it got it


def rows_of(bundle, *suites):
    """Rows whose maxima are numbers."""
    rows = [r for r in bundle["search.csv"].of_suite(*suites).rows
            if all(isinstance(r[c], float) and math.isfinite(r[c]) for c in ("sampled_error_u", "searched_error_u"))]
    if not rows:
        raise Missing(f"`search.csv` has no finite maximum of the suite `{'` or `'.join(suites)}`")
    return rows


def gain(row):
    """The searched maximum over the sampled one; infinite where the sample has no error."""
    return row["searched_error_u"] / row["sampled_error_u"] if row["sampled_error_u"] else math.inf


def exceeding(rows):
    """Rows whose searched maximum exceeds the proved bound."""
    return [r for r in rows if r["bound_u"] is not None and not r["searched_error_u"] <= r["bound_u"]]


@finding(suite="worst")
def worst_bounds(bundle):
    """Holds where no searched maximum exceeds its proved bound."""
    rows = rows_of(bundle, "worst")
    bounded = [r for r in rows if r["bound_u"]]
    if not bounded:
        raise Missing("`search.csv` has no `worst-` row with a bound")
    broken = exceeding(rows)
    closest = max(bounded, key=lambda r: r["searched_error_u"] / r["bound_u"])
    unbounded = list(dict.fromkeys(r["method"] for r in rows if r["bound_u"] is None))
    return Finding(
        id="worst_bounds", about="suite", suite="worst", claim="", holds=not broken,
        headline=f"No searched worst case exceeds a proved bound, in {count(len(bounded), 'cell')} of "
                 f"{count(len({r['method'] for r in bounded}), 'method')}." if not broken else
        f"A searched worst case exceeds the proved bound of {names(dict.fromkeys(r['method'] for r in broken))}: a bound or "
        "its condition "
        "is wrong.",
        detail=(f"The closest comes to {general(closest['searched_error_u'] / closest['bound_u'], 2)} of its bound "
                f"(`{closest['method']}`, "
                f"degree {shortest(closest['degree'])}, `{closest['search_id']}`)."
                + (f" No bound is proved for {names(unbounded)}." if unbounded else ""),), rows=tuple(broken or [closest]))


@finding(suite="worst")
def worst_gain(bundle):
    """Holds where most cells gained what was asked."""
    rows = rows_of(bundle, "worst")
    by = {status: [r for r in rows if r["status"] == status] for status in ("reached", "near_bound", "short")}
    most = max(rows, key=gain)
    given = max((r for r in rows if ":" not in r["method"]), key=gain, default=None)
    cells = {r["search_id"]: f"{r['method']}, degree {shortest(r['degree'])}" for r in by["short"]}
    holds = 2 * len(by["reached"]) > len(rows)
    return Finding(
        id="worst_gain", about="suite", suite="worst", claim="", holds=holds,
        headline=f"The maximum of a sample is not the worst: searching finds at least {GAIN} times as much in "
                 f"{len(by['reached'])} of "
                 f"{count(len(rows), 'cell')}; in {len(by['near_bound'])} more the bound leaves no room for that."
        if holds else f"Searching gains {GAIN} times over the sample in only {len(by['reached'])} of "
                      f"{count(len(rows), 'cell')}.",
        detail=(f"The sample is {large(max(r['trials'] for r in rows))} trials, the search "
                f"{large(max(r['budget'] for r in rows))} steps from "
                f"its worst. The largest gain is {factor(gain(most))} (`{most['method']}`, degree {shortest(most['degree'])}: "
                f"{general(most['sampled_error_u'])} to {general(most['searched_error_u'])} u p~, `{most['search_id']}`)"
                + (f"; among the methods that evaluate the given form it is {factor(gain(given))} (`{given['method']}`, degree "
                   f"{shortest(given['degree'])}, `{given['search_id']}`)." if given else "."),
                f"Near the bound already: {names(dict.fromkeys(r['method'] for r in by['near_bound'])) or 'none'}. Short of "
                "the gain: "
                + (names(cells.values(), 8) if cells else "none") + "."),
        rows=tuple(by["short"] + [most]))
