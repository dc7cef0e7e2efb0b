// SPDX-License-Identifier: MIT
// de Casteljau's triangle on points: the same result as run_triangle() for numbers, in an order in which the values
// between the levels stay in registers. Every step is one of the triangle's, with the same operands: the order of steps
// that do not depend on each other changes no bit.
#pragma once

#include <utility>

#include "core/evaluate/kernel/points/axes_curve.hpp"

namespace bezierbench {

namespace detail {

/// One level of the triangle: b[I] <- step(b[I], b[I + 1]) for every I, ascending.
template <class A, class Step, int... I>
[[gnu::always_inline]] inline void rise(A* b, const Step& step, std::integer_sequence<int, I...> /*values*/) {
  ((b[I] = step(b[I], b[I + 1])), ...);
}

/// Of a degree that is known at compile time: level by level, every step written out.
template <class A, class In, class Step, int... Level>
[[gnu::always_inline]] inline A apex(const In& in, const Step& step, std::integer_sequence<int, Level...> /*levels*/) {
  constexpr int degree = sizeof...(Level);
  A b[degree + 1];
  ((b[Level] = in(0, Level)), ...);
  b[degree] = in(0, degree);
  (rise(b, step, std::make_integer_sequence<int, degree - Level>()), ...);
  return b[0];
}

/// Moves x up through the levels: y <- step(newest, x), newest <- x, x <- y on each.
template <class A, class Step, int... Level>
[[gnu::always_inline]] inline A pass([[maybe_unused]] A* newest, A x, const Step& step,
                                     std::integer_sequence<int, Level...> /*levels*/) {
  (
      [&] {
        const A y = step(newest[Level], x);
        newest[Level] = x;
        x = y;
      }(),
      ...);
  return x;
}

/// b[0], ..., b[count - 1] are the values of one level; they become those of the level so many further on.
template <class A, class Step, int... Level>
[[gnu::always_inline]] inline void sweep(int count, A* b, const Step& step, std::integer_sequence<int, Level...> all) {
  constexpr int levels = sizeof...(Level);
  A newest[levels];
  ((newest[Level] = pass(newest, b[Level], step, std::make_integer_sequence<int, Level>())), ...);
  for (int i = levels; i < count; ++i) b[i - levels] = pass(newest, b[i], step, all);
}

/// Of a degree that is known at run time: eight levels in a sweep, then those that are left.
template <class A, class In, class Step>
A apex(int n, const In& in, const Step& step) {
  A b[max_degree + 1];
  b[0] = in(0, 0);
  for (int i = 1; i <= n; ++i) b[i] = in(0, i);
  for (; n >= 8; n -= 8) sweep(n + 1, b, step, std::make_integer_sequence<int, 8>());
  if (n >= 4) {
    sweep(n + 1, b, step, std::make_integer_sequence<int, 4>());
    n -= 4;
  }
  for (; n > 0; --n) sweep(n + 1, b, step, std::make_integer_sequence<int, 1>());
  return b[0];
}

}  // namespace detail

template <class A, int Degree, class Curve, class Step>
Point<A, 1> run_triangle_of_points(const Curve& b, const Step& step) {
  Point<A, 1> point;
  if constexpr (Degree == dynamic)
    point[0] = detail::apex<A>(b.degree(), b, step);
  else
    point[0] = detail::apex<A>(b, step, std::make_integer_sequence<int, Degree>());
  return point;
}

template <class S, int Dimension, int Degree, class Step>
Point<Axes<S, Dimension>, 1> run_triangle(const Curve<Form::bernstein, Axes<S, Dimension>, 1, Degree>& b, Step step) {
  return run_triangle_of_points<Axes<S, Dimension>, Degree>(b, step);
}

template <class S, int Dimension, int Degree, class Step>
Point<Axes<S, Dimension>, 1> run_triangle(const AxesFromEitherEnd<S, Dimension, Degree>& b, Step step) {
  return run_triangle_of_points<Axes<S, Dimension>, Degree>(b, step);
}

}  // namespace bezierbench
