# SPDX-License-Identifier: MIT
"""The gain of a search for worst cases over a sample."""

from ..document import Finding
from ..wording import count, factor, general, large, shortest
from .searched import GAIN, gain, rows_of
from .series import names

SUITE = "worst"


def find(bundle):
    """Holds where most cells gained what was asked."""
    rows = rows_of(bundle, "worst")
    by = {status: [r for r in rows if r["status"] == status] for status in ("reached", "near_bound", "short")}
    most = max(rows, key=gain)
    given = max((r for r in rows if ":" not in r["method"]), key=gain, default=None)
    cells = {r["search_id"]: f"{r['method']}, degree {shortest(r['degree'])}" for r in by["short"]}
    holds = 2 * len(by["reached"]) > len(rows)
    return Finding(
        id="worst_gain", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"The maximum of a sample is not the worst: searching finds at least {GAIN} times as much in "
                 f"{len(by['reached'])} of "
                 f"{count(len(rows), 'cell')}; in {len(by['near_bound'])} more the bound leaves no room for that."
        if holds else f"Searching gains {GAIN} times over the sample in only {len(by['reached'])} of "
                      f"{count(len(rows), 'cell')}.",
        detail=(f"The sample is {large(max(r['trials'] for r in rows))} trials, the search "
                f"{large(max(r['budget'] for r in rows))} steps from "
                f"its worst. The largest gain is {factor(gain(most))} (`{most['method']}`, degree {shortest(most['degree'])}: "
                f"{general(most['sampled_error_u'])} to {general(most['searched_error_u'])} u p~, `{most['search_id']}`)"
                + (f"; among the methods that evaluate the given form it is {factor(gain(given))} (`{given['method']}`, degree "
                   f"{shortest(given['degree'])}, `{given['search_id']}`)." if given else "."),
                f"Near the bound already: {names(dict.fromkeys(r['method'] for r in by['near_bound'])) or 'none'}. Short of "
                "the gain: "
                + (names(cells.values(), 8) if cells else "none") + "."),
        rows=tuple(by["short"] + [most]))
