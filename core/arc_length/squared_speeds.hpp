// SPDX-License-Identifier: MIT
// |h(t)|^2 of a hodograph at eight parameters at once, by de Casteljau's algorithm.
//
// Cost: 3d m(m+1)/2 + 2d flops each, m the degree of h, and one subtraction.
//
// The eight triangles lie side by side, so that each step is the same for eight numbers in a row: compilers make wide
// instructions of that, at any degree. One triangle at a time has loops too short for it where the degree is low.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/curve.hpp"

namespace bezierbench {

/// Working memory for hodographs of any degree. One object serves many calls.
template <int Dimension>
class SquaredSpeeds {
 public:
  static constexpr std::size_t count = 8;
  using Eight = std::array<double, count>;

  Eight operator()(const Curve<Form::bernstein, double, Dimension>& h, std::span<const double, count> parameters) {
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

 private:
  static constexpr std::size_t coordinates(int points) { return static_cast<std::size_t>(points) * Dimension; }

  /// Computes the next level of the triangles, which has `points` points.
  void step(int points, const Eight& s, const Eight& t) {
    for (std::size_t j = 0; j < coordinates(points); ++j)
      for (std::size_t k = 0; k < count; ++k)
        coordinates_[j][k] = s[k] * coordinates_[j][k] + t[k] * coordinates_[j + Dimension][k];
  }

  std::array<Eight, coordinates(max_degree + 1)> coordinates_;  ///< point by point; only those of one level are read
};

}  // namespace bezierbench
