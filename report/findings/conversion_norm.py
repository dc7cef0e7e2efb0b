# SPDX-License-Identifier: MIT
"""Errors of converted coefficients against the norm of the conversion, the effect of rounding the given
coefficients."""

from ..bundle import Missing
from ..document import Finding
from ..wording import count, factor, listing, span
from .conversion import NORMS, SUITE, UNIT, scale
from .series import names

WITHIN = 4  # times u R sqrt(d) norm, which the problem allows up to a constant


def find(bundle):
    """Holds where to Bernstein form some conversion keeps to the norm at every degree, and to power form every one does."""
    table = bundle["conversion.csv"].of_suite("conversion")
    ratios = {}  # (curve, conversion): largest of error over u R sqrt(d) norm, with its row
    for row in table.rows:
        if row["curve"] in NORMS and isinstance(row["max_error"], float) and row["max_error"] > 0:
            _, _, norm = NORMS[row["curve"]]
            ratio = row.number("max_error") / (UNIT * scale(row) * norm(int(row.number("degree"))))
            key = (row["curve"], row["conversion"])
            ratios[key] = max(ratios.get(key, (0, row)), (ratio, row), key=lambda pair: pair[0])
    if not ratios:
        raise Missing("`conversion.csv` has no `conversion-` row that names its curve")
    kept = {c: [m for (curve, m), (ratio, _) in ratios.items() if curve == c and ratio <= WITHIN] for c in NORMS}
    broken = {key: pair for key, pair in ratios.items() if pair[0] > WITHIN}
    holds = bool(kept["polynomial"]) and not any(curve == "bezier" for curve, _ in broken)
    lines = []
    for curve, (title, formula, _) in NORMS.items():
        own = [ratios[key][0] for key in ratios if key[0] == curve and key not in broken]
        text = f"{title}: {names(kept[curve]) or 'none'} stay below {WITHIN} u R √d times {formula}"
        text += f" ({span(min(own), max(own), factor)} times it at their largest)" if own else ""
        text += "".join(f"; `{m}` reaches {factor(pair[0])} times it at degree {pair[1]['degree']:g}"
                        for (c, m), pair in broken.items() if c == curve)
        lines.append(text + ".")
    lost = listing(f"`{m}`" for c, m in broken if c == "polynomial")
    return Finding(
        id="conversion_norm", about="suite", suite=SUITE, claim="", holds=holds,
        headline="To power form every conversion loses what the problem itself loses; to Bernstein form, where the norm is "
                 "only n+1, "
                 f"{names(kept['polynomial'])} keep to it" + (f" and {lost} does not." if lost else ".") if holds else
        f"{count(len(broken), 'conversion exceeds', 'conversions exceed')} the norm: "
        f"{names(dict.fromkeys(m for _, m in broken))}.",
        detail=tuple(lines), rows=tuple(row for _, row in ratios.values()))
