// SPDX-License-Identifier: MIT
// Schemes in three and more parts, each of the errors of the one before.
#pragma once

#include "core/evaluate/compensated_de_casteljau_k3.hpp"
#include "core/evaluate/compensated_de_casteljau_k4.hpp"
#include "core/evaluate/compensated_horner_k3.hpp"
#include "core/evaluate/compensated_horner_k4.hpp"
#include "experiments/programs/hand_written/by_hand.hpp"
#include "experiments/programs/hand_written/point.hpp"

namespace hand_written {

/// Adds `term` to `total`; returns the rounding error of the sum.
template <class P>
P add(P& total, const P& term) {
  const auto sum = exact_sum<P>(total, term);
  total = sum.value;
  return sum.error;
}

/// The sum of the parts, K-fold.
template <int K, class P>
P sum_of(P (&parts)[K]) {
  for (int pass = 1; pass < K; ++pass)
    for (int k = K - 1; k > 0; --k) parts[k] = add<P>(parts[k - 1], parts[k]);
  P tail = parts[K - 1];
  for (int k = K - 2; k > 0; --k) tail = tail + parts[k];
  return parts[0] + tail;
}

template <int K>
struct HornerInParts {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& q) {
    using P = Point<S, D>;
    const P on_axes = on_every_axis<P>(t);
    P v[K];
    for (auto& part : v) part = P{};
    v[0] = q[N];
    for (int j = N - 1; j >= 0; --j) {
      P errors[K];  // part + 1 of them go into a part
      const auto first = exact_product<P>(v[0], on_axes);
      v[0] = first.value;
      errors[1] = add<P>(v[0], q[j]);
      errors[0] = first.error;
      for (int part = 1; part + 1 < K; ++part) {
        P total = errors[0];
        for (int i = 1; i <= part; ++i) errors[i - 1] = add<P>(total, errors[i]);
        const auto product = exact_product<P>(v[part], on_axes);
        errors[part] = add<P>(total, product.value);
        errors[part + 1] = product.error;
        v[part] = total;
      }
      P total = errors[0];
      for (int i = 1; i < K; ++i) total = total + errors[i];
      v[K - 1] = v[K - 1] * on_axes + total;
    }
    return sum_of<K, P>(v);
  }
};

template <>
struct ByHand<bezierbench::CompensatedHornerK3> : HornerInParts<3> {};
template <>
struct ByHand<bezierbench::CompensatedHornerK4> : HornerInParts<4> {};

template <int K>
struct TriangleInParts {
  /// s is 1-t with its error; `a` becomes the combination of a and b.
  template <class P>
  [[gnu::always_inline]] static void step(P (&a)[K], const P (&b)[K], const Exact<P>& s, const P& t) {
    P errors[5 * K - 7];  // 5 part - 2 of them go into a part
    const auto first_left = exact_product<P>(s.value, a[0]);
    const auto first_right = exact_product<P>(t, b[0]);
    P above = a[0];
    a[0] = first_left.value;
    errors[2] = add<P>(a[0], first_right.value);
    errors[1] = first_right.error;
    errors[0] = first_left.error;
    for (int part = 1; part + 1 < K; ++part) {
      const int count = 5 * part - 2;
      P total = errors[0];
      for (int i = 1; i < count; ++i) errors[i - 1] = add<P>(total, errors[i]);
      const auto lost = exact_product<P>(s.error, above);
      const auto right = exact_product<P>(t, b[part]);
      const auto left = exact_product<P>(s.value, a[part]);
      errors[count - 1] = add<P>(total, lost.value);
      errors[count] = lost.error;
      errors[count + 1] = add<P>(total, right.value);
      errors[count + 2] = right.error;
      errors[count + 3] = add<P>(total, left.value);
      errors[count + 4] = left.error;
      above = a[part];
      a[part] = total;
    }
    P total = errors[0];
    for (int i = 1; i < 5 * (K - 1) - 2; ++i) total = total + errors[i];
    a[K - 1] = ((total + s.error * above) + t * b[K - 1]) + s.value * a[K - 1];
  }

  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points) {
    using P = Point<S, D>;
    const auto rest = exact_sum<S>(1, -t);
    const Exact<P> s{on_every_axis<P>(rest.value), on_every_axis<P>(rest.error)};
    const P right = on_every_axis<P>(t);
    P b[N + 1][K];
    for (int i = 0; i <= N; ++i) {
      for (auto& part : b[i]) part = P{};
      b[i][0] = points[i];
    }
    for (int last = N; last > 0; --last)
      for (int i = 0; i < last; ++i) step<P>(b[i], b[i + 1], s, right);
    return sum_of<K, P>(b[0]);
  }
};

template <>
struct ByHand<bezierbench::CompensatedDeCasteljauK3> : TriangleInParts<3> {};
template <>
struct ByHand<bezierbench::CompensatedDeCasteljauK4> : TriangleInParts<4> {};

}  // namespace hand_written
