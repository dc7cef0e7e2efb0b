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

/// A method takes the n + 1 >= 2 coordinates K_0 ... K_n of one axis, scaled by InterpolationKernel such that the
/// largest has a magnitude in [1/2, 1) or is 0. Its spline is C2 at uniform parameters and natural: the second
/// derivative is 0 at both ends. Every residual of C1, C2 and natural ends is at most `residual_bound` times u times
/// the largest magnitude; `residual_bound` is 0 where no bound is proved.
template <class M>
concept InterpolationMethod = requires(std::span<const double> coordinates) {
  requires M::info.problem == Problem::interpolation;
  requires std::same_as<const double, decltype(M::residual_bound)>;
  { M::inner_points(coordinates) } -> std::same_as<InnerPoints>;
};

}  // namespace bezierbench
