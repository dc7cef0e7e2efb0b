# SPDX-License-Identifier: MIT
"""The effect of wild weights on the errors of methods for rational curves."""

from ..bundle import Missing
from ..document import Finding
from ..wording import factor, general
from .series import best, by_degree, degrees, growth, names

SUITE = "rational"
MILD, WILD = "weights_mild", "weights_wild"
COST = 4  # times the error under mild weights


def find(bundle):
    """Holds where wild weights multiply no mean error over u p~ by more than a small constant."""
    table = bundle.exact("rational")
    ladder = next((s for s in table.distinct("study", scalar="double") if len(table.distinct("degree", study=s)) > 1), None)
    if ladder is None:
        raise Missing("`accuracy.csv` has no `rational-` study in double that varies the degree")
    methods = {g: by_degree(table.some(study=ladder, scalar="double", generator=g)) for g in (MILD, WILD)}
    pairs = [(rows[n], methods[WILD][m][n]) for m, rows in methods[MILD].items() for n in rows if n in methods[WILD].get(m, {})]
    if not pairs:
        raise Missing(f"no method has rows for both `{MILD}` and `{WILD}`")
    mild, wild = max(pairs, key=lambda p: p[1].number("mean_error_u") / p[0].number("mean_error_u"))
    ratio = wild["mean_error_u"] / mild["mean_error_u"]
    lines = []
    for g, some in methods.items():
        groups = {}
        for n, winners in best(some).items():
            groups.setdefault(winners, []).append(n)
        steepest = max(some, key=lambda m: growth(some[m]))
        lines.append(f"`{g}`: the least mean error has " + "; ".join(f"{names(w)} at {degrees(at)}" for w, at in groups.items())
                     + f". Over the ladder no mean error grows by more than a factor of {factor(growth(some[steepest]))} "
                       f"(`{steepest}`).")
    holds = ratio <= COST
    return Finding(
        id="rational_weights", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"Against `{MILD}`, the weights of `{WILD}` cost the methods for rational curves at most a factor of "
                 f"{factor(ratio)} in mean error over u p~." if holds else
        f"Against `{MILD}`, the weights of `{WILD}` cost `{wild['method']}` a factor of {factor(ratio)} in mean error over u p~.",
        detail=(f"The dearest is `{wild['method']}` at degree {wild['degree']:g}: {general(mild['mean_error_u'])} u p~ with "
                f"`{MILD}`, "
                f"{general(wild['mean_error_u'])} with `{WILD}`.", *lines),
        rows=(mild, wild, *(r for pair in pairs for r in pair)))
