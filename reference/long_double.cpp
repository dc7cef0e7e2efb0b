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

}  // namespace

LongDoublePoint long_double_point(const CurveView<double>& curve, double t) {
  const int n = curve.degree;
  const long double one_minus_t = 1.0L - static_cast<long double>(t);
  LongDoublePoint point{};
  for (int axis = 0; axis < curve.dimension; ++axis) {
    long double sum = 0;
    if (curve.form == Form::bernstein) {
      long double weight = 1;
      sum = curve(axis, 0);
      for (int i = 1; i <= n; ++i) {
        weight =
            weight * static_cast<long double>(t) * static_cast<long double>(n - i + 1) / static_cast<long double>(i);
        sum = sum * one_minus_t + weight * static_cast<long double>(curve(axis, i));
      }
    } else {
      for (int j = n; j >= 0; --j) sum = sum * static_cast<long double>(t) + static_cast<long double>(curve(axis, j));
    }
    point[static_cast<std::size_t>(axis)] = sum;
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
