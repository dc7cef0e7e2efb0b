// SPDX-License-Identifier: MIT
// a b + c with one rounding. Fused methods have ids of their own and say so here, never by compiler contraction.
#pragma once

#include <cmath>
#include <concepts>

namespace bezierbench {

/// Scalars with a fused multiply-add of their own: vectors.
template <class Scalar>
concept HasFused = requires(const Scalar& a) {
  { a.fused(a, a) } -> std::same_as<Scalar>;
};

/// std::fma for floating point; for exact scalars (the algebra tests) there is nothing to round.
template <class Scalar>
Scalar fused(const Scalar& a, const Scalar& b, const Scalar& c) {
  if constexpr (std::floating_point<Scalar>)
    return std::fma(a, b, c);
  else if constexpr (HasFused<Scalar>)
    return a.fused(b, c);
  else
    return a * b + c;
}

}  // namespace bezierbench
