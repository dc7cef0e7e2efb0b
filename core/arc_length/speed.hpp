// SPDX-License-Identifier: MIT
// The speed |h(t)| of a curve from its hodograph h, with a count of evaluations and a bound on the effect of roundings
// on a length.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/bound/error_bound.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"

namespace bezierbench {

/// Evaluates |h(t)| by Horner-Bernstein and counts the evaluations.
template <int Dimension>
class Speed {
 public:
  explicit Speed(const Curve<Form::bernstein, double, Dimension>& hodograph)
      : prepared_(HornerBernstein::prepare(hodograph)) {}

  double operator()(double t) {
    ++evaluations_;
    return HornerBernstein::evaluate(prepared_, t).norm();
  }
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

 private:
  HornerBernstein::Prepared<double, Dimension, dynamic> prepared_;
  std::int64_t evaluations_ = 0;
};

template <int Dimension>
Speed<Dimension> speed_of(const Curve<Form::bernstein, double, Dimension>& hodograph) {
  return Speed<Dimension>(hodograph);
}

/// The mean size of the control vectors, that is the length of the control polygon: an upper bound of the length of the
/// curve.
template <int Dimension, int Degree>
double polygon_length(const Curve<Form::bernstein, double, Dimension, Degree>& hodograph) {
  double sum = 0;
  for (int i = 0; i <= hodograph.degree(); ++i) {
    double square = 0;
    for (int axis = 0; axis < Dimension; ++axis) square += hodograph(axis, i) * hodograph(axis, i);
    sum += std::sqrt(square);
  }
  return sum / (hodograph.degree() + 1);
}

/// A bound of the change of a length by `roundings` relative errors u in each value of h and in the sums of a
/// quadrature with positive weights: each |h(t)| is off by at most gamma sum |h_i| B_i(t), whose integral is the length
/// of the polygon.
template <int Dimension, int Degree>
double rounding_of_length(const Curve<Form::bernstein, double, Dimension, Degree>& hodograph, int roundings) {
  constexpr double u = 0x1p-53;
  return u * gamma_over_u(roundings, u) * polygon_length(hodograph);
}

}  // namespace bezierbench
