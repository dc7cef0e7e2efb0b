// SPDX-License-Identifier: MIT
#include "experiments/studies/exhaustive/float_tally.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

namespace bezierbench::studies {
namespace {

enum Finding : std::int32_t { is_misrounded = 1, is_out_of_hull = 2, is_non_monotone = 4 };

constexpr std::int32_t without_sign = 0x7fffffff;
constexpr auto infinite = std::bit_cast<std::int32_t>(std::numeric_limits<float>::infinity());

/// The order of floats that are not negative is that of their bits, NaN above all.
std::int32_t largest(const std::int32_t* bits, std::size_t count) {
  std::int32_t result = 0;
  for (std::size_t k = 0; k < count; ++k) result = std::max(result, bits[k]);
  return result;
}

std::uint64_t count_of(Finding finding, const std::int32_t* findings, std::size_t count) {
  std::int32_t sum = 0;
  for (std::size_t k = 0; k < count; ++k) sum += (findings[k] & finding) != 0 ? 1 : 0;
  return static_cast<std::uint64_t>(sum);
}

/// The error in double, for one above the largest float; infinite where the value is not finite.
double wide_error(const reference::FloatValues& truth, std::size_t k, float value) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  const double distance = double{value} - double{truth.nearest[k]};
  return std::abs(distance * double{truth.scale[k]} * double{truth.scale_too[k]} - double{truth.rest[k]});
}

}  // namespace

void FloatTally::merge(const FloatTally& other) {
  misrounded += other.misrounded;
  non_monotone += other.non_monotone;
  out_of_hull += other.out_of_hull;
  if (other.max_error > max_error || (other.max_error == max_error && other.worst_t < worst_t)) {
    max_error = other.max_error;
    worst_t = other.worst_t;
  }
}

AxisLimits::AxisLimits(std::span<const float> control_coordinates)
    : low(*std::ranges::min_element(control_coordinates)),
      high(*std::ranges::max_element(control_coordinates)),
      rises(std::ranges::is_sorted(control_coordinates)),
      falls(std::ranges::is_sorted(control_coordinates, std::greater())) {}

void FloatJudge::begin(std::size_t count) {
  count_ = count;
  std::fill_n(errors_.begin(), count, 0);
  std::fill_n(findings_.begin(), count, 0);
  beyond_.clear();
}

// There are no branches in the loops over points, so that compilers vectorise them.
void FloatJudge::add_axis(const AxisLimits& limits, const reference::FloatValues& truth, const float* values,
                          const float* before) {
  const float low = limits.low;
  const float high = limits.high;
  const float* nearest = truth.nearest.data();
  const float* rest = truth.rest.data();
  const float* scale = truth.scale.data();
  const float* scale_too = truth.scale_too.data();
  std::int32_t* errors = errors_.data();
  std::int32_t* findings = findings_.data();
  for (std::size_t k = 0; k < count_; ++k) {
    const float value = values[k];
    const float error = (value - nearest[k]) * scale[k] * scale_too[k] - rest[k];
    errors[k] = std::max(errors[k], std::bit_cast<std::int32_t>(error) & without_sign);
    const std::int32_t rounding = value == nearest[k] ? 0 : is_misrounded;
    const std::int32_t hull = ((value >= low) & (value <= high)) ? 0 : is_out_of_hull;
    findings[k] |= rounding | hull;
  }
  if (largest(errors, count_) >= infinite)
    for (std::size_t k = 0; k < count_; ++k)
      if (errors[k] >= infinite) beyond_.emplace_back(k, wide_error(truth, k, values[k]));
  const auto steps = [&](auto goes_back) {
    if (before != nullptr) findings[0] |= goes_back(*before, values[0]) ? is_non_monotone : 0;
    for (std::size_t k = 1; k < count_; ++k) findings[k] |= goes_back(values[k - 1], values[k]) ? is_non_monotone : 0;
  };
  if (limits.rises) steps(std::greater());
  if (limits.falls) steps(std::less());
}

void FloatJudge::end(std::uint32_t first_t, FloatTally& tally) const {
  FloatTally sum;
  sum.misrounded = count_of(is_misrounded, findings_.data(), count_);
  sum.out_of_hull = count_of(is_out_of_hull, findings_.data(), count_);
  sum.non_monotone = count_of(is_non_monotone, findings_.data(), count_);
  for (const auto& [place, error] : beyond_) {
    if (error <= sum.max_error) continue;
    sum.max_error = error;
    sum.worst_t = first_t + static_cast<std::uint32_t>(place);
  }
  if (const auto worst = largest(errors_.data(), count_); worst < infinite) {
    const auto place = std::find(errors_.begin(), errors_.begin() + static_cast<std::ptrdiff_t>(count_), worst);
    sum.max_error = double{std::bit_cast<float>(worst)};
    sum.worst_t = first_t + static_cast<std::uint32_t>(place - errors_.begin());
  }
  tally.merge(sum);
}

}  // namespace bezierbench::studies
