// SPDX-License-Identifier: MIT
// The check before timing: whether the points of a method are near the exact ones.
#pragma once

#include <vector>

#include "experiments/race/kernel_rival.hpp"

namespace bezierbench::race {

/// The points of a kernel on some inputs, and whether they are right.
template <class Scalar>
struct JudgedPoints {
  std::vector<Scalar> points;  ///< point by point, as kernel_rival() wants them
  bool right = true;
};

/// Evaluates one curve and one t at a time. The points are right where each is within the method's bound of the exact
/// one or, where none is proved, within 64 (n+1) 2^n u times the amplification of a conversion to the other form.
template <class Scalar>
JudgedPoints<Scalar> judge(const Kernel<Scalar>& kernel, suite::Mode mode, const Inputs<Scalar>& inputs);

}  // namespace bezierbench::race
