// SPDX-License-Identifier: MIT
// Formula: the tridiagonal system of a C2 spline at uniform parameters, solved by elimination without pivoting:
//   2 x_0 + x_1 = r_0,  x_(i-1) + 4 x_i + x_(i+1) = r_i,  x_(m-2) + last x_(m-1) = r_(m-1).
// Source: [Higham 2002], section 9.6, the Thomas algorithm. Without pivoting it is stable, as every row is diagonally
//   dominant.
// Cost: 4m flops. The multipliers c_0 = 1/2, c_i = 1/(4 - c_(i-1)) fall to 2 - sqrt(3), where rounding stops them after
//   a few steps. Only these few are stored, for a system of any length.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace bezierbench::spline_system {

inline constexpr std::array<double, 20> multipliers = [] {
  std::array<double, 20> c{0.5};
  for (std::size_t i = 1; i < c.size(); ++i) c[i] = 1 / (4 - c[i - 1]);
  return c;
}();
static_assert(multipliers[multipliers.size() - 1] == multipliers[multipliers.size() - 2], "they have arrived");

constexpr double multiplier(std::size_t i) { return multipliers[std::min(i, multipliers.size() - 1)]; }

/// Replaces the m >= 2 right-hand sides by the solution; `last` is the last diagonal element.
inline void solve(std::span<double> x, double last) {
  const std::size_t end = x.size() - 1;
  x[0] *= multiplier(0);
  for (std::size_t i = 1; i < end; ++i) x[i] = (x[i] - x[i - 1]) * multiplier(i);
  x[end] = (x[end] - x[end - 1]) / (last - multiplier(end - 1));
  for (std::size_t i = end; i-- > 0;) x[i] -= multiplier(i) * x[i + 1];
}

}  // namespace bezierbench::spline_system
