// SPDX-License-Identifier: MIT
// Turns the roster into kernels for the target that the including translation unit is compiled for.
#pragma once

#include <type_traits>
#include <utility>

#include "core/batch/lane_triangle.hpp"
#include "core/batch/roster.hpp"
#include "core/batch/target_table.hpp"
#include "core/batch/targets.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

template <class Prepared, class S>
HWY_INLINE Prepared prepared_from(const Parts<S>& parts) {
  if constexpr (std::is_constructible_v<Prepared, const Parts<S>&>)
    return Prepared(parts);
  else if constexpr (requires { Prepared{parts.first, parts.degree}; })
    return Prepared{parts.first, parts.degree};
  else if constexpr (requires { Prepared{{parts.first, parts.degree}, {parts.second, parts.degree}}; })
    return Prepared{{parts.first, parts.degree}, {parts.second, parts.degree}};
  else if constexpr (requires {
                       Prepared{{parts.first, parts.degree}, {parts.second, parts.degree}, {parts.third, 0}};
                     })
    return Prepared{{parts.first, parts.degree}, {parts.second, parts.degree}, {parts.third, parts.degree}};
  else
    return Prepared{{parts.first, parts.degree}};
}

/// The number of vectors that are evaluated side by side: eight chains hide the latency of a multiply-add, unless the
/// registers allow fewer.
template <class Entry>
constexpr int vectors(int dimension) {
  constexpr int registers = HWY_TARGET == HWY_AVX2 ? 16 : 32;
  constexpr int temporaries = 3;
  int count = dimension == 1 ? 8 : 4;
  while (count > 1 && count * Entry::live(dimension) > registers - temporaries) count /= 2;
  return count;
}

/// The number of points in a block: all vectors that go side by side.
template <class Entry, class S, int Dimension>
inline constexpr std::size_t points_of_block = Lanes<S, vectors<Entry>(Dimension)>::size;

