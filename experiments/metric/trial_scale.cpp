// SPDX-License-Identifier: MIT
#include "experiments/metric/trial_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/basis/amplification.hpp"

namespace bezierbench::metric {

void TrialScale::set(const CurveView<double>& curve, double t) {
  form_ = curve.form;
  t_ = t;
  dimension_ = curve.dimension;
  norms_.resize(static_cast<std::size_t>(curve.degree) + 1);
  largest_ = 0;
  for (int i = 0; i <= curve.degree; ++i) {
    double largest = 0;
    for (int axis = 0; axis < curve.dimension; ++axis) largest = std::max(largest, std::abs(curve(axis, i)));
    // Squares neither overflow nor vanish after scaling by a power of two.
    const double scale = largest > 0x1p+500 ? 0x1p-600 : largest < 0x1p-400 ? 0x1p+600 : 1;
    double sum = 0;
    for (int axis = 0; axis < curve.dimension; ++axis) {
      const double scaled = curve(axis, i) * scale;
      sum += scaled * scaled;
    }
    const double norm = std::sqrt(sum) / scale;
    norms_[static_cast<std::size_t>(i)] = norm;
    largest_ = std::max(largest_, norm);
  }
  amplified_.fill(std::nullopt);
}

double TrialScale::amplified(Amplification kind) {
  auto& cached = amplified_[static_cast<std::size_t>(kind)];
  if (!cached) cached = amplification(kind, norms_, t_);
  return *cached;
}

double TrialScale::p_tilde() { return amplified(p_tilde_of(form_)); }

double TrialScale::in_bound_units(double error, const Arithmetic& arithmetic) {
  if (error == 0) return 0;
  return error / p_tilde() / arithmetic.unit_roundoff;  // x / 0 is infinite, as defined
}

double TrialScale::bound(const ErrorBound& bound, const Arithmetic& arithmetic) {
  if (bound.unit_interval_only && (t_ < 0 || t_ > 1)) return std::numeric_limits<double>::infinity();
  const int n = static_cast<int>(norms_.size()) - 1;
  const double factor = bound.factor(n, arithmetic.unit_roundoff);
  const double growth = integer_power(std::abs(t_) + std::abs(1 - t_), n);
  const double size = bound.underflow_scales_with_coefficients ? 1 + largest_ : 1;
  // The tiny unit first, so that large factors do not overflow on the way.
  const double underflow = arithmetic.smallest_subnormal * size * bound.underflow(n) * growth;
  if (!std::isfinite(factor) || !std::isfinite(underflow)) return std::numeric_limits<double>::infinity();
  const double result = bound.result_roundings == 0 ? 0 : bound.result_roundings * p_tilde();  // |p| <= p~
  const double rounding = result + factor * amplified(bound.amplification);
  return rounding * arithmetic.unit_roundoff + dimension_ * underflow;
}

}  // namespace bezierbench::metric
