// SPDX-License-Identifier: MIT
// Times of one method in two programs. Both run in turn, so that what changes on the machine affects both alike, and
// each pair of runs gives one ratio. In every second pair the other program goes first.
//
// A pair is one observation, as a repetition is in a race (experiments/race/repetition.hpp): every process has its own
// addresses of stack, heap and code, which may change a time by more than the difference that is looked for.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/compare/join.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"

namespace bezierbench::cli {

/// The times of one row of timing.csv, in nanoseconds per point; element k of both is pair k. Not empty.
struct PairedTimes {
  std::vector<double> before;
  std::vector<double> after;
  bool checked = true;  ///< whether every timed result was the judged one

  /// After over before, of the pairs.
  [[nodiscard]] metric::Interval ratio() const;
  /// Unresolved where there are too few pairs for an interval.
  [[nodiscard]] metric::Verdict verdict() const;
};

struct TimedPrograms {
  std::filesystem::path before;
  std::filesystem::path after;
  std::filesystem::path suite;    ///< a file with timing studies
  std::filesystem::path scratch;  ///< a folder for their bundles
};

/// Runs both programs `pairs` times. Rows that only one of them has are left out. Throws Failure where a program fails.
std::map<compare::Inputs, PairedTimes> paired_times(const TimedPrograms& programs, const std::string& method,
                                                    int pairs);

}  // namespace bezierbench::cli
