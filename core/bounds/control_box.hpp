// SPDX-License-Identifier: MIT
// Formula: low = min b_i, high = max b_i.
// Cost: 2dn comparisons.
// Bound: nothing is rounded. A rational curve stays in the hull if its weights have one sign; else the box is infinite.
// Fails: the box is larger than the curve wherever a control point that is not an end is the lowest or the highest.
#pragma once

#include "core/bounds/bounds.hpp"

namespace bezierbench {

template <Form F>
struct ControlBox {
  static constexpr BoxPromises promises{.contains = true, .within_one_ulp = false};
  static constexpr MethodInfo info{.id = "control_box",
                                   .label = "Box of the control points",
                                   .problem = Problem::bounds,
                                   .form = F,
                                   .promise = "contains the curve",
                                   .flops = "0",
                                   .citation = "[Farin 2002], convex hull property"};

  static Range range(const Curve<F, double, 1>& axis) { return range_of_control_points(axis); }
};

}  // namespace bezierbench
