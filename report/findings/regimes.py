# SPDX-License-Identifier: MIT
"""For the findings about regimes: one study, and the factor by which a method's mean error varies over its axis."""

from dataclasses import dataclass

from ..bundle import Missing, Row
from ..wording import count

SUITE = "regimes"
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
