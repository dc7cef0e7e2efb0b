// SPDX-License-Identifier: MIT
// Generators of rational curves.
#pragma once

#include <cmath>

#include "experiments/sample/independent_points.hpp"

namespace bezierbench::sample {

/// Takes the words that `continuous` takes, and two more per weight.
struct WeightsMild {
  static constexpr GeneratorInfo info{.id = "weights_mild",
                                      .coordinates = "as continuous",
                                      .t = "as continuous",
                                      .weights = "uniform in [1/2, 2] from 128 random bits, rounded once",
                                      .limits = {.weights = true}};

  static double coordinate(Words& words, double range) { return Continuous::coordinate(words, range); }
  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }
  static double weight(Words& words) { return affine(0.5, 2, words.next_uniform()); }
};

/// `weights_wild`: rational curves whose weights range over forty binades, so that a few dominate the curve.
/// Takes the words that `continuous` takes, and four more per weight: two for the exponent, two for the mantissa.
struct WeightsWild {
  static constexpr GeneratorInfo info{
      .id = "weights_wild",
      .coordinates = "as continuous",
      .t = "as continuous",
      .weights = "2^e m; e an integer, uniform in [-20, 20]; m uniform in [1, 2] from 128 random bits, rounded once",
      .limits = {.weights = true}};

  static double coordinate(Words& words, double range) { return Continuous::coordinate(words, range); }
  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }

  static double weight(Words& words) {
    const auto exponent = static_cast<int>(Integer::coordinate(words, largest_exponent));
    return std::ldexp(affine(1, 2, words.next_uniform()), exponent);  // exact
  }

 private:
  static constexpr double largest_exponent = 20;
};

}  // namespace bezierbench::sample
