// SPDX-License-Identifier: MIT
// The verdict on a ratio of two times. Tables, comparisons of bundles and choices of a method all use this rule.
#pragma once

#include <string_view>

#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::metric {

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
