# SPDX-License-Identifier: MIT
"""What the suites show of evaluators: by degree, range, interval, scalar and conditioning, and at the worst inputs."""

from dataclasses import dataclass
import math
import re

from ..bundle import Missing, Row
from ..methods import FORM
from ..rows import distinct, grouped
from ..wording import count, factor, general, interval, large, listing, shortest, span
from .finding import by_winners, degrees, finding, how_many_methods, methods_of, names, verdict


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
    """{degree: the methods with the smallest mean error}; several where their errors are equal."""
    degrees = sorted({n for rows in methods.values() for n in rows})
    smallest = {n: min(rows[n]["mean_error_u"] for rows in methods.values() if n in rows) for n in degrees}
    return {n: tuple(m for m, rows in methods.items() if n in rows and rows[n]["mean_error_u"] == smallest[n]) for n in degrees}


def growth(rows):
    """The largest mean error of one method over that at the lowest degree."""
    return max(r["mean_error_u"] for r in rows.values()) / rows[min(rows)]["mean_error_u"]


def _title(curve):
    return FORM[curve][0][0].upper() + FORM[curve][0][1:]


def _ladders(bundle):
    """{form: {method: {degree: row}}} of continuous inputs, in double in the plane."""
    rows = bundle.exact("ladder").select(generator="continuous")
    return {curve: by_degree(r for r in own if (r["scalar"], r["dimension"]) == ("double", 2)) for curve, own in grouped(rows, "form").items()}


@finding("ladder")
def ladder_best(bundle):
    """Holds where in each form some method has the smallest mean error at every degree."""
    always, lines, used = {}, [], []
    for curve, methods in _ladders(bundle).items():
        winners = best(methods)
        always[curve] = [m for m in methods if all(m in some for some in winners.values())]
        top = max(winners)
        used += [methods[m][n] for n, some in winners.items() for m in some]
        lines.append(f"{_title(curve)}: the smallest mean error at degree {top:g} is {general(methods[winners[top][0]][top]['mean_error_u'])} u p~. "
                     f"Most accurate: {by_winners(winners)}.")
    return verdict(
        all(always.values()), "At every degree of the ladder the most accurate on average are "
        + listing(f"{names(some)} for {FORM[curve][0]}" for curve, some in always.items()) + ".",
        "No method is the most accurate on average at every degree for "
        + listing((FORM[curve][0] for curve, some in always.items() if not some), "or") + ".", *lines, rows=used)


FLAT = 2  # the mean error at most doubles over the ladder
ALL_LOST = 2.0 ** 53  # in units of u p~: an error as large as the terms of the curve


@finding("ladder")
def ladder_growth(bundle):
    """Holds where every method that evaluates the given form grows at most with the degree, and some converted path faster."""
    lines, fast, used = [], [], []
    for curve, methods in _ladders(bundle).items():
        grown = {m: growth(rows) for m, rows in methods.items()}
        limit = max(n for rows in methods.values() for n in rows) / min(n for rows in methods.values() for n in rows)
        flat, faster = [m for m in grown if grown[m] <= FLAT], [m for m in grown if grown[m] > limit]
        between = [m for m in grown if m not in flat and m not in faster]
        fast += faster
        used += [rows[n] for rows in methods.values() for n in (min(rows), max(rows))]
        at = [min(n for n, r in methods[m].items() if r["mean_error_u"] > ALL_LOST) for m in faster
              if any(r["mean_error_u"] > ALL_LOST for r in methods[m].values())]

        def by(some):
            return span(min(grown[m] for m in some), max(grown[m] for m in some), factor)
        lines.append(
            f"{_title(curve)}. Flat, at most doubled from the lowest degree to any other: {names(flat) or 'none'}. "
            + (f"Growing, but no faster than the degree: {names(between)}, by a factor of {by(between)}. " if between else "")
            + (f"Faster than the degree: {names(faster)}, by a factor of {by(faster)}"
               + (f"; {'all' if len(at) == len(faster) else len(at)} of these {len(faster)} lose every digit on average, the first at degree {min(at):g}."
                  if at else ".") if faster else "None grows faster than the degree."))
    given = [m for m in fast if ":" not in m]
    paths = general(len([m for m in distinct(bundle.exact("ladder").rows, "method") if ":" in m]))
    converted = f"{len(fast) - len(given)} of {paths} converted paths"
    return verdict(
        fast and not given, f"No method that evaluates the given form grows faster than the degree; {converted} do.",
        f"Of the methods that evaluate the given form, {names(given)} grow faster than the degree; {converted} do." if given else
        "No method and no converted path grows faster than the degree.", *lines, rows=used)


