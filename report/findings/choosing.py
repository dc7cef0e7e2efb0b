# SPDX-License-Identifier: MIT
"""Which methods are worth choosing, by time and error."""

from ..answer import useful
from ..bundle import Missing
from ..document import Finding
from ..wording import general, listing
from .series import names

SUITE = "speed"
ON, OFF = "yes", "no"


def race_cell(rows, curve, mode="point", scalar="double"):
    """{degree: rows, fastest first} of one form, mode and scalar type, in the plane."""
    degrees = {}
    for row in rows:
        if (row["curve"], row["mode"], row["scalar"], row["dimension"]) == (curve, mode, scalar, 2):
            degrees.setdefault(row["degree"], []).append(row)
    return {n: sorted(degrees[n], key=lambda r: r.number("ns")) for n in sorted(degrees)}


def find(bundle):
    """Holds where at every degree at least half of the methods are never worth choosing."""
    table = bundle["pareto.csv"].of_suite("speed")
    degrees = race_cell(table.rows, "bezier")
    if not degrees:
        raise Missing("`pareto.csv` has no Bézier curves in double, mode `point`")
    off = {n: [r for r in rows if r["pareto"] == OFF] for n, rows in degrees.items()}
    fewer = [f"{n:g}" for n, rows in degrees.items() if 2 * len(off[n]) < len(rows)]
    holds = not fewer
    top = max(degrees)
    front = [r for r in degrees[top] if r["pareto"] == ON and useful(r["observed_max_u"], r["scalar"])]
    steps = [f"`{r['method']}` ({general(r['ns'])} ns, at most {general(r['observed_max_u'])} u p~ seen)" for r in front]
    always = [m for m in dict.fromkeys(r["method"] for rows in degrees.values() for r in rows)
              if all(any(r["method"] == m and r["pareto"] == ON and useful(r["observed_max_u"], r["scalar"]) for r in rows) for rows in degrees.values())]
    return Finding(
        id="choosing", about="suite", suite=SUITE, claim="", holds=holds,
        headline=("At every degree at least half of the methods are beaten in both time and error by another: " if holds else
                  f"At degree {listing(fewer)} fewer than half of the methods are beaten in both time and error by another; ")
        + f"at degree {top:g} {len(off[top])} of {len(degrees[top])} are beaten, one point at a time.",
        detail=(f"Worth choosing at degree {top:g}, fastest first: {listing(steps)}.",
                f"Worth choosing at every degree: {names(always)}." if always else
                "No method is worth choosing at every degree."),
        rows=tuple(r for rows in degrees.values() for r in rows))
