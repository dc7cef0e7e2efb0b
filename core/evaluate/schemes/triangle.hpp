// SPDX-License-Identifier: MIT
// The triangle of de Casteljau: b_i^k = step(b_i^(k-1), b_(i+1)^(k-1)), p(t) = b_0^n. Its variants differ in the step
// only, so they share this code. Every scalar runs the same steps on the same operands; they differ in the order, which
// changes no bit, because it is among steps that do not depend on each other:
// - level by level, every step written out and all values in registers, for a degree that is known at compile time;
// - in sweeps over four levels, for any other degree. A sweep keeps the newest value of each level. Each value x of the
//   lowest level moves all of them on: for every level, y <- step(newest, x), newest <- x, x <- y.
//
// All variants keep axes_independent, scaling_by_two and total, because their steps are sums, differences and products
// with t or the rounded 1-t; docs/proofs/de_casteljau.md has the proof.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "core/evaluate/evaluator.hpp"

namespace bezierbench {

/// How a scalar runs a triangle.
struct TriangleOrder {
  int largest_fixed = 20;  ///< the largest degree that is written out where it is known at compile time
  int width = 1;           ///< values that a sweep takes at once: their steps on a level do not wait for each other
  bool ends_in_registers = false;  ///< whether the last levels after sweeps, 9 to 16, are written out
};
template <class Scalar>
inline constexpr TriangleOrder triangle_order{};

namespace detail {

/// One level of the triangle: b[I] <- step(b[I], b[I + 1]) for every I, ascending.
template <class Scalar, class Step, int... I>
[[gnu::always_inline]] inline void rise(Scalar* b, const Step& step, std::integer_sequence<int, I...> /*values*/) {
  ((b[I] = step(b[I], b[I + 1])), ...);
}

/// The top of a triangle over in(0), ..., in(n), level by level.
template <class Scalar, class In, class Step, int... Level>
[[gnu::always_inline]] inline Scalar apex_by_levels(const In& in, const Step& step,
                                                    std::integer_sequence<int, Level...> /*levels*/) {
  constexpr int degree = sizeof...(Level);
  Scalar b[degree + 1];
  ((b[Level] = in(Level)), ...);
  b[degree] = in(degree);
  (rise(b, step, std::make_integer_sequence<int, degree - Level>()), ...);
  return b[0];
}

/// Moves x up by one level of a sweep.
template <class Scalar, class Step>
[[gnu::always_inline]] inline void move_up(Scalar& newest, Scalar& x, const Step& step) {
  const Scalar y = step(newest, x);
  newest = x;
  x = y;
}

/// Moves x up through the levels of a sweep.
template <class Scalar, class Step, int... Level>
[[gnu::always_inline]] inline Scalar pass([[maybe_unused]] Scalar* newest, Scalar x, [[maybe_unused]] const Step& step,
                                          std::integer_sequence<int, Level...> /*levels*/) {
  (move_up(newest[Level], x, step), ...);
  return x;
}

/// Moves `Width` consecutive values up by one level.
template <int Width, class Scalar, class Step>
[[gnu::always_inline]] inline void pass_together(Scalar& newest, Scalar* x, const Step& step) {
  const Scalar last = x[Width - 1];
  for (int k = Width - 1; k > 0; --k) x[k] = step(x[k - 1], x[k]);
  x[0] = step(newest, x[0]);
  newest = last;
}

/// in(0), ..., in(count - 1) are the values of one level; out(i, b_i) takes those of the level so many further on.
template <class Scalar, class In, class Step, class Out, int... Level>
[[gnu::always_inline]] inline void sweep(int count, const In& in, const Step& step, const Out& out,
                                         std::integer_sequence<int, Level...> all) {
  constexpr int levels = sizeof...(Level);
  constexpr int width = triangle_order<Scalar>.width;
  Scalar newest[levels];
  ((newest[Level] = pass(newest, in(Level), step, std::make_integer_sequence<int, Level>())), ...);
  int i = levels;
  if constexpr (width > 1)
    for (; i + width <= count; i += width) {
      Scalar x[width];
      for (int k = 0; k < width; ++k) x[k] = in(i + k);
      (pass_together<width>(newest[Level], x, step), ...);
      for (int k = 0; k < width; ++k) out(i + k - levels, x[k]);
    }
  for (; i < count; ++i) out(i - levels, pass(newest, in(i), step, all));
}

/// A sweep over at most four of the n levels that are left; returns how many are left then.
template <class Scalar, class In, class Step, class Out>
[[gnu::always_inline]] inline int sweep(int n, const In& in, const Step& step, const Out& out) {
  const auto over = [&](auto levels) { sweep<Scalar>(n + 1, in, step, out, levels); };
  switch (n) {
    case 1: over(std::make_integer_sequence<int, 1>()); return 0;
    case 2: over(std::make_integer_sequence<int, 2>()); return 0;
    case 3: over(std::make_integer_sequence<int, 3>()); return 0;
    default: over(std::make_integer_sequence<int, 4>()); return n - 4;
  }
}

/// The top of a triangle over in(0), ..., in(n), in sweeps.
template <class Scalar, class In, class Step>
[[gnu::always_inline]] inline Scalar apex_by_sweeps(int n, const In& in, const Step& step) {
  if (n == 0) return in(0);
  Scalar b[largest_degree<Scalar> + 1];
  b[0] = in(0);
  const auto read = [&b](int i) { return b[i]; };
  const auto write = [&b](int i, const Scalar& value) { b[i] = value; };
  if constexpr (triangle_order<Scalar>.ends_in_registers) {
    for (int i = 1; i <= n; ++i) b[i] = in(i);
    for (; n > 0; n = sweep<Scalar>(n, read, step, write)) switch (n) {
        case 9: return apex_by_levels<Scalar>(read, step, std::make_integer_sequence<int, 9>());
        case 10: return apex_by_levels<Scalar>(read, step, std::make_integer_sequence<int, 10>());
        case 11: return apex_by_levels<Scalar>(read, step, std::make_integer_sequence<int, 11>());
        case 12: return apex_by_levels<Scalar>(read, step, std::make_integer_sequence<int, 12>());
        case 13: return apex_by_levels<Scalar>(read, step, std::make_integer_sequence<int, 13>());
        case 14: return apex_by_levels<Scalar>(read, step, std::make_integer_sequence<int, 14>());
        case 15: return apex_by_levels<Scalar>(read, step, std::make_integer_sequence<int, 15>());
        case 16: return apex_by_levels<Scalar>(read, step, std::make_integer_sequence<int, 16>());
        default: break;
      }
  } else {
    n = sweep<Scalar>(n, in, step, write);
    while (n > 0) n = sweep<Scalar>(n, read, step, write);
  }
  return b[0];
}

/// Room for one value of `Size` numbers per coefficient.
template <std::size_t Size, class Scalar>
class ManyNumbers {
 public:
  [[nodiscard, gnu::always_inline]] std::array<Scalar, Size> operator[](int i) const {
    std::array<Scalar, Size> value;
    for (std::size_t k = 0; k < Size; ++k) value[k] = numbers_[static_cast<std::size_t>(i) * Size + k];
    return value;
  }
  [[gnu::always_inline]] void set(int i, const std::array<Scalar, Size>& value) {
    for (std::size_t k = 0; k < Size; ++k) numbers_[static_cast<std::size_t>(i) * Size + k] = value[k];
  }

