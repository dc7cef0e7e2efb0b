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

inline constexpr int levels_at_once =
    4;  ///< 4 values of two vectors each, and the operands of a step, fit into 16 registers

/// The newest value on each of the levels 0 .. Levels-1 of a sweep.
template <class L, int Levels>
class Sweep {
 public:
  /// Takes the first `Levels` values.
  template <class In, class Step>
  HWY_INLINE void begin(const In& in, const Step& step) {
    begin(in, step, std::make_integer_sequence<int, Levels>());
  }
  /// Takes one more value; returns the value that results on the level after the last.
  template <class Step>
  HWY_INLINE L next(L x, const Step& step) {
    return pass(x, step, std::make_integer_sequence<int, Levels>());
  }

 private:
  template <class In, class Step, int... I>
  HWY_INLINE void begin(const In& in, const Step& step, std::integer_sequence<int, I...> /*all*/) {
    ((newest_[I] = pass(in(I), step, std::make_integer_sequence<int, I>())), ...);
  }
  template <class Step, int... Level>
  HWY_INLINE L pass(L x, const Step& step, std::integer_sequence<int, Level...> /*levels*/) {
    (
        [&] {
          const L y = step(newest_[Level], x);
          newest_[Level] = x;
          x = y;
        }(),
        ...);
    return x;
  }

  L newest_[Levels];
};

/// in(0), ..., in(count - 1) are the values of one level, out(i, b_i) takes those of the level `Levels` further on.
template <int Levels, class L, class In, class Step, class Out>
HWY_INLINE void sweep(int count, const In& in, const Step& step, const Out& out) {
  Sweep<L, Levels> levels;
  levels.begin(in, step);
  for (int i = Levels; i < count; ++i) out(i - Levels, levels.next(in(i), step));
}

/// The same with 1 <= `levels` <= levels_at_once known at run time only.
template <class L, class In, class Step, class Out>
HWY_INLINE void sweep(int levels, int count, const In& in, const Step& step, const Out& out) {
  switch (levels) {
    case 1: return sweep<1, L>(count, in, step, out);
    case 2: return sweep<2, L>(count, in, step, out);
    case 3: return sweep<3, L>(count, in, step, out);
    default: return sweep<levels_at_once, L>(count, in, step, out);
  }
}

/// One axis of the triangle: in(0), ..., in(n) are its control points.
template <class L, class In, class Step>
HWY_INLINE L apex(int n, const In& in, const Step& step) {
  if (n == 0) return in(0);
  L between[max_degree];  // the values of a level between two sweeps
  const auto read = [&between](int i) { return between[i]; };
  const auto write = [&between](int i, const L& value) { between[i] = value; };
  int levels = n < levels_at_once ? n : levels_at_once;
  sweep<L>(levels, n + 1, in, step, write);
  for (int left = n - levels; left > 0; left -= levels) {
    levels = left < levels_at_once ? left : levels_at_once;
    sweep<L>(levels, left + 1, read, step, write);
  }
  return between[0];
}

/// One level of the triangle: b[I] <- step(b[I], b[I + 1]) for every I, ascending.
template <class L, class Step, int... I>
HWY_INLINE void rise(L* b, const Step& step, std::integer_sequence<int, I...> /*values*/) {
  ((b[I] = step(b[I], b[I + 1])), ...);
}

/// One axis of a triangle of low degree, known at compile time: level by level, all values of a level in registers. The
/// steps of a level do not wait for each other, those of a sweep do.
template <class L, class In, class Step, int... Level>
HWY_INLINE L apex_unrolled(const In& in, const Step& step, std::integer_sequence<int, Level...> /*levels*/) {
  constexpr int degree = sizeof...(Level);
  L b[degree + 1];
  ((b[Level] = in(Level)), ...);
  b[degree] = in(degree);
  (rise(b, step, std::make_integer_sequence<int, degree - Level>()), ...);
  return b[0];
}

template <class L, int Dimension, int Degree, class Source, class Step>
HWY_INLINE Point<L, Dimension> run_axes(const Source& curve, const Step& step) {
  Point<L, Dimension> point;
  for (int axis = 0; axis < Dimension; ++axis) {
    const auto in = [&](int i) { return curve(axis, i); };
    if constexpr (Degree < 0)  // known at run time
      point[axis] = apex<L>(curve.degree(), in, step);
    else
      point[axis] = apex_unrolled<L>(in, step, std::make_integer_sequence<int, Degree>());
  }
  return point;
}

template <class S, int Count, Curves Which, int Dimension, int Degree, class Step>
HWY_INLINE Point<Lanes<S, Count, Which>, Dimension> run_triangle(
    const ControlPoints<S, Count, Which, Dimension, Degree>& curve, Step step) {
  return run_axes<Lanes<S, Count, Which>, Dimension, Degree>(curve, step);
}

template <class S, int Count, Curves Which, int Dimension, int Degree, class Step>
HWY_INLINE Point<Lanes<S, Count, Which>, Dimension> run_triangle(
    const EitherEnd<S, Count, Which, Dimension, Degree>& curve, Step step) {
  return run_axes<Lanes<S, Count, Which>, Dimension, Degree>(curve, step);
}

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
