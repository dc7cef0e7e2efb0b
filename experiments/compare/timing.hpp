// SPDX-License-Identifier: MIT
// How the times of two bundles compare, method by method: as they are, and in units of the sentinel.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "experiments/compare/rows.hpp"
#include "experiments/compare/side.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"

namespace bezierbench::compare {

/// The method's name in timing.csv for the fixed work that runs beside every race.
inline constexpr std::string_view sentinel = "sentinel";

/// A ratio of two times and the verdict on it.
struct TimeRatio {
  metric::Interval ratio;  ///< b over a
  metric::Verdict verdict;
};

struct TimingRow {
  Inputs inputs;
  metric::Interval a;  ///< nanoseconds per point
  metric::Interval b;
  TimeRatio raw;
  std::optional<TimeRatio> normalised;  ///< in units of the sentinel, where both sides have it
  /// The worse quality of the two sides: `ok`, or the word in the file; `unchecked` where timed output was wrong.
  /// `noisy` also where the same build on the same machine took different times for the fixed work beside the row.
  std::string quality;
  int rank_a = 0;  ///< 1 + number of methods in the same race that are certainly faster; 0 if not ranked
  int rank_b = 0;
  /// Whether a ranked method of the same race is faster in one bundle and slower in the other, each by the verdict on
  /// the ratio of both in that bundle. Ranks may differ without that, where only one bundle tells two methods apart.
  bool changed_place = false;

  [[nodiscard]] bool is_sentinel() const { return inputs.field("method") == sentinel; }
  [[nodiscard]] bool is_ok() const { return quality == "ok"; }
  /// Whether b is slower by every measure: the interval of b lies above that of a, the verdict on the ratio is
  /// `slower`, in units of the sentinel too, and the quality is `ok`.
  [[nodiscard]] bool is_certainly_slower() const;
};

struct TimingComparison {
  std::vector<TimingRow> rows;  ///< in a's order
  std::size_t only_a = 0;
  std::size_t only_b = 0;
};

/// Compares the rows that both sides have. Verdicts are those of metric::verdict, but `unresolved` where a race had too
/// few rounds for an interval. Ranks are among the methods that both sides have. Throws Failure(Exit::input_output) for
/// a time that is not a number.
[[nodiscard]] TimingComparison compare_timing(const Side& a, const Side& b);

/// The inputs of the rows of methods, without those of sentinels.
[[nodiscard]] std::set<Inputs> timed_methods(const TimingComparison& timing);

/// Ranks the rows whose inputs are in `counted` among each other and finds those that changed their place; all other
/// rows and sentinels get rank 0. A method is certainly faster than another where its interval ends before the other's
/// begins.
void rank(TimingComparison& timing, const std::set<Inputs>& counted);

}  // namespace bezierbench::compare
