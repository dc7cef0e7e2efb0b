// SPDX-License-Identifier: MIT
// Quantiles of a small sample and the exact interval of its median; no distribution is assumed.
#pragma once

#include <cstddef>
#include <span>

namespace bezierbench::metric {

/// The smallest value with at least q of the sample at or below it (nearest rank). The sample is not empty, 0 < q <= 1.
double quantile(std::span<const double> sample, double q);

/// The middle value, or half-way between the middle two. The sample is not empty.
double median(std::span<const double> sample);

struct Interval {
  double median;
  double low;
  double high;
};

/// The median and the narrowest symmetric pair of order statistics that covers the true median with at least
/// `confidence`, by the sign test: P(Binomial(N, 1/2) < k) <= (1 - confidence) / 2. The whole range where N is too
/// small. Source: Hettmansperger and McKean, Robust Nonparametric Statistical Methods, section 1.1.
Interval median_interval(std::span<const double> sample, double confidence);

/// True where a sample of `count` is large enough for that: 2 (1/2)^count <= 1 - confidence, 8 for 99 %.
bool covers_median(std::size_t count, double confidence);

}  // namespace bezierbench::metric
