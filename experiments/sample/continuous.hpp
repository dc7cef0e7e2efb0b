// SPDX-License-Identifier: MIT
// Generator `continuous`: every double in the range can be drawn, with the probability of the reals that round to it.
#pragma once

#include "experiments/sample/affine.hpp"
#include "experiments/sample/generator.hpp"

namespace bezierbench::sample {

/// Takes two words for t and two per coordinate, the high one first.
struct Continuous {
  static constexpr GeneratorInfo info{"continuous", "uniform in [-R, R] from 128 random bits, rounded once",
                                      "uniform in [t_min, t_max] from 128 random bits, rounded once"};

  static double coordinate(Words& words, double range) { return affine(-range, range, words.next_uniform()); }
  static double parameter(Words& words, suite::Interval t) { return affine(t.min, t.max, words.next_uniform()); }
};

}  // namespace bezierbench::sample
