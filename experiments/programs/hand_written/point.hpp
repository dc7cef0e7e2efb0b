// SPDX-License-Identifier: MIT
// What hand-written codings of evaluators are made of: a point with its axes side by side in a vector of the compiler,
// the points of a curve of a degree known at compile time, and the operations that C++ has no sign for. No code of core
// is in here.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"  // of vectors that the target lacks; none leaves the unit that made it
#endif

namespace hand_written {

/// The number of lanes of the narrowest vector that has at least 16 bytes and a lane for each axis. For one axis it is 1,
/// and a point is a plain number.
template <class Scalar, int Dimension>
inline constexpr int lanes = Dimension == 1                                       ? 1
                             : Dimension == 2 && sizeof(Scalar) == sizeof(double) ? 2
                                                                                  : 4;

template <class Scalar, int Lanes>
struct Vector {
  using Type [[gnu::vector_size(sizeof(Scalar) * Lanes)]] = Scalar;
};
template <class Scalar>
struct Vector<Scalar, 1> {
  using Type = Scalar;
};

template <class Scalar, int Dimension>
using Point = typename Vector<Scalar, lanes<Scalar, Dimension>>::Type;

/// Reads the coordinates; lanes beyond them are 0.
template <class Scalar, int Dimension>
Point<Scalar, Dimension> load(const Scalar* from) {
  if constexpr (Dimension == lanes<Scalar, Dimension>) {
    Point<Scalar, Dimension> point;
    std::memcpy(&point, from, sizeof point);
    return point;
  } else if constexpr (Dimension == 2) {
    return Point<Scalar, Dimension>{from[0], from[1], 0, 0};
  } else {
    return Point<Scalar, Dimension>{from[0], from[1], from[2], 0};
  }
}

/// Writes the first coordinates.
template <int Dimension, class Scalar, class P>
void store(const P& point, Scalar* to) {
  if constexpr (sizeof point == sizeof(Scalar) * Dimension)
    std::memcpy(to, &point, sizeof point);
  else
    for (int axis = 0; axis < Dimension; ++axis) to[axis] = point[axis];
}

/// The points of a curve, one after the other in memory.
template <class ScalarT, int DimensionT, int DegreeT>
struct Points {
  using Scalar = ScalarT;
  using Point = hand_written::Point<Scalar, DimensionT>;
  static constexpr int dimension = DimensionT;
  static constexpr int degree = DegreeT;

  Point operator[](int i) const { return load<Scalar, DimensionT>(values.data() + i * DimensionT); }

  std::array<Scalar, static_cast<std::size_t>((DegreeT + 1) * DimensionT)> values;
};

/// One number for each point of a curve.
template <class Scalar, int Degree>
struct Row {
  Scalar operator[](int i) const { return values[static_cast<std::size_t>(i)]; }

  std::array<Scalar, static_cast<std::size_t>(Degree + 1)> values;
};

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

/// The same value on every axis.
template <class P, class Scalar>
P on_every_axis(Scalar value) {
  return value - P{};
}

/// A rounded value and its rounding error.
template <class P>
struct Exact {
  P value;
  P error;
};

template <class P>
Exact<P> exact_sum(const P& a, const P& b) {
  const P sum = a + b;
  const P of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

template <class P>
Exact<P> exact_product(const P& a, const P& b) {
  const P product = a * b;
  return {product, fused<P>(a, b, -product)};
}

}  // namespace hand_written
