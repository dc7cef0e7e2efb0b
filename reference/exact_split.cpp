// SPDX-License-Identifier: MIT
#include "reference/exact_split.hpp"

#include <cassert>
#include <cmath>
#include <limits>

namespace bezierbench::reference {
namespace {

/// The curve with control points `first` .. `first + degree` of `curve`.
CurveView<double> part(const CurveView<double>& curve, int first, int degree) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  const auto from = static_cast<std::size_t>(first);
  const std::size_t count = static_cast<std::size_t>(degree) + 1;
  CurveView<double> result{curve.form, curve.dimension, degree, curve.coefficients.subspan(from * d, count * d)};
  if (curve.form == Form::rational) result.weights = curve.weights.subspan(from, count);
  return result;
}

/// Its weights as a curve on one axis.
CurveView<double> weights_of(const CurveView<double>& curve) {
  return {Form::bernstein, 1, curve.degree, curve.weights};
}

/// What is asked of each part of the curve: its point, or its p~.
using Ask = const ExactPoint& (ExactCurve::*)(const CurveView<double>&, double);

void append(ExactCurve& exact, Ask ask, const CurveView<double>& control, double t, ExactHalf& half) {
  half.points.push_back((exact.*ask)(control, t));
  if (control.form == Form::rational) half.weights.push_back((exact.*ask)(weights_of(control), t).coordinate(0));
}

ExactHalves halves(const CurveView<double>& curve, double t, Ask ask) {
  assert(curve.form == Form::bernstein || curve.form == Form::rational);
  ExactCurve exact;
  ExactHalves result;
  for (int i = 0; i <= curve.degree; ++i) {
    append(exact, ask, part(curve, 0, i), t, result.left);
    append(exact, ask, part(curve, i, curve.degree - i), t, result.right);
  }
  return result;
}

}  // namespace

ExactHalves exact_split(const CurveView<double>& curve, double t) { return halves(curve, t, &ExactCurve::point); }

ExactHalves split_p_tilde(const CurveView<double>& curve, double t) { return halves(curve, t, &ExactCurve::p_tilde); }

double error_of(double value, const Rational& truth, const Format& format) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  return round_to(format, abs(exactly(value) - truth));
}

}  // namespace bezierbench::reference
