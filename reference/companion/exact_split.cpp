// SPDX-License-Identifier: MIT
#include "reference/companion/exact_split.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/rational.hpp"
#include "reference/stop.hpp"

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

namespace {

using Column = std::vector<Rational>;  // a number for each control point

/// The numerators w_i b_i of each axis, then of a rational curve the weights.
std::vector<Column> columns_of(const CurveView<double>& curve) {
  const bool is_rational = curve.form == Form::rational;
  std::vector<Column> columns(static_cast<std::size_t>(curve.dimension) + (is_rational ? 1 : 0));
  for (int i = 0; i <= curve.degree; ++i) {
    const Rational w = exactly(is_rational ? curve.weights[static_cast<std::size_t>(i)] : 1);
    for (int axis = 0; axis < curve.dimension; ++axis)
      columns[static_cast<std::size_t>(axis)].push_back(exactly(curve(axis, i)) * w);
    if (is_rational) columns.back().push_back(w);
  }
  return columns;
}

std::optional<RoundedControlPoints> rounded(const std::vector<Column>& columns, int dimension) {
  RoundedControlPoints result;
  const bool is_rational = columns.size() > static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < columns.front().size(); ++i) {
    const Rational w = is_rational ? columns.back()[i] : exactly(1);
    if (round_to(binary64, w) == 0) return std::nullopt;
    for (int axis = 0; axis < dimension; ++axis)
      result.points.push_back(quotient(binary64, columns[static_cast<std::size_t>(axis)][i], w));
    if (is_rational) result.weights.push_back(round_to(binary64, w));
  }
  return result;
}

/// Replaces the first k + 1 numbers by the k of the next level of de Casteljau's triangle.
void step(Column& b, std::size_t k, const Rational& s, const Rational& t) {
  StopWhen::poll();
  for (std::size_t j = 0; j < k; ++j) b[j] = s * b[j] + t * b[j + 1];
}

Column part(Column level, const Rational& from, const Rational& to) {
  const Rational before_from = exactly(1) - from;
  const Rational before_to = exactly(1) - to;
  Column result(level.size());
  for (std::size_t i = level.size(); i-- > 0;) {  // `level` has n - i arguments `from` and i + 1 numbers
    auto b = level;
    for (std::size_t k = i; k > 0; --k) step(b, k, before_to, to);
    result[i] = std::move(b.front());
    step(level, i, before_from, from);
    level.resize(std::max<std::size_t>(i, 1));
  }
  return result;
}

Column elevated(const Column& b, int degree) {
  const auto n = static_cast<unsigned long>(b.size() - 1);
  const auto more = static_cast<unsigned long>(degree) - n;
  const auto choose = [](unsigned long of, unsigned long count) {
    mpz_class binomial;
    mpz_bin_uiui(binomial.get_mpz_t(), of, count);
    return binomial;
  };
  Column result;
  for (unsigned long i = 0; i <= n + more; ++i) {
    StopWhen::poll();
    Rational sum;
    for (unsigned long j = i > more ? i - more : 0; j <= std::min(i, n); ++j)
      sum = sum + Rational{choose(n, j) * choose(more, i - j), 1, 0} * b[j];
    sum.denominator = choose(n + more, i);
    result.push_back(sum);
  }
  return result;
}

}  // namespace

std::optional<RoundedControlPoints> control_points_of_part(const CurveView<double>& curve, double from, double to) {
  auto columns = columns_of(curve);
  for (auto& column : columns) column = part(std::move(column), exactly(from), exactly(to));
  return rounded(columns, curve.dimension);
}

std::optional<RoundedControlPoints> elevated_control_points(const CurveView<double>& curve, int degree) {
  auto columns = columns_of(curve);
  for (auto& column : columns) column = elevated(column, degree);
  return rounded(columns, curve.dimension);
}

}  // namespace bezierbench::reference
