// SPDX-License-Identifier: MIT
// The fused multiply-add, and error-free transformations: a rounded operation together with its exact error.
//
// These are exact while nothing overflows and, for products, while the error does not fall below the smallest
// subnormal. All must be compiled without contraction and without reassociation.
//
// Source: [Knuth 1997], section 4.2.2, for two_sum; [Ogita et al. 2005], with fused multiply-add for two_prod.
#pragma once

#include <cmath>
#include <concepts>

namespace bezierbench {

/// Scalars that have a member function for the fused multiply-add: vectors.
template <class Scalar>
concept HasFused = requires(const Scalar& a) {
  { a.fused(a, a) } -> std::same_as<Scalar>;
};

/// a b + c with one rounding. Methods that use it have ids of their own, since the compiler never contracts. It is
/// std::fma for floating point, and a b + c for exact scalars (the algebra tests), which do not round.
template <class Scalar>
Scalar fused(const Scalar& a, const Scalar& b, const Scalar& c) {
  if constexpr (std::floating_point<Scalar>)
    return std::fma(a, b, c);
  else if constexpr (HasFused<Scalar>)
    return a.fused(b, c);
  else
    return a * b + c;
}

/// value + error = the exact result; |error| <= u |value|.
template <class Scalar>
struct Expansion2 {
  Scalar value;
  Scalar error;
};

/// a + b exactly; 6 flops.
template <class Scalar>
constexpr Expansion2<Scalar> two_sum(Scalar a, Scalar b) {
  const Scalar sum = a + b;
  const Scalar b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a + b exactly for |a| >= |b| ([Dekker 1971]); 3 flops.
template <class Scalar>
constexpr Expansion2<Scalar> fast_two_sum(Scalar a, Scalar b) {
  const Scalar sum = a + b;
  return {sum, b - (sum - a)};
}

/// a b exactly; 2 flops with a fused multiply-add.
template <class Scalar>
Expansion2<Scalar> two_prod(Scalar a, Scalar b) {
  const Scalar product = a * b;
  return {product, fused<Scalar>(a, b, -product)};
}

}  // namespace bezierbench
