// SPDX-License-Identifier: MIT
// The cube root by Newton's method, to a few ulp: no library decides its bits.
#pragma once

#include <cmath>

#include "core/powers.hpp"

namespace bezierbench {

/// Of a finite x >= 0.
inline double cube_root(double x) {
  if (!(x > 0)) return 0;
  double root = std::ldexp(1, binary_exponent(x) / 3);  // within a factor of 2
  for (int k = 0; k < 7; ++k) root = (2 * root + x / (root * root)) / 3;
  return root;
}

}  // namespace bezierbench
