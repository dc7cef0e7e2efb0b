# SPDX-License-Identifier: MIT
"""Whether other libraries are as accurate as our own plain methods."""

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, general, listing, shortest
from .series import by_degree

SUITE = "peers"
PEER = "peer_"
ALIKE = 10  # times the mean error of our own method


def find(bundle):
    """Holds where most methods of other libraries have at most `ALIKE` times the mean error of de Casteljau's algorithm at every
    degree."""
    methods = by_degree(bundle.exact("peers").select(curve="bezier", scalar="double", dimension=2))
    ours = methods.get("de_casteljau")
    theirs = {m: rows for m, rows in methods.items() if m.startswith(PEER)}
    if not ours or not theirs:
        raise Missing("a `peers-` study needs `de_casteljau` beside a method of another library")
    ratio = {m: max((rows[n]["mean_error"] / ours[n].number("mean_error"), n) for n in rows if n in ours) for m, rows in theirs.items()}
    far = [m for m in ratio if ratio[m][0] > ALIKE]
    near = [m for m in ratio if m not in far]
    holds = len(near) > len(far)
    lines = [f"`{m}`: at most {factor(ratio[m][0])} times, at degree {shortest(ratio[m][1])}, where it has "
             f"{general(theirs[m][ratio[m][1]]['mean_error_u'])} u p~." for m in ratio]
    return Finding(
        id="peers_accuracy", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"{len(near)} of {len(ratio)} methods of other libraries have at most {ALIKE} times the mean error of de Casteljau's "
                 "algorithm at every degree"
                 + (f"; not {listing(f'`{m}`' for m in far)}." if far else ".") if holds else
        f"Most methods of other libraries exceed {ALIKE} times the mean error of de Casteljau's algorithm at some degree: "
        f"{listing(f'`{m}`' for m in far)}.",
        detail=tuple(lines), rows=tuple(theirs[m][n] for m, (_, n) in ratio.items()))
