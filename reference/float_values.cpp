// SPDX-License-Identifier: MIT
#include "reference/float_values.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "core/error_free.hpp"

namespace bezierbench::reference {
namespace {

constexpr float near_zero_to = 0x1p-8F;
constexpr double margin = 1 + 0x1p-20;
constexpr double unit = 0x1p-53;
constexpr double underflow = 0x1p-1000;
constexpr double min_normal = 0x1p-126;
constexpr float allowed = 0x1p-20F;  ///< error of a value, in its ulp
constexpr std::int64_t exponent_bias = 1023;
constexpr std::int64_t fraction_bits = 23;

double larger(double a, double b) { return a < b ? b : a; }

/// The exponent of a positive normal number, and the power of two of an exponent. Integers have the width of doubles,
/// as vectors want it.
std::int64_t exponent_of(double x) {
  return static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(x) >> 52U) - exponent_bias;
}
double power_of_two(std::int64_t e) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(e + exponent_bias) << 52U);
}

/// Half of a number above -4096, rounded down. Vectors have no shift that keeps the sign.
std::int64_t half_of(std::int64_t x) {
  constexpr std::int64_t offset = 4096;
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(x + offset) >> 1U) - offset / 2;
}

/// a + b rounded to odd: where the sum is not a double, that neighbour of it whose last bit is 1. It lies in the
/// binade of the exact sum, and rounds to the float to which the exact sum rounds ([Boldo and Melquiond 2008]).
double odd_sum(double a, double b) {
  const auto sum = two_sum(a, b);
  const auto bits = std::bit_cast<std::uint64_t>(sum.value);
  const std::uint64_t away = sum.error != 0 ? 1 - (bits & 1U) : 0;  // in units of the last bit
  const std::uint64_t inwards = (std::bit_cast<std::uint64_t>(sum.error) ^ bits) >> 63U;
  return std::bit_cast<double>(bits + (away ^ (0 - inwards)) + inwards);
}

/// C(n,j) D^j b_0 for j = 0, ..., n, each rounded once.
std::vector<double> power_coefficients(std::span<const double> control_points) {
  if (control_points.empty()) throw std::invalid_argument("a curve without control points");
  std::vector<Rational> differences;
  for (const double b : control_points) differences.push_back(exactly(b));
  std::vector<double> result{control_points.front()};
  mpz_class binomial = 1;
  const std::size_t n = control_points.size() - 1;
  for (std::size_t j = 1; j <= n; ++j) {
    for (std::size_t i = 0; i + j <= n; ++i) differences[i] = differences[i + 1] - differences[i];
    binomial *= static_cast<unsigned long>(n - j + 1);
    binomial /= static_cast<unsigned long>(j);
    result.push_back(round_to(binary64, differences[0] * Rational{binomial, 1, 0}));
  }
  return result;
}

std::vector<double> with_binomials(std::span<const double> control_points) {
  std::vector<double> result;
  mpz_class binomial = 1;
  const std::size_t n = control_points.size() - 1;
  for (std::size_t i = 0; i <= n; ++i) {
    result.push_back(round_to(binary64, Rational{binomial, 1, 0}) * control_points[i]);
    binomial *= static_cast<unsigned long>(n - i);
    binomial /= static_cast<unsigned long>(i + 1);
  }
  return result;
}

}  // namespace

FloatValuesOf::FloatValuesOf(std::span<const float> control_points)
    : control_points_(control_points.begin(), control_points.end()),
      power_(power_coefficients(control_points_)),
      scaled_(with_binomials(control_points_)),
      pairs_(Form::bernstein, 1, static_cast<int>(control_points.size()) - 1) {
  if (control_points.size() > max_control_points) throw std::invalid_argument("the degree is above 100");
  const auto n = static_cast<double>(control_points.size() - 1);
  power_factor_ = (2 * n + 2) * unit * margin;
  scaled_factor_ = (3 * n + 5) * unit * margin;
  if (std::any_of(power_.begin() + 1, power_.end(), [](double q) { return q != 0; })) min_error_ = underflow;
  constexpr double splitter = 0x1p24 + 1;  // keeps the leading 29 bits ([Dekker 1971]); 24 more are those of t
  if (power_.size() < 2 || power_[0] != 0) return;
  const double shifted = power_[1] * splitter;
  exact_head_ = shifted - (shifted - power_[1]) == power_[1];
}

void FloatValuesOf::near_zero(std::span<const float> t, std::size_t count) {
  std::fill_n(base_.begin(), count, power_.front());
  std::fill_n(difference_.begin(), count, 0.0);
  std::fill_n(magnitude_.begin(), count, 0.0);
  const std::size_t last = exact_head_ ? 2 : 1;
  for (std::size_t j = power_.size(); j-- > last;) {
    const double q = power_[j];
    const double size = std::abs(q);
    for (std::size_t k = 0; k < count; ++k) {
      const double at = t[k];
      difference_[k] = at * (q + difference_[k]);
      magnitude_[k] = at * (size + magnitude_[k]);
    }
  }
  if (exact_head_)
    for (std::size_t k = 0; k < count; ++k) {
      const double at = t[k];
      base_[k] = at * power_[1];
      difference_[k] *= at;
      magnitude_[k] *= at;
    }
  for (std::size_t k = 0; k < count; ++k) error_[k] = power_factor_ * magnitude_[k] + min_error_;
}

