// SPDX-License-Identifier: MIT
// One coordinate of a point by exact integers of a fixed size on the stack, rounded once: the last resort of
// `correctly_rounded`, where rounded arithmetic cannot tell which number is nearest.
//
// With t = T 2^-e and S = 2^e - T every coordinate is an integer times a power of two, and the integer comes from
// Horner's scheme: P <- P S + b_k C(n,k) T^k for k = 1..n (Bernstein form), P <- P T + q_j 2^(e(n-j)) for j = n-1..0
// (power form), where all b_k or q_j were multiplied by one power of two that makes them integers. P S is taken as
// P 2^e - P T, so that a step is a few passes over the limbs of P, however small t is.
//
// Size: numbers of double are multiples of 2^-1074 and below 2^1024, t has e <= 1074, and the binomials add n bits: at
// most 1075 n + 2100 bits.
#pragma once

namespace bezierbench {

/// The largest degree for which the integers have room.
inline constexpr int rounded_max_degree = 512;

/// The coefficients of one coordinate: that of number i is at first[i * stride].
template <class Scalar>
struct CoordinateView {
  const Scalar* first;
  int stride;
  int degree;  ///< at most rounded_max_degree

  [[nodiscard]] Scalar operator[](int i) const { return first[static_cast<long>(i) * stride]; }
};

/// The number of Scalar that is nearest to sum b_i C(n,i) t^i (1-t)^(n-i), ties to even; +0 where the sum is zero.
/// NaN where a coefficient is not finite or t is not in [0,1].
template <class Scalar>
Scalar rounded_bernstein_sum(const CoordinateView<Scalar>& b, Scalar t);

/// The same for sum q_j t^j; infinite where it is too large.
template <class Scalar>
Scalar rounded_power_sum(const CoordinateView<Scalar>& q, Scalar t);

}  // namespace bezierbench
