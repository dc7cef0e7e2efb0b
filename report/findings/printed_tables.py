# SPDX-License-Identifier: MIT
"""How well the tables of the source report are reproduced, and where its printed values come from."""

from collections import Counter
from dataclasses import dataclass
import math

from ..bundle import Missing
from ..document import Finding
from ..wording import as_printed, count, factor, general, listing, percent, scientific, shortest, span
from .finding import finding

ACCURACY_TABLES = ("2.3.1", "2.3.2", "2.3.3")


def accuracy_cells(bundle):
    """The distinct printed accuracy cells: the last range of 2.3.2 repeats the last degree of 2.3.1."""
    cells = {}
    for row in bundle["scorecard.csv"].some(table=ACCURACY_TABLES):
        key = tuple(row[c] for c in ("form", "method", "statistic", "degree", "coordinate_range", "t_min", "t_max"))
        cells.setdefault(key, row)
    return list(cells.values())


def experiments(cells):
    """The cells grouped by their random curves. The methods and statistics of one experiment share its trials, so that
    their deviations are correlated."""
    found = {}
    for row in cells:
        found.setdefault(tuple(row[c] for c in ("form", "degree", "coordinate_range", "t_min", "t_max")), []).append(row)
    return list(found.values())


@dataclass(frozen=True)
class Event:
    """A printed error or count with all cells that repeat it, since a table repeats a run of another or two methods err alike."""

    rows: tuple

    @property
    def verdict(self):
        """That of its cells; where they differ, the error of the band decides."""
        found = {row["verdict"] for row in self.rows}
        return found.pop() if len(found) == 1 else "edge"


def events(bundle):
    """The distinct errors and counts that the report prints, as Events."""
    found = {}
    for row in bundle["scorecard.csv"].rows:
        key = tuple(row[c] for c in ("form", "statistic", "degree", "coordinate_range", "t_min", "t_max", "published"))
        found.setdefault(key, []).append(row)
    return [Event(tuple(rows)) for rows in found.values()]


def against_exact(bundle, method, degree):
    """The row of most trials with the errors of a method for Bézier curves, inputs continuous, on the cells of table 2.3.1."""
    return bundle.accuracy(study="2.3.1-bezier", method=method, degree=degree, baseline="exact", generator="continuous")


def degrees(bundle):
    """The degrees that the source report prints, ascending."""
    rows = bundle["scorecard.csv"].some(table="2.3.1")
    return sorted({row.number("degree") for row in rows})


def series(bundle, axis, **key):
    """The cells of one printed row, ascending along an axis."""
    rows = bundle["scorecard.csv"].some(**key)
    return sorted(rows, key=lambda row: row.number(axis))


def per_degree(first, last, low, high):
    """The factor per degree by which an error grows from `first` at degree `low` to `last` at degree `high`."""
    if first * last < 0:
        raise Missing("an error is negative")
    return (last / first) ** (1 / (high - low))


# An error that grows by at least this factor per degree is called exponential.
EXPONENTIAL = 1.5
# Values that differ by less than this factor are called flat.
FLAT = 1.25


@finding()
def cells_inside(bundle):
    """Holds where no more events are outside than chance leaves there on average."""
    found = events(bundle)
    by = Counter(event.verdict for event in found)
    by_chance = sum(event.rows[0].number("chance_outside") for event in found)
    holds = by["outside"] <= by_chance
    outside = [event for event in found if event.verdict == "outside"]
    below = sum(event.rows[0].number("published") < event.rows[0].number("ours_p05") for event in outside)
    drawn = experiments(accuracy_cells(bundle))
    missed = sum(any(r["verdict"] == "outside" for r in one) for one in drawn)
    cells = sum(len(event.rows) for event in found)
    return Finding(
        id="cells_inside_band", about="reproduction", claim="", holds=holds,
        headline=f"{by['inside']} of the {len(found)} distinct errors and counts that the report prints lie inside our 5–95 % band, "
                 f"{by['edge']} on its edge and {by['outside']} outside, "
                 f"{'no more' if holds else 'more'} than the {general(by_chance, 2)} that chance leaves there on average; "
                 f"{by['explained']} more {'is' if by['explained'] == 1 else 'are'} explained.",
        detail=(f"Of those outside {below} lie below the band and {len(outside) - below} above"
                + ("." if holds else ": the experiment is not fully reproduced."),
                f"The accuracy cells are of {count(len(drawn), 'independent experiment')}, each a form, degree, range and interval. In "
                "our repetitions all methods and both statistics of an experiment share its trials and move together, so chance spreads "
                f"further than for single cells. {missed} of these experiments {'has' if missed == 1 else 'have'} a cell outside.",
                f"The report prints {cells} errors and counts, of which {cells - len(found)} repeat another of the same run: the last "
                "range of table 2.3.2 is the last degree of table 2.3.1, and two methods can agree to the printed digits."),
        rows=tuple(row for event in found if event.verdict != "inside" for row in event.rows))


DISTANCE = "1e-5"


