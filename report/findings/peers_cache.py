# SPDX-License-Identifier: MIT
"""The accuracy of Open CASCADE's cached power form against its own evaluation from the control points."""

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, general, scientific, shortest
from .series import by_degree

SUITE = "peers"
CACHED, DIRECT = "peer_occt_cached", "peer_occt_bsplclib"
LOSS = 1000  # three digits


def find(bundle):
    """Holds where at the highest degree the cache errs more than a thousand times as much, on average."""
    methods = by_degree(bundle.exact("peers").select(curve="bezier", scalar="double", dimension=2, method=(CACHED, DIRECT)))
    common = sorted(set(methods.get(CACHED, {})) & set(methods.get(DIRECT, {})))
    if not common:
        raise Missing(f"no degree of a `peers-` study has both `{CACHED}` and `{DIRECT}`")
    rows = [(methods[CACHED][n], methods[DIRECT][n]) for n in common]
    ratios = [a.number("mean_error") / b.number("mean_error") for a, b in rows]
    cached, direct = rows[-1]
    top, holds = shortest(common[-1]), ratios[-1] > LOSS
    lines = [f"Degree {shortest(n)}: {factor(ratio)} times the mean error; {general(a['max_error_u'])} u p~ at worst through the "
             f"cache, {general(b['max_error_u'])} from the control points." for n, ratio, (a, b) in zip(common, ratios, rows)]
    return Finding(
        id="peers_cache", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"The power form that Open CASCADE's adaptor keeps costs digits as the degree grows: at degree {top} its mean error "
                 f"is {factor(ratios[-1])} times that of its own evaluation from the control points "
                 f"({scientific(cached.number('mean_error'))} against {scientific(direct.number('mean_error'))})." if holds else
        f"The power form that Open CASCADE's adaptor keeps errs {factor(ratios[-1])} times as much at degree {top} as its own "
        "evaluation from the control points: no more than three digits are lost.",
        detail=tuple(lines), rows=tuple(r for pair in rows for r in pair))
