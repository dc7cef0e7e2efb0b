// SPDX-License-Identifier: MIT
// Checks at run time that floating-point arithmetic is what bounds and digests assume.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace bezierbench {

namespace detail {

/// Hides a value from the optimiser, so that the processor computes what follows.
inline double opaque(double value) {
  volatile double hidden = value;
  return hidden;
}

}  // namespace detail

/// The ways in which this process differs from IEEE 754 double arithmetic to nearest, one line each: contraction,
/// flushed subnormals, another rounding mode, excess precision. Empty where there is none.
inline std::vector<std::string> floating_point_faults() {
  using detail::opaque;
  std::vector<std::string> faults;
  // (1 + 2^-30)^2 = 1 + 2^-29 + 2^-60: the product rounds the last term away, a fused multiply-add keeps it.
  const double a = opaque(1 + 0x1p-30);
  const double c = opaque(-(1 + 0x1p-29));
  if (a * a + c != 0) faults.emplace_back("products and sums are contracted into fused multiply-adds");
  const double tiny = opaque(std::numeric_limits<double>::min());
  if (tiny / opaque(2) == 0) faults.emplace_back("subnormal results are flushed to zero");
  if (opaque(std::numeric_limits<double>::denorm_min()) * opaque(0x1p+60) == 0)
    faults.emplace_back("subnormal operands are taken as zero");
  const double half_ulp = opaque(0x1p-53);
  if (opaque(1) + half_ulp != 1 || opaque(1 + 0x1p-52) + half_ulp != 1 + 0x1p-51 || opaque(-1) - half_ulp != -1)
    faults.emplace_back("rounding is not to nearest, ties to even");
  // 1 + 2^-53 + 2^-78 rounds up at once, but down when first rounded to 64 bits.
  if (opaque(1) + opaque(0x1p-53 + 0x1p-78) != 1 + 0x1p-52) faults.emplace_back("results are rounded twice");
  return faults;
}

}  // namespace bezierbench
