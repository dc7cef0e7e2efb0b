// SPDX-License-Identifier: MIT
// The cube root by Newton's method, to a few ulp: no library decides its bits.
#pragma once

#include <cmath>

namespace bezierbench {

/// Of a finite x >= 0.
inline double cube_root(double x) {
  if (!(x > 0)) return 0;
  int exponent = 0;
  std::frexp(x, &exponent);
  double root = std::ldexp(1, exponent / 3);  // within a factor of 2
  for (int k = 0; k < 7; ++k) root = (2 * root + x / (root * root)) / 3;
  return root;
}

}  // namespace bezierbench
