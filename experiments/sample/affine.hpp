// SPDX-License-Identifier: MIT
// Random bits as a double in an interval, rounded exactly once.
#pragma once

#include "experiments/sample/words.hpp"

namespace bezierbench::sample {

/// a + (b - a) (2U + 1) / 2^129 for the integer U = high 2^64 + low, correctly rounded (to nearest, ties to even) in
/// integer arithmetic, for all finite a <= b, also subnormal ones and those of opposite signs. The result is in [a, b]
/// and has a full mantissa also near zero. An exact zero is +0; a result that underflows keeps its sign.
///
/// The midpoints (2U + 1) / 2^129 make the image symmetric: U and its complement, with a and b exchanged, agree.
double affine(double a, double b, Uniform128 u);

}  // namespace bezierbench::sample
