// SPDX-License-Identifier: MIT
// Formula: Horner's scheme in K parts. v_0 is the rounded scheme, v_F the rounded scheme whose coefficients are the
//   errors of v_(F-1). The methods that share this scheme differ in K only. With every operation error-free, a step is
//     v_F t + l_F = v_F' + l_(F+1),     l_0 = q_j,     l_(F+1) = errors of its operations,
//   where F = K-1 is computed in plain floating point and l_K is dropped; p = sum over F of v_F + (the share of l_K).
//   Algorithm SumK adds the v_F ([Ogita et al. 2005], Algorithm 4.8).
// Source: the parts are those of [Hermes 2019], Algorithm 4.2, for Horner's scheme in place of the triangle; K = 2 is
//   compensated_horner. [Cameron and Graillat 2024] reach the same accuracy with parts that every step sums again, by
//   58 and 115 flops a step for K = 3 and 4, [Graillat et al. 2009] with 2^K - 1 schemes.
// Bound: u |p| + c_K u^K p~, for any t, with c_K from `remainder_of_parts` in compensated_parts.hpp; derived in
//   docs/proofs/compensated_parts.md. To first order c_2 = 2n(n+1).
// Fails: each method states its own.
#pragma once

#include <array>
#include <utility>

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/compensated_parts.hpp"

namespace bezierbench {

struct HornerRoundings {
  static constexpr int value_roundings = 2;
  static constexpr int error_roundings(int part) { return part + 1; }
  static constexpr int ahead = 1;  ///< the error of a sum is relative to the result of its step
};

template <int K>
constexpr ErrorBound compensated_horner_bound(std::string_view text) {
  return bound_of_parts<K, HornerRoundings>(
      text, Amplification::p_tilde_power, [](int n) { return 1.0 * K * n; }, [](int n) { return n + 1.0; });
}

/// The parts from `Part` on of a step, into which these errors go. Every index is a constant and nothing is called, so
/// that compilers keep values in registers.
template <std::size_t Part, std::size_t K, class Scalar, std::size_t... More>
[[gnu::always_inline]] inline void add_horner_parts(std::array<Scalar, K>& v, const Scalar& t,
                                                    const std::array<Scalar, sizeof...(More) + 1>& errors,
                                                    std::index_sequence<More...> /*errors but the first*/) {
  Scalar total = errors[0];
  if constexpr (Part + 1 == K) {
    ((total = total + errors[More + 1]), ...);
    v[Part] = v[Part] * t + total;
  } else {
    constexpr std::size_t more = sizeof...(More);
    std::array<Scalar, more + 2> kept;
    ((kept[More] = accumulate<Scalar>(total, errors[More + 1])), ...);
    const auto product = two_prod<Scalar>(v[Part], t);
    kept[more] = accumulate<Scalar>(total, product.value);
    kept[more + 1] = product.error;
    v[Part] = total;
    add_horner_parts<Part + 1, K, Scalar>(v, t, kept, std::make_index_sequence<more + 1>());
  }
}

/// One step on one axis: the K parts of v t + q.
template <std::size_t K, class Scalar>
[[gnu::always_inline]] inline void compensated_horner_step(std::array<Scalar, K>& v, const Scalar& t, const Scalar& q) {
  const auto product = two_prod<Scalar>(v[0], t);
  const auto sum = two_sum<Scalar>(product.value, q);
  v[0] = sum.value;
  add_horner_parts<1, K, Scalar>(v, t, std::array<Scalar, 2>{product.error, sum.error}, std::make_index_sequence<1>());
}

/// The point at t by Horner's scheme in K parts.
template <std::size_t K, class Scalar, int Dimension, int Degree>
Point<Scalar, Dimension> run_compensated_horner(const Curve<Form::power, Scalar, Dimension, Degree>& curve,
                                                const Scalar& t) {
  const int n = curve.degree();
  Point<Scalar, Dimension> p;
  for (int axis = 0; axis < Dimension; ++axis) {
    std::array<Scalar, K> parts;
    parts.fill(Scalar(0));
    parts[0] = curve(axis, n);
    for (int j = n - 1; j >= 0; --j) compensated_horner_step<K, Scalar>(parts, t, curve(axis, j));
    p[axis] = sum_of_parts(parts);
  }
  return p;
}

}  // namespace bezierbench
