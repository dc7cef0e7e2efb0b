// SPDX-License-Identifier: MIT
#include "reference/long_double.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bezierbench::reference {
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
