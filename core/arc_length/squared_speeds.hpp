// SPDX-License-Identifier: MIT
// |h(t)|^2 of a hodograph at eight parameters at once, by de Casteljau's algorithm.
//
// Cost: 3d m(m+1)/2 + 2d flops each, m the degree of h, and one subtraction.
//
// The eight triangles lie side by side, so that each step is the same for eight numbers in a row: compilers make wide
// instructions of that, at any degree. One triangle at a time has loops too short for it where the degree is low. Where
// the compiler knows the degree, all steps are written out and the triangles stay in registers.
#pragma once

#include <algorithm>
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

// Code for hodographs of a low degree that the compiler knows: its loops are written out and its values stay in
// registers. It has the same operations, and so the same bits, as code for any degree.

/// Calls measure(h), with the degree in the type of h up to 4, the hodographs of quintics.
template <int Dimension, class Measure>
auto with_fixed_degree(const Curve<Form::bernstein, double, Dimension>& hodograph, const Measure& measure) {
  const auto with_degree = [&]<int Degree>() {
    Curve<Form::bernstein, double, Dimension, Degree> h(Degree);
    for (int i = 0; i <= Degree; ++i)
      for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = hodograph(axis, i);
    return measure(h);
  };
  switch (hodograph.degree()) {
    case 1: return with_degree.template operator()<1>();
    case 2: return with_degree.template operator()<2>();
    case 3: return with_degree.template operator()<3>();
    case 4: return with_degree.template operator()<4>();
    default: return measure(hodograph);
  }
}

// Bounds of the length of a panel from the control vectors of its hodograph, and the halving of panels.

/// The length of the chord, |mean of the control vectors|, which is a lower bound of the length of the panel.
template <int Dimension, int Degree>
double chord_length(const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  double square = 0;
  for (int axis = 0; axis < Dimension; ++axis) {
    double sum = 0;
    for (int i = 0; i <= h.degree(); ++i) sum += h(axis, i);
    square += sum * sum;
  }
  return std::sqrt(square) / (h.degree() + 1);
}

/// The size of the longest of the control vectors 0, ..., last.
template <int Dimension, int Degree>
double longest_vector(const Curve<Form::bernstein, double, Dimension, Degree>& h, int last) {
  double largest_square = 0;
  for (int i = 0; i <= last; ++i) {
    double square = 0;
    for (int axis = 0; axis < Dimension; ++axis) square += h(axis, i) * h(axis, i);
    largest_square = std::max(largest_square, square);
  }
  return std::sqrt(largest_square);
}

/// The size of the longest control vector.
template <int Dimension, int Degree>
double longest_vector(const Curve<Form::bernstein, double, Dimension, Degree>& h) {
  return longest_vector(h, h.degree());
}

/// Halves a hodograph: returns the left half and leaves the right one in h.
template <int Dimension, int Degree>
Curve<Form::bernstein, double, Dimension, Degree> cut_left_half(Curve<Form::bernstein, double, Dimension, Degree>& h) {
  const int m = h.degree();
  Curve<Form::bernstein, double, Dimension, Degree> left(m);
  for (int level = 0; level <= m; ++level) {
    for (int axis = 0; axis < Dimension; ++axis) left(axis, level) = h(axis, 0);
    for (int i = 0; i < m - level; ++i)
      for (int axis = 0; axis < Dimension; ++axis) h(axis, i) = (h(axis, i) + h(axis, i + 1)) / 2;
  }
  return left;
}

}  // namespace bezierbench
