// SPDX-License-Identifier: MIT
// Where a rational curve has a pole: the roots of its denominator, isolated with integers.
#pragma once

#include <optional>

#include "core/curve_view.hpp"

namespace bezierbench::reference {

/// The first parameter in [from, to], part of [0, 1], at which the weights of a rational curve sum to zero, to some 53
/// bits; empty where there is none, and for other curves. Coefficients are finite.
std::optional<double> pole(const CurveView<double>& curve, double from = 0, double to = 1);

}  // namespace bezierbench::reference
