// SPDX-License-Identifier: MIT
// How the times of two bundles compare, method by method: as they are, and in units of the sentinel.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "experiments/compare/row_match.hpp"
#include "experiments/compare/side.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"

namespace bezierbench::compare {

/// What timing.csv calls the fixed work that ran beside every race.
inline constexpr std::string_view sentinel = "sentinel";

/// Whether the intervals of a row may be believed: the worse of the two sides.
inline constexpr std::string_view quality_ok = "ok";

/// A time over another and what that says.
struct TimeRatio {
  metric::Interval ratio;  ///< b over a
  metric::Verdict verdict;
};

struct TimingRow {
  Inputs inputs;
  metric::Interval a;  ///< nanoseconds per point
  metric::Interval b;
  TimeRatio raw;
  std::optional<TimeRatio> normalised;  ///< in units of the sentinel, where both have it
  /// `ok`, or what the file says of the doubtful side; `unchecked` where timed output was wrong; `noisy` also where one
  /// build on one machine took other times for the work of a sentinel.
  std::string quality;
  int rank_a = 0;  ///< 1 + how many methods of the same race are certainly faster; 0 for what is not ranked
  int rank_b = 0;

  [[nodiscard]] bool is_sentinel() const { return inputs.field("method") == sentinel; }
  [[nodiscard]] bool is_ok() const { return quality == quality_ok; }
  /// Whether b may be called slower in all that was measured: every repetition of b took longer than every one of a, as
  /// far as their intervals say, in units of the sentinel too, and the quality is `ok`.
  [[nodiscard]] bool is_certainly_slower() const;
};

struct TimingComparison {
  std::vector<TimingRow> rows;  ///< in a's order
  std::size_t only_a = 0;
  std::size_t only_b = 0;
};

/// Verdicts are those of metric::verdict, but `unresolved` where a race had too few rounds for an interval. Ranks are
/// among the methods that both have. Throws Failure(Exit::input_output) for a time that is no number.
[[nodiscard]] TimingComparison compare_timing(const Side& a, const Side& b);

/// The rows of methods, without those of sentinels.
[[nodiscard]] std::set<Inputs> timed_methods(const TimingComparison& timing);

/// Ranks the rows of `counted` among each other, and no others; sentinels have no rank. One method is certainly faster
/// where its interval ends before the other's begins.
void rank(TimingComparison& timing, const std::set<Inputs>& counted);

}  // namespace bezierbench::compare
