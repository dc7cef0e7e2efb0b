# SPDX-License-Identifier: MIT
"""Which methods for Bézier curves can be used outside [0, 1]."""

from ..document import Finding
from ..wording import factor, general, interval, span
from .regimes import SUITE, study
from .series import names

RUINED = 10  # times the worst mean error within [0, 1] at the same degree


def _outside(row):
    return row["t_min"] < 0 or row["t_max"] > 1


def find(bundle):
    """Holds where every method that evaluates the given form is about as accurate outside [0, 1] as inside."""
    rows = [r for r in study(bundle, "parameter") if ":" not in r["method"] and isinstance(r["mean_error_u"], float)]
    worst = {}  # method: (ratio, row outside, row inside), at its worst degree
    for method in dict.fromkeys(r["method"] for r in rows):
        for degree in sorted({r["degree"] for r in rows}):
            own = [r for r in rows if r["method"] == method and r["degree"] == degree]
            inside, outside = [r for r in own if not _outside(r)], [r for r in own if _outside(r)]
            if inside and outside:
                a, b = (max(some, key=lambda r: r["mean_error_u"]) for some in (outside, inside))
                ratio = a["mean_error_u"] / b["mean_error_u"]
                worst[method] = max(worst.get(method, (0, a, b)), (ratio, a, b), key=lambda w: w[0])
    ruined = {m: w for m, w in worst.items() if w[0] > RUINED}
    fine = [w[0] for m, w in worst.items() if m not in ruined]
    steepest = max(worst.values(), key=lambda w: w[0])
    near = max((r for r in rows if not _outside(r)), key=lambda r: r["mean_error_u"])
    return Finding(
        id="regimes_parameter", about="suite", suite=SUITE, claim="", holds=not ruined,
        headline="Every method that evaluates the given form is as good outside [0, 1] as near its ends." if not ruined else
        f"Outside [0, 1] {names(ruined)} err by up to {general(steepest[1]['mean_error_u'])} u p~ on average; the other "
        f"{len(worst) - len(ruined)} methods that evaluate the given form are as good there as near the ends.",
        detail=(f"At its worst `{steepest[1]['method']}` errs {general(steepest[1]['mean_error_u'])} u p~ on average for t in "
                f"{interval(steepest[1]['t_min'], steepest[1]['t_max'])} at degree {steepest[1]['degree']:g}, against at most "
                f"{general(steepest[2]['mean_error_u'])} near the ends of [0, 1]."
                + (f" Of the others the worst outside is {span(min(fine), max(fine), factor)} times the worst near the ends." if fine and ruined
                   else ""),
                f"Near the ends the largest mean error is {general(near['mean_error_u'])} u p~ (`{near['method']}`, degree "
                f"{near['degree']:g}, t in {interval(near['t_min'], near['t_max'])})."),
        rows=(near, *(r for w in (ruined or worst).values() for r in w[1:])))
