// SPDX-License-Identifier: MIT
// Views of a curve, and of what a method prepared for one: a coefficient is read as a scalar, which may stand for
// several numbers. Nothing is copied.
#pragma once

#include <concepts>
#include <cstddef>

#include "core/vector/same_for_every_axis.hpp"

namespace bezierbench {

/// A scalar whose curves are views of plain numbers.
template <class V>
concept ReadsCurves = requires(const typename V::Scalar* coordinates) {
  requires V::reads_curves;
  { V::read(coordinates) } -> std::same_as<V>;
  V::axes;
};

namespace detail {

/// How a scalar is read: a number as it is, and of a vector scalar V `V::axes` coordinates by `V::read`.
template <class ScalarT>
struct Reading {
  using Number = ScalarT;
  static constexpr int axes = 1;
  static ScalarT read(const Number* first) { return *first; }
};
template <class V>
requires requires { V::axes; }
struct Reading<V> {
  using Number = typename V::Scalar;
  static constexpr int axes = V::axes;
  [[gnu::always_inline]] static V read(const Number* first) { return V::read(first); }
};

/// A view of numbers that lie point by point. `DimensionT` counts the scalars that a point has.
template <Form F, class ScalarT, int DimensionT, int DegreeT>
class CurveInMemory {
  using Read = Reading<ScalarT>;

 public:
  using Scalar = ScalarT;
  using Number = typename Read::Number;
  static constexpr Form form = F;
  static constexpr int dimension = DimensionT;
  static constexpr int fixed_degree = DegreeT;

  [[gnu::always_inline]] CurveInMemory(const Number* first, int degree)
      : first_(first), last_(first + static_cast<std::ptrdiff_t>(degree) * DimensionT * Read::axes), degree_(degree) {}

  [[nodiscard, gnu::always_inline]] int degree() const { return DegreeT == dynamic ? degree_ : DegreeT; }
  [[nodiscard, gnu::always_inline]] Scalar operator()(int axis, int i) const {
    return Read::read(first_ + static_cast<std::ptrdiff_t>(i * DimensionT + axis) * Read::axes);
  }
  /// Coefficient degree() - k. Its address is counted from that of the last coefficient, which is kept: where k is a
  /// constant, that is one subtraction of a constant. From the degree, compilers compute each address again, or all of
  /// them before the first step.
  [[nodiscard, gnu::always_inline]] Scalar from_end(int axis, int k) const {
    const Number* const last = DegreeT == dynamic ? last_ : first_ + DegreeT * DimensionT * Read::axes;
    return Read::read(last + static_cast<std::ptrdiff_t>(axis - k * DimensionT) * Read::axes);
  }
  [[nodiscard, gnu::always_inline]] const Number* data() const { return first_; }

 private:
  const Number* first_;
  const Number* last_;
  int degree_;
};

}  // namespace detail

/// A curve of a prepared state, all numbers of a coefficient read at once.
template <Form F, ReadsCurves V, int DimensionT, int DegreeT>
class Curve<F, V, DimensionT, DegreeT> : public detail::CurveInMemory<F, V, DimensionT, DegreeT> {
  using detail::CurveInMemory<F, V, DimensionT, DegreeT>::CurveInMemory;
};

/// A curve as it is given.
template <Form F, class ScalarT, int DimensionT>
class Curve<F, ScalarT, DimensionT, viewed> : public detail::CurveInMemory<F, ScalarT, DimensionT, dynamic> {
  using detail::CurveInMemory<F, ScalarT, DimensionT, dynamic>::CurveInMemory;
};

/// Room for the coefficients of a view.
template <ReadsCurves V, int Dimension, int Degree>
class CopyOfView {
 public:
  [[nodiscard, gnu::always_inline]] V& operator()(int axis, int i) { return values_[i * Dimension + axis]; }

 private:
  V values_[((Degree == dynamic ? max_degree : Degree) + 1) * Dimension];
};

/// A view of values that belong to the coefficients and are the same on all axes.
template <ReadsCurves V>
class Row {
 public:
  [[gnu::always_inline]] explicit Row(const typename V::Scalar* first) : first_(first) {}
  [[nodiscard, gnu::always_inline]] V operator[](int i) const { return V(first_[i]); }
  [[nodiscard, gnu::always_inline]] const typename V::Scalar* data() const { return first_; }

 private:
  const typename V::Scalar* first_;
};

template <ReadsCurves V, int DimensionT, int DegreeT>
class Curve<Form::power_double_double, V, DimensionT, DegreeT> {
 public:
  using Scalar = V;
  using Part = Curve<Form::power, V, DimensionT, DegreeT>;

  [[nodiscard, gnu::always_inline]] int degree() const { return high.degree(); }

  Part high;
  Part low;
};

template <ReadsCurves V, int DimensionT, int DegreeT>
class Curve<Form::rational, V, DimensionT, DegreeT> {
 public:
  using Scalar = V;

  [[nodiscard, gnu::always_inline]] int degree() const { return points.degree(); }

  Curve<Form::bernstein, V, DimensionT, DegreeT> points;
  Row<V> weights;
};

}  // namespace bezierbench
