// SPDX-License-Identifier: MIT
#include "reference/error/coordinate_error.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace bezierbench::reference {
namespace {

/// u p~, exactly.
Rational unit_of(const Rational& p_tilde, const Arithmetic& arithmetic) {
  return p_tilde * exactly(arithmetic.unit_roundoff);
}

}  // namespace

CoordinateError coordinate_error(double value, const Rational& truth, const Rational& p_tilde) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  CoordinateError result{round_to(binary64, truth), infinite, infinite, infinite};
  if (!std::isfinite(value)) return result;
  const auto difference = abs(exactly(value) - truth);
  result.error = round_to(binary64, difference);
  result.error_ulp = quotient(binary64, difference, ulp(truth));
  if (difference.numerator == 0)
    result.error_u = 0;
  else if (p_tilde.numerator != 0)
    result.error_u = quotient(binary64, difference, unit_of(p_tilde, double_arithmetic));
  return result;
}

double coordinate_bound(const ErrorBound& bound, const CurveView<double>& curve, int axis, double t,
                        const Rational& truth, const Arithmetic& arithmetic) {
  std::vector<double> coefficients;
  for (int i = 0; i <= curve.degree; ++i) coefficients.push_back(curve(axis, i));
  TrialScale scale;
  scale.set({curve.form, 1, curve.degree, coefficients, curve.weights}, t);
  return scale.least_bound(bound, arithmetic, std::abs(round_to(binary64, truth)));
}

std::optional<double> bound_units(double bound, const Rational& p_tilde, const Arithmetic& arithmetic) {
  if (!std::isfinite(bound) || p_tilde.numerator == 0) return std::nullopt;
  return quotient(binary64, exactly(bound), unit_of(p_tilde, arithmetic));
}

}  // namespace bezierbench::reference
