// SPDX-License-Identifier: MIT
// A triangle of sums or differences of neighbours, in place: level k replaces a_i by the sum or difference of a_i and
// a_(i-1), for i = n, ..., k.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

namespace bezierbench {

namespace detail {

/// Levels k to k + Levels - 1 in one pass over the coefficients, each of which is read and written once. before[l]
/// holds the value of coefficient i - 1 before level k + l.
template <std::size_t Levels, class At, class Combine>
void levels_at_once(const At& at, int k, int n, const Combine& combine) {
  using Scalar = std::remove_cvref_t<decltype(at(0))>;
  std::array<Scalar, Levels> before;
  Scalar last = at(k - 1);
  for (std::size_t level = 0; level < Levels; ++level) {  // coefficient k + level ends after level + 1 levels
    before[level] = last;
    last = at(k + static_cast<int>(level));
    for (std::size_t below = 0; below <= level; ++below) {
      const Scalar next = combine(last, before[below]);
      before[below] = last;
      last = next;
    }
    at(k + static_cast<int>(level)) = last;
  }
  for (int i = k + static_cast<int>(Levels); i <= n; ++i) {
    Scalar here = at(i);
    for (std::size_t level = 0; level < Levels; ++level) {
      const Scalar next = combine(here, before[level]);
      before[level] = here;
      here = next;
    }
    at(i) = here;
  }
}

}  // namespace detail

/// For k = 1, ..., n and i = n, ..., k replaces a_i by combine(a_i, a_(i-1)), where at(i) is a reference to a_i.
template <class At, class Combine>
void combine_neighbours(const At& at, int n, const Combine& combine) {
  constexpr std::size_t max_levels = 4;
  int k = 1;
  for (; k + static_cast<int>(max_levels) - 1 <= n; k += static_cast<int>(max_levels))
    detail::levels_at_once<max_levels>(at, k, n, combine);
  for (; k <= n; ++k) detail::levels_at_once<1>(at, k, n, combine);
}

}  // namespace bezierbench
