# SPDX-License-Identifier: MIT
"""How far the fast reference tiers are from the exact value."""

from ..bundle import Missing
from ..document import Text
from ..tables import flat
from ..wording import general, large, shortest

TITLE = "Audit of the extended-precision tier"


def blocks(bundle, _findings):
    """The worst cells first said in words, then every row."""
    table = bundle["audit.csv"]
    if not table.rows:
        raise Missing("`audit.csv` has no rows")
    worst = max(table.rows, key=lambda r: r.number("max_axis_error_ulp"))
    yield Text(f"The tier `{worst['tier']}` is compared with the exact value on inputs of the suite. Its largest error is "
               f"{general(worst['max_axis_error_ulp'])} ulp of double on an axis (study {worst['study']}, degree {worst.text('degree')}, "
               f"generator `{worst['generator']}`)"
               + (": more than half an ulp, so it cannot serve as the truth without the check against the exact value."
                  if worst["max_axis_error_ulp"] > 0.5 else "."))
    columns = [("study", "study", str), ("tier", "tier", str), ("degree", "degree", shortest)]
    if "coordinate_range" in table.columns:
        columns.append(("R", "coordinate_range", shortest))
    columns += [("t from", "t_min", shortest), ("t to", "t_max", shortest)] if "t_min" in table.columns else []
    columns += [("inputs", "generator", str), ("trials", "trials", large), ("mean error, ulp", "mean_axis_error_ulp", general),
                ("largest error, ulp", "max_axis_error_ulp", general)]
    yield flat("audit-tiers", "Error of the tier against the exact value, in ulp of double", "扩展精度层相对精确值的误差（双精度 ulp）",
               table.rows, columns)
