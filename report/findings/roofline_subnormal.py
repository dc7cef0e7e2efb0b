# SPDX-License-Identifier: MIT
"""The time that subnormal powers of t cost the methods that form them."""

from ..bundle import Missing
from ..document import Finding
from ..wording import general

SUITE = "roofline"
METHOD = "horner_bernstein_fma"
LEAST = 2  # times as long; no other difference between the two intervals of t has an effect of this size


def find(bundle):
    """Holds where the same work takes LEAST times as long over the whole of [0, 1] as in the middle of it."""
    rows = bundle["roofline.csv"].select(method=METHOD, scalar="float", study=("roofline-bezier", "roofline-middle"))
    pairs = [(whole, middle) for whole in rows if whole["study"] == "roofline-bezier"
             for middle in rows if middle["study"] == "roofline-middle"
             and all(whole[column] == middle[column] for column in ("degree", "dimension", "target", "mode"))]
    if not pairs:
        raise Missing(f"no row of `{METHOD}` in float is in both `roofline-bezier` and `roofline-middle`")
    slowest = max(pairs, key=lambda pair: pair[0].number("median_ns") / pair[1].number("median_ns"))
    whole, middle = slowest
    times = whole.number("median_ns") / middle.number("median_ns")
    where = f"`{METHOD}` in float at degree {whole.number('degree'):g} on {whole['target']}"
    return Finding(
        id="roofline_subnormal", about="suite", suite=SUITE, claim="", holds=times >= LEAST,
        headline=f"With t anywhere in [0, 1], {where} takes {general(times)} times as long as with t in the middle." if times >= LEAST
        else f"With t anywhere in [0, 1], {where} takes about as long as with t in the middle.",
        detail=(f"{general(whole['median_ns'])} ns per point for t drawn from [0, 1], {general(middle['median_ns'])} ns from "
                f"[{middle.number('t_min'):g}, {middle.number('t_max'):g}], with the same instructions. Powers of t near 0, and of "
                "1 - t near 1, are subnormal numbers in float at such degrees, "
                + ("and a processor that is slow with these waits with a whole vector for one of them. de Casteljau's algorithm forms "
                   "no powers." if times >= LEAST else f"which cost less than a factor of {LEAST} here."),),
        rows=slowest)
