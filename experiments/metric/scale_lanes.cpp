// SPDX-License-Identifier: MIT
#include "experiments/metric/scale_lanes.hpp"

#include <cmath>
#include <limits>

#include "core/basis/amplification.hpp"

namespace bezierbench::metric {
namespace {

using Lanes = ScaleLanes::Lanes;
constexpr std::size_t lanes = reference::certified_lanes;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double larger(double a, double b) { return a < b ? b : a; }

Lanes integer_powers(Lanes base, int exponent) {
  Lanes result;
  result.fill(1);
  while (true) {
    if (exponent % 2 != 0)
      for (std::size_t k = 0; k < lanes; ++k) result[k] *= base[k];
    exponent /= 2;
    if (exponent == 0) return result;
    for (double& value : base) value *= value;
  }
}

}  // namespace

void ScaleLanes::begin(int dimension, int degree) {
  dimension_ = dimension;
  degree_ = degree;
  norms_.resize(static_cast<std::size_t>(degree) + 1);
  coefficients_.resize(norms_.size() * static_cast<std::size_t>(dimension));
}

void ScaleLanes::load(std::size_t lane, const CurveView<double>& curve, double t) {
  for (std::size_t i = 0; i < coefficients_.size(); ++i) coefficients_[i][lane] = curve.coefficients[i];
  t_[lane] = t;
}

void ScaleLanes::take_norms() {
  static_assert(reference::max_dimension == 3);
  constexpr Lanes none{};
  const auto d = static_cast<std::size_t>(dimension_);
  Lanes most{};
  Lanes least;  // of what is not 0
  least.fill(1);
  for (std::size_t i = 0; i < norms_.size(); ++i) {
    const Lanes& x = coefficients_[i * d];
    const Lanes& y = d > 1 ? coefficients_[i * d + 1] : none;
    const Lanes& z = d > 2 ? coefficients_[i * d + 2] : none;
    Lanes& norm = norms_[i];
    for (std::size_t k = 0; k < lanes; ++k) {
      const double length = std::sqrt(x[k] * x[k] + y[k] * y[k] + z[k] * z[k]);
      const double largest = larger(larger(std::abs(x[k]), std::abs(y[k])), std::abs(z[k]));
      const double positive = largest == 0 ? 1 : largest;
      norm[k] = length;
      most[k] = larger(most[k], length);
      least[k] = positive < least[k] ? positive : least[k];
    }
  }
  largest_ = most;
  for (std::size_t k = 0; k < lanes; ++k) plain_[k] = least[k] > 0x1p-400 && most[k] < 0x1p+400;
}

Lanes ScaleLanes::bernstein_sums(const Lanes& x, const Lanes& y) const {
  const int n = degree_;
  Lanes larger_power;
  Lanes ratio;
  for (std::size_t k = 0; k < lanes; ++k) {
    larger_power[k] = larger(x[k], y[k]);
    ratio[k] = (x[k] <= y[k] ? x[k] : y[k]) / larger_power[k];
  }
  Lanes weight;
  weight.fill(1);
  Lanes sum{};
  for (int i = 0; i <= n; ++i) {
    const Lanes& from_start = norms_[static_cast<std::size_t>(i)];
    const Lanes& from_end = norms_[static_cast<std::size_t>(n - i)];
    const double up = n - i + 1;
    const double down = i;
    for (std::size_t k = 0; k < lanes; ++k) {
      if (i > 0) weight[k] = weight[k] * ratio[k] * up / down;
      sum[k] += weight[k] * (x[k] <= y[k] ? from_start[k] : from_end[k]);
    }
  }
  const Lanes powers = integer_powers(larger_power, n);
  for (std::size_t k = 0; k < lanes; ++k) {
    sum[k] *= powers[k];
    const bool moderate = n < detail::safe_exponent && detail::has_moderate_powers(larger_power[k], n) &&
                          detail::has_moderate_powers(ratio[k], n);
    if (!moderate) sum[k] = unknown;
  }
  return sum;
}

Lanes ScaleLanes::power_sums(const Lanes& x, const Lanes& y) const {
  Lanes sum = norms_.back();
  Lanes y_power;
  y_power.fill(1);
  for (std::size_t j = norms_.size() - 1; j-- > 0;)
    for (std::size_t k = 0; k < lanes; ++k) {
      y_power[k] *= y[k];
      sum[k] = sum[k] * x[k] + norms_[j][k] * y_power[k];
    }
  for (std::size_t k = 0; k < lanes; ++k)
    if (!detail::has_moderate_powers(x[k], degree_) || !detail::has_moderate_powers(y[k], degree_)) sum[k] = unknown;
  return sum;
}

Lanes ScaleLanes::amplifications(Amplification kind) const {
  Lanes x;
  Lanes y;
  Lanes other;
  for (std::size_t k = 0; k < lanes; ++k) {
    x[k] = std::abs(t_[k]);
    y[k] = std::abs(1 - t_[k]);
  }
  switch (kind) {
    case Amplification::p_tilde_bernstein: return bernstein_sums(x, y);
    case Amplification::p_tilde_power: other.fill(1); return power_sums(x, other);
    case Amplification::bernstein_to_power:
      for (std::size_t k = 0; k < lanes; ++k) other[k] = 1 + x[k];
      return bernstein_sums(x, other);
    case Amplification::power_to_bernstein:
      for (std::size_t k = 0; k < lanes; ++k) other[k] = x[k] + y[k];
      return power_sums(x, other);
    case Amplification::forward_substitution:
      for (std::size_t k = 0; k < lanes; ++k) other[k] = 3 * x[k] + y[k];
      return power_sums(x, other);
    case Amplification::p_tilde_centered:
    case Amplification::bernstein_to_centered: break;  // rare
  }
  other.fill(unknown);
  return other;
}

}  // namespace bezierbench::metric
