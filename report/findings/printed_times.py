# SPDX-License-Identifier: MIT
"""The times that the source report prints, as ratios of two methods at one degree: no other machine repeats the times themselves."""

from collections import Counter
from dataclasses import dataclass
from itertools import combinations
import math

from ..bundle import Missing
from ..methods import FORM, name
from ..rows import Row, grouped
from ..wording import count, factor, general, listing, shortest
from .finding import finding, verdict

TICK = 1  # ms: a printed time is the difference of two readings of this clock, so that it may be off by almost as much either way
CLOSE = 2  # the factor up to which the ratios of two machines are called close
# fastest first, as the report concludes
ORDERS = {
    "bernstein": ("direct", "de_casteljau", "factorial:power_sum"),
    "power": ("power_sum", "forward_substitution:direct", "forward_substitution:de_casteljau"),
}
# (what it is called, how the scorecard counts it)
VERDICTS = {
    "agrees": ("agrees", "inside"), "close": (f"within a factor of {CLOSE}", "explained"), "kept": ("order kept", "explained"),
    "untestable": ("untestable", "untestable"), "apart": ("further apart, order open", "outside"), "reversed": ("order reversed", "outside"),
}


@dataclass(frozen=True)
class Ratio:
    """The time of `slower` over that of `faster`, as the report orders them: what the clock may have shown, and the interval of ours."""

    faster: Row
    slower: Row
    printed: tuple  # of (low, high), neither of which it reaches
    ours: tuple  # of (low, ratio, high)
    raced: tuple  # the rows of `ours`

    def __getitem__(self, column):
        """What both have in common, such as their degree; or the `label` of the ratio."""
        return self.label if column == "label" else self.faster[column]

    @property
    def label(self):
        return f"{name(self.slower['method'])} over {name(self.faster['method'])}"

    @property
    def gap(self):
        """The factor between the nearest ends of both intervals; below 1 where they overlap."""
        return max(self.printed[0] / self.ours[2], self.ours[0] / self.printed[1] if self.printed[1] else math.inf)

    @property
    def verdict(self):
        if self.printed == (0, math.inf):
            return "untestable"
        if self.gap < 1:
            return "agrees"
        order = ((self.printed[0] >= 1) - (self.printed[1] <= 1)) * ((self.ours[0] > 1) - (self.ours[2] < 1))
        if order < 0:
            return "reversed"
        return "close" if self.gap <= CLOSE else "kept" if order else "apart"


def _printed(faster, slower):
    above, below = slower.number("published"), faster.number("published")
    return max(above - TICK, 0) / (below + TICK), (above + TICK) / (below - TICK) if below > TICK else math.inf


def _ours(race, faster, slower):
    """The interval of the ratio of two methods of a race, of which one or both are measured against a third."""
    def of_base(method):
        row = race[method]
        return (1.0, 1.0, 1.0) if row["relative_to"] == method else tuple(row.number(c) for c in ("ratio_low", "ratio", "ratio_high"))
    below, above = of_base(faster), of_base(slower)
    return above[0] / below[2], above[1] / below[1], above[2] / below[0]


def ratios(bundle):
    """Every two methods of a degree of table 2.4, measured as the report does: preparation and one point for each curve."""
    found = []
    for (form, degree), rows in grouped(bundle["scorecard_timing.csv"].some(table="2.4"), "form", "degree").items():
        printed = {row["method"]: row for row in rows}
        race = {row["method"]: row for row in bundle["timing.csv"].some(form=form, degree=degree, mode="one_shot", scalar="double")
                if row["study"].startswith("2.4")}
        found += [Ratio(printed[a], printed[b], _printed(printed[a], printed[b]), _ours(race, a, b), (race[a], race[b]))
                  for a, b in combinations([m for m in ORDERS.get(form, ()) if m in printed and m in race], 2)]
    return found


@finding(about="reproduction")
def times_as_ratios(bundle):
    """Holds where no order of two methods that the clock shows is reversed, and most ratios agree or are close."""
    found = ratios(bundle)
    by = Counter(ratio.verdict for ratio in found)
    testable = [ratio for ratio in found if ratio.verdict != "untestable"]
    if not testable:
        raise Missing("`scorecard_timing.csv` and `timing.csv` have no ratio of times in common that the printed clock shows")
    turned = [ratio for ratio in found if ratio.verdict == "reversed"]
    said = (f"Of {count(len(testable), 'ratio')} of two printed times that its clock can show, {by['agrees']} agree with ours and "
            f"{by['close']} are within a factor of {CLOSE}")
    worst = max(testable, key=lambda ratio: ratio.gap)
    return verdict(
        not turned and 2 * (by["agrees"] + by["close"]) > len(testable),
        f"{said}; no order that it shows is reversed.",
        f"{said}; the order alone is kept by {by['kept']}{f''', left open by {by['apart']}''' if by['apart'] else ''}, and reversed by {by['reversed']}.",
        f"A printed time is a number of ticks of {TICK} ms and may be off by one, so a ratio of two is an interval. "
        f"{count(by['untestable'], 'other ratio')} may be anything.",
        f"The ratio that is furthest from its interval is {worst.label} at degree {shortest(worst['degree'])}, "
        f"{FORM[worst['form']][0]}: printed {words(*worst.printed)}, ours {general(worst.ours[1])} [{words(worst.ours[0], worst.ours[2])}], a factor of "
        f"{factor(worst.gap)}." if worst.gap > 1 else "",
        f"Reversed: {listing(f'''{ratio.label} at degree {shortest(ratio['degree'])}''' for ratio in turned)}." if turned else "",
        rows=dict.fromkeys(row for ratio in found for row in (ratio.faster, ratio.slower, *ratio.raced)))


def words(low, high):
    """`2 to 3`, `above 2`, `any`."""
    return "any" if (low, high) == (0, math.inf) else f"above {general(low)}" if high == math.inf else f"{general(low)} to {general(high)}"
