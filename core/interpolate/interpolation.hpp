// SPDX-License-Identifier: MIT
// The concept of a method for interpolation: `info`, and one function from points to the cubic Bezier segments that
// join them with continuous first and second derivatives. Axes are independent, so a method is handed one at a time.
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

/// The spline is C2 at uniform parameters and natural: its second derivative is 0 at both ends. A method takes the
/// n + 1 >= 2 coordinates K_0 ... K_n of one axis, scaled so that the largest has a size in [1/2, 1) or is 0
/// (InterpolationKernel scales). `residual_bound` times u times that size bounds every residual of C1, C2 and natural
/// ends; it is 0 where nothing is proved.
template <class M>
concept InterpolationMethod = requires(std::span<const double> coordinates) {
  requires M::info.problem == Problem::interpolation;
  requires std::same_as<const double, decltype(M::residual_bound)>;
  { M::inner_points(coordinates) } -> std::same_as<InnerPoints>;
};

}  // namespace bezierbench
