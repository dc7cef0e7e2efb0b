# SPDX-License-Identifier: MIT
"""How well the tables of the source report are reproduced, and where its printed values come from."""

from collections import Counter
from dataclasses import dataclass
import math
from pathlib import Path

from .. import files
from ..bundle import Missing
from ..rows import Row, grouped
from ..wording import as_printed, count, factor, general, listing, percent, scientific, shortest, span
from .finding import finding, trials_of, verdict

BAND = 0.95 - 0.05
RARE = 0.05  # a probability below which chance does not explain them
ACCURACY_TABLES = ("2.3.1", "2.3.2", "2.3.3")


def accuracy_cells(bundle):
    """The distinct printed accuracy cells: the last range of 2.3.2 repeats the last degree of 2.3.1."""
    cells = grouped(bundle["scorecard.csv"].some(table=ACCURACY_TABLES), "form", "method", "statistic", "degree", "coordinate_range", "interval")
    return [rows[0] for rows in cells.values()]


def experiments(cells):
    """The cells grouped by their random curves. The methods and statistics of one experiment share its trials, so that
    their deviations are correlated."""
    return list(grouped(cells, "form", "degree", "coordinate_range", "interval").values())


@dataclass(frozen=True)
class Event:
    """A printed error or count with all cells that repeat it, since a table repeats a run of another or two methods err alike."""

    rows: tuple

    @property
    def verdict(self):
        """That of its cells; where they differ, the error of the band decides."""
        found = {row["verdict"] for row in self.rows}
        return found.pop() if len(found) == 1 else "edge"

    @property
    def chance(self):
        """The probability that a repetition of the report's experiment is called outside."""
        return self.rows[0].number("chance_outside")


def events(bundle):
    """The distinct errors and counts that the report prints, as Events."""
    found = grouped(bundle["scorecard.csv"].rows, "form", "statistic", "degree", "coordinate_range", "interval", "published")
    return [Event(tuple(rows)) for rows in found.values()]


def outside_by_chance(found):
    """(how many of these events chance leaves outside on average, the probability that it leaves as many outside as there are, if the
    events were independent)."""
    expected = sum(event.chance for event in found)
    share, n = expected / len(found), len(found)
    outside = sum(event.verdict == "outside" for event in found)
    return expected, math.fsum(math.comb(n, k) * share ** k * (1 - share) ** (n - k) for k in range(outside, n + 1))


def against_exact(bundle, method, degree):
    """The row of most trials with the errors of a method for Bézier curves, inputs continuous, on the cells of table 2.3.1."""
    return bundle.accuracy(study="2.3.1-bezier", method=method, degree=degree, baseline="exact", generator="continuous")


def printed_degrees(bundle):
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


def verdicts(found):
    """How many events have which verdict, in words, and whether chance explains those outside."""
    by = Counter(event.verdict for event in found)
    expected, probability = outside_by_chance(found)
    holds = probability >= RARE
    return by, holds, (f"{'as many as' if holds else 'more than'} chance leaves outside, which are {general(expected, 2)} of "
                       f"{len(found)} on average")


