// SPDX-License-Identifier: MIT
// A cheap tier: the same sums in long double. No result depends on it; every accuracy study audits its error against
// the exact point. The audit also shows on which platforms long double is the same as double.
#pragma once

#include <array>

#include "core/curve_view.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::reference {

/// The point in long double, on each axis.
using LongDoublePoint = std::array<long double, max_dimension>;

/// Horner's nested sum in the form of `curve`, all in long double.
LongDoublePoint long_double_point(const CurveView<double>& curve, double t);

/// |value - true| in units of the ulp of double at the true coordinate, the largest over the axes, rounded once.
double audit_ulp(const LongDoublePoint& value, const ExactPoint& exact);

}  // namespace bezierbench::reference
