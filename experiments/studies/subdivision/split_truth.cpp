// SPDX-License-Identifier: MIT
#include "experiments/studies/subdivision/split_truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/error/norm.hpp"
#include "reference/error/trial_scale.hpp"
#include "reference/exact_curve.hpp"

namespace bezierbench::studies {
namespace {

using reference::binary64;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double u = reference::double_arithmetic.unit_roundoff;

/// The Euclidean norm, without intermediate overflow or underflow.
double norm(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  if (largest == 0 || !std::isfinite(largest)) return largest;
  double sum = 0;
  for (const double value : values) sum += (value / largest) * (value / largest);
  return largest * std::sqrt(sum);
}

std::vector<double> norms_of(const CurveView<double>& curve) {
  const auto d = static_cast<std::size_t>(curve.dimension);
  std::vector<double> norms;
  for (std::size_t k = 0; k < curve.coefficients.size(); k += d)
    norms.push_back(norm(curve.coefficients.subspan(k, d)));
  return norms;
}

double rounded(const reference::Rational& value) { return reference::round_to(binary64, value); }

double in_bound_units(double error, double p_tilde) { return error == 0 ? 0 : error / p_tilde / u; }

SplitError judged(double error, double p_tilde, double bound) {
  return {error, in_bound_units(error, p_tilde), bound, in_bound_units(bound, p_tilde)};
}

}  // namespace

void compute_halves(const SplitKernel& method, const CurveView<double>& curve, double t, std::vector<double>& numbers) {
  const auto columns = static_cast<std::size_t>(split_columns(curve.form, curve.dimension));
  const std::size_t size = (static_cast<std::size_t>(curve.degree) + 1) * columns;
  numbers.resize(2 * size);
  method.split(curve, t, numbers.data(), numbers.data() + size);
}

ComputedHalves::ComputedHalves(const CurveView<double>& curve, std::vector<double> numbers)
    : form_(curve.form), dimension_(curve.dimension), degree_(curve.degree), numbers_(std::move(numbers)) {
  for (const Side side : sides)
    for (int i = 0; i <= degree_; ++i) {
      const auto point = control(side, i);
      auto& points = points_[static_cast<std::size_t>(side)];
      points.insert(points.end(), point.begin(), point.begin() + dimension_);
      if (form_ == Form::rational) weights_[static_cast<std::size_t>(side)].push_back(point.back());
    }
}

std::span<const double> ComputedHalves::control(Side side, int i) const {
  const auto columns = static_cast<std::size_t>(split_columns(form_, dimension_));
  const std::size_t place = static_cast<std::size_t>(side) * (static_cast<std::size_t>(degree_) + 1);
  return std::span(numbers_).subspan((place + static_cast<std::size_t>(i)) * columns, columns);
}

bool ComputedHalves::all_finite() const { return reference::all_finite(numbers_); }

CurveView<double> ComputedHalves::curve(Side side) const {
  const auto k = static_cast<std::size_t>(side);
  return {form_, dimension_, degree_, points_[k], weights_[k]};
}

SplitTruth::SplitTruth(const CurveView<double>& curve, double t)
    : curve_(curve),
      proved_(t >= 0 && t <= 1 && std::ranges::all_of(curve.weights, [](double weight) { return weight >= 0; })),
      middles_(reference::exact_middles(curve, t)) {
  const auto norms = norms_of(curve);
  auto exact = reference::exact_split(curve, t);
  const auto p_tilde = reference::split_p_tilde({curve.form, 1, curve.degree, norms, curve.weights}, t);
  take(Side::left, std::move(exact.left), p_tilde.left);
  take(Side::right, std::move(exact.right), p_tilde.right);
}

void SplitTruth::take(Side side, reference::ExactHalf exact, const reference::ExactHalf& p_tilde) {
  Half& half = halves_[static_cast<std::size_t>(side)];
  half.exact = std::move(exact);
  for (int i = 0; i <= curve_.degree; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int levels = side == Side::left ? i : curve_.degree - i;
    const int first = side == Side::left ? 0 : i;
    half.distances.emplace_back();
    if (half.exact.points[k].exists()) half.distances.back().emplace(half.exact.points[k]);
    const auto& point = p_tilde.points[k];
    half.points.push_back(
        {levels, point.exists() ? rounded(point.coordinate(0)) : infinite, largest_point(first, first + levels)});
    if (curve_.form == Form::rational)
      half.weights.push_back({levels, rounded(p_tilde.weights[k]), largest_weight(first, first + levels)});
  }
}

double SplitTruth::largest_point(int first, int last) const {
  std::array<double, reference::max_dimension> largest{};
  for (int j = first; j <= last; ++j)
    for (int axis = 0; axis < curve_.dimension; ++axis) {
      const double weight = curve_.form == Form::rational ? curve_.weights[static_cast<std::size_t>(j)] : 1;
      double& axis_max = largest[static_cast<std::size_t>(axis)];
      axis_max = std::max(axis_max, std::abs(weight * curve_(axis, j)));
    }
  return norm(largest);
}

double SplitTruth::largest_weight(int first, int last) const {
  double largest = 0;
  for (int j = first; j <= last; ++j)
    largest = std::max(largest, std::abs(curve_.weights[static_cast<std::size_t>(j)]));
  return largest;
}

double SplitTruth::point_bound(const SplitBound* bound, Side side, int i) const {
  const auto k = static_cast<std::size_t>(i);
  if (bound == nullptr || !proved_ || !half(side).exact.points[k].exists()) return infinite;
  // Every axis has the error of underflow.
  const SplitArithmetic arithmetic{u, curve_.dimension * reference::double_arithmetic.smallest_subnormal};
  const SplitScale& point = half(side).points[k];
  return curve_.form == Form::rational ? split_quotient_bound(*bound, point, half(side).weights[k], arithmetic)
                                       : split_bound(*bound, point, arithmetic);
}

double SplitTruth::weight_bound(const SplitBound* bound, Side side, int i) const {
  if (bound == nullptr || !proved_) return infinite;
  return split_bound(*bound, half(side).weights[static_cast<std::size_t>(i)],
                     {u, reference::double_arithmetic.smallest_subnormal});
}

SplitError SplitTruth::point_error(const SplitBound* bound, Side side, int i, std::span<const double> computed) const {
  const auto k = static_cast<std::size_t>(i);
  const double error = half(side).distances[k] ? half(side).distances[k]->to(computed) : infinite;
  return judged(error, half(side).points[k].p_tilde, point_bound(bound, side, i));
}

SplitError SplitTruth::weight_error(const SplitBound* bound, Side side, int i, double computed) const {
  const auto k = static_cast<std::size_t>(i);
  const double error = reference::error_of(computed, half(side).exact.weights[k], reference::error_format);
  return judged(error, half(side).weights[k].p_tilde, weight_bound(bound, side, i));
}

/// The bound of the error of a half's middle. The middle is an average of the control points, so its error is at most
/// the largest of their bounds. For a rational curve the coefficients of this average have errors as well: if the
/// relative errors of the weights are at most r, those of the coefficients are at most 2 r / (1 - r),
/// and |b_i| <= p~_i.
double SplitTruth::middle_bound(const SplitBound* bound, Side side) const {
  double max_point_bound = 0;
  double max_weight_bound = 0;  // r
  double largest = 0;
  for (int i = 0; i <= curve_.degree; ++i) {
    max_point_bound = std::max(max_point_bound, point_bound(bound, side, i));
    if (curve_.form != Form::rational) continue;
    const auto k = static_cast<std::size_t>(i);
    max_weight_bound = std::max(max_weight_bound, weight_bound(bound, side, i) / half(side).weights[k].p_tilde);
    largest = std::max(largest, half(side).points[k].p_tilde);
  }
  if (!(max_weight_bound < 1)) return infinite;
  return max_point_bound + 2 * max_weight_bound / (1 - max_weight_bound) * largest;
}

bool SplitTruth::middles_agree(const SplitBound* bound, const ComputedHalves& computed) const {
  reference::ExactCurve exact;
  for (const Side side : sides) {
    const auto& truth = side == Side::left ? middles_.left : middles_.right;
    const double most = middle_bound(bound, side);
    if (truth.empty() || !std::isfinite(most)) continue;
    const auto& point = exact.point(computed.curve(side), 0.5);
    if (!point.exists()) return false;
    std::array<double, reference::max_dimension> difference{};
    for (int axis = 0; axis < curve_.dimension; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      difference[k] = rounded(abs(point.coordinate(axis) - truth[k]));
    }
    if (reference::TrialScale::violates(norm(difference), most)) return false;
  }
  return true;
}

}  // namespace bezierbench::studies
