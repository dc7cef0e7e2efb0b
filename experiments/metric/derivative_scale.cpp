// SPDX-License-Identifier: MIT
#include "experiments/metric/derivative_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/factorial.hpp"
#include "core/powers.hpp"
#include "reference/error/norm.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::metric {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

void DerivativeScale::set(const CurveView<double>& curve, int order, double t) {
  dimension_ = curve.dimension;
  degree_ = curve.degree;
  order_ = order;
  t_ = t;
  const auto coefficients = exact_.derivative_coefficients(curve, order);
  const int degree = std::max(curve.degree - order, 0);
  p_tilde_ = infinite;
  if (reference::all_finite(coefficients)) {
    scale_.set({curve.form, curve.dimension, degree, coefficients}, t);
    p_tilde_ = scale_.p_tilde();
  }
  differences_ = 0;
  largest_ = 0;
  for (const double own : coefficients) largest_ = std::max(largest_, std::abs(own));
  if (curve.form != Form::bernstein || order > curve.degree) return;  // no differences are formed
  const auto sums = magnitudes(curve);
  differences_ = infinite;
  largest_ = std::ranges::max(sums);
  if (!std::isfinite(largest_)) return;
  scale_.set({Form::bernstein, 1, degree, sums}, t);
  differences_ = scale_.p_tilde();
}

std::vector<double> DerivativeScale::magnitudes(const CurveView<double>& curve) const {
  const auto d = static_cast<std::size_t>(curve.dimension);
  std::vector<double> sums;
  for (std::size_t i = 0; i < curve.coefficients.size(); i += d)
    sums.push_back(reference::Distance(curve.coefficients.subspan(i, d)).to_origin(curve.dimension));
  for (int k = 0; k < order_; ++k) {
    for (std::size_t i = 0; i + 1 < sums.size(); ++i) sums[i] += sums[i + 1];
    sums.pop_back();
  }
  for (double& sum : sums) sum *= falling_factorial(curve.degree, order_);
  return sums;
}

double DerivativeScale::in_bound_units(double error, const reference::Arithmetic& arithmetic) const {
  return reference::in_units(error, p_tilde_, arithmetic.unit_roundoff);
}

double DerivativeScale::bound(const DerivativeBound& bound, const reference::Arithmetic& arithmetic) const {
  const double u = arithmetic.unit_roundoff;
  if (!std::isfinite(p_tilde_) || !std::isfinite(differences_)) return infinite;
  const bool scales = bound.underflow_scales_with_coefficients;
  const double reach = integer_power(std::abs(t_) + std::abs(1 - t_), std::max(degree_ - order_, 0));
  const double largest = bound.growth(degree_, order_) * (scales ? std::max(largest_, 1.0) : largest_) * reach;
  if (!stays_in_range(largest, degree_, u)) return infinite;
  const double underflow =
      bound.underflow(degree_, order_) * arithmetic.smallest_subnormal * (scales ? 1 + largest_ : 1) * reach;
  return u * (bound.differences(degree_, order_, u) * differences_ + bound.evaluation(degree_, order_, u) * p_tilde_) +
         dimension_ * underflow;
}

}  // namespace bezierbench::metric
