# SPDX-License-Identifier: MIT
"""The source report's tables as curves."""

from ..bundle import Missing
from ..document import Text

TITLE = "Figures"
SUITE = "report"


def blocks(bundle, _findings):
    """Every figure that the bundle has the rows for."""
    from ..figures.printed import TABLES  # needs matplotlib, which --summary does without

    drawn = []
    for figure in TABLES:
        try:
            drawn.append(figure(bundle))
        except (Missing, ZeroDivisionError) as lack:
            drawn.append(Text(f"The figure {figure.__name__.replace('_', ' ')} is left out: {lack}."))
    if all(isinstance(block, Text) for block in drawn):
        raise Missing("the bundle has no `scorecard.csv` with the printed cells")
    yield Text("Lines are our medians, shaded bands hold 90 % of our repetitions, circles are the printed values. Dashed: the same "
               "with continuous inputs. Dotted: the same, measured against the exact value; where it cannot be seen it lies "
               "under the median.")
    yield from drawn
