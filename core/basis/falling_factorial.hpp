// SPDX-License-Identifier: MIT
#pragma once

namespace bezierbench {

/// (n)_k = n (n-1) ... (n-k+1), the factor that k derivatives bring; 1 for k = 0, and 0 for k > n. At most k - 1
/// roundings, none while it stays below 2^53.
constexpr double falling_factorial(int n, int k) {
  double product = 1;
  for (int m = 0; m < k && product != 0; ++m) product *= n - m;
  return product;
}

}  // namespace bezierbench