/// That many blocks of points at t[0], t[1], ... It is compiled once for all who call it.
template <class Entry, class S, int Dimension>
[[gnu::flatten, gnu::noinline]] void evaluate_blocks(const Parts<S>& parts, const S* t, std::size_t blocks, S* points,
                                                     std::size_t axis_stride) {
  using L = Lanes<S, vectors<Entry>(Dimension)>;
  const auto prepared = prepared_from<typename Entry::State::template Prepared<L, Dimension, dynamic>>(parts);
  with_evaluation<typename Entry::Evaluator>(prepared, [=](const auto& point_at) {
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
template <class L, int Dimension, int Degree, class S>
HWY_INLINE Curve<Form::bernstein, L, Dimension, Degree> spread(const Parts<S>& parts) {
  Curve<Form::bernstein, L, Dimension, Degree> curve(Degree);
  const S* next = parts.first;
  for (int i = 0; i <= Degree; ++i)
    for (int axis = 0; axis < Dimension; ++axis) curve(axis, i) = L(*next++);
  return curve;
}

/// The number of vectors side by side where a triangle of this degree keeps all values of a level in registers.
constexpr int unrolled_vectors(int degree) { return 2 * (degree + 1) < 16 ? 2 : 1; }

/// The points at the first t, as many as fill whole vectors, for a degree that is known at compile time; returns their
/// number.
template <class Entry, class S, int Dimension, int Degree>
[[gnu::flatten, gnu::noinline]] std::size_t evaluate_unrolled(const Parts<S>& parts, const S* t, std::size_t count,
                                                              S* points) {
  using L = Lanes<S, unrolled_vectors(Degree), Curves::each>;
  const auto curve = spread<L, Dimension, Degree>(parts);
  std::size_t k = 0;
  for (; k + L::size <= count; k += L::size) {
    const Point<L, Dimension> point = Entry::Evaluator::evaluate(curve, L::load(t + k));
    for (int axis = 0; axis < Dimension; ++axis) point[axis].store(points + static_cast<std::size_t>(axis) * count + k);
  }
  return k;
}

/// The same where the degree is one of 2, ..., Entry::largest_unrolled_degree; else none.
template <class Entry, class S, int Dimension, int... Less>
std::size_t evaluate_unrolled(const Parts<S>& parts, const S* t, std::size_t count, S* points,
                              std::integer_sequence<int, Less...> /*degrees less 2*/) {
  std::size_t done = 0;
  ((parts.degree == Less + 2 ? void(done = evaluate_unrolled<Entry, S, Dimension, Less + 2>(parts, t, count, points))
                             : void()),
   ...);
  return done;
}

/// Whole blocks, then what is left in a block that is filled up with its first t.
template <class Entry, class S, int Dimension>
void evaluate_all(const Parts<S>& parts, const S* t, std::size_t count, S* points) {
  constexpr std::size_t block = points_of_block<Entry, S, Dimension>;
  std::size_t k = 0;
  if constexpr (Entry::largest_unrolled_degree >= 2)
    k = evaluate_unrolled<Entry, S, Dimension>(parts, t, count, points,
                                               std::make_integer_sequence<int, Entry::largest_unrolled_degree - 1>());
  const std::size_t blocks = (count - k) / block;
  evaluate_blocks<Entry, S, Dimension>(parts, t + k, blocks, points + k, count);
  k += blocks * block;
  if (k == count) return;
  S filled[block];
  S last[block * Dimension];
  for (std::size_t lane = 0; lane < block; ++lane) filled[lane] = t[k + lane < count ? k + lane : k];
  evaluate_blocks<Entry, S, Dimension>(parts, filled, 1, last, block);
  for (std::size_t axis = 0; axis < Dimension; ++axis)
    for (std::size_t lane = 0; k + lane < count; ++lane) points[axis * count + k + lane] = last[axis * block + lane];
}

/// Evaluates one axis after the other; the coefficients of each are copied into a row first.
template <class S, int Dimension, Evaluate<S> evaluate_axis>
void evaluate_each_axis(const Parts<S>& parts, const S* t, std::size_t count, S* points) {
  S coefficients[max_degree + 1];
  for (int axis = 0; axis < Dimension; ++axis, points += count) {
    for (int i = 0; i <= parts.degree; ++i) coefficients[i] = parts.first[i * Dimension + axis];
    evaluate_axis({parts.degree, coefficients}, t, count, points);
  }
}

template <class Entry, class S, int Dimension>
constexpr Evaluate<S> kernel() {
  if constexpr (axis_by_axis<typename Entry::Evaluator> && Dimension > 1)
    return evaluate_each_axis<S, Dimension, evaluate_all<Entry, S, 1>>;
  else
    return evaluate_all<Entry, S, Dimension>;
}

template <class Entry, class S>
constexpr Evaluate<S> homogeneous_kernel() {
  if constexpr (takes_rational<typename Entry::Evaluator>)
    return kernel<Entry, S, max_dimension + 1>();
  else
    return nullptr;
}

template <class S, class... Entries>
inline constexpr TargetKernels<S> kernels_of[sizeof...(Entries)] = {
    {{kernel<Entries, S, 1>(), kernel<Entries, S, 2>(), kernel<Entries, S, 3>(), homogeneous_kernel<Entries, S>()}}...};

template <class S, class... Entries>
constexpr FamilyTable<S> table_of(TypeList<Entries...> /*entries*/) {
  if constexpr (sizeof...(Entries) > 0)
    return {kernels_of<S, Entries...>, sizeof...(Entries)};
  else
    return {nullptr, 0};
}

template <class S, class Family>
constexpr FamilyTable<S> family_table() {
  if constexpr (HWY_NATIVE_FMA != 0)
    return table_of<S>(EntriesOf<Family>());
  else
    return table_of<S>(typename Family::Unfused());
}

}  // namespace bezierbench::batch::HWY_NAMESPACE

namespace bezierbench::batch {

template <class Target, class Family, class Scalar>
constinit const FamilyTable<Scalar> FamilyOf<Target, Family, Scalar>::table =
    HWY_NAMESPACE::family_table<Scalar, Family>();

}  // namespace bezierbench::batch
