// SPDX-License-Identifier: MIT
// Generator `weights_mild`: rational curves whose weights differ by a factor of four at most.
#pragma once

#include "experiments/sample/continuous.hpp"

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

}  // namespace bezierbench::sample
