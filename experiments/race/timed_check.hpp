// SPDX-License-Identifier: MIT
// Check, then time: only methods whose points are near the exact ones are worth a time.
#pragma once

#include <vector>

#include "experiments/race/kernel_rival.hpp"

namespace bezierbench::race {

/// The points of a kernel on some inputs, and what was found of them.
template <class Scalar>
struct JudgedPoints {
  std::vector<Scalar> points;  ///< point by point, as kernel_rival() wants them
  bool right = true;
};

/// Evaluates one curve and one t at a time. The points are right where all are as near to the exact ones as a method
/// may be: within its bound or, where none is proved, within 64 (n+1) 2^n u times the amplification of a detour through
/// the other form.
template <class Scalar>
JudgedPoints<Scalar> judge(const Kernel<Scalar>& kernel, suite::Mode mode, const Inputs<Scalar>& inputs);

}  // namespace bezierbench::race
