# SPDX-License-Identifier: MIT
"""What the report knows of the columns of a bundle's tables before it reads one."""

import re

# Columns that are words wherever they occur, even where a value looks like a number (study 2.2, table 2.4).
TEXT = frozenset(
    "study accuracy_study table curve method conversion scalar generator baseline status statistic verdict note tier mode "
    "relative_to target goal_met quality checked pareto id problem form bound bit_stable flops citation worst_id search_id t "
    "coefficients coordinates weights placement spacing data kind bundle against file column fact cpu compiler machine "
    "normalised_verdict".split())

_ACCURACY = ("study curve method scalar dimension degree coordinate_range t_min t_max generator trials baseline status "
             "mean_error max_error mean_error_u max_error_u bound_u bound_violations non_finite").split()
_SCORECARD = ("table curve method statistic degree coordinate_range t_min t_max published ours_median ours_p05 ours_p95 "
              "verdict note").split()
_PROJECTION = ("study method dimension degree coordinate_range generator placement trials status missed max_error_eps max_t_error "
               "non_converged").split()
_ARC_LENGTH = ("study curve method scalar dimension degree coordinate_range t_min t_max generator tolerance trials status "
               "mean_relative max_relative mean_evaluations non_converged broken_promises non_finite").split()

# What the report reads from each file. Files that are not named here can be read too; their types are inferred.
REQUIRED = {
    "accuracy.csv": _ACCURACY,
    "unstable.csv": _ACCURACY,
    "scorecard.csv": _SCORECARD + ["continuous_median", "against_exact"],
    "scorecard_timing.csv": _SCORECARD + ["prepared_median"],
    "conversion.csv": ("study conversion degree coordinate_range generator trials mean_error max_error "
                       "within_1e-5 within_1e-3 within_0.1").split(),
    "derivative.csv": ("study curve method scalar dimension degree coordinate_range t_min t_max generator order trials status "
                       "mean_error max_error mean_error_u max_error_u bound_u bound_violations non_finite").split(),
    "arc_length.csv": _ARC_LENGTH,
    "arc_length_unstable.csv": _ARC_LENGTH,
    "inverse_arc_length.csv": ("study curve method scalar dimension degree coordinate_range t_min t_max generator tolerance trials "
                               "status mean_relative max_relative max_t_error mean_iterations max_iterations mean_evaluations "
                               "non_converged broken_promises outside non_finite").split(),
    "spacing.csv": "study dimension degree coordinate_range generator trial spacing index t x y share gap".split(),
    "projection.csv": _PROJECTION,
    "projection_unstable.csv": _PROJECTION,
    "interpolation.csv": ("study method scalar dimension degree coordinate_range generator points trials status max_error_u max_data_u "
                          "max_c0_u max_c1_u max_c2_u max_natural_u bound_u bound_violations non_finite").split(),
    "fitting.csv": ("study curve method scalar dimension degree coordinate_range generator data points tolerance trials status "
                    "mean_segments one_segment max_error max_error_over_tolerance max_iterations non_converged broken_promises "
                    "understated non_finite").split(),
    "fitting_example.csv": "study data tolerance method segment index x y".split(),
    "timing.csv": "study curve method degree mode median_ns low_ns high_ns checked".split(),
    "complexity.csv": "study curve method mode first_degree last_degree exponent exponent_low exponent_high claimed verdict".split(),
    "pareto.csv": ("study accuracy_study curve method scalar dimension degree mode ns ns_low ns_high observed_max_u bound_u "
                   "quality pareto").split(),
    "roofline.csv": ("study curve method scalar dimension degree target median_ns peak_gflops mixed_peak_gflops share_of_peak "
                     "goal_share goal_ns goal_met quality checked t_min t_max").split(),
    "audit.csv": "study curve tier degree generator trials".split(),
    "search.csv": ("search_id study curve method scalar dimension degree coordinate_range t_min t_max generator trials budget "
                   "status sampled_error_u searched_error_u bound_u error t coefficients").split(),
    "worst.csv": ("worst_id study curve method scalar dimension degree coordinate_range t_min t_max generator trial error "
                  "error_u t coefficients").split(),
    "comparison.csv": ("kind study method degree mode a b ratio ratio_low ratio_high verdict against bundle file column "
                       "quality normalised normalised_low normalised_high normalised_verdict rank_a rank_b").split(),
    "facts.csv": "against bundle fact a b".split(),
    "standings.csv": "rank bundle cpu compiler machine accuracy_rows_differing timings mean_ratio mean_normalised".split(),
    "generators.csv": "id coordinates t weights".split(),
    "methods.csv": "id problem form min_degree max_degree bound bit_stable flops citation".split(),
}

# Columns that say what a row is about; a row of the files above without one of them is malformed.
KEYS = frozenset("study accuracy_study pareto table curve method conversion scalar dimension degree generator order points tolerance "
                 "trials baseline status statistic tier mode id search_id worst_id target placement spacing data".split())
# The exceptions: a sentinel is timed over all degrees of a study; data that curves are fitted to are no method's.
MAY_BE_EMPTY = frozenset({("timing.csv", "degree"), ("fitting_example.csv", "method")})
# Tables in which it depends on the row which columns apply and whether they hold a number.
MIXED = frozenset({"comparison.csv", "facts.csv"})

# Ids of studies and suites as a suite has to write them, and of what it names: a path is `conversion:evaluator`.
ID = re.compile(r"[A-Za-z0-9._-]+")
NAME = re.compile(r"[A-Za-z0-9._:+-]+")
IDS = frozenset("study accuracy_study worst_id search_id".split())
NAMES = frozenset("method conversion curve scalar generator mode".split())
MOST_DEGREE = 1023  # of a suite
