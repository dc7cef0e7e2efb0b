# SPDX-License-Identifier: MIT
"""What the suite `conversion` shows."""

import math

from ..bundle import Missing
from ..document import Finding
from ..wording import count, factor, general, interval, listing, percent, scientific, shortest, span
from .evaluators import names
from .finding import finding

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
    """Accuracy rows whose error was taken apart."""
    rows = [r for r in bundle.exact("conversion").rows if all(r[c] is not None for c, _ in SOURCES)]
    if not rows:
        raise Missing("`accuracy.csv` has no row of the suite `conversion` with its error taken apart")
    return rows


def to_power(bundle):
    """Rows of Bernstein curves that are evaluated in several intervals of t."""
    rows = [r for r in bundle.exact("conversion").rows if r["form"] == "bernstein"]
    if len({(r["t_min"], r["t_max"]) for r in rows}) < 2:
        raise Missing("`accuracy.csv` has no study of the suite `conversion` of Bézier curves with several intervals of t")
    return rows


def middle(row):
    """The middle of a row's interval of t."""
    return (row.number("t_min") + row.number("t_max")) / 2


def growth(start, t, degree):
    """The factor by which (1+2t)^n grows from `start` to `t`."""
    return ((1 + 2 * t) / (1 + 2 * start)) ** degree


WITHIN_NORM = 4  # times u R sqrt(d) norm, which the problem allows up to a constant


@finding(suite="conversion")
def conversion_norm(bundle):
    """Holds where to Bernstein form some conversion keeps to the norm at every degree, and to power form every one does."""
    table = bundle["conversion.csv"].of_suite("conversion")
    ratios = {}  # (curve, conversion): largest of error over u R sqrt(d) norm, with its row
    for row in table.rows:
        if row["form"] in NORMS and isinstance(row["max_error"], float) and row["max_error"] > 0:
            _, _, norm = NORMS[row["form"]]
            ratio = row.number("max_error") / (UNIT * scale(row) * norm(int(row.number("degree"))))
            key = (row["form"], row["conversion"])
            ratios[key] = max(ratios.get(key, (0, row)), (ratio, row), key=lambda pair: pair[0])
    if not ratios:
        raise Missing("`conversion.csv` has no `conversion-` row that names its curve")
    kept = {c: [m for (curve, m), (ratio, _) in ratios.items() if curve == c and ratio <= WITHIN_NORM] for c in NORMS}
    broken = {key: pair for key, pair in ratios.items() if pair[0] > WITHIN_NORM}
    holds = bool(kept["power"]) and not any(curve == "bernstein" for curve, _ in broken)
    lines = []
    for curve, (title, formula, _) in NORMS.items():
        own = [ratios[key][0] for key in ratios if key[0] == curve and key not in broken]
        text = f"{title}: {names(kept[curve]) or 'none'} stay below {WITHIN_NORM} u R √d times {formula}"
        text += f" ({span(min(own), max(own), factor)} times it at their largest)" if own else ""
        text += "".join(f"; `{m}` reaches {factor(pair[0])} times it at degree {pair[1]['degree']:g}"
                        for (c, m), pair in broken.items() if c == curve)
        lines.append(text + ".")
    lost = listing(f"`{m}`" for c, m in broken if c == "power")
    return Finding(
        id="conversion_norm", about="suite", suite="conversion", claim="", holds=holds,
        headline="To power form every conversion loses what the problem itself loses; to Bernstein form, where the norm is "
                 "only n+1, "
                 f"{names(kept['power'])} keep to it" + (f" and {lost} does not." if lost else ".") if holds else
        f"{count(len(broken), 'conversion exceeds', 'conversions exceed')} the norm: "
        f"{names(dict.fromkeys(m for _, m in broken))}.",
        detail=tuple(lines), rows=tuple(row for _, row in ratios.values()))


BAD = 10  # times the error of the best method that converts nothing, in the same cell


