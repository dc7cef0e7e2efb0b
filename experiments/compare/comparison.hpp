// SPDX-License-Identifier: MIT
// A bundle compared with another one: machines and builds, results bit for bit, and times.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/compare/join.hpp"
#include "experiments/metric/order_statistics.hpp"

namespace bezierbench::compare {

// The verdicts on results; those on times are the names of metric::Verdict.
inline constexpr std::string_view identical = "identical";
inline constexpr std::string_view different = "different";

/// What only rows of times have.
struct Timed {
  metric::Interval a;  ///< nanoseconds per point
  metric::Interval b;
  std::optional<metric::Interval> normalised = {};  ///< b over a in units of the sentinel, where both sides have them
  /// The ratio that compares the methods. Between two machines it is the one in units of the sentinel. On one machine
  /// it reaches over both ratios: they differ where the machine changed its speed, and then neither is the method's.
  metric::Interval judged = {};
  std::string quality = {};  ///< the worse of the two sides: `ok`, or the word in the file
  int rank_a = 0;            ///< 1 + number of methods in the same race that are certainly faster; 0 if not ranked
  int rank_b = 0;
  /// Whether a ranked method of the same race is faster in one bundle and slower in the other, each by the verdict on
  /// the ratio of both in that bundle. Ranks may differ without that, where only one bundle tells two methods apart.
  bool changed_place = false;
};

/// Two rows, one of each bundle, with the same inputs.
struct Row {
  std::string file;
  Inputs inputs;
  std::string column;  ///< of the result: the largest error if it differs, else the first result that does
  std::string a;       ///< the values in that column
  std::string b;
  /// b over a. The median is NaN where a is 0 or one of them is not a number; the limits of a result are NaN.
  metric::Interval ratio{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::quiet_NaN()};
  std::string_view verdict = {};  ///< of times that on `timed->judged`
  std::optional<Timed> timed = {};
  /// Of results: b over a of every mean and largest error that differs, by column; infinite where it was 0.
  std::vector<std::pair<std::string, double>> errors = {};
  /// What says against b and not against a: a broken bound, promise or guarantee, or a status without numbers.
  std::string broken = {};

  /// |b/a|; infinite where that is not a number.
  [[nodiscard]] double growth() const;
  /// The row of the fixed work that runs beside every race.
  [[nodiscard]] bool is_sentinel() const { return inputs.field("method") == "sentinel"; }
};

/// The inputs of a row without a partner in the other bundle.
struct Single {
  std::string file;
  Inputs inputs;
};

/// One bundle compared with the first. The sides must outlive it.
struct Comparison {
  const Side* a;
  const Side* b;
  bool same_machine;
  std::vector<Row> results = {};  ///< by file, and within a file in a's order
  std::vector<Row> times = {};    ///< in a's order
  std::vector<Row> costs = {};    ///< instructions, in a's order; none where compiler or flags differ
  std::vector<Single> only_a = {};
  std::vector<Single> only_b = {};
  std::vector<std::string> left_out = {};  ///< files of both bundles whose rows do not determine their inputs

  /// The results that differ, by descending growth.
  [[nodiscard]] std::vector<const Row*> differing() const;
};

/// Compares the deterministic tables bit for bit, counted instructions exactly, and times by metric::verdict, which
/// is `unresolved` where the quality is not `ok`. Bundles with different seeds have different inputs, so that only
/// times and counts are compared. For different suites only tables with a column `trials` are compared: the rows of
/// any other table do not say how many trials they cover. Throws Failure(Exit::input_output) for a time that is not
/// a number.
[[nodiscard]] Comparison compare_sides(const Side& a, const Side& b);

/// The worst_id of the input that `side` recorded for the cell and method of `inputs`, which can be replayed; empty
/// where none was recorded.
[[nodiscard]] std::string recorded_input(const Side& side, const Inputs& inputs);

/// Every row: kind,study,method,scalar,dimension,degree,mode,a,b,ratio,ratio_low,ratio_high,verdict, then the further
/// inputs of the row and the columns that explain the verdict. `kind` is `accuracy`, `timing` or `cost`; `a` and
/// `b` are the values in `column` of `file`.
[[nodiscard]] bundle::CsvTable comparison_table(const std::vector<Comparison>& comparisons);

// The ratio of two times with its interval, where each time is known by its median and an interval only.
//
// Recovery of variance estimates (MOVER), on logarithms. A run's interval [l, u] around its median m says how far the
// median may be off in each direction: log(m/l) below and log(u/m) above, whatever the distribution. For a difference
// of independent estimates these distances add in squares, the lower one of the first with the upper one of the second
// (Zou and Donner 2008, Statistics in Medicine 27:1693, section 2; Donner and Zou 2012, Statistical Methods in Medical
// Research 21:347, for ratios). With x = log b and y = log a, log(b/a) = x - y lies in
//
//     [x - y - sqrt(log(b/b_low)^2 + log(a_high/a)^2),  x - y + sqrt(log(b_high/b)^2 + log(a/a_low)^2)]
//
// at the confidence of the two intervals. The intervals cover what varied within each run. Each time is therefore taken
// in several repetitions (experiments/race/race.hpp): what changes from one repetition to the next also changes
// from one run to the next.

/// The ratio b / a with its interval. Medians and limits must be positive; the interval is NaN where they are not.
inline metric::Interval ratio(const metric::Interval& b, const metric::Interval& a) {
  const auto distance = [](double low, double high) {
    return low > 0 && low <= high ? std::log(high / low) : std::numeric_limits<double>::quiet_NaN();
  };
  const auto root_of_squares = [](double x, double y) { return std::sqrt(x * x + y * y); };
  const double median = b.median / a.median;
  const double below = root_of_squares(distance(b.low, b.median), distance(a.median, a.high));
  const double above = root_of_squares(distance(b.median, b.high), distance(a.low, a.median));
  return {median, median * std::exp(-below), median * std::exp(above)};
}

}  // namespace bezierbench::compare