# Both are choices of this report, and every sentence that rests on one of them names it. No column is an interval of a mean error;
# that of a converted path, whose errors are heavy-tailed, differs more from sample to sample than others.
ALIKE = 2  # a smaller factor between means does not show a dependence
CLOSE = 1.25  # means that differ by at most this factor are counted as equal


@dataclass(frozen=True)
class Spread:
    """The smallest and the largest mean error over u p~ of a method among cells that differ in one column only."""

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
    finite = [r for r in rows if r["status"] == "ok" and not r["non_finite"] and isinstance(r["mean_error_u"], float) and r["mean_error_u"] > 0]
    rest = [c for c in ("scalar", "dimension", "degree", "coordinate_range", "t_min", "t_max") if c != axis]
    found = {}
    for (method, *_), members in grouped(finite, "method", *rest).items():
        if len(members) > 1:
            found.setdefault(method, []).append(Spread(*(end(members, key=lambda r: r["mean_error_u"]) for end in (min, max))))
    if not found:
        raise Missing(f"no two cells of the study differ in `{axis}` only")
    return {method: max(some, key=lambda s: (s.apart, s.ratio)) for method, some in found.items()}


def _independent(bundle, name, axis, extent, what, write, *detail, yes="{extent} the mean error over u p~ of no method changes by more than a factor of "
                 f"{ALIKE}", more="", broken=()):
    """The verdict that no mean error over u p~ depends on an axis. `extent` says along which values, and `write` a value in words."""
    found = spreads(study(bundle, name), axis)
    apart = {m: s for m, s in found.items() if s.apart}
    widest = max(found.values(), key=lambda s: (s.apart, s.ratio))
    close = sum(s.ratio <= CLOSE for s in found.values())
    return verdict(
        not apart, f"{yes.format(extent=extent, count=count(len(found), 'method'))}{more}.",
        f"The mean error over u p~ of {names(apart)} depends on {what}, by a factor of up to {factor(widest.ratio)}; that of the other "
        f"{len(found) - len(apart)} methods does not.",
        f"{close} of {count(len(found), 'method')} stay within a factor of {CLOSE}; the largest variation is that of `{widest.high['method']}` at degree "
        f"{widest.high['degree']:g}: {general(widest.low['mean_error_u'])} {write(widest.low)}, {general(widest.high['mean_error_u'])} "
        f"{write(widest.high)}.", *detail, rows=[r for s in (apart or {0: widest}).values() for r in (s.low, s.high)] + list(broken))


RUINED = 10  # times the worst mean error within [0, 1] at the same degree


def _outside(row):
    return row["t_min"] < 0 or row["t_max"] > 1


@finding("regimes")
def regimes_parameter(bundle):
    """Holds where every method that evaluates the given form is about as accurate outside [0, 1] as inside."""
    rows = [r for r in study(bundle, "parameter") if ":" not in r["method"] and isinstance(r["mean_error_u"], float)]
    worst = {}  # method: (ratio, row outside, row inside), at its worst degree
    for (method, _), own in grouped(rows, "method", "degree").items():
        inside, outside = [r for r in own if not _outside(r)], [r for r in own if _outside(r)]
        if inside and outside:
            a, b = (max(some, key=lambda r: r["mean_error_u"]) for some in (outside, inside))
            worst[method] = max(worst.get(method, (0, a, b)), (a["mean_error_u"] / b["mean_error_u"], a, b), key=lambda w: w[0])
    ruined = {m: w for m, w in worst.items() if w[0] > RUINED}
    fine = [w[0] for m, w in worst.items() if m not in ruined]
    _, far, near = max(worst.values(), key=lambda w: w[0])
    nearest = max((r for r in rows if not _outside(r)), key=lambda r: r["mean_error_u"])
    return verdict(
        not ruined, "Every method that evaluates the given form is as accurate outside [0, 1] as near its ends.",
        f"Outside [0, 1] {names(ruined)} err by up to {general(far['mean_error_u'])} u p~ on average; the other {len(worst) - len(ruined)} methods that "
        "evaluate the given form are as accurate there as near the ends.",
        f"At its worst `{far['method']}` errs {general(far['mean_error_u'])} u p~ on average for t in {interval(*far['interval'])} at degree "
        f"{far['degree']:g}, against at most {general(near['mean_error_u'])} near the ends of [0, 1]."
        + (f" Of the others the worst outside is {span(min(fine), max(fine), factor)} times the worst near the ends." if fine and ruined else ""),
        f"Near the ends the largest mean error is {general(nearest['mean_error_u'])} u p~ (`{nearest['method']}`, degree {nearest['degree']:g}, t in "
        f"{interval(*nearest['interval'])}).", rows=(nearest, *(r for w in (ruined or worst).values() for r in w[1:])))


