// SPDX-License-Identifier: MIT
// Rational curves.
#pragma once

#include <algorithm>

#include "core/evaluate/de_casteljau_farin.hpp"
#include "core/evaluate/homogeneous.hpp"
#include "core/evaluate/wozny_chudy_positive_rational.hpp"
#include "core/evaluate/wozny_chudy_rational.hpp"
#include "experiments/programs/hand_written/quotients.hpp"

namespace hand_written {

template <class Part>
inline constexpr int dimension_of = 0;
template <class S, int D, int N>
inline constexpr int dimension_of<Points<S, D, N>> = D;

/// The polynomial method one dimension higher. The last coordinate divides the others.
template <HasCoding Method>
struct ByHand<bezierbench::Homogeneous<Method>> {
  template <class S, class... Parts>
  static auto evaluate(S t, const Parts&... parts) {
    const auto lifted = ByHand<Method>::evaluate(t, parts...);
    return lifted / lifted[std::max({dimension_of<Parts>...}) - 1];
  }
};

template <>
struct ByHand<bezierbench::WoznyChudyRational> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& b, const Row<S, N>& ratios) {
    const OverLarger<S> pair(t);
    Point<S, D> q = b[0];
    S h = 1;
    for (int k = 1; k <= N; ++k) {
      const S numerator = h * (pair.of_t * ratios[k]);
      h = numerator / (pair.of_rest + numerator);
      q = (1 - h) * q + h * b[k];
    }
    return q;
  }
};

template <>
struct ByHand<bezierbench::WoznyChudyPositiveRational> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& b, const Row<S, N>& ratios) {
    const OverLarger<S> pair(t);
    Point<S, D> q = b[0];
    S h = 1;
    for (int k = 1; k <= N; ++k) {
      const S numerator = h * (pair.of_t * ratios[k]);
      const S denominator = pair.of_rest + numerator;
      h = numerator / denominator;
      q = pair.of_rest / denominator * q + h * b[k];
    }
    return q;
  }
};

template <>
struct ByHand<bezierbench::DeCasteljauFarin> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points, const Row<S, N>& weights) {
    const S s = 1 - t;
    std::array<Point<S, D>, N + 1> b;
    std::array<S, N + 1> w = weights.values;
    for (std::size_t i = 0; i <= N; ++i) b[i] = points[static_cast<int>(i)];
    for (std::size_t last = N; last > 0; --last)
      for (std::size_t i = 0; i < last; ++i) {
        const S left = s * w[i];
        const S right = t * w[i + 1];
        w[i] = left + right;
        b[i] = left / w[i] * b[i] + right / w[i] * b[i + 1];
      }
    return b[0];
  }
};

}  // namespace hand_written
