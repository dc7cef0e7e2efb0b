# SPDX-License-Identifier: MIT
"""Definitions: what every column means."""

from ..document import Definitions, Text

TITLE = "How it was measured"


def blocks(_bundle, _findings):
    """Words that hold for every bundle; numbers stand in the suite below."""
    yield Text("The true point is computed exactly: control points and t are binary fractions, so the point of a Bézier curve is "
               "one too, and of a polynomial curve likewise. Errors are distances to it unless a yardstick is named.")
    yield Definitions((
        ("error", "Euclidean distance in coordinate units, rounded to 24 significant bits"),
        ("u, ulp", "u = 2^-53 is the unit roundoff of double; an ulp is the spacing of doubles at the exact value"),
        ("p~", "the sum of the absolute terms of the curve at t, over the coefficients in the form in which it is given"),
        ("`mean_error_u`, `max_error_u`", "error over u p~: what rounding alone would give is of order one"),
        ("`bound_u`", "the largest of proved bound over u p~ among the trials"),
        ("`bound_violations`", "trials whose error exceeds the proved bound; anything but none is a mistake in bound or code"),
        ("relative error", "error over the size of the exact point; `p50_relative` is the median over the trials of a cell"),
        ("condition number", "p~/|p|: by what relative errors of the coefficients can grow at t; `p50_condition` is its "
                             "median"),
        ("conversion, rounding of 1-t, evaluation", "parts of the error of a path, on as many trials as `decomposed_trials`: "
                                                    "the converted "
                                                    "curve against the given one, the curve with 1-t rounded against that, "
                                                    "and the "
                                                    "computed point against that; they need not add up"),
        ("searched maximum", "the largest error over u p~ that a climb over control points and t reached from the worst of "
                             "the sample"),
        ("`baseline`", "what the error is measured against: `exact`, or the report's yardstick (`direct` for Bézier curves, "
                       "`power_sum` for polynomial curves)"),
        ("replicate", "one independent repetition of the report's experiment; the band is over replicates"),
        ("generator `report`", "the random grid that the printed tables betray: coordinates on a decimal grid, t on a 15-bit grid"),
        ("generator `continuous`", "coordinates and t use every bit of a double"),
        ("generator `dyadic`", "as `continuous`, with t rounded so that 1-t is exact"),
        ("generator `integer`", "whole-number coordinates"),
        ("generators `multiple_root`, `clustered_roots`", "curves whose coordinates vanish at a multiple root or near a "
                                                          "cluster, with exact "
                                                         "coefficients"),
        ("generator `distant`", "coordinates in [R (1 - 2^-20), R]: small curves far from the origin"),
        ("generators `weights_mild`, `weights_wild`", "rational curves with weights in [1/2, 2], and over forty powers of two"),
        ("path", "`conversion:evaluator`: convert to the other form, then evaluate there"),
        ("time", "median over rounds; the report charges the conversion to every curve, `prepared` does it once"),
    ))
