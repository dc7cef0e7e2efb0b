// SPDX-License-Identifier: MIT
// a b + c with one rounding. Fused methods have ids of their own and say so here, never by compiler contraction.
#pragma once

#include <cmath>
#include <concepts>

namespace bezierbench {

/// std::fma for floating point; for exact scalars (the algebra tests) there is nothing to round.
template <class Scalar>
Scalar fused(const Scalar& a, const Scalar& b, const Scalar& c) {
  if constexpr (std::floating_point<Scalar>)
    return std::fma(a, b, c);
  else
    return a * b + c;
}

}  // namespace bezierbench
