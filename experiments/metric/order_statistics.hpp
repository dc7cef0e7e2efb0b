// SPDX-License-Identifier: MIT
// Quantiles of a small sample and the exact interval of its median, for which no distribution is assumed; and the
// verdict on a ratio of two times, by which tables, comparisons of bundles and choices of a method all go.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

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

/// The confidence of every interval of a time or a ratio.
inline constexpr double timing_confidence = 0.99;

/// Differences below it are of no practical interest.
inline constexpr double practical_margin = 0.01;

/// A tolerance for the sentinels. Where a sentinel takes longer than its fastest time by more than this, the machine
/// changed its speed, and times from then are not compared with others.
inline constexpr double tolerated_drift = 2 * practical_margin;

enum class Verdict { same, slower, faster, unresolved };

constexpr std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::same: return "same";
    case Verdict::slower: return "slower";
    case Verdict::faster: return "faster";
    case Verdict::unresolved: return "unresolved";
  }
  return "";
}

/// `ratio` is time over the time that it is compared with: `same` where the whole interval lies in [1 - margin, 1 +
/// margin], `slower` where it lies above, `faster` where it lies below, else `unresolved` (also for NaN). So `same` is
/// a positive result, not the absence of evidence.
constexpr Verdict verdict(const Interval& ratio, double margin = practical_margin) {
  if (ratio.low > 1 + margin) return Verdict::slower;
  if (ratio.high < 1 - margin) return Verdict::faster;
  if (ratio.low >= 1 - margin && ratio.high <= 1 + margin) return Verdict::same;
  return Verdict::unresolved;
}

}  // namespace bezierbench::metric
