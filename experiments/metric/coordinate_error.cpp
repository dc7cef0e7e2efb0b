// SPDX-License-Identifier: MIT
#include "experiments/metric/coordinate_error.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace bezierbench::metric {
namespace {

/// u p~, exactly.
reference::Rational unit_of(const reference::Rational& p_tilde, const Arithmetic& arithmetic) {
  return p_tilde * reference::exactly(arithmetic.unit_roundoff);
}

}  // namespace

CoordinateError coordinate_error(double value, const reference::Rational& truth, const reference::Rational& p_tilde) {
  using reference::binary64;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  CoordinateError result{reference::round_to(binary64, truth), infinite, infinite, infinite};
  if (!std::isfinite(value)) return result;
  const auto difference = abs(reference::exactly(value) - truth);
  result.error = reference::round_to(binary64, difference);
  result.error_ulp = reference::quotient(binary64, difference, reference::ulp(truth));
  if (difference.numerator == 0)
    result.error_u = 0;
  else if (p_tilde.numerator != 0)
    result.error_u = reference::quotient(binary64, difference, unit_of(p_tilde, double_arithmetic));
  return result;
}

double coordinate_bound(const ErrorBound& bound, const CurveView<double>& curve, int axis, double t,
                        const reference::Rational& truth, const Arithmetic& arithmetic) {
  std::vector<double> coefficients;
  for (int i = 0; i <= curve.degree; ++i) coefficients.push_back(curve(axis, i));
  TrialScale scale;
  scale.set({curve.form, 1, curve.degree, coefficients, curve.weights}, t);
  return scale.bound(bound, arithmetic, std::abs(reference::round_to(reference::binary64, truth)));
}

std::optional<double> bound_units(double bound, const reference::Rational& p_tilde, const Arithmetic& arithmetic) {
  if (!std::isfinite(bound) || p_tilde.numerator == 0) return std::nullopt;
  return reference::quotient(reference::binary64, reference::exactly(bound), unit_of(p_tilde, arithmetic));
}

}  // namespace bezierbench::metric
