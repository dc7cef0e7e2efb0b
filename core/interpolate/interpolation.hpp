// SPDX-License-Identifier: MIT
// The concept of a method for interpolation: `info`, and one function from points to the cubic Bezier segments that
// join them with continuous first and second derivatives. The axes are independent, so a method works on one axis at a
// time.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include "core/method.hpp"

namespace bezierbench {

/// The inner control points of n cubic segments on one axis: segment i is K_i, first[i], second[i], K_(i+1).
struct InnerPoints {
  std::vector<double> first;
  std::vector<double> second;
};

/// What scaling back adds to the residuals, in units of the smallest double 2^-1074: an inner control point that
/// becomes subnormal is rounded once more, by 1/2 at most. C2 has six of them: twice P1 and once P2 of one segment,
/// once P1 and twice P2 of the one before. C1 has two, an end has three.
inline constexpr int residual_underflow = 3;

/// A method takes the n + 1 >= 2 coordinates K_0 ... K_n of one axis, scaled by InterpolationKernel such that the
/// largest has a magnitude in [1/2, 1) or is 0. Its spline is C2 at uniform parameters and natural: the second
/// derivative is 0 at both ends. Every residual of C1, C2 and natural ends is at most `residual_bound` times u times
/// the largest magnitude, scaled; `residual_bound` is 0 where no bound is proved. Scaling back adds
/// `residual_underflow`.
template <class M>
concept InterpolationMethod = requires(std::span<const double> coordinates) {
  requires M::info.problem == Problem::interpolation;
  requires std::same_as<const double, decltype(M::residual_bound)>;
  { M::inner_points(coordinates) } -> std::same_as<InnerPoints>;
};

}  // namespace bezierbench

// Formula: the tridiagonal system of a C2 spline at uniform parameters, solved by elimination without pivoting:
//   2 x_0 + x_1 = r_0,  x_(i-1) + 4 x_i + x_(i+1) = r_i,  x_(m-2) + last x_(m-1) = r_(m-1).
// Source: [Higham 2002], section 9.6, the Thomas algorithm. Without pivoting it is stable, as every row is diagonally
//   dominant.
// Cost: 4m flops. The multipliers c_0 = 1/2, c_i = 1/(4 - c_(i-1)) fall to 2 - sqrt(3), where rounding stops them after
//   a few steps. Only these few are stored, for a system of any length.

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