@finding("regimes")
def regimes_range(bundle):
    """Holds where no method's mean error over u p~ depends on the range. Overflow is reported separately."""
    rows = study(bundle, "range")
    ranges = sorted(distinct(rows, "coordinate_range"))
    broken = [r for r in rows if r["non_finite"]]
    places = listing(dict.fromkeys(f"R = {shortest(r['coordinate_range'])}, degree {r['degree']:g}" for r in broken))
    return _independent(
        bundle, "range", "coordinate_range", f"From R = {shortest(ranges[0])} to {shortest(ranges[-1])}", "the range",
        lambda r: f"at R = {shortest(r['coordinate_range'])}",
        f"Not finite: {large(sum(r['non_finite'] for r in broken))} trials, of {methods_of(broken)}. These cells are not compared." if broken else
        "Every trial gave a finite value.", broken=broken,
        more=f", but {count(len(distinct(broken, 'method')), 'method overflows', 'methods overflow')} at {places}" if broken else "")


@finding("regimes")
def regimes_degree(bundle):
    """Holds where no method returns a value that is not finite."""
    rows = study(bundle, "degree")
    methods = by_degree(rows)
    broken = [r for r in rows if r["non_finite"]]
    refused = {m: min(distinct(own, "degree")) for m, own in grouped((r for r in rows if r["status"] != "ok"), "method").items()}
    top = max(r["degree"] for r in rows)
    last = {m: at[top]["mean_error_u"] for m, at in methods.items() if top in at}
    low, high = (end(last, key=last.get) for end in (min, max))
    return verdict(
        not broken, f"Up to degree {shortest(top)} no method returns a value that is not finite"
        + (f" (unsupported: {listing(f'`{m}` from degree {shortest(n)}' for m, n in refused.items())})." if refused else "."),
        f"{methods_of(broken)} return values that are not finite, first at degree {shortest(min((r['degree'] for r in broken), default=None))}.",
        f"At degree {shortest(top)} the mean error is {general(last[low])} u p~ (`{low}`) to {general(last[high])} (`{high}`) among "
        f"{count(len(last), 'method')}; {large(sum(r['non_finite'] or 0 for r in rows))} trials are not finite.",
        rows=broken or [at[top] for at in methods.values() if top in at])


@finding("regimes")
def regimes_float(bundle):
    """Holds where the mean errors of every method, in the unit of its scalar, agree between float and double."""
    return _independent(bundle, "float", "scalar", "", "whether the scalar is float or double", lambda r: f"in {r['scalar']}",
                        yes=f"In units of its own u p~ float errs as double does: the mean errors of {{count}} agree within a factor of {ALIKE}")


@finding("regimes")
def regimes_dimension(bundle):
    """Holds where no method's mean error over u p~ depends on the number of axes."""
    axes = sorted(distinct(study(bundle, "dimension"), "dimension"))
    return _independent(bundle, "dimension", "dimension", f"From {shortest(axes[0])} to {shortest(axes[-1])} axes", "the number of axes",
                        lambda r: f"on {count(int(r['dimension']), 'axis', 'axes')}")


UNIT = 2.0 ** -53
ACCURATE = 2 * UNIT  # one ulp at most: "accurate to u"
NO_DIGIT = 1.0  # a relative error of 1: no digit is correct
SLACK = 2  # the rule holds up to a constant, since the condition number is a bound on the effect of rounding


def precision(method):
    """K for a method that works as if in K-fold precision; None where the id does not state K."""
    if ":" in method:
        return None
    fold = re.search(r"_k(\d+)$", method)
    return int(fold[1]) if fold else 2 if method.startswith("compensated_") else 1


