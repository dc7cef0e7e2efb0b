// SPDX-License-Identifier: MIT
// The concept of a method for interpolation: `info`, and one function from points to the cubic Bezier segments that
// join them with continuous first and second derivatives. The axes are independent, so a method works on one axis at a
// time.
#pragma once

#include <concepts>
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
