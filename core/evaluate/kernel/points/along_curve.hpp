// SPDX-License-Identifier: MIT
// Triangles on one axis with several consecutive control points in each vector, so that one vector operation does
// several steps of a level. This pays for steps that take longer than to shift a vector by a lane. Each step has the
// operands of the scalar triangle, so the bits are the same. Lanes after the last value of a level hold numbers that
// nothing reads.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/evaluate/kernel/points/axes.hpp"
#include "core/evaluate/methods/de_casteljau_farin.hpp"
#include "core/evaluate/schemes/compensated_triangle.hpp"

namespace bezierbench {

namespace detail {

/// Consecutive values of a curve: all four of a cubic, for other degrees as many as fill 32 bytes.
template <class S, int Degree>
using AlongCurve = Axes<S, Degree == 3 ? 4 : 32 / static_cast<int>(sizeof(S))>;

/// Whether the values of a curve are loaded as whole vectors. A curve of fewer values is filled lane by lane, which
/// takes longer than its few steps.
template <int Degree>
inline constexpr bool fills_vectors = Degree == dynamic || Degree == 3;

/// The first `count` values, and 0 in the other lanes.
template <class V, class S>
V load_first(const S* values, int count) {
  if (count >= V::Kind::lanes) return V::load(values);
  S first[V::Kind::lanes] = {};
  std::copy_n(values, std::max(count, 0), first);
  return V::load(first);
}

/// The top of a triangle whose values are `Size` numbers. rows[k] has the k-th number of each value of the bottom
/// level, and nullptr stands for zeros. `step` combines neighbours.
template <class S, int Degree, std::size_t Size, class Step>
std::array<S, Size> apex_along_curve(int n, const std::array<const S*, Size>& rows, const Step& step) {
  using V = AlongCurve<S, Degree>;
  constexpr int most = (Degree == dynamic ? max_degree : Degree) / V::Kind::lanes + 2;
  V b[Size][most];
  for (std::size_t k = 0; k < Size; ++k)
    for (int i = 0; i <= n + V::Kind::lanes; i += V::Kind::lanes)
      b[k][i / V::Kind::lanes] = rows[k] == nullptr ? V(S(0)) : load_first<V>(rows[k] + i, n + 1 - i);
  for (int count = n; count > 0; --count)
    for (int i = 0; i * V::Kind::lanes < count; ++i) {
      std::array<V, Size> left;
      std::array<V, Size> right;
      for (std::size_t k = 0; k < Size; ++k) {
        left[k] = b[k][i];
        right[k] = shifted(b[k][i], b[k][i + 1]);
      }
      const auto next = step(left, right);
      for (std::size_t k = 0; k < Size; ++k) b[k][i] = next[k];
    }
  std::array<S, Size> top;
  for (std::size_t k = 0; k < Size; ++k) top[k] = b[k][0].lane(0);
  return top;
}

}  // namespace detail

template <std::size_t K, class S, int Degree>
requires(detail::fills_vectors<Degree>) auto run_compensated_triangle(
    const Curve<Form::bernstein, Axes<S, 1>, 1, Degree>& curve, const Axes<S, 1>& t) {
  using V = detail::AlongCurve<S, Degree>;
  const auto rest = two_sum<S>(S(1), -t.lane(0));
  const Expansion2<V> s{V(rest.value), V(rest.error)};
  const V right(t.lane(0));
  const auto parts = detail::apex_along_curve<S, Degree, K>(
      curve.degree(), {curve.data()},
      [&](const auto& a, const auto& b) { return compensated_step<K, V>(a, b, s, right); });
  Point<Axes<S, 1>, 1> point;
  point[0] = Axes<S, 1>(sum_of_parts(parts));
  return point;
}

template <class S, int Degree>
requires(detail::fills_vectors<Degree>) auto run_weighted_triangle(
    const Curve<Form::rational, Axes<S, 1>, 1, Degree>& curve, const Axes<S, 1>& t) {
  using V = detail::AlongCurve<S, Degree>;
  const V right(t.lane(0));
  const V s = V(S(1)) - right;
  const auto top = detail::apex_along_curve<S, Degree, 2>(
      curve.degree(), {curve.points.data(), curve.weights.data()},
      [&](const auto& a, const auto& b) { return weighted_step<V>(a, b, s, right); });
  Point<Axes<S, 1>, 1> point;
  point[0] = Axes<S, 1>(top[0]);
  return point;
}

}  // namespace bezierbench
