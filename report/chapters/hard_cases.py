# SPDX-License-Identifier: MIT
"""Hard cases: how many inputs each search kept of each family, and how near to a rounding boundary the nearest lies."""

from decimal import Decimal

from ..document import Cell, Group, Table
from ..wording import general, large

SEARCHES = {"tie": "on a boundary", "nearest": "next to a boundary", "cancelled": "cancelled most", "zero": "cancelled to 0"}


def _cells(rows):
    """(number of cases, least distance from a rounding boundary in ulp) of a search; empty where it kept none."""
    if not rows:
        return [Cell(), Cell()]
    least = min((r.text("distance_ulp") for r in rows), key=Decimal)
    return [Cell(str(len(rows)), str(len(rows))), Cell(general(float(least)) if float(least) or not Decimal(least) else f"{Decimal(least):.2e}", least)]


def study_tables(bundle, study):
    """A table of the families of inputs, each with its searches."""
    rows = bundle["hard_cases.csv"].some(study=study)
    families = {}
    for row in rows:
        families.setdefault((row["family"], row["scalar"]), []).append(row)
    groups = tuple(Group(f"`{family}`, {scalar}", f"{family} {scalar}",
                         tuple((words, _cells([r for r in own if r["search"] == search])) for search, words in SEARCHES.items()
                               if any(r["search"] == search for r in own)))
                   for (family, scalar), own in families.items())
    yield Table(id=f"{study}-families", caption=f"Inputs kept by family ({large(max(r['drawn'] for r in rows))} drawn for each family): "
                "cases, and the least distance of an exact value from a rounding boundary in ulp",
                caption_zh="各类难例的数目及真值与舍入边界的最小距离（以 ulp 计）", groups=groups, head=("cases", "least distance"),
                group_head="family", row_head="search")
