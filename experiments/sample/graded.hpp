// SPDX-License-Identifier: MIT
// Generator `graded`: coordinates from sixty binades in one curve, so that sums with large ones lose the small ones.
#pragma once

#include <cmath>

#include "experiments/sample/continuous.hpp"

namespace bezierbench::sample {

/// Takes four words per coordinate, two for the exponent before the two that `continuous` takes.
struct Graded {
  static constexpr GeneratorInfo info{
      .id = "graded", .coordinates = "2^-e c; e an integer, uniform in [0, 60]; c as continuous", .t = "as continuous"};

  static double coordinate(Words& words, double range) {
    constexpr std::uint64_t exponents = 61;
    const auto exponent = static_cast<int>(words.next_below(exponents));
    return std::ldexp(Continuous::coordinate(words, range), -exponent);  // a subnormal result is rounded once more
  }
  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }
};

}  // namespace bezierbench::sample