 private:
  Scalar numbers_[(largest_degree<Scalar> + 1) * Size];
};

/// The top of a triangle over values that are several numbers each, whose steps take far longer than to load and to
/// store them: level by level, in memory. The steps of a level do not wait for each other.
template <std::size_t Size, class Scalar, class In, class Step>
[[gnu::always_inline]] inline std::array<Scalar, Size> apex_in_memory(int n, const In& in, const Step& step) {
  ManyNumbers<Size, Scalar> b;
  for (int i = 0; i <= n; ++i) b.set(i, in(i));
  for (int count = n; count > 0; --count)
    for (int i = 0; i < count; ++i) b.set(i, step(b[i], b[i + 1]));
  return b[0];
}

}  // namespace detail

/// The point at the top of the triangle over control points b; `step(a, b)` combines two neighbours on one axis.
template <class Points, class Step>
[[gnu::always_inline]] inline auto run_triangle(const Points& b, const Step& step) {
  using Scalar = typename Points::Scalar;
  constexpr int degree = Points::fixed_degree;
  Point<Scalar, Points::dimension> point;
  for (int axis = 0; axis < Points::dimension; ++axis) {
    const auto in = [&b, axis](int i) { return b(axis, i); };
    if constexpr (degree >= 0 && degree <= triangle_order<Scalar>.largest_fixed)
      point[axis] = detail::apex_by_levels<Scalar>(in, step, std::make_integer_sequence<int, degree>());
    else
      point[axis] = detail::apex_by_sweeps<Scalar>(b.degree(), in, step);
  }
  return point;
}

}  // namespace bezierbench
