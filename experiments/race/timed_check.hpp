// SPDX-License-Identifier: MIT
// The check before timing: whether the points of a method are near the exact ones.
#pragma once

#include <optional>
#include <vector>

#include "experiments/race/kernel_rival.hpp"

namespace bezierbench::race {

/// The points of a kernel on some inputs, and whether they are right.
template <class Scalar>
struct JudgedPoints {
  std::vector<Scalar> points;  ///< point by point, as kernel_rival() requires them
  bool right = true;           ///< all are finite, and within the method's bound of the exact ones where one is proved
  /// The largest error, in units of u p~, where no bound is proved; metric::allowed_error_u() says what it may be.
  std::optional<double> max_error_u;
};

/// Evaluates one curve and one t at a time.
template <class Scalar>
JudgedPoints<Scalar> judge_points(const Kernel<Scalar>& kernel, suite::Mode mode, const Inputs<Scalar>& inputs);

}  // namespace bezierbench::race
