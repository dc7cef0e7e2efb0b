// SPDX-License-Identifier: MIT
// de Casteljau's triangle on lanes, several levels at a time: the same result as run_triangle() for scalars, in an
// order in which the values between the levels stay in registers.
//
// A sweep over `Levels` levels keeps the newest value of each. Each coefficient b_i that is read moves all of them on,
//   x <- b_i;  for every level: y <- step(newest, x), newest <- x, x <- y,
// and value i-Levels of the last level results. Every step is one of the triangle's, with the same operands: the order
// of steps that do not depend on each other changes no bit.
#pragma once

#include <array>
#include <utility>

#include "core/batch/lane_curve.hpp"
#include "core/batch/lane_memory.hpp"
#include "core/evaluate/methods/de_casteljau_farin.hpp"
#include "core/evaluate/schemes/compensated_triangle.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

/// A triangle of values that are many numbers, whose steps take far longer than to load and to store them: level by
/// level, in memory. The steps of a level do not wait for each other.
template <std::size_t Size, class L, class In, class Step>
HWY_INLINE std::array<L, Size> apex_in_memory(int n, const In& in, const Step& step) {
  ManyNumbers<Size, L> b;
  for (int i = 0; i <= n; ++i) b.set(i, in(i));
  for (int count = n; count > 0; --count) {
    auto left = b[0];
    for (int i = 0; i < count; ++i) {
      const auto right = b[i + 1];
      b.set(i, step(left, right));
      left = right;
    }
  }
  return b[0];
}

template <std::size_t K, class S, int Count, Curves Which, int Dimension, int Degree>
HWY_INLINE Point<Lanes<S, Count, Which>, Dimension> run_compensated_triangle(
    const ControlPoints<S, Count, Which, Dimension, Degree>& curve, const Lanes<S, Count, Which>& t) {
  using L = Lanes<S, Count, Which>;
  const auto s = two_sum<L>(L(1), -t);
  Point<L, Dimension> point;
  for (int axis = 0; axis < Dimension; ++axis)
    point[axis] = sum_of_parts(apex_in_memory<K, L>(
        curve.degree(),
        [&](int i) {
          std::array<L, K> parts;
          parts.fill(L(0));
          parts[0] = curve(axis, i);
          return parts;
        },
        [&](const auto& a, const auto& b) { return compensated_step<K, L>(a, b, s, t); }));
  return point;
}

template <class S, int Count, Curves Which, int Dimension, int Degree>
HWY_INLINE Point<Lanes<S, Count, Which>, Dimension> run_weighted_triangle(
    const Curve<Form::rational, Lanes<S, Count, Which>, Dimension, Degree>& curve, const Lanes<S, Count, Which>& t) {
  using L = Lanes<S, Count, Which>;
  const L s = L(1) - t;
  const auto top = apex_in_memory<Dimension + 1, L>(
      curve.degree(),
      [&](int i) {
        std::array<L, Dimension + 1> values;
        for (int axis = 0; axis < Dimension; ++axis) values[static_cast<std::size_t>(axis)] = curve.points(axis, i);
        values[Dimension] = curve.weights[i];
        return values;
      },
      [&](const auto& a, const auto& b) { return weighted_step<L>(a, b, s, t); });
  Point<L, Dimension> point;
  for (int axis = 0; axis < Dimension; ++axis) point[axis] = top[static_cast<std::size_t>(axis)];
  return point;
}

}  // namespace bezierbench::batch::HWY_NAMESPACE
