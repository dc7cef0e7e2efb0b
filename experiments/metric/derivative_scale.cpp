// SPDX-License-Identifier: MIT
#include "experiments/metric/derivative_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/binomial.hpp"
#include "core/bound/error_bound.hpp"
#include "core/factorial.hpp"
#include "core/powers.hpp"
#include "reference/error/norm.hpp"
#include "reference/exact_point.hpp"

namespace bezierbench::metric {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<double> norms_of(const CurveView<double>& curve) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  std::vector<double> norms;
  for (std::size_t i = 0; i < curve.coefficients.size(); i += d)
    norms.push_back(reference::Distance(curve.coefficients.subspan(i, d)).to_origin(curve.dimension));
  return norms;
}

}  // namespace

void DerivativeScale::set(const CurveView<double>& curve, int order, double t) {
  dimension_ = curve.dimension;
  degree_ = curve.degree;
  order_ = order;
  t_ = t;
  p_tilde_ = infinite;
  differences_ = {};
  numerators_.clear();
  denominators_.clear();
  if (curve.form == Form::rational) {
    const auto norms = norms_of(curve);
    const auto& scale = exact_.derivative_p_tilde({Form::rational, 1, degree_, norms, curve.weights}, order, t);
    if (!scale.exists()) return;
    p_tilde_ = reference::Distance(scale).to_origin(1);
    weight_ = reference::Distance(exact_.point({Form::bernstein, 1, degree_, curve.weights}, t)).to_origin(1);
    std::vector<double> weights;
    std::vector<double> products;
    for (std::size_t i = 0; i < norms.size(); ++i) {
      weights.push_back(std::abs(curve.weights[i]));
      products.push_back(weights.back() * norms[i]);
    }
    for (int k = 0; k <= order; ++k) {
      numerators_.push_back(differences(products, k));
      denominators_.push_back(differences(weights, k));
    }
    return;
  }
  const auto coefficients = exact_.derivative_coefficients(curve, order);
  const int degree = std::max(curve.degree - order, 0);
  if (reference::all_finite(coefficients)) {
    scale_.set({curve.form, curve.dimension, degree, coefficients}, t);
    p_tilde_ = scale_.p_tilde();
  }
  if (curve.form == Form::bernstein && order <= degree_)
    differences_ = differences(norms_of(curve), order);
  else
    for (const double own : coefficients) differences_.largest = std::max(differences_.largest, std::abs(own));
}

DerivativeScale::Differences DerivativeScale::differences(const std::vector<double>& norms, int order) {
  if (order > degree_) return {};
  auto sums = norms;  // (n)_k sum_j C(k,j) |b_(i+j)|
  for (int k = 0; k < order; ++k) {
    for (std::size_t i = 0; i + 1 < sums.size(); ++i) sums[i] += sums[i + 1];
    sums.pop_back();
  }
  for (double& sum : sums) sum *= falling_factorial(degree_, order);
  const double largest = std::ranges::max(sums);
  if (!std::isfinite(largest)) return {infinite, largest};
  scale_.set({Form::bernstein, 1, degree_ - order, sums}, t_);
  return {scale_.p_tilde(), largest};
}

double DerivativeScale::in_bound_units(double error, const reference::Arithmetic& arithmetic) const {
  return reference::in_units(error, p_tilde_, arithmetic.unit_roundoff);
}

double DerivativeScale::underflow(const DerivativeBound& bound, int order, double largest,
                                  const reference::Arithmetic& arithmetic) const {
  const bool scales = bound.underflow_scales_with_coefficients;
  const double reach = integer_power(std::abs(t_) + std::abs(1 - t_), std::max(degree_ - order, 0));
  const double grown = bound.growth(degree_, order) * (scales ? std::max(largest, 1.0) : largest) * reach;
  if (!stays_in_range(grown, degree_, arithmetic.unit_roundoff)) return infinite;
  return bound.underflow(degree_, order) * arithmetic.smallest_subnormal * (scales ? 1 + largest : 1) * reach;
}

double DerivativeScale::bound(const DerivativeBound& bound, const reference::Arithmetic& arithmetic) const {
  if (!numerators_.empty()) return quotient_bound(bound, arithmetic);
  const double u = arithmetic.unit_roundoff;
  if (!std::isfinite(p_tilde_) || !std::isfinite(differences_.sum)) return infinite;
  return u * (bound.differences(degree_, order_, u) * differences_.sum +
              bound.evaluation(degree_, order_, u) * p_tilde_) +
         dimension_ * underflow(bound, order_, differences_.largest, arithmetic);
}

double DerivativeScale::quotient_bound(const DerivativeBound& bound, const reference::Arithmetic& arithmetic) const {
  if (!std::isfinite(p_tilde_) || weight_ == 0 || order_ > exact_binomial_degree) return infinite;
  const double u = arithmetic.unit_roundoff;
  const double eta = arithmetic.smallest_subnormal;
  // A^(k) and W^(k), with what may underflow, in products w_i b_i and afterwards, as a part of them.
  const auto with_underflow = [&](const Differences& part, int order) {
    const double reach = integer_power(std::abs(t_) + std::abs(1 - t_), std::max(degree_ - order, 0));
    const double products = falling_factorial(degree_, order) * integer_power(2.0, order) * reach * eta;
    return part.sum + dimension_ * (underflow(bound, order, part.largest, arithmetic) + products) / u;
  };
  double roundings = 0;  // G
  for (int k = 0; k <= order_; ++k) {
    const double method = bound.differences(degree_, k, u) + bound.evaluation(degree_, k, u);
    roundings = std::max(roundings, u * (method * (1 + u) + 1));
  }
  std::vector<double> weights;
  for (int k = 0; k <= order_; ++k) weights.push_back(with_underflow(denominators_[static_cast<std::size_t>(k)], k));
  std::vector<double> sizes;  // S_0, ..., S_k
  for (int k = 0; k <= order_; ++k) {
    const BinomialRow<double, dynamic> binomials(k);
    double sum = with_underflow(numerators_[static_cast<std::size_t>(k)], k) + dimension_ * k * eta / u;
    for (int i = 1; i <= k; ++i)
      sum += binomials[i] * weights[static_cast<std::size_t>(i)] * sizes[static_cast<std::size_t>(k - i)];
    if (!(2 * sum < arithmetic.range)) return infinite;
    sizes.push_back(sum / weight_ + dimension_ * eta / u);
  }
  const double s = roundings * (1 + weights.front() / weight_) + u * (gamma_over_u(order_ + 2, u) + 1);
  const double all = (order_ + 1) * s;
  if (!(all < 0.5) || !(2 * sizes.back() < arithmetic.range)) return infinite;
  return all / (1 - all) * sizes.back();
}

}  // namespace bezierbench::metric
