// SPDX-License-Identifier: MIT
// Loops of a length known at compile time, unrolled step by step: GCC unrolls nested loops too late to keep small
// polygons in registers.
#pragma once

#include <utility>

#include "core/curve.hpp"

namespace bezierbench {

/// Calls step(i) for i = 0, ..., count - 1. Count is that number at compile time, or `dynamic`.
template <int Count, class Step>
void each(int count, const Step& step) {
  if constexpr (Count == dynamic)
    for (int i = 0; i < count; ++i) step(i);
  else
    [&]<int... I>(std::integer_sequence<int, I...> /*all*/) { (step(I), ...); }
  (std::make_integer_sequence<int, Count>());
}

/// For every level of de Casteljau's triangle with at least `Least` points calls step(i) for i = 0, ..., count - 1,
/// where count falls from the degree to `Least`. Degree is that number at compile time, or `dynamic`.
template <int Degree, int Least = 1, class Step>
void each_of_triangle(int degree, const Step& step) {
  if constexpr (Degree == dynamic)
    for (int count = degree; count >= Least; --count) each<dynamic>(count, step);
  else if constexpr (Degree >= Least) {
    each<Degree>(Degree, step);
    each_of_triangle<Degree - 1, Least>(Degree - 1, step);
  }
}

}  // namespace bezierbench
