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

/// Ranks of a sample in ascending order, from 1. 0 and one more than the size of the sample are those of no value.
struct Ranks {
  std::size_t low;
  std::size_t high;
};

/// The greatest and the least rank of a sample of `count` whose values lie below and above the quantile 1/`part` of the
/// distribution, except with a probability of 1/`exceptions` each. The number of values below the quantile is binomial,
/// so that value number r exceeds it where fewer than r are; the sums are exact integers. Count from above for the
/// quantile 1 - 1/`part`. Source: David and Nagaraja, Order Statistics, 3rd ed., section 7.1.
Ranks quantile_ranks(std::size_t count, unsigned long part, unsigned long exceptions);

/// True where a sample of `count` is large enough for that: 2 (1/2)^count <= 1 - confidence, 8 for 99 %.
bool covers_median(std::size_t count, double confidence);

}  // namespace bezierbench::metric
