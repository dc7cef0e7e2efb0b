// SPDX-License-Identifier: MIT
// Power form: q[j] is the coefficient of t^j.
#pragma once

#include "core/evaluate/estrin.hpp"
#include "core/evaluate/horner.hpp"
#include "core/evaluate/horner_centered.hpp"
#include "core/evaluate/horner_fma.hpp"
#include "core/evaluate/power_sum.hpp"
#include "experiments/programs/hand_written/by_hand.hpp"
#include "experiments/programs/hand_written/point.hpp"

namespace hand_written {

template <>
struct ByHand<bezierbench::PowerSum> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& q) {
    Point<S, D> sum = q[0];
    S power = 1;
    for (int j = 1; j <= N; ++j) {
      power *= t;
      sum += q[j] * power;
    }
    return sum;
  }
};

template <>
struct ByHand<bezierbench::Horner> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& q) {
    Point<S, D> p = q[N];
    for (int j = N - 1; j >= 0; --j) p = p * t + q[j];
    return p;
  }
};

template <>
struct ByHand<bezierbench::HornerFma> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& q) {
    using P = Point<S, D>;
    const P on_axes = on_every_axis<P>(t);
    P p = q[N];
    for (int j = N - 1; j >= 0; --j) p = fused<P>(p, on_axes, q[j]);
    return p;
  }
};

/// About t = 1/2.
template <>
struct ByHand<bezierbench::HornerCentered> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& q) {
    return ByHand<bezierbench::Horner>::evaluate(t - S(0.5), q);
  }
};

template <>
struct ByHand<bezierbench::Estrin> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& coefficients) {
    std::array<Point<S, D>, N + 1> q;
    for (std::size_t j = 0; j <= N; ++j) q[j] = coefficients[static_cast<int>(j)];
    S power = t;
    for (std::size_t count = N + 1; count > 1; count = (count + 1) / 2) {
      for (std::size_t k = 0; k < count / 2; ++k) q[k] = q[2 * k] + q[2 * k + 1] * power;
      if (count % 2 != 0) q[count / 2] = q[count - 1];
      power *= power;
    }
    return q[0];
  }
};

}  // namespace hand_written
