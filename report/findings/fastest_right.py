# SPDX-License-Identifier: MIT
"""Which method of a companion problem is the fastest of those that are right, as the findings about their times say it."""

from ..bundle import Missing
from ..document import Finding
from ..wording import count, factor, listing, span

SUITE = "companion_speed"


def fastest_right(bundle, finding_id, study, best, answers, belongs=lambda row: True):
    """Holds where `best` is right and every other right method takes longer in every race that belongs, by the interval of the
    ratio to `best`, taken round by round."""
    rows = [r for r in bundle["timing.csv"].some(study=study) if r["degree"] is not None and belongs(r)]
    own = [r for r in rows if r["method"] == best]
    others = [r for r in rows if r["method"] != best and r["relative_to"] == best]
    right = [r for r in others if r["checked"] == "yes"]
    if not own or not right:
        raise Missing(f"`{study}` needs ratios to `{best}` of another method that is right")
    beaten = [r for r in right if r.number("ratio_low") > 1]
    holds = len(beaten) == len(right) and all(r["checked"] == "yes" for r in own)

    def ratios(of):
        methods = {}
        for row in of:
            methods.setdefault(row["method"], []).append(row.number("ratio"))
        return listing(f"`{m}` {span(min(r), max(r), factor)}" for m, r in methods.items())
    wrong = [r for r in others if r["checked"] != "yes"]
    return Finding(
        id=finding_id, about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"{answers} come fastest by `{best}`, of the methods that are right." if holds else
        f"{answers} do not always come fastest by `{best}`: it is certainly faster than {len(beaten)} of "
        f"{count(len(right), 'right rival')}.",
        detail=(f"Times of the others over its own, in {count(len(own), 'race')}: {ratios(right)}.",
                f"Where answers were not right: {ratios(wrong)}." if wrong else ""),
        rows=(*own, *others))
