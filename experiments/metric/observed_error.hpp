// SPDX-License-Identifier: MIT
// The limit of the errors of a method without a proved bound, above which its times do not count.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace bezierbench::metric {

/// How much larger than in an accuracy study errors may be where few other inputs are drawn from the same cell.
inline constexpr double observed_multiple = 16;

/// The largest error allowed, in units of u p~: that multiple of the largest one `observed` in the same cell, or of 1
/// if that is larger. Where none was observed, or an infinite one, half of the digits of the exact value must be right.
inline double allowed_error_u(std::optional<double> observed, double unit_roundoff) {
  if (observed && std::isfinite(*observed)) return observed_multiple * std::max(*observed, 1.0);
  return 1 / std::sqrt(unit_roundoff);
}

}  // namespace bezierbench::metric
