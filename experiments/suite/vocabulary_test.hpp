// SPDX-License-Identifier: MIT
// Known ids for tests of this folder.
#pragma once

#include <string>

#include "experiments/failure.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/suite/vocabulary.hpp"

namespace bezierbench::suite {

inline const Vocabulary& test_vocabulary() {
  static const Vocabulary known{studies::kinds(),
                                {"direct",
                                 "direct_pow",
                                 "de_casteljau",
                                 "de_casteljau_lerp",
                                 "horner_bernstein",
                                 "power_sum",
                                 "horner",
                                 "factorial:power_sum",
                                 "factorial:horner",
                                 "forward_substitution:de_casteljau",
                                 "forward_substitution:direct",
                                 "positive_sum:de_casteljau",
                                 "positive_sum:de_casteljau_lerp",
                                 "positive_sum:direct_pow",
                                 "positive_sum:horner_bernstein",
                                 "horner_bernstein_fma",
                                 "differences_horner",
                                 "gauss_legendre_adaptive",
                                 "bracketed_newton",
                                 "quintic_isolate",
                                 "c2_natural",
                                 "schneider",
                                 "forward_differencing",
                                 "de_boor",
                                 "de_casteljau_split",
                                 "wang_count",
                                 "exact_box",
                                 "lane_riesenfeld",
                                 "easing_halley"},
                                {"factorial", "differences", "forward_substitution", "positive_sum", "exact"},
                                {{"continuous", {}},
                                 {"dyadic", {}},
                                 {"integer", {.smallest_range = 1, .largest_range = 0x1p53}},
                                 {"report", {.finite_width = true}},
                                 {"weights_mild", {.weights = true}},
                                 {"weights_wild", {.weights = true}},
                                 {"multiple_root",
                                  {.whole_curve = true,
                                   .bezier_degree = 33,
                                   .polynomial_degree = 27,
                                   .smallest_range = 0x1p-900,
                                   .largest_range = 0x1p900,
                                   .exact_coefficients = true}}},
                                {"report_tables.csv"},
                                {{"peer_gsl", "configure with peers"}}};
  return known;
}

/// The message of the failure of `action`; empty where it does not fail. For a failure that is not one of usage, and
/// for one of several lines, a text that says so and that matches no expected message.
template <class Action>
std::string failure_of(Action action) {
  try {
    action();
  } catch (const Failure& failure) {
    const std::string line = failure.what();
    if (failure.exit() != Exit::usage) return "not Exit::usage: " + line;
    return line.find('\n') == std::string::npos ? line : "more than one line: " + line;
  }
  return {};
}

}  // namespace bezierbench::suite
