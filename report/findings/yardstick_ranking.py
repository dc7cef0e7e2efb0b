# SPDX-License-Identifier: MIT
"""Direct evaluation against de Casteljau's algorithm, both compared with the truth."""

from ..document import Finding
from ..wording import count, general, large, listing, scientific
from .printed import against_exact, degrees


def find(bundle):
    """Holds where de Casteljau has the smaller mean error at most of the printed degrees."""
    pairs = [(n, *(against_exact(bundle, m, n) for m in ("de_casteljau", "direct"))) for n in degrees(bundle)]
    wins = [n for n, a, b in pairs if a.number("mean_error") < b.number("mean_error")]
    top, casteljau, direct = pairs[-1]
    ratio = direct.number("mean_error") / casteljau.number("mean_error")
    holds = 2 * len(wins) > len(pairs)
    worst = [r.number("max_error_u") for r in (casteljau, direct)]
    return Finding(
        id="yardstick_ranking", about="correction",
        claim="For Bézier curves direct evaluation is the most accurate, and de Casteljau comes second.",
        place="section 3.2, paragraph 1",
        holds=holds,
        headline=(f"Against the exact value de Casteljau is more accurate on average than direct evaluation at {len(wins)} of "
                  f"{count(len(pairs), 'degree')}" + (": the yardstick inverts the ranking." if holds else
                                                      ": the report's ranking stands.")),
        detail=(f"At degree {top:g}, over {large(direct['trials'])} trials, the mean errors are {scientific(casteljau['mean_error'])} (de Casteljau) and "
                f"{scientific(direct['mean_error'])} (direct), a ratio of {general(ratio)}; the largest are {general(worst[0])} "
                f"and {general(worst[1])} times u p~. The report could not see this: it had set the error of direct evaluation "
                "to zero.",
                *((f"De Casteljau is ahead at degree {listing(f'{n:g}' for n in wins)}.",) if 0 < len(wins) < len(pairs)
                  else ())),
        rows=tuple(r for _, a, b in pairs for r in (a, b)))
