// SPDX-License-Identifier: MIT
// Generator `multiple_root`: p(t) = R (t - 3/4)^n, whose condition number grows without limit as t nears 3/4.
//
// With 3/4 = 3 * 2^-2 the coefficients are integers times powers of two,
//   Bernstein form   b_i = R (-3/4)^(n-i) (1/4)^i = R (-3)^(n-i) 4^-n
//   power form       q_j = R C(n,j) (-3/4)^(n-j)  = R C(n,j) (-3)^(n-j) 4^(j-n)
// and doubles, exactly, as long as 3^n and the odd parts of C(n,j) 3^(n-j) are below 2^53: through n = 33 and n = 27.
//
// Condition number p~/|p| at t in [0, 1], exactly:
//   Bernstein form   ((t + 3 (1-t)) / (4 |t - 3/4|))^n    (3/8 / d)^n  at t = 3/4 -+ d, to first order in d
//   power form       ((t + 3/4) / |t - 3/4|)^n            (3/2 / d)^n
// Jiang, Li, Cheng and Su 2010 and Hermes 2019, section 5, test compensated schemes with (t - 1)(t - 3/4)^7.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "experiments/sample/independent_points.hpp"

namespace bezierbench::sample {

/// Takes two words, for t: all trials of a cell have the same polynomial.
struct MultipleRoot {
  static constexpr GeneratorInfo info{.id = "multiple_root",
                                      .coordinates = "those of R (t - 3/4)^n on every axis, exact; R a power of two",
                                      .t = "as continuous",
                                      .limits = {.whole_curve = true,
                                                 .bezier_degree = 33,
                                                 .polynomial_degree = 27,
                                                 .smallest_range = 0x1p-900,
                                                 .largest_range = 0x1p900,
                                                 .exact_coefficients = true}};

  static double parameter(Words& words, suite::Interval t) { return Continuous::parameter(words, t); }

  static void polynomial(Words& /*words*/, Form curve, std::span<double> coefficients) {
    const int n = static_cast<int>(coefficients.size()) - 1;
    const bool power = curve == Form::power;
    std::int64_t integer = 1;  // (-3)^k, in power form times C(n,k), of coefficient n - k
    for (int k = 0; k <= n; ++k) {
      coefficients[static_cast<std::size_t>(n - k)] = std::ldexp(static_cast<double>(integer), -2 * (power ? k : n));
      integer *= -3;
      if (power) integer = integer * (n - k) / (k + 1);  // exact: k + 1 divides C(n,k) (n - k)
    }
  }
};

}  // namespace bezierbench::sample
