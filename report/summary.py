# SPDX-License-Identifier: MIT
"""The scorecard and the findings as plain text for a terminal."""

import shutil
import textwrap

from .bundle import Missing
from .chapters.printed import MARK, counts
from .findings.roster import grouped
from .inline import to_plain

LONGEST = 100  # characters of a line, in a pipe, too


def text(bundle, findings):
    """What scripts/reproduce prints at its end."""
    found, undecided = findings
    width = min(shutil.get_terminal_size((LONGEST, 0)).columns, LONGEST)
    lines = [f"Scorecard of {bundle.name}"]
    try:
        tables = counts(bundle)
        lines.append("  " + f"{'table':<8}" + "".join(f"{v:>12}" for v in MARK) + f"{'cells':>8}")
        for number, verdicts in tables.items():
            lines.append("  " + f"{number:<8}" + "".join(f"{verdicts[v]:>12}" for v in MARK)
                         + f"{sum(verdicts.values()):>8}")
    except Missing as lack:
        lines.append(f"  none: {lack}")
    for heading, members in grouped(found):
        lines += ["", heading]
        for finding in members:
            lines += textwrap.wrap(to_plain(finding.headline), width, initial_indent="  - ", subsequent_indent="    ")
    if undecided:
        lines += ["", "What this bundle cannot decide"]
        for name, lack in undecided:
            lines += textwrap.wrap(f"{name.replace('_', ' ')}: {to_plain(lack)}", width, initial_indent="  - ",
                                   subsequent_indent="    ")
    return "\n".join(lines) + "\n"
