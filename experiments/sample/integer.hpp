// SPDX-License-Identifier: MIT
// Generator `integer`: integer coordinates, whose sums and small products are exact.
#pragma once

#include <cstdint>

#include "experiments/sample/continuous.hpp"

namespace bezierbench::sample {

/// Takes two words per coordinate: a number below 2m + 1, minus m, with m = floor(R).
struct Integer {
  static constexpr GeneratorInfo info{.id = "integer",
                                      .coordinates = "integers, uniform in [-R, R]; 1 <= R <= 2^53",
                                      .t = "as continuous",
                                      .limits = {.smallest_range = 1, .largest_range = 0x1p53}};

  static double coordinate(Words& words, double range) {
    const auto m = static_cast<std::int64_t>(range);
    const std::uint64_t index = words.next_below(static_cast<std::uint64_t>(2 * m + 1));
    return static_cast<double>(static_cast<std::int64_t>(index) - m);
  }

  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }
};

}  // namespace bezierbench::sample
