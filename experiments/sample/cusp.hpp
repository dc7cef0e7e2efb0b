// SPDX-License-Identifier: MIT
// Generator `cusp`: curves with C'(c) = 0 exactly at one inner c; in a random half of the curves only nearly.
//
// With r = c / (1 - c), C'(c) = n (1-c)^(n-1) sum C(n-1,j) r^j (b_(j+1) - b_j). All points but the first are drawn from
// a lattice; b_0 = b_1 + sum_(j>0) C(n-1,j) r^j (b_(j+1) - b_j) makes that sum 0. r = a/4 with a of 1 to 8, so that c
// is 1/5, 1/3, 3/7, 1/2, 5/9, 3/5, 7/11 or 2/3: most of these are not parameters that repeated halving reaches. In
// units of R 2^-26 the points are integers m 4^(n-1), |m| <= M, and so b_0 is an integer of at most M 4^(n-1) (2
// 3^(n-1) - 1); M is the largest for which that is at most 15/16 of 2^26. For a near cusp b_0 is moved by 2^-s R on
// every axis, s of 5 to 50: a multiple of 2^-50 R below R, still a double. So |C'(c)| = n (1-c)^(n-1) 2^-s R sqrt(d).
//
// Degrees end at 6, where M is 126.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/sample/independent_points.hpp"

namespace bezierbench::sample {

/// Takes two words each for t, a, whether the cusp is a near one, and s; then two for each coordinate of every point
/// but the first.
struct Cusp {
  static constexpr int largest_degree = 6;

  static constexpr GeneratorInfo info{
      .id = "cusp",
      .coordinates = "those of a curve that stops at an inner t, exact, half of them only nearly; R a power of two",
      .t = "as continuous",
      .limits = {.whole_curve = true,
                 .bezier_degree = largest_degree,
                 .polynomial_degree = 0,
                 .smallest_range = 0x1p-900,
                 .largest_range = 0x1p900,
                 .exact_coefficients = true}};

  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }

  static void curve(Words& words, int dimension, std::span<double> coordinates) {
    const auto d = static_cast<std::size_t>(dimension);
    const int n = static_cast<int>(coordinates.size() / d) - 1;
    const std::int64_t quarters = 1 + below(words, 8);
    const bool near = below(words, 2) == 1;
    const double offset = std::ldexp(near ? 1 : 0, -5 - static_cast<int>(below(words, 46)));
    const std::int64_t largest = largest_multiple(n);
    std::vector<std::int64_t> m(coordinates.size());
    for (std::size_t k = d; k < m.size(); ++k) m[k] = below(words, 2 * largest + 1) - largest;
    for (std::size_t axis = 0; axis < d; ++axis) {
      const auto at = [&](int i) { return m[static_cast<std::size_t>(i) * d + axis]; };
      std::int64_t first = n > 0 ? at(1) * power(4, n - 1) : 0;
      std::int64_t binomial = 1;
      for (int j = 1; j < n; ++j) {
        binomial = binomial * (n - j) / j;
        first += binomial * power(quarters, j) * power(4, n - 1 - j) * (at(j + 1) - at(j));
      }
      coordinates[axis] = std::ldexp(static_cast<double>(first), -unit_bits) + offset;
      for (int i = 1; i <= n; ++i)
        coordinates[static_cast<std::size_t>(i) * d + axis] =
            std::ldexp(static_cast<double>(at(i) * power(4, n - 1)), -unit_bits);
    }
  }

 private:
  static constexpr int unit_bits = 26;

  static std::int64_t below(Words& words, std::int64_t count) {
    return static_cast<std::int64_t>(words.next_below(static_cast<std::uint64_t>(count)));
  }

  static constexpr std::int64_t power(std::int64_t base, int exponent) {
    std::int64_t value = 1;
    for (int k = 0; k < exponent; ++k) value *= base;
    return value;
  }

  /// The M for degree n.
  static constexpr std::int64_t largest_multiple(int n) {
    constexpr std::int64_t limit = (std::int64_t{1} << unit_bits) / 16 * 15;
    return n == 0 ? 0 : limit / (power(4, n - 1) * (2 * power(3, n - 1) - 1));
  }
};

}  // namespace bezierbench::sample
