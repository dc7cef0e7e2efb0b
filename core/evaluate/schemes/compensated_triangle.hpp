// SPDX-License-Identifier: MIT
// Formula: de Casteljau's triangle in K parts. v_0 is the rounded triangle, v_F the rounded triangle of the errors of
//   v_(F-1). The methods that share this scheme differ in K only. With s + rho = 1 - t and every operation error-free,
//   a step on level m, l_0 = 0, is
//     (1-t) v_F,i + t v_F,i+1 + l_F = v_F,i' + l_(F+1),     l_(F+1) = errors of its operations + rho v_F,i,
//   where F = K-1 is computed in plain floating point and l_K is dropped; p = sum over F of v_F + (the share of l_K).
//   Algorithm SumK adds the v_F ([Ogita et al. 2005], Algorithm 4.8); plain addition would round at u |v_1|.
// Source: [Hermes 2019], Algorithm 4.2; for K = 2 [Jiang et al. 2010].
// Bound: u |p| + c_K u^K p~, for any t, with c_K from `compensated_remainder`; derived in
//   docs/proofs/compensated_parts.md. To first order c_2 = 9 C(n,2) + 15 n.
// Fails: each method states its own.
#pragma once

#include <array>
#include <utility>

#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/compensated_parts.hpp"
#include "core/evaluate/schemes/triangle.hpp"

namespace bezierbench {

/// The roundings of a step: three of each value of a level, and for each error of a part those of its sums.
struct TriangleRoundings {
  static constexpr int value_roundings = 3;
  static constexpr int error_roundings(int part) { return 5 * part; }
  static constexpr int ahead = 0;
};

/// The largest (|computed - p| - (u + 3 gamma_(K-1)^2) |p|) / p~, without underflow: c_K u^K and the share of SumK.
template <int K>
constexpr double compensated_remainder(int n, double u) {
  return remainder_of_parts<K, TriangleRoundings>(n, u);
}

template <int K>
constexpr ErrorBound compensated_bound(std::string_view text) {
  return bound_of_parts<K, TriangleRoundings>(
      text, Amplification::p_tilde_bernstein, [](int n) { return (3.0 * K - 1) * n; }, [](int) { return 1.0; });
}

/// The parts from `Part` on of a step, whose first parts had these errors. Every index is a constant and nothing is
/// called, so that compilers keep values in registers.
template <std::size_t Part, std::size_t K, class Scalar, std::size_t... More>
[[gnu::always_inline]] inline void add_parts(std::array<Scalar, K>& next, const std::array<Scalar, K>& a,
                                             const std::array<Scalar, K>& b, const Expansion2<Scalar>& s,
                                             const Scalar& t, const std::array<Scalar, sizeof...(More) + 1>& errors,
                                             std::index_sequence<More...> /*errors but the first*/) {
  Scalar total = errors[0];
  if constexpr (Part + 1 == K) {
    ((total = total + errors[More + 1]), ...);
    next[Part] = ((total + s.error * a[Part - 1]) + t * b[Part]) + s.value * a[Part];
  } else {
    constexpr std::size_t more = sizeof...(More);
    std::array<Scalar, more + 6> kept;
    ((kept[More] = accumulate<Scalar>(total, errors[More + 1])), ...);
    const auto lost = two_prod<Scalar>(s.error, a[Part - 1]);
    const auto right = two_prod<Scalar>(t, b[Part]);
    const auto left = two_prod<Scalar>(s.value, a[Part]);
    kept[more] = accumulate<Scalar>(total, lost.value);
    kept[more + 1] = lost.error;
    kept[more + 2] = accumulate<Scalar>(total, right.value);
    kept[more + 3] = right.error;
    kept[more + 4] = accumulate<Scalar>(total, left.value);
    kept[more + 5] = left.error;
    next[Part] = total;
    add_parts<Part + 1, K, Scalar>(next, a, b, s, t, kept, std::make_index_sequence<more + 5>());
  }
}

/// One step of the triangle on one axis: the K parts of (1-t) a + t b, with s.value + s.error = 1 - t.
template <std::size_t K, class Scalar>
[[gnu::always_inline]] inline std::array<Scalar, K> compensated_step(const std::array<Scalar, K>& a,
                                                                     const std::array<Scalar, K>& b,
                                                                     const Expansion2<Scalar>& s, const Scalar& t) {
  const auto left = two_prod<Scalar>(s.value, a[0]);
  const auto right = two_prod<Scalar>(t, b[0]);
  const auto sum = two_sum<Scalar>(left.value, right.value);
  std::array<Scalar, K> next;
  next[0] = sum.value;
  add_parts<1, K, Scalar>(next, a, b, s, t, std::array<Scalar, 3>{left.error, right.error, sum.error},
                          std::make_index_sequence<2>());
  return next;
}

/// Runs the triangle in K parts on a copy of the control points.
template <std::size_t K, class Scalar, int Dimension, int Degree>
Point<Scalar, Dimension> run_compensated_triangle(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve,
                                                  const Scalar& t) {
  const auto s = two_sum<Scalar>(Scalar(1), -t);
  const auto step = [&](const auto& a, const auto& b) { return compensated_step<K, Scalar>(a, b, s, t); };
  Point<Scalar, Dimension> point;
  for (int axis = 0; axis < Dimension; ++axis) {
    const auto in = [&](int i) {
      std::array<Scalar, K> parts;
      parts[0] = curve(axis, i);
      for (std::size_t part = 1; part < K; ++part) parts[part] = Scalar(0);
      return parts;
    };
    point[axis] = sum_of_parts(detail::apex_in_memory<K, Scalar>(curve.degree(), in, step));
  }
  return point;
}

}  // namespace bezierbench
