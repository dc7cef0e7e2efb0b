# SPDX-License-Identifier: MIT
"""One colour for a method in every figure and page, and the methods that a figure shows until a reader asks for all.

The exception: of two methods that have the same colour, the later one takes another in a figure of both.
"""

from collections import Counter
from zlib import crc32

from ..answer import is_proved_small, useful
from ..rows import grouped

# Each has a contrast of at least 3 to light and to dark paper.
WELL_KNOWN = {
    "de_casteljau": "#2f7fc1", "horner_bernstein": "#d2691e", "direct": "#2a9d6f", "volk_schumaker": "#9754ad", "wozny_chudy": "#b8860b",
    "compensated_de_casteljau": "#c0506a", "horner_bernstein_fma": "#009fac", "correctly_rounded": "#5b7a99", "factorial:power_sum": "#8b5e3c",
    "factorial:horner": "#8a9600", "horner": "#c664a8", "power_sum": "#586bcb", "forward_substitution:de_casteljau": "#448823",
    "forward_substitution:direct": "#d8625c", "compensated_volk_schumaker": "#9477dd", "compensated_horner": "#238579",
}
PALETTE = tuple(WELL_KNOWN.values())
OTHERS = ("#9e5200", "#6a8f09", "#4a7dd9", "#c9593b", "#6058bb", "#007978", "#c0558b", "#a04a9e",
          "#a77600", "#0090aa", "#746b00", "#b43f54", "#1e9577", "#9765c6", "#1370a1", "#007f32")
MARKERS = ("o", "s", "^", "D", "v")
MOST = 8
FRONT = 5  # of them
RULE = f"up to {FRONT} that the bundle recommends or that no other dominates, in as many races as possible, the best known, and those with the least values"


def colours(bundle, methods):
    """{method: colour}. The best known have theirs; others take one by their place among those of their problem in the roster, or, where they are
    not in it, by their id. Of two alike among the first MOST the later takes the next that is free."""
    found = {}
    for at, method in enumerate(sorted(methods, key=lambda m: m not in WELL_KNOWN)):
        wheel, start = _place(bundle, method)
        taken = set(found.values()) if at < MOST else ()
        found[method] = next((c for c in wheel[start:] + wheel[:start] if c not in taken), wheel[start])
    return found


def _place(bundle, method):
    """(colours, the position at which the search for one begins)"""
    if method in WELL_KNOWN:
        return PALETTE, PALETTE.index(WELL_KNOWN[method])
    rows = bundle.tables["methods.csv"].rows if "methods.csv" in bundle else ()
    for problem, own in grouped(rows, "problem").items():
        ids = [m for m in dict.fromkeys(row["id"] for row in own) if ":" not in m and m not in WELL_KNOWN]
        if method in ids:
            wheel = OTHERS if problem == "evaluation" else PALETTE + OTHERS
            return wheel, ids.index(method) % len(wheel)
    return OTHERS, crc32(method.encode()) % len(OTHERS)


def looks(bundle, methods):
    """{method: how to draw it}: its colour, and a marker that tells it from its neighbours in this figure."""
    return {method: {"color": colour, "marker": MARKERS[at % len(MARKERS)], "markersize": 4.5} for at, (method, colour) in enumerate(colours(bundle, methods).items())}


def leading(bundle, methods, value):
    """At most MOST of the methods, by RULE; `value` has the number by which the last of them are chosen."""
    front = [r for r in bundle.tables["pareto.csv"].rows if r["pareto"] == "yes" and useful(r["observed_max_u"], r["scalar"])] if "pareto.csv" in bundle else []
    small = [r for r in front if is_proved_small(r["bound_u"], r["degree"], r["form"])]
    often = dict.fromkeys(method for rows in (small, front) for method, _ in Counter(r["method"] for r in rows).most_common() if method in methods)
    return list(dict.fromkeys(m for m in (*list(often)[:FRONT], *WELL_KNOWN, *sorted(methods, key=value)) if m in methods))[:MOST]


def chosen(shown, methods):
    """What a caption adds where a figure does not show all."""
    rule = RULE if WELL_KNOWN.keys() & set(shown) else "those with the least values"
    return f"{len(shown)} of {len(methods)} methods: {rule}" if len(shown) < len(methods) else ""
