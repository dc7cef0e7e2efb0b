// SPDX-License-Identifier: MIT
#include "reference/companion/exact_split.hpp"

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

/// The two results for each part of the curve: its point, or its p~.
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

/// The coefficients of a Bernstein sum.
using Coefficient = Rational (*)(const CurveView<double>& curve, int axis, int i);

Rational plain(const CurveView<double>& curve, int axis, int i) { return exactly(curve(axis, i)); }
Rational weight(const CurveView<double>& curve, int /*axis*/, int i) {
  return exactly(curve.weights[static_cast<std::size_t>(i)]);
}
Rational weighted(const CurveView<double>& curve, int axis, int i) {
  return weight(curve, axis, i) * plain(curve, axis, i);
}

/// sum_i c_i C(n,i) t^i (1-t)^(n-i), nested.
Rational bernstein_sum(const CurveView<double>& curve, Coefficient c, int axis, const Rational& t) {
  const Rational s = exactly(1) - t;
  Rational sum = c(curve, axis, 0);
  Rational power = exactly(1);  // t^i
  for (int i = 1; i <= curve.degree; ++i) {
    power = power * t;
    Rational term = power;
    mpz_class binomial;
    mpz_bin_uiui(binomial.get_mpz_t(), static_cast<unsigned long>(curve.degree), static_cast<unsigned long>(i));
    term.numerator *= binomial;
    sum = sum * s + term * c(curve, axis, i);
  }
  return sum;
}

/// The coordinates at a dyadic t.
std::vector<Rational> coordinates_at(const CurveView<double>& curve, const Rational& t) {
  std::vector<Rational> coordinates;
  const bool rational = curve.form == Form::rational;
  const Rational sum = rational ? bernstein_sum(curve, weight, 0, t) : exactly(1);
  if (sum.numerator == 0) return coordinates;
  for (int axis = 0; axis < curve.dimension; ++axis) {
    Rational coordinate = bernstein_sum(curve, rational ? weighted : plain, axis, t);
    if (sum.numerator < 0) coordinate.numerator = -coordinate.numerator;
    coordinates.push_back({coordinate.numerator, ::abs(sum.numerator), coordinate.exponent - sum.exponent});
  }
  return coordinates;
}

}  // namespace

ExactHalves exact_split(const CurveView<double>& curve, double t) { return halves(curve, t, &ExactCurve::point); }

ExactHalves split_p_tilde(const CurveView<double>& curve, double t) { return halves(curve, t, &ExactCurve::p_tilde); }

Middles exact_middles(const CurveView<double>& curve, double t) {
  const Rational half{1, 1, -1};
  return {coordinates_at(curve, exactly(t) * half), coordinates_at(curve, (exactly(1) + exactly(t)) * half)};
}

double error_of(double value, const Rational& truth, const Format& format) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  return round_to(format, abs(exactly(value) - truth));
}

}  // namespace bezierbench::reference
