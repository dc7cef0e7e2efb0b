// SPDX-License-Identifier: MIT
// Generator `dyadic`: as `continuous`, with a t for which 1 - t is exact.
#pragma once

#include <cmath>

#include "experiments/sample/continuous.hpp"

namespace bezierbench::sample {

/// Takes the words that `continuous` takes. Where t_min or t_max is not a multiple of 2^-53, t may leave the interval
/// by 2^-54.
struct Dyadic {
  static constexpr GeneratorInfo info{"dyadic", "as continuous",
                                      "as continuous, then rounded to a multiple of 2^-53, so that 1 - t is exact"};

  static double coordinate(Words& words, double range) { return Continuous::coordinate(words, range); }

  static double parameter(Words& words, suite::Interval interval) {
    const double t = Continuous::parameter(words, interval);
    if (std::abs(t) >= 0.5) return t;                   // already a multiple; the product below could overflow
    return std::nearbyint(t * 0x1p53) * 0x1p-53 + 0.0;  // ties to even; + 0.0 makes -0 a 0
  }
};

}  // namespace bezierbench::sample
