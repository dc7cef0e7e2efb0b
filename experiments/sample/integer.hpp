// SPDX-License-Identifier: MIT
// Generator `integer`: coordinates on which sums and small products are exact.
#pragma once

#include <cstdint>

#include "experiments/sample/continuous.hpp"

namespace bezierbench::sample {

/// Two words per coordinate. With m = floor(R) and N = 2m + 1 the coordinate is floor(N U / 2^128) - m for a 128-bit
/// uniform U: no rejection, so that every draw has its place, at a bias below N / 2^128 <= 2^-73 of a probability.
struct Integer {
  static constexpr GeneratorInfo info{"integer", "integers, uniform in [-R, R]; 1 <= R <= 2^53", "as continuous"};

  static double coordinate(Words& words, double range) {
    __extension__ using Wide = unsigned __int128;
    const auto m = static_cast<std::int64_t>(range);
    const auto count = static_cast<std::uint64_t>(2 * m + 1);
    const Uniform128 u = words.next_uniform();
    const Wide carry = (Wide{count} * u.low) >> 64U;
    const auto index = static_cast<std::int64_t>((Wide{count} * u.high + carry) >> 64U);
    return static_cast<double>(index - m);
  }

  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }
};

}  // namespace bezierbench::sample
