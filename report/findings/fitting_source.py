# SPDX-License-Identifier: MIT
"""Whether a fit to samples of a cubic is that cubic."""

from ..document import Finding
from ..wording import general, large, percent, scientific

SUITE = "fitting"
STUDY = "fitting-cubics"
METHOD, OTHER = "gauss_newton", "schneider"


def find(bundle):
    """Holds where, at the smallest tolerance, the orthogonal distance fit needs one segment for most sampled cubics and
    Schneider's fit for few."""
    table = bundle["fitting.csv"]
    rows = table.some(study=STUDY, data="samples", degree=3)
    smallest = min(r.number("tolerance") for r in rows)
    share, segments, used = {}, {}, []
    for method in (METHOD, OTHER):
        chosen = table.some(study=STUDY, data="samples", degree=3, tolerance=smallest, method=method)
        share[method] = sum(r.number("one_segment") for r in chosen) / sum(r.number("trials") for r in chosen)
        segments[method] = max(r.number("mean_segments") for r in chosen)
        used += chosen
    holds = share[METHOD] > 0.5 and share[OTHER] < 0.1
    given = f"{percent(share[METHOD])} of sampled cubics"
    where = f"at a tolerance of {scientific(smallest)}"
    return Finding(
        id="fitting_source", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"Orthogonal distances give {given} back as one segment {where}, Schneider's fit {percent(share[OTHER])}." if holds else
        f"Orthogonal distances give only {given} back as one segment {where}; Schneider's fit gives {percent(share[OTHER])}.",
        detail=(f"Segments on average: {general(segments[METHOD])} and {general(segments[OTHER])}, for "
                f"{large(used[0].number('points'))} points. Schneider's directions at the ends are chords of the data, and no "
                "iteration corrects them.",),
        rows=tuple(used))
