// SPDX-License-Identifier: MIT
// |h(t)|^2 of a hodograph at eight parameters at once, by de Casteljau's algorithm.
//
// Cost: 3d m(m+1)/2 + 2d flops each, m the degree of h, and one subtraction.
//
// The eight triangles lie side by side, so that each step is the same for eight numbers in a row: compilers make wide
// instructions of that, at any degree. One triangle at a time has loops too short for it where the degree is low. Where
// the compiler knows the degree, all steps are written out and the triangles stay in registers.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>

#include "core/curve.hpp"
#include "core/vector/vectors.hpp"

namespace bezierbench {

/// Working memory for hodographs of any degree. One object serves many calls.
template <int Dimension>
class SquaredSpeeds {
 public:
  static constexpr std::size_t count = 8;
  using Eight = std::array<double, count>;

  template <int Degree>
  Eight operator()(const Curve<Form::bernstein, double, Dimension, Degree>& h,
                   std::span<const double, count> parameters) {
    if constexpr (Degree == dynamic)
      return at_any_degree(h, parameters);
    else
      return at_fixed_degree(h, parameters);
  }

  /// |h(t)| likewise.
  template <class Hodograph>
  Eight speeds(const Hodograph& h, std::span<const double, count> parameters) {
    auto result = (*this)(h, parameters);
    for (double& value : result) value = std::sqrt(value);
    return result;
  }

 private:
  using Four = VectorOf<double, 4>;

  template <int Degree>
  static Eight at_fixed_degree(const Curve<Form::bernstein, double, Dimension, Degree>& h,
                               std::span<const double, count> parameters) {
    Eight result;
    for (std::size_t first = 0; first < count; first += 4) {
      Four t;
      std::memcpy(&t, &parameters[first], sizeof t);
      const Four s = 1 - t;
      Four squares{};
      for (int axis = 0; axis < Dimension; ++axis) {
        std::array<Four, Degree + 1> b;
        for (int i = 0; i <= Degree; ++i) b[static_cast<std::size_t>(i)] = h(axis, i) - Four{};
        for (std::size_t last = Degree; last > 0; --last)
          for (std::size_t i = 0; i < last; ++i) b[i] = s * b[i] + t * b[i + 1];
        squares += b[0] * b[0];
      }
      std::memcpy(&result[first], &squares, sizeof squares);
    }
    return result;
  }

  Eight at_any_degree(const Curve<Form::bernstein, double, Dimension>& h, std::span<const double, count> parameters) {
    const int m = h.degree();
    Eight s;
    Eight t;
    for (std::size_t k = 0; k < count; ++k) {
      t[k] = parameters[k];
      s[k] = 1 - t[k];
    }
    for (std::size_t j = 0; j < coordinates(m + 1); ++j) coordinates_[j].fill(h.data()[j]);
    for (int points = m; points > 0; --points) step(points, s, t);
    Eight squares{};
    for (std::size_t axis = 0; axis < Dimension; ++axis)
      for (std::size_t k = 0; k < count; ++k) squares[k] += coordinates_[axis][k] * coordinates_[axis][k];
    return squares;
  }

  static constexpr std::size_t coordinates(int points) { return static_cast<std::size_t>(points) * Dimension; }

  /// Computes the next level of the triangles, which has `points` points.
  void step(int points, const Eight& s, const Eight& t) {
    for (std::size_t j = 0; j < coordinates(points); ++j)
      for (std::size_t k = 0; k < count; ++k)
        coordinates_[j][k] = s[k] * coordinates_[j][k] + t[k] * coordinates_[j + Dimension][k];
  }

  std::array<Eight, coordinates(max_degree + 1)> coordinates_;  ///< point by point; only those of one level are read
};

template <int Dimension, int Degree>
SquaredSpeeds<Dimension> speeds_for(const Curve<Form::bernstein, double, Dimension, Degree>& hodograph);

}  // namespace bezierbench
