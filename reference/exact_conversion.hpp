// SPDX-License-Identifier: MIT
// The true coefficients of a curve in the other form.
#pragma once

#include <vector>

#include "core/curve_view.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::reference {

/// Coefficients of `curve` in the other form, each a point:
///   q_j = C(n,j) sum_i (-1)^(j-i) C(j,i) b_i,    b_i = sum_(j<=i) C(i,j) / C(n,j) q_j (over the denominator n!).
std::vector<ExactPoint> converted(const CurveView<double>& curve);

}  // namespace bezierbench::reference