@finding(about="reproduction")
def cells_inside_band(bundle):
    """Holds where chance leaves as many events outside as there are, except for a rare accident."""
    found = events(bundle)
    by, holds, chance = verdicts(found)
    outside = [event for event in found if event.verdict == "outside"]
    below = sum(event.rows[0].number("published") < event.rows[0].number("ours_p05") for event in outside)
    drawn = experiments(accuracy_cells(bundle))
    missed = sum(any(r["verdict"] == "outside" for r in one) for one in drawn)
    cells = sum(len(event.rows) for event in found)
    said = (f"Of the {len(found)} distinct errors and counts that the report prints, {by['inside']} lie inside our 5–95 % band, {by['edge']} on its edge, "
            f"{by['explained']} outside for a stated cause and {by['outside']} outside, {chance}")
    return verdict(
        holds, f"{said}.", f"{said}: the experiment is not fully reproduced.",
        f"Of those outside {below} lie below the band and {len(outside) - below} above. If they were independent, chance would leave at least as many outside "
        f"with a probability of {percent(outside_by_chance(found)[1])}.",
        f"The accuracy cells are of {count(len(drawn), 'independent experiment')}, each a form, degree, range and interval. In our repetitions all methods and "
        "both statistics of an experiment share its trials and move together, so chance spreads further than for single cells. Experiments with a cell "
        f"outside: {missed}.",
        f"The report prints {cells} errors and counts, of which {cells - len(found)} repeat another of the same run: the last range of table 2.3.2 is the last "
        "degree of table 2.3.1, and two methods can agree to the printed digits.",
        rows=[row for event in found if event.verdict != "inside" for row in event.rows])


WORKED = Path(__file__).resolve().parents[2] / "reference/published/worked_conversions.csv"


def worked():
    """The worked conversions that the source report prints: [(row, its control points, its coefficients, the coefficients that are exact)], a row
    for each axis."""
    columns, lines = files.table(WORKED, files.content(WORKED))
    rows = [Row(WORKED.name, line, dict(zip(columns, fields)), dict(zip(columns, fields))) for line, fields in lines]
    return [(row, *(list(map(int, row[c].split())) for c in ("control_points", "coefficients")), _power([int(b) for b in row["control_points"].split()]))
            for row in rows]


def _power(b):
    """[Report 001], section 1.1, in whole numbers: C(n,j) sum_i (-1)^(j-i) C(j,i) b_i."""
    return [math.comb(len(b) - 1, j) * sum((-1) ** (j - i) * math.comb(j, i) * b[i] for i in range(j + 1)) for j in range(len(b))]


@finding(about="conclusion", claim="The results of the five worked conversions are completely correct.", place="section 2.2, table; section 3.1, paragraph 1")
def worked_conversions(bundle):
    """Holds where the printed coefficients are exact, and round trips of whole numbers of the same degrees come back without an error."""
    found = worked()
    right = [row for row, _, printed, exact in found if printed == exact]
    trips = bundle["conversion.csv"].some(study="2.2", generator="integer", degree={float(row["degree"]) for row, *_ in found})
    largest = max(row.number("max_error") for row in trips)
    examples = {row["example"] for row, *_ in found}
    good = examples - {row["example"] for row, *_ in found if row not in right}
    said = f"{len(good)} of the {len(examples)} worked conversions are exact"
    return verdict(
        len(good) == len(examples) and largest == 0, f"{said}, as the report says.", f"{said}; round trips of whole numbers err by up to {scientific(largest)}.",
        f"The printed coefficients of {len(right)} of {count(len(found), 'axis', 'axes')} are those that follow from the control points in whole numbers.",
        f"In {trials_of(trips)} round trips of random whole numbers of up to {shortest(max(row.number('coordinate_range') for row in trips))}, of the "
        f"same degrees, the largest error is {scientific(largest)}.", rows=[*(row for row, *_ in found), *trips])


DISTANCE = "1e-5"


@finding(about="correction", claim=f"95 % of the random curves come back from the round trip within {DISTANCE} and all within 1e-1, which is negligible "
         "for their range, so the conversions are correct.", place="section 3.1, paragraph 1")
