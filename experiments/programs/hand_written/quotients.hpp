// SPDX-License-Identifier: MIT
// Methods that divide at every step.
#pragma once

#include "core/evaluate/barycentric_chebyshev.hpp"
#include "core/evaluate/barycentric_uniform.hpp"
#include "core/evaluate/wozny_chudy.hpp"
#include "core/evaluate/wozny_chudy_positive.hpp"
#include "experiments/programs/hand_written/by_hand.hpp"
#include "experiments/programs/hand_written/point.hpp"

namespace hand_written {

/// The pair t : 1-t, over the larger of them.
template <class S>
struct OverLarger {
  explicit OverLarger(S t) {
    const S s = 1 - t;
    const bool near_start = t + t <= 1;
    const S ratio = near_start ? t / s : s / t;
    of_t = near_start ? ratio : 1;
    of_rest = near_start ? 1 : ratio;
  }

  S of_t;
  S of_rest;
};

template <>
struct ByHand<bezierbench::WoznyChudy> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& b) {
    const OverLarger<S> pair(t);
    Point<S, D> q = b[0];
    S h = 1;
    for (int k = 1; k <= N; ++k) {
      const S numerator = h * pair.of_t * static_cast<S>(N - k + 1);
      h = numerator / (static_cast<S>(k) * pair.of_rest + numerator);
      q = (1 - h) * q + h * b[k];
    }
    return q;
  }
};

template <>
struct ByHand<bezierbench::WoznyChudyPositive> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& b) {
    const OverLarger<S> pair(t);
    Point<S, D> q = b[0];
    S h = 1;
    for (int k = 1; k <= N; ++k) {
      const S numerator = h * pair.of_t * static_cast<S>(N - k + 1);
      const S complement = static_cast<S>(k) * pair.of_rest;
      const S denominator = complement + numerator;
      h = numerator / denominator;
      q = complement / denominator * q + h * b[k];
    }
    return q;
  }
};

struct Barycentric {
  /// `points` lie on the curve at `nodes`. As near to a node as `reach` a quotient might overflow.
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Row<S, N>& nodes, const Row<S, N>& weights, const Points<S, D, N>& points) {
    constexpr S reach = sizeof(S) == sizeof(float) ? S(0x1p-60) : S(0x1p-500);
    Point<S, D> sum{};
    S denominator = 0;
    for (int j = 0; j <= N; ++j) {
      const S distance = t - nodes[j];
      if (-reach < distance && distance < reach) return points[j];
      const S quotient = weights[j] / distance;
      denominator += quotient;
      sum += quotient * points[j];
    }
    return sum / denominator;
  }
};

template <>
struct ByHand<bezierbench::BarycentricChebyshev> : Barycentric {};
template <>
struct ByHand<bezierbench::BarycentricUniform> : Barycentric {};

}  // namespace hand_written
