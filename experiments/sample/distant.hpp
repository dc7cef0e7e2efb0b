// SPDX-License-Identifier: MIT
// Generator `distant`: small curves far from the origin, such as a road in a country's coordinates. Differences of
// control points lose twenty bits.
#pragma once

#include "experiments/sample/continuous.hpp"

namespace bezierbench::sample {

/// Takes the words that `continuous` takes.
struct Distant {
  static constexpr GeneratorInfo info{
      "distant",
      "uniform in [R (1 - 2^-20), R] from 128 random bits, rounded once; the lower end, "
      "too, is rounded",
      "as continuous"};

  static double coordinate(Words& words, double range) {
    return affine(range * (1 - 0x1p-20), range, words.next_uniform());
  }
  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }
};

}  // namespace bezierbench::sample
