// SPDX-License-Identifier: MIT
// Sums of Bernstein polynomials, nested or not, and the related bases.
#pragma once

#include "core/evaluate/direct.hpp"
#include "core/evaluate/horner_bernstein.hpp"
#include "core/evaluate/horner_bernstein_fma.hpp"
#include "core/evaluate/seiler.hpp"
#include "core/evaluate/volk_schumaker.hpp"
#include "core/evaluate/wang_ball.hpp"
#include "experiments/programs/hand_written/by_hand.hpp"
#include "experiments/programs/hand_written/point.hpp"

namespace hand_written {

template <>
struct ByHand<bezierbench::Direct> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& b, const Row<S, N>& binomial) {
    const S s = 1 - t;
    std::array<S, N + 1> s_power;
    s_power[0] = 1;
    for (std::size_t i = 1; i <= N; ++i) s_power[i] = s_power[i - 1] * s;
    Point<S, D> sum{};
    S t_power = 1;
    for (int i = 0; i <= N; ++i) {
      sum += binomial[i] * t_power * s_power[static_cast<std::size_t>(N - i)] * b[i];
      t_power *= t;
    }
    return sum;
  }
};

/// `c` are the points times binomials.
template <>
struct ByHand<bezierbench::HornerBernstein> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& c) {
    const S s = 1 - t;
    Point<S, D> p = c[0];
    S power = 1;
    for (int i = 1; i <= N; ++i) {
      power *= t;
      p = p * s + c[i] * power;
    }
    return p;
  }
};

template <>
struct ByHand<bezierbench::HornerBernsteinFma> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& c) {
    using P = Point<S, D>;
    const P s = on_every_axis<P>(1 - t);
    P p = c[0];
    S power = 1;
    for (int i = 1; i <= N; ++i) {
      power *= t;
      p = fused<P>(p, s, c[i] * power);
    }
    return p;
  }
};

/// base^exponent by repeated squaring.
template <class S>
S power_of(S base, int exponent) {
  S result = 1;
  for (; exponent > 1; exponent /= 2) {
    if (exponent % 2 != 0) result *= base;
    base *= base;
  }
  return result * base;
}

template <>
struct ByHand<bezierbench::VolkSchumaker> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& c) {
    const S s = 1 - t;
    const bool near_start = t + t <= 1;
    const S larger = near_start ? s : t;
    const S r = (near_start ? t : s) / larger;
    Point<S, D> p = c[near_start ? N : 0];
    for (int i = 1; i <= N; ++i) p = p * r + c[near_start ? N - i : i];
    return p * power_of(larger, N);
  }
};

/// `v` are the points of Wang and Ball's basis.
template <>
struct ByHand<bezierbench::WangBall> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& v) {
    using P = Point<S, D>;
    const S s = 1 - t;
    P c = v[N / 2];
    if (N % 2 != 0) c = s * c + t * v[N / 2 + 1];
    for (int i = (N + 1) / 2 - 1 - N % 2; i >= 0; --i) {
      const P a = s * v[i] + t * c;
      const P b = s * c + t * v[N - i];
      c = s * a + t * b;
    }
    return c;
  }
};

/// `q` are the coefficients of Seiler's form.
template <>
struct ByHand<bezierbench::Seiler> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& q) {
    using P = Point<S, D>;
    const S s = 1 - t;
    const S z = t * s;
    int j = (N - 1) / 2;
    P c = s * q[j] + t * q[N - j];
    if (N % 2 == 0) c = c + z * q[N / 2];
    for (--j; j >= 0; --j) {
      const P line = s * q[j] + t * q[N - j];
      c = line + z * (c - line);
    }
    return c;
  }
};

}  // namespace hand_written
