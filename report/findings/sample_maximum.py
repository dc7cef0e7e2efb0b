# SPDX-License-Identifier: MIT
"""The largest error of a sample against the largest of all trials."""

from ..document import Finding
from ..methods import yardstick
from ..wording import factor, general, large
from .printed import FLAT, accuracy_cells


def find(bundle):
    """Holds where the largest error over all pooled trials clearly exceeds the median of the printed statistic."""
    cells = [r for r in accuracy_cells(bundle) if r["statistic"] == "max_error" and r["table"] == "2.3.1"]
    found = []
    for cell in cells:
        pooled = bundle.accuracy(study=f"2.3.1-{cell['curve']}", method=cell["method"], baseline=yardstick(cell["curve"]),
                                 generator="report", degree=cell["degree"])
        found.append((pooled.number("max_error") / cell.number("ours_median"), cell, pooled))
    least, most = min(f[0] for f in found), max(f[0] for f in found)
    widths = sorted(r.number("ours_p95") / r.number("ours_p05") for r in cells)
    pooled = found[0][2]
    holds = least > FLAT
    return Finding(
        id="sample_maximum", about="note", claim="In all cases the largest error of evaluation is only 0.054.",
        place="section 3.1, paragraph 2", holds=holds,
        headline="The largest error of a sample is not a worst case." if holds else
        "The largest error of the report's sample is close to the largest that we found.",
        detail=(f"Over {large(pooled.number('trials'))} trials per cell the largest error is {factor(least)} to "
                f"{factor(most)} times the median of the report's statistic, and from one repetition to the next that statistic "
                f"varies by up to a factor of {general(widths[-1], 2)} (5 to 95 %).",),
        rows=tuple(r for f in found for r in f[1:]))
