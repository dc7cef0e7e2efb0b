// SPDX-License-Identifier: MIT
// The curve under study: its form is part of its type, so power coefficients cannot reach de Casteljau.
#pragma once

#include <Eigen/Core>
#include <cassert>
#include <cstddef>
#include <span>
#include <string_view>

namespace bezierbench {

/// Representation of a curve. Curves are given in the first three; the others exist inside converted paths.
enum class Form {
  bernstein,            ///< sum b_i B_i,n(t)
  power,                ///< sum q_j t^j
  rational,             ///< sum w_i b_i B_i,n(t) / sum w_i B_i,n(t): a rational Bezier curve
  power_centered,       ///< sum q_j (t - 1/2)^j
  power_double_double,  ///< sum (high q_j + low q_j) t^j, each coefficient an unevaluated sum of two
};

/// True for the forms in which a curve can be given.
constexpr bool is_given(Form form) { return form == Form::bernstein || form == Form::power || form == Form::rational; }

/// The word for a form in files and messages.
constexpr std::string_view name(Form form) {
  switch (form) {
    case Form::bernstein: return "bernstein";
    case Form::power: return "power";
    case Form::rational: return "rational";
    case Form::power_centered: return "power_centered";
    case Form::power_double_double: return "power_double_double";
  }
  return "";
}

/// Largest degree that any curve can have: C(n, n/2) must stay finite in double (it does through n = 1029).
inline constexpr int max_degree = 1023;

/// Degree known only at run time (storage then has room for max_degree).
inline constexpr int dynamic = Eigen::Dynamic;

/// A point with `Dimension` coordinates.
template <class Scalar, int Dimension>
using Point = Eigen::Matrix<Scalar, Dimension, 1>;

/// Room for one value per coefficient, without heap allocation.
template <class Scalar, int Degree>
using PerCoefficient = Eigen::Matrix<Scalar, 1, Degree == dynamic ? Eigen::Dynamic : Degree + 1, Eigen::RowMajor, 1,
                                     Degree == dynamic ? max_degree + 1 : Degree + 1>;

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

  explicit Curve(int degree) {
    assert(degree >= 0 && degree <= max_degree);
    coefficients_.resize(DimensionT, degree + 1);  // a sized constructor would mean values for small fixed sizes
  }

  [[nodiscard]] int degree() const { return static_cast<int>(coefficients_.cols()) - 1; }
  [[nodiscard]] Scalar operator()(int axis, int i) const { return coefficients_.coeff(axis, i); }
  [[nodiscard]] Scalar& operator()(int axis, int i) { return coefficients_.coeffRef(axis, i); }
  /// Point by point.
  [[nodiscard]] const Scalar* data() const { return coefficients_.data(); }

 private:
  static constexpr int columns = DegreeT == dynamic ? Eigen::Dynamic : DegreeT + 1;
  static constexpr int max_columns = DegreeT == dynamic ? max_degree + 1 : DegreeT + 1;
  static constexpr int order = DimensionT == 1 ? Eigen::RowMajor : Eigen::ColMajor;  // Eigen asks it of a single row
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

  Curve<Form::bernstein, ScalarT, DimensionT, DegreeT> points;
  PerCoefficient<ScalarT, DegreeT> weights;
};

/// A curve behind the erased interfaces: coefficients point by point (x0 y0 x1 y1 ...), not owned.
template <class Scalar>
struct CurveView {
  Form form = Form::bernstein;
  int dimension = 2;
  int degree = 0;
  std::span<const Scalar> coefficients;  ///< (degree + 1) * dimension values; control points are not premultiplied
  std::span<const Scalar> weights = {};  ///< degree + 1 values for a rational curve, else none

  [[nodiscard]] Scalar operator()(int axis, int i) const {
    return coefficients[static_cast<std::size_t>(i) * static_cast<std::size_t>(dimension) +
                        static_cast<std::size_t>(axis)];
  }
};

}  // namespace bezierbench
