// SPDX-License-Identifier: MIT
// One evaluator of each family as one writes it by hand for one degree, as a loop or with every step written out:
// `evaluate` takes the coefficients that the evaluator prepared for a curve, as a plain array, and a parameter.
// Operations, their order and so the bits are those of the evaluator; no code of core is in a coding.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"  // of vectors that the target does not have; they stay in this unit
#endif

namespace hand_written {

/// The number of lanes of the narrowest vector that has at least 16 bytes and a lane for each axis. For one axis it is 1,
/// and a point is a plain number.
template <class S, int D>
inline constexpr int lanes = D == 1                                  ? 1
                             : D == 2 && sizeof(S) == sizeof(double) ? 2
                                                                     : 4;

template <class S, int Lanes>
struct Vector {
  using Type [[gnu::vector_size(sizeof(S) * Lanes)]] = S;
};
template <class S>
struct Vector<S, 1> {
  using Type = S;
};

/// A point with its axes side by side in a vector of the compiler.
template <class S, int D>
using Point = typename Vector<S, lanes<S, D>>::Type;

/// The coefficients of a curve of degree N, one point after the other in memory.
template <class S, int D, int N>
struct Points {
  Point<S, D> operator[](int i) const {
    const S* from = values.data() + i * D;
    if constexpr (D == lanes<S, D>) {
      Point<S, D> point;
      std::memcpy(&point, from, sizeof point);
      return point;
    } else if constexpr (D == 2) {
      return Point<S, D>{from[0], from[1], 0, 0};
    } else {
      return Point<S, D>{from[0], from[1], from[2], 0};
    }
  }

  std::array<S, static_cast<std::size_t>((N + 1) * D)> values;
};

/// Writes the coordinates of a point.
template <int D, class P, class S>
void store(const P& point, S* to) {
  if constexpr (sizeof point == sizeof(S) * D)
    std::memcpy(to, &point, sizeof point);
  else
    for (int axis = 0; axis < D; ++axis) to[axis] = point[axis];
}

/// a b + c, rounded once. GCC 12 makes no vector instruction of several calls of std::fma.
template <class P>
P fused(const P& a, const P& b, const P& c) {
  if constexpr (sizeof(P) <= sizeof(double)) {
    return std::fma(a, b, c);
  } else {
#ifdef __FMA__
    if constexpr (sizeof(a[0]) == sizeof(float))
      return __builtin_ia32_vfmaddps(a, b, c);
    else if constexpr (sizeof(P) == 2 * sizeof(double))
      return __builtin_ia32_vfmaddpd(a, b, c);
    else
      return __builtin_ia32_vfmaddpd256(a, b, c);
#else
    P result;
    for (std::size_t lane = 0; lane < sizeof(P) / sizeof(a[0]); ++lane)
      result[lane] = std::fma(a[lane], b[lane], c[lane]);
    return result;
#endif
  }
}

/// Calls step(0), ..., step(N - 1), in a loop.
struct Loop {
  template <int N, class Step>
  [[gnu::always_inline]] static void steps(const Step& step) {
    for (int k = 0; k < N; ++k) step(k);
  }
};

/// The same, written out.
struct WrittenOut {
  template <int N, class Step>
  [[gnu::always_inline]] static void steps(const Step& step) {
    write_out(step, std::make_integer_sequence<int, N>());
  }

 private:
  template <class Step, int... K>
  [[gnu::always_inline]] static void write_out(const Step& step, std::integer_sequence<int, K...> /*all*/) {
    (step(K), ...);
  }
};

/// A sum of Bernstein polynomials; `c` are the control points times binomials.
template <class Way>
struct HornerBernstein {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& c) {
    const S s = 1 - t;
    Point<S, D> p = c[0];
    S power = 1;
    Way::template steps<N>([&](int k) {
      power *= t;
      p = p * s + c[k + 1] * power;
    });
    return p;
  }
};

/// A polynomial in power form; q[j] is the coefficient of t^j.
template <class Way>
struct Horner {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& q) {
    Point<S, D> p = q[N];
    Way::template steps<N>([&](int k) { p = p * t + q[N - 1 - k]; });
    return p;
  }
};

/// The same with fused steps.
template <class Way>
struct HornerFma {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& q) {
    const Point<S, D> on_axes = t - Point<S, D>{};
    Point<S, D> p = q[N];
    Way::template steps<N>([&](int k) { p = fused<Point<S, D>>(p, on_axes, q[N - 1 - k]); });
    return p;
  }
};

/// A polynomial in power form by joining neighbours, level by level.
struct Estrin {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points) {
    Point<S, D> q[N + 1];
    for (int j = 0; j <= N; ++j) q[j] = points[j];
    int count = N + 1;
    for (S power = t; count > 1; power *= power) {
      for (int k = 0; k < count / 2; ++k) q[k] = q[2 * k] + q[2 * k + 1] * power;
      if (count % 2 != 0) q[count / 2] = q[count - 1];
      count = (count + 1) / 2;
    }
    return q[0];
  }
};

/// A triangle in a loop, in memory.
struct DeCasteljauLoop {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points) {
    const S s = 1 - t;
    Point<S, D> b[N + 1];
    for (int i = 0; i <= N; ++i) b[i] = points[i];
    for (int count = N; count > 0; --count)
      for (int i = 0; i < count; ++i) b[i] = s * b[i] + t * b[i + 1];
    return b[0];
  }
};

/// A triangle, every step of it written out, up to degree 21.
struct DeCasteljauWrittenOut {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& points) {
    if constexpr (N > 21) return DeCasteljauLoop::evaluate(t, points);
    Point<S, D> b[N + 1];
    for (int i = 0; i <= N; ++i) b[i] = points[i];
    return apex(b, 1 - t, t, std::make_integer_sequence<int, N>());
  }

 private:
  template <class P, class S, int... I>
  [[gnu::always_inline]] static void rise(P* b, S s, S t, std::integer_sequence<int, I...> /*all*/) {
    ((b[I] = s * b[I] + t * b[I + 1]), ...);
  }
  template <class P, class S, int... Level>
  [[gnu::always_inline]] static P apex(P* b, S s, S t, std::integer_sequence<int, Level...> /*levels*/) {
    (rise(b, s, t, std::make_integer_sequence<int, static_cast<int>(sizeof...(Level)) - Level>()), ...);
    return b[0];
  }
};

/// Horner's rule that carries the rounding errors of its operations along.
struct CompensatedHorner {
  template <class S, int D, int N>
  static Point<S, D> evaluate(S t, const Points<S, D, N>& q) {
    using P = Point<S, D>;
    const P on_axes = t - P{};
    P p = q[N];
    P error{};
    for (int j = N - 1; j >= 0; --j) {
      const P product = p * on_axes;
      const P sum = product + q[j];
      const P q_part = sum - product;
      error = error * on_axes + (fused<P>(p, on_axes, -product) + ((product - (sum - q_part)) + (q[j] - q_part)));
      p = sum;
    }
    return p + error;
  }
};

}  // namespace hand_written
