// SPDX-License-Identifier: MIT
#include "reference/true_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bezierbench::reference {

const ExactPoint& TruePoint::exact() {
  if (point_ == nullptr) point_ = &exact_->point(curve_, t_);
  return *point_;
}

bool TruePoint::exists() { return certified_ || curve_.form != Form::rational || exact().exists(); }

const Distance& TruePoint::exact_distance() {
  if (!distance_) distance_.emplace(exact());
  return *distance_;
}

double TruePoint::distance(std::span<const double> point) {
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(point, finite)) return std::numeric_limits<double>::infinity();
  if (certified_ && !distance_) {
    if (const auto proved = certified_->distance(point)) return *proved;
    escalated_ = true;
  }
  return exact_distance().to(point);
}

double TruePoint::length() {
  constexpr std::array<double, max_dimension> origin{};
  return distance(std::span(origin).first(static_cast<std::size_t>(curve_.dimension)));
}

double TruePoint::ulp(double length, const Format& format) {
  if (const auto decided = ulp_at_length(length, format)) return *decided;
  escalated_ = escalated_ || certified_.has_value();
  return ulp_of_length(exact(), length, format);
}

namespace {

/// The number nearest to high + low, which is the coordinate up to `error`; empty where the error leaves two of them.
template <class Scalar>
std::optional<double> certain_nearest(double high, double low, double error) {
  const auto number = static_cast<Scalar>(high);
  if (!std::isfinite(number)) return std::nullopt;
  const double rest = (high - static_cast<double>(number)) + low;  // the difference is exact
  const double unsure = error + std::numeric_limits<double>::epsilon() * std::abs(rest);
  if (rest == 0 && unsure == 0) return number;
  // Below a power of two the numbers are closer to each other, so the gap towards 0 serves for both sides.
  const double gap = std::abs(static_cast<double>(number) - static_cast<double>(std::nextafter(number, Scalar{0})));
  return std::abs(rest) + unsure < gap / 2 ? std::optional<double>(number) : std::nullopt;
}

}  // namespace

double TruePoint::nearest(int axis, const Format& format) {
  if (certified_) {
    const auto a = static_cast<std::size_t>(axis);
    const double high = certified_->high[a];
    const double low = certified_->low[a];
    const auto number = format.precision == binary32.precision ? certain_nearest<float>(high, low, certified_->error)
                                                               : certain_nearest<double>(high, low, certified_->error);
    if (number) return *number;
  }
  return round_to(format, exact().coordinate(axis));
}

namespace {

/// A finite long double as the exact sum of its parts in double.
Rational exactly_long(long double value) {
  int exponent = 0;
  long double mantissa = std::frexp(value, &exponent);
  Rational sum;
  while (mantissa != 0) {
    const auto part = static_cast<double>(mantissa);
    sum = sum + exactly(part);
    mantissa -= part;
  }
  sum.exponent += exponent;
  return sum;
}

/// Horner's nested sum in Bernstein form of the coefficients c(0) .. c(n).
template <class Coefficient>
long double bernstein_sum(int n, long double t, Coefficient c) {
  const long double one_minus_t = 1.0L - t;
  long double weight = 1;
  long double sum = c(0);
  for (int i = 1; i <= n; ++i) {
    weight = weight * t * static_cast<long double>(n - i + 1) / static_cast<long double>(i);
    sum = sum * one_minus_t + weight * c(i);
  }
  return sum;
}

}  // namespace

LongDoublePoint long_double_point(const CurveView<double>& curve, double t) {
  const int n = curve.degree;
  const auto x = static_cast<long double>(t);
  const auto weight = [&](int i) { return static_cast<long double>(curve.weights[static_cast<std::size_t>(i)]); };
  LongDoublePoint point{};
  for (int axis = 0; axis < curve.dimension; ++axis) {
    const auto c = [&](int i) { return static_cast<long double>(curve(axis, i)); };
    long double& sum = point[static_cast<std::size_t>(axis)];
    if (curve.form == Form::bernstein)
      sum = bernstein_sum(n, x, c);
    else if (curve.form == Form::rational)
      sum = bernstein_sum(n, x, [&](int i) { return weight(i) * c(i); }) / bernstein_sum(n, x, weight);
    else
      for (int j = n; j >= 0; --j) sum = sum * x + c(j);
  }
  return point;
}

double audit_ulp(const LongDoublePoint& value, const ExactPoint& exact) {
  double worst = 0;
  for (int axis = 0; axis < exact.dimension; ++axis) {
    const long double coordinate = value[static_cast<std::size_t>(axis)];
    if (!std::isfinite(coordinate)) return std::numeric_limits<double>::infinity();
    const Rational truth = exact.coordinate(axis);
    worst = std::max(worst, quotient(binary64, abs(exactly_long(coordinate) - truth), ulp(truth)));
  }
  return worst;
}

}  // namespace bezierbench::reference