void FloatValuesOf::elsewhere(std::span<const float> t, std::size_t first) {
  const std::size_t count = t.size();
  auto& power = error_;  // of t
  for (std::size_t k = first; k < count; ++k) {
    base_[k] = 0;
    difference_[k] = scaled_.front();
    magnitude_[k] = std::abs(scaled_.front());
    power[k] = 1;
  }
  for (std::size_t i = 1; i < scaled_.size(); ++i) {
    const double c = scaled_[i];
    const double size = std::abs(c);
    for (std::size_t k = first; k < count; ++k) {
      const double at = t[k];
      const double s = 1 - at;
      const double next = power[k] * at;
      difference_[k] = difference_[k] * s + c * next;
      magnitude_[k] = magnitude_[k] * s + size * next;
      power[k] = next;
    }
  }
  for (std::size_t k = first; k < count; ++k) error_[k] = scaled_factor_ * magnitude_[k] + underflow;
}

// There are no branches in the loops, and no members, so that compilers vectorise them.
void FloatValuesOf::decide(std::size_t count, FloatValues& values) {
  const double* bases = base_.data();
  double* differences = difference_.data();
  double* errors = error_.data();
  double* lows = low_.data();
  double* highs = high_.data();
  double* per_ulps = magnitude_.data();
  for (std::size_t k = 0; k < count; ++k) {
    const double difference = differences[k];
    const double bound = errors[k] + 2 * unit * std::abs(difference);  // the differences below round as well
    const double low = odd_sum(bases[k], difference - bound);
    const double high = odd_sum(bases[k], difference + bound);
    // Of different signs are only values that round to 0, below all normal floats.
    const auto exponent = exponent_of(larger(std::abs(low), min_normal));
    const bool one_binade = exponent == exponent_of(larger(std::abs(high), min_normal));
    const double per_ulp = power_of_two(fraction_bits - exponent);
    lows[k] = low;
    highs[k] = high;
    per_ulps[k] = per_ulp;
    errors[k] = one_binade ? bound * per_ulp : 1;
  }
  float* nearests = values.nearest.data();
  float* rests = values.rest.data();
  float* scales = values.scale.data();
  float* scales_too = values.scale_too.data();
  std::int32_t* undecided = undecided_.data();
  for (std::size_t k = 0; k < count; ++k) nearests[k] = static_cast<float>(lows[k]);
  for (std::size_t k = 0; k < count; ++k)
    rests[k] = static_cast<float>(((bases[k] - double{nearests[k]}) + differences[k]) * per_ulps[k]);
  for (std::size_t k = 0; k < count; ++k) {
    const double scale = power_of_two(half_of(exponent_of(per_ulps[k])));
    scales[k] = static_cast<float>(scale);
    scales_too[k] = static_cast<float>(per_ulps[k] / scale);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const auto other = static_cast<float>(highs[k]);
    const auto error = static_cast<float>(errors[k]);
    undecided[k] = ((other == nearests[k]) & (error <= allowed)) ? 0 : 1;
  }
}

void FloatValuesOf::find(std::span<const float> t, FloatValues& values) {
  if (t.size() > float_values_at_once) throw std::invalid_argument("more values of t than there is room for");
  const auto first = static_cast<std::size_t>(std::ranges::upper_bound(t, near_zero_to) - t.begin());
  if (first > 0) near_zero(t, first);
  if (first < t.size()) elsewhere(t, first);
  decide(t.size(), values);
  std::int32_t undecided = 0;
  for (std::size_t k = 0; k < t.size(); ++k) undecided += undecided_[k];
  if (undecided > 0) decide_rest(t, values);
}

void FloatValuesOf::decide_rest(std::span<const float> t, FloatValues& values) {
  left_.clear();
  for (std::size_t k = 0; k < t.size(); ++k)
    if (undecided_[k] != 0) left_.push_back(k);
  left_by_doubles_ += left_.size();
  for (std::size_t first = 0; first < left_.size(); first += certified_lanes) {
    for (std::size_t lane = 0; lane < certified_lanes; ++lane)
      pairs_.load(lane, curve(), t[left_[std::min(first + lane, left_.size() - 1)]]);
    pairs_.evaluate();
    const auto& points = pairs_.points();
    std::ranges::copy(points.high[0], base_.begin());
    std::ranges::copy(points.low[0], difference_.begin());
    std::ranges::copy(points.error, error_.begin());
    decide(certified_lanes, pair_values_);
    for (std::size_t lane = 0; lane < certified_lanes && first + lane < left_.size(); ++lane) {
      const std::size_t place = left_[first + lane];
      if (undecided_[lane] != 0) {
        decide_exactly(t[place], place, values);
        continue;
      }
      values.nearest[place] = pair_values_.nearest[lane];
      values.rest[place] = pair_values_.rest[lane];
      values.scale[place] = pair_values_.scale[lane];
      values.scale_too[place] = pair_values_.scale_too[lane];
    }
  }
}

void FloatValuesOf::decide_exactly(double t, std::size_t place, FloatValues& values) {
  const Rational value = exact_.point(curve(), t).coordinate(0);
  const double nearest = round_to(binary32, value);
  constexpr long least = -126;
  const long exponent = value.numerator == 0 ? least : std::max(floor_log2(value), least);
  Rational rest = value - exactly(nearest);
  rest.exponent += fraction_bits - exponent;
  const double per_ulp = power_of_two(fraction_bits - exponent);
  const double scale = power_of_two(half_of(fraction_bits - exponent));
  values.nearest[place] = static_cast<float>(nearest);
  values.rest[place] = static_cast<float>(round_to(binary64, rest));
  values.scale[place] = static_cast<float>(scale);
  values.scale_too[place] = static_cast<float>(per_ulp / scale);
}

}  // namespace bezierbench::reference
