// SPDX-License-Identifier: MIT
// Turns the roster into kernels for the target that the including translation unit is compiled for.
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>

#include "core/batch/group_kernels.hpp"
#include "core/batch/lane_triangle.hpp"
#include "core/batch/roster.hpp"
#include "core/batch/target_table.hpp"

namespace bezierbench::batch::HWY_NAMESPACE {

template <class Prepared, class S>
HWY_INLINE Prepared prepared_from(const Parts<S>& parts) {
  if constexpr (std::is_constructible_v<Prepared, const Parts<S>&>)
    return Prepared(parts);
  else if constexpr (requires { Prepared{parts.first, parts.degree}; })
    return Prepared{parts.first, parts.degree};
  else if constexpr (requires { Prepared{{parts.first, parts.degree}, {parts.second, parts.degree}}; })
    return Prepared{{parts.first, parts.degree}, {parts.second, parts.degree}};
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

/// `Count` vectors of points at t[0], t[1], ...
template <class Entry, class S, int Dimension, int Count>
[[gnu::flatten]] void evaluate_block(const Parts<S>& parts, const S* t, S* points, std::size_t axis_stride) {
  using L = Lanes<S, Count>;
  using Prepared = typename Entry::State::template Prepared<L, Dimension, dynamic>;
  const Point<L, Dimension> point = Entry::Evaluator::evaluate(prepared_from<Prepared>(parts), L::load(t));
  for (int axis = 0; axis < Dimension; ++axis) point[axis].store(points + static_cast<std::size_t>(axis) * axis_stride);
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

/// Evaluates blocks of as many vectors as go side by side; returns the number of points.
template <class Entry, class S, int Dimension>
std::size_t evaluate_blocks(const Parts<S>& parts, const S* t, std::size_t count, S* points) {
  constexpr int side_by_side = vectors<Entry>(Dimension);
  constexpr std::size_t block = Lanes<S, side_by_side>::size;
  std::size_t k = 0;
  for (; k + block <= count; k += block)
    evaluate_block<Entry, S, Dimension, side_by_side>(parts, t + k, points + k, count);
  return k;
}

/// The number of vectors side by side where a triangle of this degree keeps all values of a level in registers.
constexpr int unrolled_vectors(int degree) { return 2 * (degree + 1) < 16 ? 2 : 1; }

/// The same for a degree that is known at compile time.
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

/// The same with the degree known at compile time where it is one of 2, ..., Entry::largest_unrolled_degree.
template <class Entry, class S, int Dimension, int... Less>
std::size_t evaluate_blocks(const Parts<S>& parts, const S* t, std::size_t count, S* points,
                            std::integer_sequence<int, Less...> /*degrees less 2*/) {
  std::size_t done = 0;
  const bool unrolled = ((parts.degree == Less + 2 &&
                          ((done = evaluate_unrolled<Entry, S, Dimension, Less + 2>(parts, t, count, points)), true)) ||
                         ...);
  return unrolled ? done : evaluate_blocks<Entry, S, Dimension>(parts, t, count, points);
}

/// Blocks, then single vectors; the last one is filled up with its first t.
template <class Entry, class S, int Dimension>
void evaluate_all(const Parts<S>& parts, const S* t, std::size_t count, S* points) {
  constexpr std::size_t single = Lanes<S, 1>::size;
  constexpr int unrolled_degrees = std::max(Entry::largest_unrolled_degree - 1, 0);
  std::size_t k = evaluate_blocks<Entry, S, Dimension>(parts, t, count, points,
                                                       std::make_integer_sequence<int, unrolled_degrees>());
  for (; k + single <= count; k += single) evaluate_block<Entry, S, Dimension, 1>(parts, t + k, points + k, count);
  if (k == count) return;
  S filled[single];
  S last[single * Dimension];
  for (std::size_t lane = 0; lane < single; ++lane) filled[lane] = t[k + lane < count ? k + lane : k];
  evaluate_block<Entry, S, Dimension, 1>(parts, filled, last, single);
  for (std::size_t axis = 0; axis < Dimension; ++axis)
    for (std::size_t lane = 0; k + lane < count; ++lane) points[axis * count + k + lane] = last[axis * single + lane];
}

template <class S, class... Entries>
inline constexpr TargetKernels<S> kernels_of[sizeof...(Entries)] = {
    {{evaluate_all<Entries, S, 1>, evaluate_all<Entries, S, 2>, evaluate_all<Entries, S, 3>}}...};

template <class S, class... Entries>
constexpr TargetTable<S> table_of(TypeList<Entries...> /*entries*/) {
  return {kernels_of<S, Entries...>, sizeof...(Entries), group_table<S>()};
}

template <class S, class... Plain, class... WithFma>
constexpr TargetTable<S> table_of(TypeList<Plain...> plain, TypeList<WithFma...> /*fused*/) {
  if constexpr (HWY_NATIVE_FMA != 0)
    return table_of<S>(TypeList<Plain..., WithFma...>());
  else
    return table_of<S>(plain);
}

}  // namespace bezierbench::batch::HWY_NAMESPACE
