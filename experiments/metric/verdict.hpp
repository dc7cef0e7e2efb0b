// SPDX-License-Identifier: MIT
// What a ratio of two times says: the one rule for rows of a table, comparisons of bundles and choices of a method.
#pragma once

#include <string_view>

#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::metric {

/// Of every interval of a time or a ratio.
inline constexpr double timing_confidence = 0.99;

/// Differences below it are of no practical interest.
inline constexpr double practical_margin = 0.01;

/// Of fixed work that runs beside: where it takes longer than at other times by more than this, the machine changed its
/// speed, and times taken then do not compare with those others.
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

/// `ratio` is time over the time that it is compared with: `same` where the whole interval lies in
/// [1 - margin, 1 + margin], `slower` where it lies above, `faster` where it lies below, else `unresolved` (also for
/// NaN). So `same` is shown, not merely never refuted.
constexpr Verdict verdict(const Interval& ratio, double margin = practical_margin) {
  if (ratio.low > 1 + margin) return Verdict::slower;
  if (ratio.high < 1 - margin) return Verdict::faster;
  if (ratio.low >= 1 - margin && ratio.high <= 1 + margin) return Verdict::same;
  return Verdict::unresolved;
}

}  // namespace bezierbench::metric
