// SPDX-License-Identifier: MIT
// The curve under study: its form is part of its type, so power coefficients cannot reach de Casteljau.
#pragma once

#include <Eigen/Core>
#include <cassert>
#include <tuple>

#include "core/curve_view.hpp"

namespace bezierbench {

/// Degree known only at run time (storage then has room for largest_degree).
inline constexpr int dynamic = Eigen::Dynamic;

/// The largest degree of curves over `Scalar`. One that stands for numbers of many curves may have a smaller one.
template <class Scalar>
inline constexpr int largest_degree = max_degree;
template <class Scalar>
requires requires { Scalar::largest_degree; }
inline constexpr int largest_degree<Scalar> = Scalar::largest_degree;

/// A point with `Dimension` coordinates.
template <class Scalar, int Dimension>
using Point = Eigen::Matrix<Scalar, Dimension, 1>;

/// Room for one value per coefficient, without heap allocation.
template <class Scalar, int Degree>
using PerCoefficient = Eigen::Matrix<Scalar, 1, Degree == dynamic ? Eigen::Dynamic : Degree + 1, Eigen::RowMajor, 1,
                                     Degree == dynamic ? largest_degree<Scalar> + 1 : Degree + 1>;

/// Uninitialised room for the n + 1 values that belong to the coefficients of a curve of degree n.
template <class Scalar, int Degree>
PerCoefficient<Scalar, Degree> per_coefficient(int degree) {
  PerCoefficient<Scalar, Degree> row;
  row.resize(1, degree + 1);
  return row;
}

/// The coefficients of one curve. Coefficient i (ascending, in both forms) is column i; axis a is row a.
template <Form F, class ScalarT, int DimensionT, int DegreeT = dynamic>
class Curve {
 public:
  using Scalar = ScalarT;
  static constexpr Form form = F;
  static constexpr int dimension = DimensionT;
  static constexpr int fixed_degree = DegreeT;  ///< or `dynamic`

  explicit Curve(int degree) {
    assert(degree >= 0 && degree <= largest_degree<Scalar>);
    // Not by Eigen's constructor, which takes two numbers as coefficients where the fixed size is small.
    coefficients_.resize(DimensionT, degree + 1);
  }

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients_.cols()) - 1; }
  [[nodiscard]] Scalar operator()(int axis, int i) const { return coefficients_.coeff(axis, i); }
  [[nodiscard]] Scalar& operator()(int axis, int i) { return coefficients_.coeffRef(axis, i); }
  /// Coefficient degree() - k.
  [[nodiscard]] Scalar from_end(int axis, int k) const { return (*this)(axis, degree() - k); }
  /// The coefficients in memory, point by point.
  [[nodiscard]] const Scalar* data() const { return coefficients_.data(); }

 private:
  static constexpr int columns = DegreeT == dynamic ? Eigen::Dynamic : DegreeT + 1;
  static constexpr int max_columns = DegreeT == dynamic ? largest_degree<Scalar> + 1 : DegreeT + 1;
  static constexpr int order =
      DimensionT == 1 ? Eigen::RowMajor : Eigen::ColMajor;  // Eigen requires this of a single row
  Eigen::Matrix<Scalar, DimensionT, columns, order, DimensionT, max_columns> coefficients_;
};

/// Coefficients as unevaluated sums high + low with |low| <= u |high|.
template <class ScalarT, int DimensionT, int DegreeT>
class Curve<Form::power_double_double, ScalarT, DimensionT, DegreeT> {
 public:
  using Scalar = ScalarT;
  using Part = Curve<Form::power, ScalarT, DimensionT, DegreeT>;
  static constexpr Form form = Form::power_double_double;
  static constexpr int dimension = DimensionT;

  explicit Curve(int degree) : high(degree), low(degree) {}

  [[nodiscard]] int degree() const { return high.degree(); }
  [[nodiscard]] auto parts() const { return std::tie(high, low); }

  Part high;
  Part low;
};

/// Control points, not premultiplied, and their weights.
template <class ScalarT, int DimensionT, int DegreeT>
class Curve<Form::rational, ScalarT, DimensionT, DegreeT> {
 public:
  using Scalar = ScalarT;
  static constexpr Form form = Form::rational;
  static constexpr int dimension = DimensionT;

  explicit Curve(int degree) : points(degree), weights(per_coefficient<ScalarT, DegreeT>(degree)) {}

  [[nodiscard]] int degree() const { return points.degree(); }
  [[nodiscard]] auto parts() const { return std::tie(points, weights); }

  Curve<Form::bernstein, ScalarT, DimensionT, DegreeT> points;
  PerCoefficient<ScalarT, DegreeT> weights;
};

}  // namespace bezierbench
