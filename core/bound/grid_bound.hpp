// SPDX-License-Identifier: MIT
// A proved error bound of a point of a grid as data, like ErrorBound of a point by itself: it may grow with the number
// of the point, where each is made from the one before.
#pragma once

#include <string_view>

#include "core/bound/error_bound.hpp"

namespace bezierbench {

/// The bound on each axis at t_k = k/m, for a curve of degree n:
///   |computed - true| <= factor(n, k, u) u A + underflow(n, m) eta S
/// with the amplification A at t_k, the smallest subnormal eta, and S = 1 or, where powers of t are rounded apart from
/// the coefficients, S = 1 + max|c|. Proved while growth(n, m) S_0 stays in range, as in core/bound/error_bound.hpp.
struct GridBound {
  std::string_view text;  ///< for people
  Amplification amplification;
  double (*factor)(int degree, int k, double u);
  double (*underflow)(int degree, int steps);
  bool underflow_scales_with_coefficients = false;
  double (*growth)(int degree, int steps) = [](int, int) { return 1.0; };
};

}  // namespace bezierbench
