// SPDX-License-Identifier: MIT
// Generator `thin`: small whole numbers along one axis and far smaller numbers along the others. The curves turn back,
// or nearly so, within a short part of their parameter. A turn that lies between the abscissae of a quadrature rule
// does not change its result.
//
// In units of R/32 the first coordinate is a whole number of [-32, 32], and every other one such a number over 2^s, s
// of 4 to 20, the same for the whole curve. In a random half of the curves the first coordinates zigzag, which brings
// two turns close together: points with even numbers take them from [-32, 0], those with odd numbers from [0, 32].
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "experiments/sample/independent_points.hpp"

namespace bezierbench::sample {

/// Takes two words each for t, s and whether the curve zigzags, then two for each coordinate.
struct Thin {
  static constexpr GeneratorInfo info{
      .id = "thin",
      .coordinates =
          "small whole multiples of R/32 on the first axis, of R 2^-9 to R 2^-25 on others; half zigzag; R a "
          "power of two",
      .t = "as continuous",
      .limits = {.whole_curve = true,
                 .polynomial_degree = 0,
                 .smallest_range = 0x1p-900,
                 .largest_range = 0x1p900,
                 .exact_coefficients = true}};

  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }

  static void curve(Words& words, int dimension, std::span<double> coordinates) {
    const auto d = static_cast<std::size_t>(dimension);
    const int shift = 4 + static_cast<int>(words.next_below(17));
    const bool zigzag = words.next_below(2) == 1;
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
      const bool first_axis = k % d == 0;
      const bool one_sided = first_axis && zigzag;
      const bool below = k / d % 2 == 0;
      const auto index = static_cast<int>(words.next_below(one_sided ? largest + 1 : 2 * largest + 1));
      const int whole = index - (one_sided && !below ? 0 : static_cast<int>(largest));
      coordinates[k] = std::ldexp(whole, -unit_bits - (first_axis ? 0 : shift));
    }
  }

 private:
  static constexpr int unit_bits = 5;
  static constexpr std::uint64_t largest = 32;
};

}  // namespace bezierbench::sample