@finding(suite="conversion")
def conversion_parts(bundle):
    """Holds where in every bad cell the conversion is the largest part of the error."""
    rows = sources(bundle)
    given = {}
    for row in rows:
        if ":" not in row["method"]:
            key = tuple(row[c] for c in ("study", "degree", "t_min", "t_max"))
            given[key] = min(given.get(key, row.number("mean_error")), row.number("mean_error"))
    bad = [r for r in rows if ":" in r["method"]
           and r.number("mean_error") > BAD * given.get(tuple(r[c] for c in ("study", "degree", "t_min", "t_max")), float("inf"))]
    if not bad:
        raise Missing(f"no path of a `conversion-` study errs {BAD} times as much as a method that converts nothing")
    largest = {r: max(SOURCES, key=lambda source: r[source[0]])[1] for r in bad}
    of_conversion = sum(part == "conversion" for part in largest.values())
    worst = max(bad, key=lambda r: r["mean_error"])
    others = sorted({part for part in largest.values() if part != "conversion"})
    parts = listing(f"{scientific(worst[column])} from {name}" for column, name in SOURCES)
    return Finding(
        id="conversion_parts", about="suite", suite="conversion", claim="", holds=of_conversion == len(bad),
        headline=f"Wherever a path errs more than {BAD} times as much as the best method for the given form, the conversion "
                 "is the largest "
                 f"part of its error: in all {len(bad)} cells." if of_conversion == len(bad) else
        f"Where a path errs more than {BAD} times as much as the best method for the given form, the conversion is the "
        "largest part of its "
        f"error in {of_conversion} of {len(bad)} cells ({percent(of_conversion / len(bad))}), {listing(others)} in the others.",
        detail=(f"The worst is `{worst['method']}` at degree {worst['degree']:g}, t in "
                f"{interval(worst['t_min'], worst['t_max'])}: of a mean "
                f"error of {scientific(worst['mean_error'])}, {parts}. The parts are averages over the trials whose error "
                "was taken apart "
                f"and need not add up; {general(len(rows))} cells have them.",),
        rows=tuple(bad))


WITHIN_GROWTH = 10  # the norm, taken at the middles of intervals, bounds the growth up to a constant


@finding(suite="conversion")
def conversion_growth(bundle):
    """Holds where no mean error grows from the first to the last interval more than a constant faster than (1+2t)^n."""
    cells = {}
    for row in to_power(bundle):
        if ":" in row["method"] and row["mean_error"]:
            cells.setdefault((row["method"], row["degree"]), []).append(row)
    grown = {}
    for key, rows in cells.items():
        rows = sorted(rows, key=middle)
        first, last = rows[0], rows[-1]
        grown[key] = (last.number("mean_error") / first.number("mean_error"), growth(middle(first), middle(last), key[1]), first, last)
    faster = [key for key, (ours, norm, *_) in grown.items() if ours > WITHIN_GROWTH * norm]
    top = max(degree for _, degree in grown)
    method, _ = max((key for key in grown if key[1] == top), key=lambda key: grown[key][0])
    ours, norm, first, last = grown[method, top]
    slow = [m for (m, degree), (a, b, *_) in grown.items() if degree == top and a < b / 100]
    return Finding(
        id="conversion_growth", about="suite", suite="conversion", claim="", holds=not faster,
        headline="Over t the error of every path through power form grows at most as (1+2t)^n, up to a constant." if not faster else
        f"The error of {names(dict.fromkeys(m for m, _ in faster))} grows over t faster than (1+2t)^n.",
        detail=(f"At degree {shortest(top)} from the middle of the first interval, t = {shortest(middle(first))}, to that of "
                "the last, t = "
                f"{shortest(middle(last))}, (1+2t)^n grows by {factor(norm)}; the mean error of `{method}`, which grows "
                "most, by "
                f"{factor(ours)}, from {scientific(first['mean_error'])} to {scientific(last['mean_error'])}."
                + (f" Less than a hundredth of that growth have {names(slow)}." if slow else ""),),
        rows=tuple(r for _, _, *pair in grown.values() for r in pair))