@finding("conditioning")
def conditioning_digits(bundle):
    """Holds where the median relative error of every K-fold scheme stays below about u + condition u^K."""
    rows = [r for r in bundle.exact("conditioning").rows if r["p50_condition"] is not None and r["p50_relative"] is not None]
    if not rows:
        raise Missing("`accuracy.csv` has no `conditioning-` row with `p50_condition` and `p50_relative`")
    rows.sort(key=lambda r: r.number("p50_condition"))
    judged = [(r, precision(r["method"])) for r in rows if precision(r["method"])]
    broken = [r for r, k in judged if not r["p50_relative"] <= SLACK * (UNIT + r["p50_condition"] * UNIT ** k)]
    top = max(k for _, k in judged)
    lines, used = [], list(broken)
    for (curve, method), own in grouped(rows, "form", "method").items():
        first = [next((r for r in own if not r["p50_relative"] <= limit), None) for limit in (ACCURATE, NO_DIGIT)]
        used += filter(None, first)
        lines.append((precision(method) or top + 1, f"`{method}` ({'Bernstein' if curve == 'bernstein' else 'power'} form) "
                      + " and ".join(factor(r["p50_condition"]) if r else "in no cell" for r in first)))
    return verdict(
        not broken, f"With K-fold precision the median relative error stays below about u + condition u^K, for K = 1 to {top} in all {len(judged)} cells: "
        "accurate to u until the condition number nears 1/u^(K-1).", f"The rule u + condition u^K does not describe {methods_of(broken)}.",
        "Condition number from which the median relative error exceeds 2u, and from which it exceeds 1: "
        + "; ".join(text for _, text in sorted(lines, key=lambda line: line[0])) + ".", rows=used or [r for r, _ in judged])


MILD, WILD = "weights_mild", "weights_wild"
COST = 4  # times the error under mild weights


@finding("rational")
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
        steepest = max(some, key=lambda m: growth(some[m]))
        lines.append(f"Smallest mean error under `{g}`: {by_winners(best(some))}. Over the ladder no mean error grows by more than a factor of "
                     f"{factor(growth(some[steepest]))} (`{steepest}`).")
    return verdict(
        ratio <= COST, f"The weights of `{WILD}` multiply the mean error over u p~ of the methods for rational curves under `{MILD}` by at most {factor(ratio)}.",
        f"The weights of `{WILD}` multiply the mean error over u p~ of `{wild['method']}` under `{MILD}` by {factor(ratio)}.",
        f"The largest effect is that on `{wild['method']}` at degree {wild['degree']:g}: {general(mild['mean_error_u'])} u p~ with `{MILD}`, "
        f"{general(wild['mean_error_u'])} with `{WILD}`.", *lines, rows=(mild, wild, *(r for pair in pairs for r in pair)))


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


@finding("worst")
def worst_bounds(bundle):
    """Holds where no searched maximum exceeds its proved bound."""
    rows = rows_of(bundle, "worst")
    bounded, unbounded = [r for r in rows if r["bound_u"]], [r for r in rows if r["bound_u"] is None]
    if not bounded:
        raise Missing("`search.csv` has no `worst-` row with a bound")
    broken = exceeding(rows)
    closest = max(bounded, key=lambda r: r["searched_error_u"] / r["bound_u"])
    return verdict(
        not broken, f"No searched worst case exceeds a proved bound, in {count(len(bounded), 'cell')} of {how_many_methods(bounded)}.",
        f"A searched worst case exceeds the proved bound of {methods_of(broken)}: a bound or its condition is wrong.",
        f"The closest is {general(closest['searched_error_u'] / closest['bound_u'], 2)} of its bound (`{closest['method']}`, degree "
        f"{shortest(closest['degree'])}, `{closest['search_id']}`)." + (f" No bound is proved for {methods_of(unbounded)}." if unbounded else ""),
        rows=broken or [closest])


@finding("worst")
def worst_gain(bundle):
    """Holds where most cells gained the requested factor."""
    rows = rows_of(bundle, "worst")
    reached, near, short = ([r for r in rows if r["status"] == status] for status in ("reached", "near_bound", "short"))
    most = max(rows, key=gain)
    given = max((r for r in rows if ":" not in r["method"]), key=gain, default=None)
    return verdict(
        2 * len(reached) > len(rows),
        f"The maximum of a sample is not the worst case: searching finds at least {GAIN} times as much in {len(reached)} of {count(len(rows), 'cell')}; in "
        f"{len(near)} more the bound leaves no room for that.",
        f"Searching gains {GAIN} times over the sample in only {len(reached)} of {count(len(rows), 'cell')}.",
        f"The sample is {large(max(r['trials'] for r in rows))} trials, the search {large(max(r['budget'] for r in rows))} steps from its worst. The largest "
        f"gain is {factor(gain(most))} (`{most['method']}`, degree {shortest(most['degree'])}: {general(most['sampled_error_u'])} to "
        f"{general(most['searched_error_u'])} u p~, `{most['search_id']}`)"
        + (f"; among the methods that evaluate the given form it is {factor(gain(given))} (`{given['method']}`, degree {shortest(given['degree'])}, "
           f"`{given['search_id']}`)." if given else "."),
        f"Near the bound already: {methods_of(near) or 'none'}. Short of the gain: "
        f"{names((f'''{r['method']}, degree {shortest(r['degree'])}''' for r in short), 8) or 'none'}.", rows=[*short, most])
