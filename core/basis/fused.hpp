// SPDX-License-Identifier: MIT
// a b + c with one rounding. Fused methods have ids of their own and call this function; the compiler never contracts.
#pragma once

#include <cmath>
#include <concepts>

namespace bezierbench {

/// Scalars that have a member function for the fused multiply-add: vectors.
template <class Scalar>
concept HasFused = requires(const Scalar& a) {
  { a.fused(a, a) } -> std::same_as<Scalar>;
};

/// std::fma for floating point; a b + c for exact scalars (the algebra tests), which do not round.
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
