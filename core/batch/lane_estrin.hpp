// SPDX-License-Identifier: MIT
// Estrin's scheme on lanes: the same joins as join_neighbours() for scalars, the first two levels in registers.
#pragma once

#include <array>

#include "core/batch/lane_curve.hpp"
#include "core/batch/lane_memory.hpp"
#include "core/evaluate/methods/estrin.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

template <class L, std::size_t Axes>
using OnAllAxes = std::array<L, Axes>;

/// left + right * power on all axes.
template <class L, std::size_t Axes>
HWY_INLINE OnAllAxes<L, Axes> join(const OnAllAxes<L, Axes>& left, const OnAllAxes<L, Axes>& right, const L& power) {
  OnAllAxes<L, Axes> joined;
  for (std::size_t axis = 0; axis < Axes; ++axis) joined[axis] = left[axis] + right[axis] * power;
  return joined;
}

/// q(0), ..., q(n) are coefficients.
template <std::size_t Axes, class L, class Coefficient>
HWY_INLINE OnAllAxes<L, Axes> joined(int n, const Coefficient& q, const L& t) {
  const L square = t * t;
  ManyNumbers<Axes, L> b;
  const int fours = (n + 1) / 4;
  for (int k = 0; k < fours; ++k)
    b.set(k, join(join(q(4 * k), q(4 * k + 1), t), join(q(4 * k + 2), q(4 * k + 3), t), square));
  const int rest = (n + 1) % 4;
  if (rest == 1) b.set(fours, q(n));
  if (rest == 2) b.set(fours, join(q(n - 1), q(n), t));
  if (rest == 3) b.set(fours, join(join(q(n - 2), q(n - 1), t), q(n), square));
  L power = square * square;
  for (int count = fours + (rest > 0 ? 1 : 0); count > 1; count = (count + 1) / 2, power *= power) {
    for (int k = 0; k < count / 2; ++k) b.set(k, join(b[2 * k], b[2 * k + 1], power));
    if (count % 2 != 0) b.set(count / 2, b[count - 1]);
  }
  return b[0];
}

template <class S, int Count, Curves Which, int Dimension, int Degree>
HWY_INLINE Point<Lanes<S, Count, Which>, Dimension> join_neighbours(
    const Curve<Form::power, Lanes<S, Count, Which>, Dimension, Degree>& q, const Lanes<S, Count, Which>& t) {
  using L = Lanes<S, Count, Which>;
  const auto all = joined<Dimension>(
      q.degree(),
      [&q](int i) {
        OnAllAxes<L, Dimension> each;
        for (int axis = 0; axis < Dimension; ++axis) each[static_cast<std::size_t>(axis)] = q(axis, i);
        return each;
      },
      t);
  Point<L, Dimension> point;
  for (int axis = 0; axis < Dimension; ++axis) point[axis] = all[static_cast<std::size_t>(axis)];
  return point;
}

}  // namespace bezierbench::batch::HWY_NAMESPACE
