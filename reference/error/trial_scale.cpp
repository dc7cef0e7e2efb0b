// SPDX-License-Identifier: MIT
#include "reference/error/trial_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/bound/amplification.hpp"
#include "core/bound/locality.hpp"
#include "reference/error/norm.hpp"

namespace bezierbench::reference {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

void TrialScale::begin(const CurveView<double>& curve, double t) {
  curve_ = curve;
  form_ = curve.form;
  t_ = t;
  dimension_ = curve.dimension;
  norms_.clear();
  amplified_.fill(std::nullopt);
  reach_.reset();
}

void TrialScale::set(const CurveView<double>& curve, double t) {
  begin(curve, t);
  take_norms();
  if (form_ == Form::rational) weigh(curve);
}

void TrialScale::set(const CurveView<double>& curve, double t, double largest, const Amplifications& amplified) {
  begin(curve, t);
  largest_ = largest;
  amplified_ = amplified;
}

void TrialScale::take_norms() {
  norms_.resize(static_cast<std::size_t>(curve_.degree) + 1);
  largest_ = 0;
  for (int i = 0; i <= curve_.degree; ++i) {
    const double length = norm<double>(curve_.dimension, [&](int axis) { return curve_(axis, i); });
    norms_[static_cast<std::size_t>(i)] = length;
    largest_ = larger(largest_, length);
  }
}

std::vector<double> TrialScale::norms_from(int anchor) const {
  std::vector<double> norms;
  for (int i = 0; i <= curve_.degree; ++i)
    norms.push_back(norm<double>(curve_.dimension, [&](int axis) { return curve_(axis, i) - curve_(axis, anchor); }));
  return norms;
}

void TrialScale::weigh(const CurveView<double>& curve) {
  const auto [smallest, largest] = std::ranges::minmax(curve.weights);
  weights_ = {smallest, largest, 0, largest_};
  const auto points = norms_;
  largest_ = 0;
  bool plain = smallest >= 0 && t_ >= 0 && t_ <= 1 && std::ranges::all_of(curve.weights, detail::is_moderate<double>);
  for (std::size_t i = 0; i < norms_.size(); ++i) {
    norms_[i] *= std::abs(curve.weights[i]);
    largest_ = std::max(largest_, norms_[i]);
    plain = plain && detail::is_moderate(norms_[i]) && (norms_[i] != 0 || points[i] == 0 || curve.weights[i] == 0);
  }
  if (plain)
    weights_.sum = amplification(Amplification::p_tilde_bernstein, curve.weights, t_);
  else
    weigh_exactly({Form::rational, 1, curve.degree, points, curve.weights});
}

void TrialScale::weigh_exactly(const CurveView<double>& norms) {
  auto& p_tilde = amplified_[static_cast<std::size_t>(Amplification::p_tilde_bernstein)];
  p_tilde = infinite;
  if (!std::isfinite(weights_.largest_point)) return;  // a norm overflows
  const auto& exact = exact_.p_tilde(norms, t_);
  if (!exact.exists()) return;
  p_tilde = round_to(binary64, exact.coordinate(0));
  const auto& sum = exact_.point({Form::bernstein, 1, norms.degree, norms.weights}, t_);
  weights_.sum = std::abs(round_to(binary64, sum.coordinate(0)));
}

double TrialScale::amplified(Amplification kind) {
  auto& cached = amplified_[static_cast<std::size_t>(kind)];
  if (cached) return *cached;
  if (anchor_of(kind) != Anchor::none) {
    const bool at_start = anchor_of(kind) == Anchor::start || t_ + t_ <= 1;
    cached = amplification(kind, norms_from(at_start ? 0 : curve_.degree), t_);
  } else {
    if (norms_.empty()) take_norms();
    cached = amplification(kind, norms_, t_) / (form_ == Form::rational ? weights_.sum : 1);
  }
  return *cached;
}

double TrialScale::p_tilde() { return amplified(p_tilde_of(form_)); }

double TrialScale::in_bound_units(double error, const Arithmetic& arithmetic) {
  return in_units(error, p_tilde(), arithmetic.unit_roundoff);
}

double TrialScale::reach() {
  if (!reach_) reach_ = integer_power(std::abs(t_) + std::abs(1 - t_), degree());
  return *reach_;
}

bool TrialScale::stays_in_range(const BoundAtDegree& bound, const Arithmetic& arithmetic) {
  double largest = largest_;
  if (form_ == Form::rational)  // with an error of up to half of it, a quotient is at most twice as large as a point
    largest = std::max({largest_, weights_.largest, 2 * weights_.largest_point});
  if (bound.bound.underflow_scales_with_coefficients) largest = std::max(largest, 1.0);
  return bezierbench::stays_in_range(bound.growth * largest * reach(), degree(), arithmetic.unit_roundoff);
}

double TrialScale::polynomial_underflow(const BoundAtDegree& bound, const Arithmetic& arithmetic, double rounding) {
  const double size = bound.bound.underflow_scales_with_coefficients ? 1 + largest_ : 1;
  // Operations on subnormal numbers take a processor up to a hundred times as long. The term is left out where it
  // cannot change a bit.
  const bool is_lost = rounding > 0x1p-800 && size * bound.underflow * reach() < 0x1p+100 &&
                       arithmetic.smallest_subnormal == double_arithmetic.smallest_subnormal;
  if (is_lost) return 0;
  // Multiplied from the left, beginning with the smallest subnormal, so that large factors do not overflow.
  return arithmetic.smallest_subnormal * size * bound.underflow * reach();
}

double TrialScale::rational_underflow(const BoundAtDegree& bound, const Arithmetic& arithmetic) {
  const int n = degree();
  const double eta = arithmetic.smallest_subnormal;
  const auto& w = weights_;
  if (bound.bound.positive_weights_only) {
    const double in_range = arithmetic.range / integer_power(2.0, n);
    if (!(w.smallest > 0 && (n + 1) * (1 + w.largest) * (1 + 1 / w.smallest) <= in_range)) return infinite;
    return eta + eta * bound.underflow * (1 + w.largest_point) * ((1 + w.largest) / w.smallest);
  }
  if (!(w.smallest >= 0 && w.sum > 0)) return infinite;
  const double numerator_bound = bound.bound.underflow_scales_with_coefficients ? 1 + largest_ : 1;
  const double denominator_bound = bound.bound.underflow_scales_with_coefficients ? 1 + w.largest : 1;
  const double lost = eta * bound.underflow;
  if (!(lost * denominator_bound / w.sum <= 0.125)) return infinite;
  return eta + lost * (numerator_bound + denominator_bound * p_tilde()) / w.sum;
}

double TrialScale::bound_of_kind(const BoundAtDegree& at_degree, const Arithmetic& arithmetic,
                                 std::optional<double> length) {
  const ErrorBound& bound = at_degree.bound;
  if (bound.unit_interval_only && (t_ < 0 || t_ > 1)) return infinite;
  if (!std::isfinite(at_degree.factor) || !stays_in_range(at_degree, arithmetic)) return infinite;
  // |p| <= p~
  const double result = bound.result_roundings == 0 ? 0 : bound.result_roundings * (length ? *length : p_tilde());
  const double rounding = (result + at_degree.factor * amplified(bound.amplification)) * arithmetic.unit_roundoff;
  const double underflow = form_ == Form::rational ? rational_underflow(at_degree, arithmetic)
                                                   : polynomial_underflow(at_degree, arithmetic, rounding);
  if (!std::isfinite(underflow)) return infinite;
  return rounding + dimension_ * underflow;
}

double TrialScale::bound(const BoundAtDegree& at_degree, const Arithmetic& arithmetic, std::optional<double> length) {
  const ErrorBound* const of_local = at_degree.bound.of_local;
  if (of_local == nullptr) return bound_of_kind(at_degree, arithmetic, length);
  LocalOrNot kinds;
  for (int axis = 0; axis < dimension_; ++axis)
    kinds.add(locality(degree(), [&](int i) { return curve_(axis, i); }), degree(), arithmetic.unit_roundoff);
  double sum = kinds.may_be_other ? bound_of_kind(at_degree, arithmetic, length) : 0;
  if (kinds.may_be_local) sum += bound_of_kind(BoundAtDegree(*of_local, degree(), arithmetic), arithmetic, length);
  return sum;
}

std::optional<BoundCheck> TrialScale::check(double error, const BoundAtDegree& at_degree, const Arithmetic& arithmetic,
                                            std::optional<double> length) {
  const double proved = bound(at_degree, arithmetic, length);
  if (!std::isfinite(proved)) return std::nullopt;
  return BoundCheck{proved, in_bound_units(proved, arithmetic), violates(error, proved)};
}

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
