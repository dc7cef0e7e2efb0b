# SPDX-License-Identifier: MIT
"""What the suite `conversion` shows."""

import math

from ..bundle import Missing
from ..rows import distinct, grouped
from ..wording import count, factor, general, interval, listing, percent, scientific, shortest, span
from .finding import finding, names, verdict

UNIT = 2.0 ** -53
# By kind of curve: the name of the conversion, and its norm (from the largest coefficient to the largest coefficient).
NORMS = {
    "bernstein": ("Bernstein to power form", "max_j C(n,j) 2^j", lambda n: max(math.comb(n, j) * 2 ** j for j in range(n + 1))),
    "power": ("Power to Bernstein form", "(n+1)", lambda n: n + 1),
}
SOURCES = (("mean_conversion_error", "conversion"), ("mean_one_minus_t_error", "rounding of 1-t"),
           ("mean_evaluation_error", "evaluation"))


def scale(row):
    """The largest distance of a control point from the origin, with R in every coordinate."""
    return row.number("coordinate_range") * math.sqrt(row["dimension"] or 1)


def sources(bundle):
    """Accuracy rows whose error was decomposed."""
    rows = [r for r in bundle.exact("conversion").rows if all(r[c] is not None for c, _ in SOURCES)]
    if not rows:
        raise Missing("`accuracy.csv` has no row of the suite `conversion` with its error decomposed")
    return rows


def to_power(bundle):
    """Rows of Bernstein curves that are evaluated in several intervals of t."""
    rows = [r for r in bundle.exact("conversion").rows if r["form"] == "bernstein"]
    if len(distinct(rows, "interval")) < 2:
        raise Missing("`accuracy.csv` has no study of the suite `conversion` of Bézier curves with several intervals of t")
    return rows


def middle(row):
    """The middle of a row's interval of t."""
    return (row.number("t_min") + row.number("t_max")) / 2


def growth(start, t, degree):
    """The factor by which (1+2t)^n grows from `start` to `t`."""
    return ((1 + 2 * t) / (1 + 2 * start)) ** degree


WITHIN_NORM = 4  # times u R sqrt(d) norm, which the problem allows up to a constant


@finding("conversion")
def conversion_norm(bundle):
    """Holds where to Bernstein form some conversion keeps to the norm at every degree, and to power form every one does."""
    rows = [r for r in bundle["conversion.csv"].of_suite("conversion").rows if r["form"] in NORMS and isinstance(r["max_error"], float)
            and r["max_error"] > 0]
    if not rows:
        raise Missing("`conversion.csv` has no `conversion-` row that names its curve")

    def ratio(row):
        return row.number("max_error") / (UNIT * scale(row) * NORMS[row["form"]][2](int(row.number("degree"))))
    worst = {key: max(own, key=ratio) for key, own in grouped(rows, "form", "conversion").items()}
    kept, broken = ({c: [m for (curve, m), row in worst.items() if curve == c and (ratio(row) <= WITHIN_NORM) == within] for c in NORMS}
                    for within in (True, False))
    lines = []
    for curve, (title, formula, _) in NORMS.items():
        own = [ratio(worst[curve, m]) for m in kept[curve]]
        lines.append(f"{title}: {names(kept[curve]) or 'no conversion'} stays below {WITHIN_NORM} u R √d times {formula}"
                     + (f" ({span(min(own), max(own), factor)} times it at most)" if own else "")
                     + "".join(f"; `{m}` reaches {factor(ratio(worst[curve, m]))} times it at degree {worst[curve, m]['degree']:g}" for m in broken[curve]) + ".")
    exceeding = dict.fromkeys(m for some in broken.values() for m in some)
    return verdict(
        kept["power"] and not broken["bernstein"],
        "To power form every conversion loses what the problem itself loses; to Bernstein form, where the norm is only n+1, "
        f"{names(kept['power'])} {'keeps' if len(kept['power']) == 1 else 'keep'} to it"
        + (f" and {names(broken['power'])} exceeds it." if broken["power"] else "."),
        f"{count(len(exceeding), 'conversion exceeds', 'conversions exceed')} the norm: {names(exceeding)}.", *lines, rows=worst.values())


BAD = 10  # times the error of the best method that converts nothing, in the same cell


@finding("conversion")
def conversion_parts(bundle):
    """Holds where in every bad cell the conversion is the largest part of the error."""
    rows = sources(bundle)
    bad = []
    for cell in grouped(rows, "study", "degree", "interval").values():
        given = min((r.number("mean_error") for r in cell if ":" not in r["method"]), default=math.inf)
        bad += [r for r in cell if ":" in r["method"] and r.number("mean_error") > BAD * given]
    if not bad:
        raise Missing(f"no path of a `conversion-` study errs {BAD} times as much as a method that converts nothing")
    largest = [max(SOURCES, key=lambda source: r[source[0]])[1] for r in bad]
    of_conversion = largest.count("conversion")
    worst = max(bad, key=lambda r: r["mean_error"])
    parts = listing(f"{scientific(worst[column])} from {name}" for column, name in SOURCES)
    where = f"a path errs more than {BAD} times as much as the best method for the given form, the conversion is the largest part of its error"
    return verdict(
        of_conversion == len(bad), f"Wherever {where}: in all {len(bad)} cells.",
        f"Where {where} in {of_conversion} of {len(bad)} cells ({percent(of_conversion / len(bad))}), and "
        f"{listing(sorted(set(largest) - {'conversion'}))} in the others.",
        f"The worst is `{worst['method']}` at degree {worst['degree']:g}, t in {interval(*worst['interval'])}: of a mean error of "
        f"{scientific(worst['mean_error'])}, {parts}. The parts are averages over the trials whose error was decomposed and need not add up; "
        f"{general(len(rows))} cells have them.", rows=bad)


WITHIN_GROWTH = 10  # the norm, taken at the middles of intervals, bounds the growth up to a constant


@finding("conversion")
def conversion_growth(bundle):
    """Holds where no mean error grows from the first to the last interval more than a constant faster than (1+2t)^n."""
    grown = {}
    for (method, degree), rows in grouped((r for r in to_power(bundle) if ":" in r["method"] and r["mean_error"]), "method", "degree").items():
        first, last = (end(rows, key=middle) for end in (min, max))
        grown[method, degree] = last.number("mean_error") / first.number("mean_error"), growth(middle(first), middle(last), degree), first, last
    faster = dict.fromkeys(method for (method, _), (ours, norm, *_) in grown.items() if ours > WITHIN_GROWTH * norm)
    top = max(degree for _, degree in grown)
    at_top = {method: found for (method, degree), found in grown.items() if degree == top}
    method = max(at_top, key=lambda m: at_top[m][0])
    ours, norm, first, last = at_top[method]
    slow = [m for m, (a, b, *_) in at_top.items() if a < b / 100]
    return verdict(
        not faster, "Over t the error of every path through power form grows at most as (1+2t)^n, up to a constant.",
        f"The error of {names(faster)} grows over t faster than (1+2t)^n.",
        f"At degree {shortest(top)} from the middle of the first interval, t = {shortest(middle(first))}, to that of the last, t = {shortest(middle(last))}, "
        f"(1+2t)^n grows by {factor(norm)}; the mean error of `{method}`, which grows most, by {factor(ours)}, from {scientific(first['mean_error'])} to "
        f"{scientific(last['mean_error'])}." + (f" Errors of {names(slow)} grow by less than a hundredth of that." if slow else ""),
        rows=[r for _, _, *pair in grown.values() for r in pair])
