// SPDX-License-Identifier: MIT
// de Casteljau's triangle in its variants.
#pragma once

#include <utility>

#include "core/evaluate/de_casteljau.hpp"
#include "core/evaluate/de_casteljau_fixed_point.hpp"
#include "core/evaluate/de_casteljau_fma.hpp"
#include "core/evaluate/de_casteljau_lerp.hpp"
#include "core/evaluate/de_casteljau_lerp_fma.hpp"
#include "core/evaluate/de_casteljau_two_sided.hpp"
#include "experiments/programs/hand_written/by_hand.hpp"
#include "experiments/programs/hand_written/point.hpp"

namespace hand_written {

/// One level: b[I] <- step(b[I], b[I + 1]) for every I, ascending.
template <class P, class Step, int... I>
[[gnu::always_inline]] inline void rise(P* b, const Step& step, std::integer_sequence<int, I...> /*all*/) {
  ((b[I] = step(b[I], b[I + 1])), ...);
}

/// The triangle above b[0], ..., b[N], every step of it written out: GCC 12 leaves loops from degree 6 on or so.
template <class P, class Step, int... Level>
[[gnu::always_inline]] inline P apex(P* b, const Step& step, std::integer_sequence<int, Level...> /*levels*/) {
  (rise(b, step, std::make_integer_sequence<int, static_cast<int>(sizeof...(Level)) - Level>()), ...);
  return b[0];
}

template <class S, int D, int N, class Step>
[[gnu::always_inline]] inline Point<S, D> apex(const Points<S, D, N>& points, const Step& step) {
  Point<S, D> b[N + 1];
  for (int i = 0; i <= N; ++i) b[i] = points[i];
  return apex(b, step, std::make_integer_sequence<int, N>());
}

template <>
struct ByHand<bezierbench::DeCasteljau> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points) {
    using P = Point<S, D>;
    const S s = 1 - t;
    return apex(points, [s, t](const P& a, const P& b) -> P { return s * a + t * b; });
  }
};

template <>
struct ByHand<bezierbench::DeCasteljauFma> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points) {
    using P = Point<S, D>;
    const P right = on_every_axis<P>(t);
    return apex(points, [right](const P& a, const P& b) { return fused<P>(right, b, fused<P>(-right, a, a)); });
  }
};

template <>
struct ByHand<bezierbench::DeCasteljauLerp> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points) {
    using P = Point<S, D>;
    return apex(points, [t](const P& a, const P& b) -> P { return a + t * (b - a); });
  }
};

template <>
struct ByHand<bezierbench::DeCasteljauLerpFma> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points) {
    using P = Point<S, D>;
    const P right = on_every_axis<P>(t);
    return apex(points, [right](const P& a, const P& b) { return fused<P>(right, b - a, a); });
  }
};

template <>
struct ByHand<bezierbench::DeCasteljauTwoSided> {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points) {
    using P = Point<S, D>;
    const bool near_start = t + t <= 1;
    const S r = near_start ? t : 1 - t;
    P b[N + 1];
    for (int i = 0; i <= N; ++i) b[i] = points[near_start ? i : N - i];
    const auto step = [r](const P& left, const P& right) -> P { return left + r * (right - left); };
    return apex(b, step, std::make_integer_sequence<int, N>());
  }
};

template <>
struct ByHand<bezierbench::DeCasteljauFixedPoint> {
  /// `frame` has first and last point, the least values, the offset and the inverse of the scale.
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points, const Points<S, D, 4>& frame) {
    if (t <= 0) return frame[0];
    if (t >= 1) return frame[1];
    const auto x = ByHand<bezierbench::DeCasteljauLerpFma>::evaluate(t, points);
    return fused<Point<S, D>>(frame[4], x - frame[3], frame[2]);
  }
};

}  // namespace hand_written
