// SPDX-License-Identifier: MIT
// Formula: a curve in Bernstein form over [0, 1] as a series of Chebyshev polynomials of z = 2t - 1, cut at a limited
//   degree, with a bound of the part that was cut.
// Source: derived here, from de Casteljau's algorithm with polynomials in place of points: a step takes
//   (A + B)/2 + z (B - A)/2, and z T_k = (T_(k+1) + T_(k-1))/2.
// Cost: m(m+1)/2 steps of 6d min(r, limit) flops, r the level.
// Bound: a step rounds each coefficient by at most 3u of those that it is made of. The squares of the coefficients of a
//   polynomial of degree r and size 1 sum to at most 2, so their sizes sum to at most sqrt(2(r+1)). After all levels
//   the error of the sum is at most 2 sqrt(2) u (m+1)^(3/2) times the largest control point, which counts as cut.
//
// The series of a level lie side by side, so that each step is the same for four numbers in a row.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/curve.hpp"

namespace bezierbench {

/// sum_k a_k T_k(z), k = 0 .. degree.
template <int Dimension>
class ChebyshevSeries {
 public:
  static constexpr std::size_t degree_limit = 16;

  /// Room for the series of curves of this degree.
  explicit ChebyshevSeries(int curve_degree)
      : curve_degree_(static_cast<std::size_t>(curve_degree)),
        stride_((curve_degree_ + 1) * Dimension + Dimension + chunk) {
    constexpr double u = 0x1p-53;
    rounding_ = curve_degree == 0 ? 0 : 3 * u * (curve_degree + 1) * std::sqrt(curve_degree + 1.0);
  }

  [[nodiscard]] std::size_t degree() const { return degree_; }
  /// |a_k|
  [[nodiscard]] double size(std::size_t k) const { return sizes_[k]; }
  /// A bound of the distance between the curve and the series on [-1, 1].
  [[nodiscard]] double cut() const { return cut_; }

  /// The part of cut() that comes from rounding, for control points of at most this size.
  [[nodiscard]] double rounding(double largest) const { return rounding_ * largest; }

  /// Replaces the series by that of h, whose control points are at most `largest` in size.
  template <int Degree>
  void expand(const Curve<Form::bernstein, double, Dimension, Degree>& h, double largest) {
    cut_ = rounding(largest);
    if constexpr (Degree == dynamic)
      expand_any(h);
    else
      expand_fixed(h);
  }

  /// Removes as many of the last terms as change the series by at most `allowed`, including the terms removed before.
  void shorten(double allowed) {
    while (degree_ > 0 && cut_ + sizes_[degree_] <= allowed) cut_ += sizes_[degree_--];
  }

 private:
  static constexpr std::size_t chunk = 4;
  using Chunk = Eigen::Array<double, chunk, 1>;

  static Chunk read(const double* from) { return Eigen::Map<const Chunk>(from); }

  /// Curves of a low degree that the compiler knows: the same operations, without loops through memory. Nothing is cut.
  template <int CurveDegree>
  void expand_fixed(const Curve<Form::bernstein, double, Dimension, CurveDegree>& h) {
    constexpr std::size_t Degree = CurveDegree;
    static_assert(Degree <= degree_limit);
    std::array<double, Degree + 1> squares{};
    for (int axis = 0; axis < Dimension; ++axis) {
      std::array<std::array<double, Degree + 1>, Degree + 1> triangle;
      for (std::size_t i = 0; i <= Degree; ++i) triangle[i][0] = h(axis, static_cast<int>(i));
      for (std::size_t level = 1; level <= Degree; ++level)
        for (std::size_t i = 0; i + level <= Degree; ++i) combine(triangle[i], triangle[i + 1], level);
      for (std::size_t k = 0; k <= Degree; ++k) squares[k] += triangle[0][k] * triangle[0][k];
    }
    degree_ = Degree;
    for (std::size_t k = 0; k <= Degree; ++k) sizes_[k] = std::sqrt(squares[k]);
  }

  /// Puts (A + B)/2 + z (B - A)/2, of degree `level`, in place of A.
  template <std::size_t Count>
  static void combine(std::array<double, Count>& a, const std::array<double, Count>& b, std::size_t level) {
    double here = (b[0] - a[0]) / 4;
    double before = 0;  // of T_(k-1), twice that of T_0
    for (std::size_t k = 0; k < level; ++k) {
      const double after = k + 1 < level ? (b[k + 1] - a[k + 1]) / 4 : 0.0;
      a[k] = (a[k] + b[k]) / 2 + (before + after);
      before = k == 0 ? 2 * here : here;
      here = after;
    }
    a[level] = before;
  }

  void expand_any(const Curve<Form::bernstein, double, Dimension>& h) {
    if (rows_.empty()) rows_.resize(stride_ * (std::min(curve_degree_, degree_limit) + 1), 0.0);
    std::copy_n(h.data(), (curve_degree_ + 1) * Dimension, rows_.begin());
    for (std::size_t level = 1; level <= curve_degree_; ++level) {
      const std::size_t width = (curve_degree_ - level + 1) * Dimension;
      double cut = 0;
      for (std::size_t first = 0; first < width; first += chunk)
        cut = std::max(cut, step(first, std::min(chunk, width - first), level - 1));
      cut_ += cut;
    }
    degree_ = std::min(curve_degree_, degree_limit);
    for (std::size_t k = 0; k <= degree_; ++k) {
      double square = 0;
      for (std::size_t axis = 0; axis < Dimension; ++axis)
        square += rows_[k * stride_ + axis] * rows_[k * stride_ + axis];
      sizes_[k] = std::sqrt(square);
    }
  }

  /// Puts (A + B)/2 + z (B - A)/2 in place of A, both of degree at most `from`, in some columns, of which `used` count;
  /// returns the size of the term that is cut.
  double step(std::size_t first, std::size_t used, std::size_t from) {
    const std::size_t degree = std::min(from, degree_limit);
    double* row = &rows_[first];
    Chunk a = read(row);
    Chunk b = read(row + Dimension);
    Chunk here = (b - a) / 4;
    Chunk before = Chunk::Zero();  // coefficient of T_(k-1), twice that of T_0
    for (std::size_t k = 0; k <= degree; ++k) {
      const Chunk sum = a + b;
      Chunk after = Chunk::Zero();
      if (k < degree) {
        a = read(row + stride_);
        b = read(row + stride_ + Dimension);
        after = (b - a) / 4;
      }
      Eigen::Map<Chunk> result(row);
      result = sum / 2 + (before + after);
      before = k == 0 ? Chunk(2 * here) : here;
      here = after;
      row += stride_;
    }
    if (degree < degree_limit) {
      Eigen::Map<Chunk> result(row);
      result = before;
      return 0;
    }
    return before.head(static_cast<Eigen::Index>(used)).abs().maxCoeff() * std::sqrt(1.0 * Dimension);
  }

  std::size_t curve_degree_;
  std::size_t stride_;
  std::vector<double> rows_;  ///< row k: a_k of each series of a level; for expand_any() only
  std::array<double, degree_limit + 1> sizes_;
  std::size_t degree_ = 0;
  double rounding_;
  double cut_ = 0;
};

}  // namespace bezierbench