@finding()
def round_trip_grid(bundle):
    """Holds where continuous inputs stay close clearly less often than the report's grid."""
    table = bundle["conversion.csv"]
    rows = {g: table.some(study="2.2", generator=g) for g in ("report", "continuous", "integer")}
    column = f"within_{DISTANCE}"
    share = {g: sum(r.number(column) for r in found) / sum(r.number("trials") for r in found)
             for g, found in rows.items()}
    cell = bundle["scorecard.csv"].one(table="2.2", statistic=f"count_within_{DISTANCE}")
    curves = round(cell.number("ours_median") / share["report"]) if share["report"] else 0
    holds = share["continuous"] * FLAT < share["report"] <= share["integer"]
    numbers = (f"Within {DISTANCE} stay {percent(share['report'])} of the curves on the report's grid, "
               f"{percent(share['continuous'])} with continuous coordinates and {percent(share['integer'])} with whole "
               f"numbers. The report prints {count(int(cell.number('published')), 'curve')}; we get "
               f"{general(cell.number('ours_median'))} [{general(cell.number('ours_p05'))} to "
               f"{general(cell.number('ours_p95'))}]"
               + (f" of about {curves}" if curves else "") + " with its generator.")
    return Finding(
        id="round_trip_grid", about="correction",
        claim=f"95 % of the random curves come back from the round trip within {DISTANCE} and all within 1e-1, which is negligible for "
              "their range, so the conversions are correct.", place="section 3.1, paragraph 1",
        holds=holds,
        headline=f"How many round trips stay within {DISTANCE} is a property of the grid, not of the conversions." if holds
        else f"The grid does not decide how many round trips stay within {DISTANCE} in this bundle.",
        detail=(numbers,), rows=(cell, *(r for found in rows.values() for r in found)))


@finding()
def timings_quantised(bundle):
    """Holds where every printed time is a whole number of ticks (milliseconds) and some are no more than one."""
    rows = bundle["scorecard_timing.csv"].some(table="2.4")
    printed = [r.number("published") for r in rows]
    tick = math.gcd(*map(int, printed)) if all(p == int(p) for p in printed) else 0
    small = [r for r in rows if r["published"] <= tick]
    holds = bool(tick and small)
    ours = [r.number("ours_median") for r in small] or [r.number("ours_median") for r in rows]
    prepared = [r for r in rows if r["prepared_median"] and ":" in r["method"]]
    gain = [r.number("ours_median") / r.number("prepared_median") for r in prepared]
    lines = [f"{len(small)} of the {count(len(rows), 'printed time')} are no more than one tick of {tick} ms. Where it prints "
             f"those, we measure {span(min(ours), max(ours), general)} µs per curve, a spread of "
             f"{general(max(ours) / min(ours), 2)}." if small else
             f"The {count(len(rows), 'printed time')} have no tick in common that any of them is as small as."]
    if gain:
        lines.append(f"The report charges the conversion to every point. Prepared once, a point on a converted curve costs "
                     f"{span(min(gain), max(gain), lambda v: general(v, 2))} times less"
                     + ("." if min(gain) > FLAT else ", so the conversion is not the larger part everywhere."))
    return Finding(
        id="timings_quantised", about="note", claim="", holds=holds,
        headline=f"The printed times are steps of a clock of {tick} ms: {len(small)} of {len(rows)} are 0 or {tick}." if holds else
        "The printed times are not whole steps of a clock in this bundle.",
        detail=tuple(lines), rows=tuple(rows))


DECADE = 10  # the factor of an exponent that is off by one


@finding()
def printed_slip(bundle):
    """Holds where an explained cell lies above the band and a tenth of it lies inside: a slip of the exponent."""
    explained = [r for r in accuracy_cells(bundle) if r["verdict"] == "explained"]
    if not explained:
        raise Missing("`scorecard.csv` has no explained accuracy cell")
    slips = [r for r in explained if r.number("published") > r.number("ours_p95")
             and r.number("ours_p05") <= r.number("published") / DECADE <= r.number("ours_p95")]
    holds = len(slips) == len(explained)
    values = listing(dict.fromkeys(as_printed(r["published"]) for r in explained))
    ratios = [r.number("published") / r.number("ours_median") for r in explained]
    places = listing(dict.fromkeys(f"table {r['table']}, R = {shortest(r['coordinate_range'])}" for r in explained))
    others = [r.number("published") / r.number("ours_median") for e in explained
              for r in bundle["scorecard.csv"].select(**{c: e[c] for c in ("table", "form", "method", "statistic")})
              if r["verdict"] != "explained"]
    if holds:
        headline = (f"{count(len(explained), 'cell')} reading {values} ({places}) "
                    f"{'is' if len(explained) == 1 else 'are'} a slip in the exponent.")
        detail = (f"Repetitions give {scientific(explained[0]['ours_median'])} there, {span(min(ratios), max(ratios), factor)} "
                  f"times less than printed, and a tenth of the printed value lies inside our band. In the other cells of "
                  f"{'its row' if len(explained) == 1 else 'these rows'} the printed value is "
                  f"{span(min(others), max(others), general)} times our median." if others else "",)
    else:
        headline = (f"{count(len(explained), 'cell')} reading {values} ({places}) cannot be called a slip in the exponent.")
        detail = (f"A tenth of the printed value lies inside our band in {len(slips)} of {len(explained)}; printed over our "
                  f"median is {span(min(ratios), max(ratios), general)}.",)
    return Finding(id="printed_slip", about="correction", claim=f"The largest error at {places} is {values}.",
                   holds=holds, headline=headline, detail=detail, rows=tuple(explained))
