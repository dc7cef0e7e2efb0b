// SPDX-License-Identifier: MIT
// Turns the roster into kernels for the target that the including translation unit is compiled for.
#pragma once

#include <type_traits>
#include <utility>

#include "core/batch/lanes.hpp"
#include "core/batch/roster.hpp"
#include "core/batch/target_table.hpp"
#include "core/batch/targets.hpp"
#include "core/evaluate/kernel/parts.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

/// The number of vectors that are evaluated side by side: eight chains hide the latency of a multiply-add, unless the
/// registers allow fewer.
template <class E>
constexpr int vectors(int dimension) {
  constexpr int registers = HWY_TARGET == HWY_AVX2 ? 16 : 32;
  constexpr int temporaries = 3;
  int count = dimension == 1 ? 8 : 4;
  while (count > 1 && count * (E::lanes.per_axis * dimension + E::lanes.shared) > registers - temporaries) count /= 2;
  return count;
}

/// The number of points in a block: all vectors that go side by side.
template <class E, class S, int Dimension>
inline constexpr std::size_t points_of_block = Lanes<S, vectors<E>(Dimension)>::size;

/// That many blocks of points at t[0], t[1], ... It is compiled once for all who call it.
template <class E, class S, int Dimension>
[[gnu::flatten, gnu::noinline]] void evaluate_blocks(const Parts& parts, const S* t, std::size_t blocks, S* points,
                                                     std::size_t axis_stride) {
  using L = Lanes<S, vectors<E>(Dimension)>;
  const auto prepared = viewed_as<PreparedOf<E, S, Dimension>, L, dynamic>(parts);
  with_evaluation<E>(prepared, [=](const auto& point_at) {
    S* next = points;
    for (std::size_t k = 0; k < blocks; ++k, next += L::size) {
      const Point<L, Dimension> point = point_at(L::load(t + k * L::size));
      for (int axis = 0; axis < Dimension; ++axis)
        point[axis].store(next + static_cast<std::size_t>(axis) * axis_stride);
    }
  });
}

/// Every coefficient in all lanes, on the stack. It is copied to the lanes once: a compiler would do so again for every
/// point, because it cannot know that points do not overlap the coefficients.
template <class L, int Dimension, int Degree>
HWY_INLINE Curve<Form::bernstein, L, Dimension, Degree> spread(const Parts& parts) {
  Curve<Form::bernstein, L, Dimension, Degree> curve(Degree);
  const auto* next = static_cast<const typename L::Scalar*>(parts.arrays[0]);
  for (int i = 0; i <= Degree; ++i)
    for (int axis = 0; axis < Dimension; ++axis) curve(axis, i) = L(*next++);
  return curve;
}

/// The number of vectors side by side where a triangle of this degree keeps all values of a level in registers.
constexpr int unrolled_vectors(int degree) { return 2 * (degree + 1) < 16 ? 2 : 1; }

/// The points at the first t, as many as fill whole vectors, for a degree that is known at compile time; returns their
/// number.
template <class E, class S, int Dimension, int Degree>
[[gnu::flatten, gnu::noinline]] std::size_t evaluate_unrolled(const Parts& parts, const S* t, std::size_t count,
                                                              S* points) {
  using L = Lanes<S, unrolled_vectors(Degree), Held::by_value>;
  const auto curve = spread<L, Dimension, Degree>(parts);
  std::size_t k = 0;
  for (; k + L::size <= count; k += L::size) {
    const Point<L, Dimension> point = E::evaluate(curve, L::load(t + k));
    for (int axis = 0; axis < Dimension; ++axis) point[axis].store(points + static_cast<std::size_t>(axis) * count + k);
  }
  return k;
}

/// The same where the degree is one of 2, ..., E::lanes.largest_fixed_degree; else none.
template <class E, class S, int Dimension, int... Less>
std::size_t evaluate_unrolled(const Parts& parts, const S* t, std::size_t count, S* points,
                              std::integer_sequence<int, Less...> /*degrees less 2*/) {
  std::size_t done = 0;
  ((parts.degree == Less + 2 ? void(done = evaluate_unrolled<E, S, Dimension, Less + 2>(parts, t, count, points))
                             : void()),
   ...);
  return done;
}

/// Whole blocks, then what is left in a block that is filled up with its first t.
template <class E, class S, int Dimension>
void evaluate_all(const Parts& parts, const S* t, std::size_t count, S* points) {
  constexpr std::size_t block = points_of_block<E, S, Dimension>;
  std::size_t k = 0;
  if constexpr (E::lanes.largest_fixed_degree >= 2)
    k = evaluate_unrolled<E, S, Dimension>(parts, t, count, points,
                                           std::make_integer_sequence<int, E::lanes.largest_fixed_degree - 1>());
  const std::size_t blocks = (count - k) / block;
  evaluate_blocks<E, S, Dimension>(parts, t + k, blocks, points + k, count);
  k += blocks * block;
  if (k == count) return;
  S filled[block];
  S last[block * Dimension];
  for (std::size_t lane = 0; lane < block; ++lane) filled[lane] = t[k + lane < count ? k + lane : k];
  evaluate_blocks<E, S, Dimension>(parts, filled, 1, last, block);
  for (std::size_t axis = 0; axis < Dimension; ++axis)
    for (std::size_t lane = 0; k + lane < count; ++lane) points[axis * count + k + lane] = last[axis * block + lane];
}

/// Evaluates one axis after the other; the coefficients of each are copied into a row first.
template <class S, int Dimension, Evaluate<S> evaluate_axis>
void evaluate_each_axis(const Parts& parts, const S* t, std::size_t count, S* points) {
  const S* const all = static_cast<const S*>(parts.arrays[0]);
  S coefficients[max_degree + 1];
  for (int axis = 0; axis < Dimension; ++axis, points += count) {
    for (int i = 0; i <= parts.degree; ++i) coefficients[i] = all[i * Dimension + axis];
    evaluate_axis({parts.degree, {coefficients}}, t, count, points);
  }
}

template <class E, class S, int Dimension>
constexpr Evaluate<S> kernel() {
  if constexpr (axis_by_axis<E> && Dimension > 1)
    return evaluate_each_axis<S, Dimension, evaluate_all<E, S, 1>>;
  else
    return evaluate_all<E, S, Dimension>;
}

template <class E, class S>
constexpr Evaluate<S> homogeneous_kernel() {
  if constexpr (takes_rational<E>)
    return kernel<E, S, max_dimension + 1>();
  else
    return nullptr;
}

template <class S, class... Es>
inline constexpr TargetKernels<S> kernels_of[sizeof...(Es)] = {
    {{kernel<Es, S, 1>(), kernel<Es, S, 2>(), kernel<Es, S, 3>(), homogeneous_kernel<Es, S>()}}...};

template <class S, class... Es>
constexpr const TargetKernels<S>* unit_table(TypeList<Es...> /*evaluators*/) {
  return kernels_of<S, Es...>;
}

}  // namespace bezierbench::batch::HWY_NAMESPACE

namespace bezierbench::batch {

template <class Target, int Unit, class Scalar>
constinit const TargetKernels<Scalar>* const UnitOf<Target, Unit, Scalar>::table =
    HWY_NAMESPACE::unit_table<Scalar>(Dealt<Unit, units, OneCurve>());

}  // namespace bezierbench::batch
