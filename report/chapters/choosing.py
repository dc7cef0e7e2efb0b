# SPDX-License-Identifier: MIT
"""Time against error: which methods are worth choosing, degree by degree."""

from ..answer import USELESS, lost, useful
from ..bundle import Missing
from ..document import Cell, Text
from ..methods import form
from ..tables import by_axis
from ..wording import general, listing, shortest
from .suite_parts import figure, of_suite

TITLE = "Time against error"
KIND = "timing"
SIGN = {"yes": " ✓", "unresolved": " ?", "no": ""}
KEY = ("study", "accuracy_study", "form", "scalar", "dimension")


def blocks(bundle, findings):
    """The finding, the figure, then a table for each form and scalar type of the methods that are ever worth choosing."""
    table = bundle["pareto.csv"]
    if not table.rows:
        raise Missing("`pareto.csv` has no rows")
    yield from of_suite(findings, "speed")
    yield from figure("time_against_error", bundle)
    yield Text("Each cell gives nanoseconds per point and the largest error seen, in units of u p~. ✓: no other method of the "
               "same race is at least as right and certainly faster. ✗: useless, since its largest error exceeds "
               f"{shortest(USELESS)} of p~, whatever its time. ?: one is at least as right and faster by its median, "
               "but the 99 % intervals of the two times overlap. Methods that are beaten everywhere are in `pareto.csv` only. "
               "`bezierbench choose BUNDLE --degree N --tolerance E` asks the same question for a tolerance.")
    kinds = {}
    for row in table.rows:
        kinds.setdefault(tuple(row[c] for c in KEY), []).append(row)
    for number, (key, rows) in enumerate(kinds.items(), 1):
        yield _table(number, dict(zip(KEY, key)), rows)


def _table(number, key, rows):
    worth = {(r["method"], r["mode"]) for r in rows if r["pareto"] != "no" and useful(r["observed_max_u"], key["scalar"])}
    english, chinese = form(key["form"])
    modes = list(dict.fromkeys(r["mode"] for r in rows))
    return by_axis(
        [r for r in rows if (r["method"], r["mode"]) in worth], "degree", f"choosing-{number}",
        f"Worth choosing, {english} ({key['scalar']}, {shortest(key['dimension'])} axes): times of `{key['study']}`, errors of "
        f"`{key['accuracy_study']}`, modes {listing(modes)}",
        f"值得选用的方法，{chinese}",
        [(mode, _cell, lambda r, mode=mode: r["mode"] == mode and (r["method"], mode) in worth) for mode in modes],
        row_head="mode")


def _cell(row):
    good, loss = useful(row["observed_max_u"], row["scalar"]), lost(row["observed_max_u"])
    text = ", ".join(filter(None, (f"{general(row['ns'])} ns", f"{general(row['observed_max_u'])} u", loss)))
    return Cell(text + (SIGN.get(row["pareto"], "") if good else " ✗"),
                f"{row.text('ns')} {row.text('observed_max_u')} {row.text('pareto')}",
                "outside" if not good else "inside" if row["pareto"] == "yes" and not loss else "")