def round_trip_grid(bundle):
    """Holds where continuous inputs stay close clearly less often than the report's grid."""
    rows = {g: bundle["conversion.csv"].some(study="2.2", generator=g) for g in ("report", "continuous", "integer")}
    share = {g: sum(r.number(f"within_{DISTANCE}") for r in found) / sum(r.number("trials") for r in found) for g, found in rows.items()}
    cell = bundle["scorecard.csv"].one(table="2.2", statistic=f"count_within_{DISTANCE}")
    ours = [general(cell.number(c)) for c in ("ours_median", "ours_p05", "ours_p95")]
    curves = f" of about {round(cell['ours_median'] / share['report'])}" if share["report"] else ""
    return verdict(
        share["continuous"] * FLAT < share["report"] <= share["integer"],
        f"How many round trips stay within {DISTANCE} is a property of the grid, not of the conversions.",
        f"The grid does not decide how many round trips stay within {DISTANCE} in this bundle.",
        f"Within {DISTANCE} stay {percent(share['report'])} of the curves on the report's grid, {percent(share['continuous'])} with continuous coordinates and "
        f"{percent(share['integer'])} with whole numbers. The report prints {count(int(cell.number('published')), 'curve')}; we get {ours[0]} [{ours[1]} to "
        f"{ours[2]}]{curves} with its generator.", rows=(cell, *(r for found in rows.values() for r in found)))


@finding(about="note")
def timings_quantised(bundle):
    """Holds where every printed time is a whole number of ticks (milliseconds) and some are at most one."""
    rows = bundle["scorecard_timing.csv"].some(table="2.4")
    printed = [r.number("published") for r in rows]
    tick = math.gcd(*map(int, printed)) if all(p == int(p) for p in printed) else 0
    small = [r for r in rows if r["published"] <= tick]
    ours = [r.number("ours_median") for r in small]
    gain = [r.number("ours_median") / r.number("prepared_median") for r in rows if r["prepared_median"] and ":" in r["method"]]
    return verdict(
        tick and small, f"The printed times are steps of a clock of {tick} ms: {len(small)} of {len(rows)} are 0 or {tick}.",
        "The printed times are not whole steps of a clock in this bundle.",
        f"{len(small)} of the {count(len(rows), 'printed time')} are at most one tick of {tick} ms. Where it prints those, we measure "
        f"{span(min(ours), max(ours), general)} µs per curve, a spread of {general(max(ours) / min(ours), 2)}." if small else "",
        "The report charges the conversion to every point. Prepared once, a point on a converted curve costs "
        f"{span(min(gain), max(gain), lambda v: general(v, 2))} times less"
        + ("." if min(gain) > FLAT else ", so the conversion is not the larger part everywhere.") if gain else "", rows=rows)


DECADE = 10  # the factor of an exponent that is off by one


@finding(about="correction")
def printed_slip(bundle):
    """Holds where an explained cell lies above the band and a tenth of it lies inside: a slip of the exponent."""
    explained = [r for r in accuracy_cells(bundle) if r["verdict"] == "explained"]
    if not explained:
        raise Missing("`scorecard.csv` has no explained accuracy cell")
    slips = [r for r in explained if r.number("published") > r.number("ours_p95")
             and r.number("ours_p05") <= r.number("published") / DECADE <= r.number("ours_p95")]
    values = listing(dict.fromkeys(as_printed(r["published"]) for r in explained))
    places = listing(dict.fromkeys(f"table {r['table']}, R = {shortest(r['coordinate_range'])}" for r in explained))
    ratios = [r.number("published") / r.number("ours_median") for r in explained]
    others = [r.number("published") / r.number("ours_median") for e in explained
              for r in bundle["scorecard.csv"].select(**{c: e[c] for c in ("table", "form", "method", "statistic")}) if r["verdict"] != "explained"]
    cells = f"The printed {values} ({places}, {count(len(explained), 'cell')})"
    return verdict(
        len(slips) == len(explained), f"{cells} has a slip in the exponent.", f"{cells} cannot be explained by a slip in the exponent.",
        f"Repetitions give {scientific(explained[0]['ours_median'])} there; the printed value is {span(min(ratios), max(ratios), factor)} times as large. A "
        f"tenth of it lies inside our band in {len(slips)} of {count(len(explained), 'cell')}."
        + (f" In the other cells of the row the printed value is {span(min(others), max(others), general)} times our median." if others else ""),
        rows=explained, claim=f"The largest error at {places} is {values}.")
