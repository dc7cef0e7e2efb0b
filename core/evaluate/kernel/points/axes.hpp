// SPDX-License-Identifier: MIT
// The coordinates of one point side by side in a vector, as one scalar: instantiated with it, in one dimension, a
// method's own header evaluates all axes of a point at once. What depends on t only is the same in every lane. Lanes
// beyond the dimension are 0 in coefficients.
#pragma once

#include <cmath>
#include <concepts>
#include <utility>

#include "core/evaluate/schemes/steps.hpp"
#include "core/evaluate/schemes/triangle.hpp"
#include "core/vector/vectors.hpp"

namespace bezierbench {

/// The kind of vectors whose lanes are `Dimension` coordinates.
template <class Number, int Dimension>
struct CoordinatesOfPoint {
  /// One lane for one axis, else the least power of two that holds all axes and fills 16 bytes.
  static constexpr int lanes_for_axes() {
    if (Dimension == 1) return 1;
    int lanes = 16 / static_cast<int>(sizeof(Number));
    while (lanes < Dimension) lanes *= 2;
    return lanes;
  }

  using Scalar = Number;
  using Shared = Number;
  static constexpr int lanes = lanes_for_axes();
  static constexpr int vectors = 1;
  static constexpr int axes = Dimension;
  static constexpr int numbers = Dimension;
  static constexpr bool shares_t = true;
  static constexpr int largest_degree = max_degree;
  using Vector = VectorOf<Number, lanes>;

  static Vector read(const Number* first) {
#ifdef __AVX__
    // One instruction. By two loads and an insertion Horner's scheme in three dimensions takes up to 1.5 times as long.
    if constexpr (std::same_as<Vector, VectorOf<double, 4>>) {
      constexpr VectorOf<long long, 4> in_point{-1, -1, Dimension > 2 ? -1 : 0, Dimension > 3 ? -1 : 0};
      return __builtin_ia32_maskloadpd256(reinterpret_cast<const Vector*>(first), in_point);
    }
    if constexpr (std::same_as<Vector, VectorOf<float, 4>> && Dimension == 3)
      return __builtin_ia32_maskloadps(reinterpret_cast<const Vector*>(first), VectorOf<int, 4>{-1, -1, -1, 0});
#endif
    return read(first, std::make_integer_sequence<int, lanes>());
  }
  template <int... Lane>
  static Vector read(const Number* first, std::integer_sequence<int, Lane...> /*all*/) {
    return Vector{(Lane < Dimension ? first[Lane] : Number(0))...};
  }
  /// An instruction where the compiled target has one.
  static Vector fused(const Vector& a, const Vector& b, const Vector& c) {
#ifdef __FMA__
    if constexpr (std::same_as<Vector, VectorOf<double, 2>>) return __builtin_ia32_vfmaddpd(a, b, c);
    if constexpr (std::same_as<Vector, VectorOf<double, 4>>) return __builtin_ia32_vfmaddpd256(a, b, c);
    if constexpr (std::same_as<Vector, VectorOf<float, 4>>) return __builtin_ia32_vfmaddps(a, b, c);
    if constexpr (std::same_as<Vector, VectorOf<float, 8>>) return __builtin_ia32_vfmaddps256(a, b, c);
#endif
    if constexpr (lanes == 1) {
      return std::fma(a, b, c);
    } else {
      Vector result;
      for (int lane = 0; lane < lanes; ++lane) result[lane] = std::fma(a[lane], b[lane], c[lane]);
      return result;
    }
  }
  template <class Truths>
  static bool all(const Truths& truths) {
    if constexpr (lanes == 1) {
      return truths;
    } else {
      bool all = true;
      for (int axis = 0; axis < Dimension; ++axis) all = all && truths[axis] != 0;
      return all;
    }
  }
  template <class Truths>
  static bool any(const Truths& truths) {
    if constexpr (lanes == 1) {
      return truths;
    } else {
      bool any = false;
      for (int axis = 0; axis < Dimension; ++axis) any = any || truths[axis] != 0;
      return any;
    }
  }
};

template <class Number, int Dimension, Held held = Held::by_reference>
using Axes = Vectors<CoordinatesOfPoint<Number, Dimension>, held>;

/// These two take a value that is the same in every lane, as a parameter is.
template <class Number, int Dimension, Held held>
Number parameter_of(const Axes<Number, Dimension, held>& t) {
  return t.lane(0);
}
template <class Number, int Dimension, Held held>
bool inside_unit_interval(const Axes<Number, Dimension, held>& t) {
  return inside_unit_interval(t.lane(0));
}

#ifdef __wasm__
inline constexpr bool is_compiled_for_web = true;  // size counts there: every visitor of a page loads all kernels
#else
inline constexpr bool is_compiled_for_web = false;
#endif

template <class Number, int Dimension>
inline constexpr bool writes_out_steps<Axes<Number, Dimension>> = !is_compiled_for_web;
template <class Number, int Dimension>
inline constexpr TriangleOrder triangle_order<Axes<Number, Dimension>>{.width = 4,
                                                                       .ends_in_registers = !is_compiled_for_web};

}  // namespace bezierbench
